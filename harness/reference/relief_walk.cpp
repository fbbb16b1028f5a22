#include "reference/relief_walk.hpp"

#include "reference/ray_cubic.hpp"
#include "scene/relief.hpp"

#include <algorithm>
#include <cmath>

namespace reliefbench {

namespace {

/// How far the cubic may be from the exact way, in texels and in h.
constexpr double way_tolerance = 1e-9;
/// Halvings of a ray's way through one piece. Ways that bend need a few; in prisms that turn inside out none are
/// enough.
constexpr int max_halvings = 200;

/// A bilinear cell of heights, at coordinates from its lower left texel.
struct BilinearCell {
    double h00 = 0;
    double along_x = 0;
    double along_y = 0;
    double twist = 0;
    double lowest = 0;
    double highest = 0;

    double at(double x, double y) const { return h00 + along_x * x + (along_y + twist * x) * y; }
    double slope(double x, double y, double dx, double dy) const {
        return (along_x + twist * y) * dx + (along_y + twist * x) * dy;
    }
};

BilinearCell bilinear_cell(const HeightMap& map, int column, int row) {
    const int width = map.width();
    const int height = map.height();
    const int next_column = column + 1 == width ? 0 : column + 1;
    const int next_row = row + 1 == height ? 0 : row + 1;
    const float* lower = map.heights.texels.data() + static_cast<std::ptrdiff_t>(row) * width;
    const float* upper = map.heights.texels.data() + static_cast<std::ptrdiff_t>(next_row) * width;
    const double h00 = lower[column];
    const double h10 = lower[next_column];
    const double h01 = upper[column];
    const double h11 = upper[next_column];
    return {h00,
            h10 - h00,
            h01 - h00,
            (h11 - h01) - (h10 - h00),
            std::min(std::min(h00, h10), std::min(h01, h11)),
            std::max(std::max(h00, h10), std::max(h01, h11))};
}

struct Block {
    int level = 0;
    /// In the map.
    int column = 0;
    int row = 0;
};

/// One span of a ray's way, s from 0 to 1.
class Span {
public:
    Span(const HeightMap& map, const MaximumMipChain& maxima, const Prism& prism, const Prism::RayTerms& terms,
         const Ray& ray, glm::dvec2 repeat, double from, double length, const Prism::Along& first,
         const Prism::Along& last)
        : map_(map),
          maxima_(maxima),
          prism_(prism),
          terms_(terms),
          ray_(ray),
          repeat_(repeat),
          from_(from),
          length_(length),
          m_(first.m),
          m_per_s_(last.m - first.m) {
        for (int axis = 0; axis < 3; ++axis) {
            Cubic& way = axis == 0 ? x_ : axis == 1 ? y_ : z_;
            const double origin = axis < 2 ? repeat[axis] : 0;
            way = Cubic::hermite(first.point[axis] - origin, first.change[axis] * length, last.point[axis] - origin,
                                 last.change[axis] * length);
        }
    }

    bool is_close_to(const Prism::Along& middle) const {
        const double off =
            std::max({std::abs(x_.at(0.5) - (middle.point.x - repeat_.x)),
                      std::abs(y_.at(0.5) - (middle.point.y - repeat_.y)), std::abs(z_.at(0.5) - middle.point.z)});
        return off <= way_tolerance;
    }

    std::optional<WalkHit> first_hit(const ReliefPiece& piece, int level) {
        const auto wrapped = [](std::int32_t first, double repeat) {
            return static_cast<int>(static_cast<std::int64_t>(first) - static_cast<std::int64_t>(repeat));
        };
        block_ = {level, wrapped(piece.column, repeat_.x), wrapped(piece.row, repeat_.y)};
        return clip(0, 0, 1);
    }

    std::size_t unresolved() const { return unresolved_; }

private:
    static constexpr int triangle_sides = 3;
    static constexpr int borders = triangle_sides + 4;

