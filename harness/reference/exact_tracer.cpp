#include "reference/exact_tracer.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>

namespace reliefbench {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Past h = 0, where no surface is: a ray that has come this far is beneath the sheet.
constexpr double surely_below = 1.5;

/// One coordinate of a descending ray, in cells: texel i has its centre at i, and at the parameter s the ray is at
/// origin + s·step.
struct Axis {
    double origin = 0;
    double step = 0;
    double inverse_step = infinity;

    /// Steps too short to leave a cell within the slab count as none, so that their reciprocal cannot overflow.
    Axis(double o, double d) : origin(o), step(std::abs(d) < 1e-100 ? 0.0 : d) {
        if (step != 0) {
            inverse_step = 1 / step;
        }
    }

    double at(double s) const { return origin + s * step; }
};

/// A descending ray: at the parameter s it is at height h = 1 − s.
struct SlabRay {
    Axis x;
    Axis y;
    double first = 0;
    double last = surely_below;

    /// Narrows [first, last] to where a coordinate lies in [low, high].
    void clip(const Axis& axis, double low, double high) {
        if (axis.step == 0) {
            last = axis.origin < low || axis.origin > high ? -infinity : last;
            return;
        }
        const double a = (low - axis.origin) * axis.inverse_step;
        const double b = (high - axis.origin) * axis.inverse_step;
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
    }
};

/// Height above the sheet along a ray inside one cell, f(s) = (a·s + b)·s + c with s counted from where the ray enters
/// the cell.
struct CellQuadratic {
    double a = 0;
    double b = 0;
    double c = 0;

    double at(double s) const { return (a * s + b) * s + c; }

    /// The root at which f falls: of both roots it is always (−b − √D) / 2a, here without cancellation.
    double falling_root() const {
        const double root = std::sqrt(std::max(b * b - 4 * a * c, 0.0));
        if (b > 0) {
            return (-b - root) / (2 * a);
        }
        const double q = root - b;
        return q > 0 ? 2 * c / q : 0.0;
    }

    /// Whether f has an extremum inside (0, end) on the other side of zero than it has at both ends.
    bool turns_through_zero(double end) const {
        const double extremum = -b / (2 * a);
        return a != 0 && extremum > 0 && extremum < end && b * b > 4 * a * c;
    }
};

/// Where a ray is in the grid of cells. Cells repeat: (column, row) lies in the map, the base counts whole maps.
struct Position {
    double base_x = 0;
    double base_y = 0;
    int column = 0;
    int row = 0;
};

/// One ray's walk through the hierarchy. `right` and `up` say whether the cell coordinates grow along the ray (or
/// stay).
template <bool right, bool up>
class Walk {
public:
    Walk(const HeightMap& map, const MaximumMipChain& maxima, const SlabRay& ray)
        : texels_(map.heights.texels.data()),
          width_(map.width()),
          height_(map.height()),
          maxima_(maxima),
          ray_(ray),
          s_(ray.first) {
        enter(ray.x.at(s_), width_, position_.base_x, position_.column);
        enter(ray.y.at(s_), height_, position_.base_y, position_.row);
        above_ = s_ <= 0 || quadratic(corners()).c >= 0;
    }

    /// The ray parameter of the first crossing from above to below, or a negative number.
    ///
    /// `above_` is carried from cell to cell and never worked out anew at a border, so whatever rounding does there, a
    /// ray that was above the sheet and is below it has been given a hit in between.
    double run() {
        const int top = top_level();
        int level = above_ ? top : 0;
        while (s_ < ray_.last) {
            const Exit exit = node_exit(level);
            if (level == 0) {
                const double hit = test_cell(exit.s);
                if (hit >= 0) {
                    return hit;
                }
            } else {
                const float maximum = maxima_.at(level, position_.column >> level, position_.row >> level);
                if (1 - exit.s < maximum) {
                    --level;
                    continue;
                }
            }
            if (exit.s >= ray_.last || (!above_ && exit.s > 1)) {
                break;
            }
            const bool new_parent = leave(exit, level);
            if (above_ && new_parent && level < top) {
                ++level;
            }
        }
        return -1;
    }

private:
    struct Exit {
        double s;
        bool through_x;
    };

