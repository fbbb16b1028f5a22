#include "reference/exact_tracer.hpp"

#include "reference/packet_tracer.hpp"

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
          x_(ray.x),
          y_(ray.y),
          last_(ray.last),
          s_(ray.first) {
        column_ = enter(x_, s_, width_);
        row_ = enter(y_, s_, height_);
        above_ = s_ <= 0 || quadratic(corners()).c >= 0;
    }

    /// The ray parameter of the first crossing from above to below, or a negative number.
    ///
    /// `above_` is carried from cell to cell and never worked out anew at a border, so whatever rounding does there, a
    /// ray that was above the sheet and is below it has been given a hit in between.
    double run() {
        if (s_ <= 0 && quadratic(corners()).c <= entry_tolerance) {
            return 0;
        }
        const int top = top_level();
        int level = above_ ? top : 0;
        while (s_ < last_) {
            const int wall_x = wall<right>(column_, level, width_);
            const int wall_y = wall<up>(row_, level, height_);
            const double s_x = (wall_x - x_.origin) * x_.inverse_step;
            const double s_y = (wall_y - y_.origin) * y_.inverse_step;
            const double exit = std::max(std::min(s_x, s_y), s_);
            if (level == 0) {
                const double hit = test_cell(std::min(exit, last_));
                if (hit >= 0) {
                    return hit;
                }
                if (!above_ && exit > 1) {
                    break;
                }
            } else if (1 - exit < maxima_.at(level, column_ >> level, row_ >> level)) {
                --level;
                continue;
            }
            s_ = exit;
            bool new_parent = false;
            if (s_x <= s_y) {
                row_ = advance<up>(row_, y_.at(exit), wall_y);
                new_parent = leaves_parent<right>(column_ >> level);
                column_ = cross<right>(wall_x, x_, width_);
            } else {
                column_ = advance<right>(column_, x_.at(exit), wall_x);
                new_parent = leaves_parent<up>(row_ >> level);
                row_ = cross<up>(wall_y, y_, height_);
            }
            if (new_parent && above_ && level < top) {
                ++level;
            }
        }
        return -1;
    }

private:
    struct Corners {
        float h00, h10, h01, h11;
        float minimum() const { return std::min(std::min(h00, h10), std::min(h01, h11)); }
        float maximum() const { return std::max(std::max(h00, h10), std::max(h01, h11)); }
    };

    /// Nodes of a quarter to half of the ray's way through the slab: larger ones hardly ever let it pass.
    int top_level() const {
        const double extent = std::min(std::max(std::abs(x_.step), std::abs(y_.step)), 1e9);
        const int bits = static_cast<int>(std::bit_width(static_cast<unsigned>(extent)));
        return std::clamp(bits - 2, 1, maxima_.top_level());
    }

    /// The cell at s. Maps repeat: the axis is moved by whole maps so that the cell lies in the first one.
    static int enter(Axis& axis, double s, int size) {
        const double coordinate = axis.at(s);
        if (coordinate < 0 || coordinate >= size) {
            axis.origin -= std::floor(coordinate / size) * size;
            if (axis.at(s) >= size) {  // by rounding; a ray along this border must not have it behind itself
                axis.origin -= size;
            }
        }
        return std::clamp(static_cast<int>(axis.at(s)), 0, size - 1);
    }

    template <bool forward>
    static int wall(int cell, int level, int size) {
        const int node = cell >> level;
        return forward ? std::min((node + 1) << level, size) : node << level;
    }

    /// The cell at a coordinate of the same node. Cells only ever change in the ray's direction: rounding cannot send
    /// it back.
    template <bool forward>
    static int advance(int cell, double coordinate, int wall) {
        const int reached = static_cast<int>(coordinate);  // not floor: what is negative is clamped anyway
        return forward ? std::min(std::max(reached, cell), wall - 1) : std::max(std::min(reached, cell), wall);
    }

    /// The cell behind a wall; from the map's last one to the first of the next map, with the axis.
    template <bool forward>
    static int cross(int wall, Axis& axis, int size) {
        if (forward) {
            if (wall < size) {
                return wall;
            }
            axis.origin -= size;
            return 0;
        }
        if (wall > 0) {
            return wall - 1;
        }
        axis.origin += size;
        return size - 1;
    }

    template <bool forward>
    static bool leaves_parent(int node) {
        return (node & 1) == (forward ? 1 : 0);
    }

    Corners corners() const {
        const int next_column = column_ + 1 == width_ ? 0 : column_ + 1;
        const int next_row = row_ + 1 == height_ ? 0 : row_ + 1;
        const float* lower = texels_ + static_cast<std::ptrdiff_t>(row_) * width_;
        const float* upper = texels_ + static_cast<std::ptrdiff_t>(next_row) * width_;
        return {lower[column_], lower[next_column], upper[column_], upper[next_column]};
    }

    CellQuadratic quadratic(const Corners& corner) const {
        const double x = x_.at(s_) - column_;
        const double y = y_.at(s_) - row_;
        const double h00 = corner.h00;
        const double along_x = corner.h10 - h00;
        const double along_y = corner.h01 - h00;
        const double twist = (corner.h11 - static_cast<double>(corner.h01)) - along_x;
        CellQuadratic f;
        f.a = -twist * x_.step * y_.step;
        f.b = -1 - ((along_x + twist * y) * x_.step + (along_y + twist * x) * y_.step);
        f.c = (1 - s_) - (h00 + along_x * x + (along_y + twist * x) * y);
        return f;
    }

    /// The crossing between here and `end` within the cell, or a negative number; keeps `above_` up to date.
    double test_cell(double end) {
        const Corners corner = corners();
        if (1 - end >= corner.maximum()) {
            above_ = true;
            return -1;
        }
        if (!above_ && 1 - s_ < corner.minimum()) {
            return -1;
        }
        const double length = end - s_;
        const CellQuadratic f = quadratic(corner);
        const bool above_at_end = f.at(length) >= 0;
        const bool crosses = above_ ? !above_at_end || (f.a > 0 && f.turns_through_zero(length))
                                    : !above_at_end && f.a < 0 && f.turns_through_zero(length);
        if (crosses) {
            return s_ + std::clamp(f.falling_root(), 0.0, length);
        }
        above_ = above_at_end;
        return -1;
    }

    const float* texels_;
    int width_;
    int height_;
    const MaximumMipChain& maxima_;
    Axis x_;
    Axis y_;
    double last_;
    double s_;
    int column_ = 0;
    int row_ = 0;
    bool above_ = true;
};