    /// What is ≥ 0 on the inner side of one of the triangle's sides or the block's.
    Cubic distance_from(int border) const {
        Cubic distance;
        if (border < triangle_sides) {
            const glm::dvec3& side = prism_.sides()[static_cast<std::size_t>(border)];
            for (std::size_t k = 0; k < 4; ++k)
                distance.c[k] = side.x * x_.c[k] + side.y * y_.c[k];
            distance.c[0] += side.x * repeat_.x + side.y * repeat_.y + side.z;
        } else {
            const int wall = border - triangle_sides;
            const bool is_x = wall < 2;
            const bool is_high = wall % 2 == 1;
            const int first = is_x ? block_.column : block_.row;
            const int size = is_x ? map_.width() : map_.height();
            const int place = is_high ? std::min(first + (1 << block_.level), size) : first;
            distance = is_x ? x_ : y_;
            distance.c[0] -= place;
            if (is_high) {
                for (double& coefficient : distance.c)
                    coefficient = -coefficient;
            }
        }
        distance.c[0] += piece_overlap;
        return distance;
    }

    /// The parts of [from, to] within all borders from this one on, in turn.
    std::optional<WalkHit> clip(int border, double from, double to) {
        for (; border < borders; ++border) {
            const Cubic distance = distance_from(border);
            const Cubic::Range range = distance.range(from, to);
            if (range.high < 0) return std::nullopt;
            if (range.low >= 0) continue;
            const CubicRoots roots = crossings(distance, 0, from, to);
            double start = from;
            for (std::size_t part = 0; part <= roots.count; ++part) {
                const double end = part < roots.count ? roots.places[part] : to;
                if (distance.at((start + end) / 2) >= 0) {
                    if (const auto hit = clip(border + 1, start, end)) return hit;
                }
                start = end;
            }
            return std::nullopt;
        }
        return descend(block_, from, to);
    }

    std::optional<WalkHit> descend(const Block& block, double from, double to) {
        if (block.level == 0) return cross_cell(block, from, to);
        const double highest =
            static_cast<double>(maxima_.at(block.level, block.column >> block.level, block.row >> block.level));
        if (z_.range(from, to).low > std::max(highest, entry_height(highest))) return std::nullopt;
        const int half = 1 << (block.level - 1);
        const int middle_column = block.column + half;
        const int middle_row = block.row + half;
        // At most three of each, and both ends; in order.
        std::array<double, 8> places{from};
        std::size_t count = 1;
        const auto add = [&](const Cubic& way, int middle) {
            const CubicRoots roots = crossings(way, middle, from, to);
            for (std::size_t root = 0; root < roots.count; ++root) {
                std::size_t place = count++;
                for (; places[place - 1] > roots.places[root]; --place)
                    places[place] = places[place - 1];
                places[place] = roots.places[root];
            }
        };
        add(x_, middle_column);
        add(y_, middle_row);
        places[count++] = to;
        for (std::size_t part = 0; part + 1 < count; ++part) {
            const double s = (places[part] + places[part + 1]) / 2;
            const Block child{block.level - 1,
                              x_.at(s) >= middle_column && middle_column < map_.width() ? middle_column : block.column,
                              y_.at(s) >= middle_row && middle_row < map_.height() ? middle_row : block.row};
            if (const auto hit = descend(child, places[part], places[part + 1])) return hit;
        }
        return std::nullopt;
    }

    /// The height at which a ray may hit where the relief reaches as high as this: what is nearly 1 is hit at 1.
    static double entry_height(double highest) { return highest >= 1 - entry_tolerance ? 1 : highest; }

    struct Sample {
        double s = 0;
        /// Height above the sheet, and its change with s.
        double f = 0;
        double slope = 0;
    };

    Sample sample(const BilinearCell& cell, const Block& block, double s) const {
        const double x = x_.at(s) - block.column;
        const double y = y_.at(s) - block.row;
        return {s, z_.at(s) - cell.at(x, y), z_.slope(s) - cell.slope(x, y, x_.slope(s), y_.slope(s))};
    }