    struct Corners {
        float h00, h10, h01, h11;
        float minimum() const { return std::min(std::min(h00, h10), std::min(h01, h11)); }
        float maximum() const { return std::max(std::max(h00, h10), std::max(h01, h11)); }
    };

    /// Nodes of about a quarter of the ray's way through the slab: larger ones hardly ever let it pass.
    int top_level() const {
        const double extent = std::min(std::max(std::abs(ray_.x.step), std::abs(ray_.y.step)), 1e9);
        const int bits = static_cast<int>(std::bit_width(static_cast<unsigned>(extent)));
        return std::clamp(bits - 3, 1, maxima_.top_level());
    }

    static void enter(double coordinate, int size, double& base, int& cell) {
        base = coordinate >= 0 && coordinate < size ? 0.0 : std::floor(coordinate / size) * size;
        cell = std::clamp(static_cast<int>(coordinate - base), 0, size - 1);
    }

    static int wall(int cell, int level, int size, bool forward) {
        const int node = cell >> level;
        return forward ? std::min((node + 1) << level, size) : node << level;
    }

    Exit node_exit(int level) const {
        const double wall_x = position_.base_x + wall(position_.column, level, width_, right);
        const double wall_y = position_.base_y + wall(position_.row, level, height_, up);
        const double s_x = (wall_x - ray_.x.origin) * ray_.x.inverse_step;
        const double s_y = (wall_y - ray_.y.origin) * ray_.y.inverse_step;
        return {std::max(std::min(std::min(s_x, s_y), ray_.last), s_), s_x <= s_y};
    }

    /// Cells only ever change in the ray's direction, so rounding cannot send it back.
    static int advance_cell(double coordinate, int cell, int level, int size, bool forward) {
        const int reached = static_cast<int>(coordinate);  // not floor: what is negative is clamped anyway
        const int limit = wall(cell, level, size, forward);
        return forward ? std::clamp(reached, cell, limit - 1) : std::clamp(reached, limit, cell);
    }

    /// Through the wall of a node into its neighbour; whether that has another parent.
    bool leave(const Exit& exit, int level) {
        const int parent_column = position_.column >> (level + 1);
        const int parent_row = position_.row >> (level + 1);
        if (exit.through_x) {
            position_.row = advance_cell(ray_.y.at(exit.s) - position_.base_y, position_.row, level, height_, up);
            cross(position_.column, position_.base_x, level, width_, right);
        } else {
            position_.column =
                advance_cell(ray_.x.at(exit.s) - position_.base_x, position_.column, level, width_, right);
            cross(position_.row, position_.base_y, level, height_, up);
        }
        s_ = exit.s;
        return (position_.column >> (level + 1)) != parent_column || (position_.row >> (level + 1)) != parent_row;
    }

    static void cross(int& cell, double& base, int level, int size, bool forward) {
        cell = forward ? wall(cell, level, size, true) : wall(cell, level, size, false) - 1;
        if (cell == size) {
            cell = 0;
            base += size;
        } else if (cell < 0) {
            cell = size - 1;
            base -= size;
        }
    }

    Corners corners() const {
        const int next_column = position_.column + 1 == width_ ? 0 : position_.column + 1;
        const int next_row = position_.row + 1 == height_ ? 0 : position_.row + 1;
        const float* lower = texels_ + static_cast<std::ptrdiff_t>(position_.row) * width_;
        const float* upper = texels_ + static_cast<std::ptrdiff_t>(next_row) * width_;
        return {lower[position_.column], lower[next_column], upper[position_.column], upper[next_column]};
    }