double first_crossing(const HeightMap& map, const MaximumMipChain& maxima, const SlabRay& ray) {
    if (ray.x.step >= 0) {
        return ray.y.step >= 0 ? Walk<true, true>(map, maxima, ray).run() : Walk<true, false>(map, maxima, ray).run();
    }
    return ray.y.step >= 0 ? Walk<false, true>(map, maxima, ray).run() : Walk<false, false>(map, maxima, ray).run();
}

ExactHit hit_at(const StraightPath& path, double s) {
    return {path.uv.x + s * path.uv_per_s.x, path.uv.y + s * path.uv_per_s.y, std::max(1 - s, 0.0),
            path.t_top + s * path.t_per_s};
}

/// Fewer rays than this are as quick one by one.
constexpr std::size_t min_packet_rays = 4;

}  // namespace

ExactTracer::ExactTracer(const HeightMap& map, const Relief& relief)
    : map_(&map), relief_(relief), plane_(flat_base(relief.base)), maxima_(map), windows_(map) {
    assert(relief.height_scale > 0 && relief.tiling > 0);
}

std::optional<ExactHit> ExactTracer::trace(const Ray& ray) const {
    if (!descends(plane_, ray)) {
        return std::nullopt;
    }
    const StraightPath path = straight_path(plane_, ray, relief_.height_scale);
    const double columns = relief_.tiling * map_->width();
    const double rows = relief_.tiling * map_->height();

    SlabRay slab{Axis(path.uv.x * columns - 0.5, path.uv_per_s.x * columns),
                 Axis(path.uv.y * rows - 0.5, path.uv_per_s.y * rows)};
    if (path.t_top < 0) {
        slab.first = -path.t_top / path.t_per_s;
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
    return hit_at(path, s);
}

void ExactTracer::trace(std::span<const Ray> rays, std::span<std::optional<ExactHit>> hits) const {
    assert(rays.size() == hits.size());
    const PacketScene scene{.texels = map_->heights.texels.data(),
                            .width = map_->width(),
                            .height = map_->height(),
                            .height_scale = relief_.height_scale,
                            .columns = relief_.tiling * map_->width(),
                            .rows = relief_.tiling * map_->height(),
                            .clip = relief_.boundary == Boundary::clip,
                            .windows = &windows_};
    PacketCrossings crossings;
    for (std::size_t first = 0; first < rays.size(); first += max_packet_rays) {
        const std::span<const Ray> packet = rays.subspan(first, std::min(max_packet_rays, rays.size() - first));
        if (packet.size() < min_packet_rays) {
            std::fill_n(crossings.begin(), packet.size(), not_decided);
        } else {
            find_crossings(scene, packet, crossings);
        }
        for (std::size_t i = 0; i < packet.size(); ++i) {
            const Ray& ray = packet[i];
            std::optional<ExactHit>& hit = hits[first + i];
            if (crossings[i] == not_decided) {
                hit = trace(ray);
            } else if (crossings[i] == crosses_nowhere) {
                hit.reset();
            } else {
                hit = hit_at(straight_path(plane_, ray, relief_.height_scale), crossings[i]);
            }
        }
    }
}

}  // namespace reliefbench