    std::optional<WalkHit> cross_cell(const Block& block, double from, double to) {
        const BilinearCell cell = bilinear_cell(map_, block.column, block.row);
        const Cubic::Range range = z_.range(from, to);
        if (range.low > entry_height(cell.highest) || range.high < cell.lowest) return std::nullopt;
        const std::optional<WalkHit> entered = enter_on_sheet(cell, block, from, to);
        // A cell goes on for a little, as its piece does.
        const double before = from - overlap_in_s();
        const double after = to + overlap_in_s();
        const auto root = falling_root(cell, block, sample(cell, block, before), sample(cell, block, after), 0);
        if (!root) return entered;
        const WalkHit hit = refined(cell, block, *root);
        return entered && entered->t <= hit.t ? entered : hit;
    }

    double overlap_in_s() const {
        const double texels = std::max(std::abs(x_.c[1]), std::abs(y_.c[1]));
        return std::min(piece_overlap / std::max(texels, 1e-300), 1e-6);
    }

    /// The rule of touches: where the ray enters the relief over a height of 1, to entry_tolerance.
    std::optional<WalkHit> enter_on_sheet(const BilinearCell& cell, const Block& block, double from, double to) {
        if (cell.highest < 1 - entry_tolerance) return std::nullopt;
        const CubicRoots roots = crossings(z_, 1, from, to);
        for (std::size_t index = 0; index < roots.count; ++index) {
            const double s = roots.places[index];
            const double x = x_.at(s);
            const double y = y_.at(s);
            if (z_.slope(s) >= 0 || cell.at(x - block.column, y - block.row) < 1 - entry_tolerance) continue;
            return WalkHit{from_ + s * length_, {x + repeat_.x, y + repeat_.y, 1}};
        }
        return std::nullopt;
    }

    /// Where f falls through zero for the first time. Of no more than one extremum between both samples where f bends
    /// one way only; else they are halved.
    std::optional<std::array<double, 2>> falling_root(const BilinearCell& cell, const Block& block, const Sample& first,
                                                      const Sample& last, int depth) const {
        const double length = last.s - first.s;
        if (length <= 0) return std::nullopt;
        const double rise = last.f - first.f;
        // f''' times −length³/12.
        const double skew = rise - length * (first.slope + last.slope) / 2;
        const bool bends_one_way = std::abs(last.slope - first.slope) * length >= 6.5 * std::abs(skew);
        const bool slopes_one_way =
            (first.slope > 0) == (last.slope > 0) &&
            std::min(std::abs(first.slope), std::abs(last.slope)) * length >= 2 * std::abs(skew);
        constexpr int max_depth = 12;
        if (!bends_one_way && !slopes_one_way && depth < max_depth) {
            const Sample middle = sample(cell, block, (first.s + last.s) / 2);
            if (const auto root = falling_root(cell, block, first, middle, depth + 1)) return root;
            return falling_root(cell, block, middle, last, depth + 1);
        }
        const bool above_first = first.f >= 0;
        const bool above_last = last.f >= 0;
        if (above_first && !above_last) return std::array{first.s, last.s};
        if (above_first != above_last) return std::nullopt;
        // Above at both ends with a dip between, or below with a bump.
        if (above_first ? !(first.slope < 0 && last.slope > 0) : !(first.slope > 0 && last.slope < 0))
            return std::nullopt;
        const double extremum = bracketed_root(
            first.s, last.s, first.slope, 1e-13, [&](double s) { return sample(cell, block, s).slope; },
            [&](double) { return (last.slope - first.slope) / length; });
        const bool above_extremum = sample(cell, block, extremum).f >= 0;
        if (above_extremum == above_first) return std::nullopt;
        return above_first ? std::array{first.s, extremum} : std::array{extremum, last.s};
    }