    CellQuadratic quadratic(const Corners& corner) const {
        const double x = ray_.x.at(s_) - (position_.base_x + position_.column);
        const double y = ray_.y.at(s_) - (position_.base_y + position_.row);
        const double h00 = corner.h00;
        const double along_x = corner.h10 - h00;
        const double along_y = corner.h01 - h00;
        const double twist = (corner.h11 - static_cast<double>(corner.h01)) - along_x;
        CellQuadratic f;
        f.a = -twist * ray_.x.step * ray_.y.step;
        f.b = -1 - ((along_x + twist * y) * ray_.x.step + (along_y + twist * x) * ray_.y.step);
        f.c = (1 - s_) - (h00 + along_x * x + (along_y + twist * x) * y);
        return f;
    }

    /// The crossing between here and the cell's exit, or a negative number; keeps `above_` up to date.
    double test_cell(double exit) {
        const Corners corner = corners();
        if (1 - exit >= corner.maximum()) {
            above_ = true;
            return -1;
        }
        if (!above_ && 1 - s_ < corner.minimum()) {
            return -1;
        }
        const double length = exit - s_;
        const CellQuadratic f = quadratic(corner);
        const bool above_at_exit = f.at(length) >= 0;
        const bool crosses = above_ ? !above_at_exit || (f.a > 0 && f.turns_through_zero(length))
                                    : !above_at_exit && f.a < 0 && f.turns_through_zero(length);
        if (crosses) {
            return s_ + std::clamp(f.falling_root(), 0.0, length);
        }
        above_ = above_at_exit;
        return -1;
    }

    const float* texels_;
    int width_;
    int height_;
    const MaximumMipChain& maxima_;
    SlabRay ray_;
    double s_;
    Position position_;
    bool above_ = true;
};

double first_crossing(const HeightMap& map, const MaximumMipChain& maxima, const SlabRay& ray) {
    if (ray.x.step >= 0) {
        return ray.y.step >= 0 ? Walk<true, true>(map, maxima, ray).run() : Walk<true, false>(map, maxima, ray).run();
    }
    return ray.y.step >= 0 ? Walk<false, true>(map, maxima, ray).run() : Walk<false, false>(map, maxima, ray).run();
}

}  // namespace

ExactTracer::ExactTracer(const HeightMap& map, const Relief& relief) : map_(&map), relief_(relief), maxima_(map) {
    assert(relief.height_scale > 0 && relief.tiling > 0);
}

std::optional<ExactHit> ExactTracer::trace(const Ray& ray) const {
    if (!(ray.direction.z < 0)) {
        return std::nullopt;
    }
    const double t_per_z = 1 / ray.direction.z;
    const double t_top = -ray.origin.z * t_per_z;
    const double t_per_s = -relief_.height_scale * t_per_z;
    const double u = ray.origin.x + t_top * ray.direction.x + 0.5;
    const double v = ray.origin.y + t_top * ray.direction.y + 0.5;
    const double du = t_per_s * ray.direction.x;
    const double dv = t_per_s * ray.direction.y;
    const double columns = relief_.tiling * map_->width();
    const double rows = relief_.tiling * map_->height();

    SlabRay slab{Axis(u * columns - 0.5, du * columns), Axis(v * rows - 0.5, dv * rows)};
    if (t_top < 0) {
        slab.first = -t_top / t_per_s;
    }
    if (relief_.boundary == Boundary::clip) {
        slab.clip(slab.x, -0.5, columns - 0.5);
        slab.clip(slab.y, -0.5, rows - 0.5);
    }
    if (slab.first > slab.last || slab.first > 1) {
        return std::nullopt;
    }
    const double s = first_crossing(*map_, maxima_, slab);
    if (s < 0) {
        return std::nullopt;
    }
    return ExactHit{u + s * du, v + s * dv, std::max(1 - s, 0.0), t_top + s * t_per_s};
}

}  // namespace reliefbench