    /// The crossing on the exact way, from the bracket of it on the cubic.
    WalkHit refined(const BilinearCell& cell, const Block& block, const std::array<double, 2>& bracket) {
        double s = bracketed_root(
            bracket[0], bracket[1], 1.0, 1e-10, [&](double place) { return sample(cell, block, place).f; },
            [&](double place) { return sample(cell, block, place).slope; });
        const glm::dvec2 corner = repeat_ + glm::dvec2(block.column, block.row);
        const double slack = 1e-6 + (bracket[1] - bracket[0]);
        Prism::Along along{.m = m_ + s * m_per_s_, .point = {x_.at(s) + repeat_.x, y_.at(s) + repeat_.y, z_.at(s)}};
        const double start = s;
        bool converged = false;
        constexpr int max_steps = 8;
        for (int step = 0; step < max_steps && !converged; ++step) {
            if (!prism_.locate(ray_, terms_, from_ + s * length_, along.m, along)) break;
            const double x = along.point.x - corner.x;
            const double y = along.point.y - corner.y;
            const double f = along.point.z - cell.at(x, y);
            const double slope = (along.change.z - cell.slope(x, y, along.change.x, along.change.y)) * length_;
            converged = std::abs(f) <= 1e-13;
            if (converged) break;
            const double next = s - f / slope;
            // A double root: what the cubic says is within its tolerance of it.
            if (!(std::abs(next - start) <= slack)) break;
            s = next;
        }
        if (!converged) ++unresolved_;
        return {from_ + s * length_, along.point};
    }

    const HeightMap& map_;
    const MaximumMipChain& maxima_;
    const Prism& prism_;
    const Prism::RayTerms& terms_;
    const Ray& ray_;
    glm::dvec2 repeat_;
    double from_;
    double length_;
    double m_;
    double m_per_s_;
    Cubic x_;
    Cubic y_;
    Cubic z_;
    Block block_;
    std::size_t unresolved_ = 0;
};

}  // namespace

std::optional<WalkHit> ReliefWalk::first_hit(const Prism& prism, const Prism::RayTerms& terms, const ReliefPiece& piece,
                                             const Ray& ray, double from, double to, WalkCounts& counts) const {
    // Where b(m) = D·n(m) keeps its sign over the piece's m, m rises or falls with t all the way.
    const double low = static_cast<double>(piece.lowest);
    const double high = static_cast<double>(piece.highest);
    const auto steepness = [&](double sum, double product) {
        return terms.b[0] + terms.b[1] * sum / 2 + terms.b[2] * product;
    };
    const double at_low = steepness(2 * low, low * low);
    const double between = steepness(low + high, low * high);
    const double at_high = steepness(2 * high, high * high);
    double guess_first = (low + high) / 2;
    double guess_last = guess_first;
    if ((at_low > 0) == (at_high > 0) && (between > 0) == (at_low > 0)) {
        const double t_low = prism.t_at(terms, low);
        const double t_high = prism.t_at(terms, high);
        guess_first = t_low < t_high ? low : high;
        guess_last = t_low < t_high ? high : low;
        from = std::max(from, std::min(t_low, t_high));
        to = std::min(to, std::max(t_low, t_high));
    }
    if (!(from < to)) return std::nullopt;
    const auto repeat_of = [](std::int32_t first, int size) {
        return std::floor(static_cast<double>(first) / size) * size;
    };
    const glm::dvec2 repeat(repeat_of(piece.column, map_->width()), repeat_of(piece.row, map_->height()));

    int halvings = 0;
    const auto walk = [&](const auto& self, double begin, const Prism::Along& first, double end,
                          const Prism::Along& last) -> std::optional<WalkHit> {
        Span span(*map_, *maxima_, prism, terms, ray, repeat, begin, end - begin, first, last);
        Prism::Along middle;
        const double half_way = (begin + end) / 2;
        if (!prism.locate(ray, terms, half_way, (first.m + last.m) / 2, middle)) {
            ++counts.unresolved;
            return std::nullopt;
        }
        if (!span.is_close_to(middle)) {
            if (++halvings <= max_halvings) {
                if (const auto hit = self(self, begin, first, half_way, middle)) return hit;
                return self(self, half_way, middle, end, last);
            }
            ++counts.unresolved;
        }
        const auto hit = span.first_hit(piece, level_);
        counts.unresolved += span.unresolved();
        return hit;
    };
    Prism::Along first;
    Prism::Along last;
    if (!prism.locate(ray, terms, from, guess_first, first) || !prism.locate(ray, terms, to, guess_last, last)) {
        ++counts.unresolved;
        return std::nullopt;
    }
    return walk(walk, from, first, to, last);
}

}  // namespace reliefbench
