#include "reference/relief_pieces.hpp"

#include "core/parallel.hpp"
#include "reference/texel_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reliefbench {

namespace {

/// Slack of the heights that bound a piece, in h: rays start above what they may hit.
constexpr double height_slack = 1e-6;
/// |M| below which nothing is expected of the normals between the corners; such prisms are folded.
constexpr double min_normal_length = 0.05;

struct HeightRange {
    double low = 0;
    double high = 1;
};

class Splitter {
public:
    Splitter(const TexelScale& scale, const HeightMap& map, const MaximumMipChain& maxima,
             const MaximumMipChain& minima, double margin, int level)
        : scale_(scale), map_(map), maxima_(maxima), minima_(minima), margin_(margin), level_(level) {}

    void split(const Prism& prism, std::uint32_t triangle, ReliefPieces& pieces) const {
        if (!prism.has_area()) return;
        const TexelRect bounds = texel_bounds(prism);
        for_blocks(bounds.low.y, bounds.high.y, map_.height(), [&](std::int64_t row, std::int64_t next_row) {
            for_blocks(bounds.low.x, bounds.high.x, map_.width(), [&](std::int64_t column, std::int64_t next_column) {
                const glm::dvec2 low(static_cast<double>(column), static_cast<double>(row));
                const glm::dvec2 high(static_cast<double>(next_column), static_cast<double>(next_row));
                const TexelRect rect{low - piece_overlap, high + piece_overlap};
                const TexelPolygon polygon = triangle_in_rect(prism, rect);
                if (polygon.count < 3) return;
                add(prism, polygon, {triangle, static_cast<std::int32_t>(column), static_cast<std::int32_t>(row), 0, 0},
                    pieces);
            });
        });
    }

private:
    /// Calls body(first, next) for each block of cells along one side that [low, high] meets: blocks begin anew with
    /// each repeat of the map.
    template <typename Body>
    void for_blocks(double low, double high, std::int64_t size, const Body& body) const {
        const auto first_cell = static_cast<std::int64_t>(std::floor(low));
        std::int64_t repeat = first_cell / size * size;
        if (repeat > first_cell) repeat -= size;
        std::int64_t block = repeat + ((first_cell - repeat) >> level_ << level_);
        while (static_cast<double>(block) < high) {
            const std::int64_t next = std::min(block + (std::int64_t{1} << level_), repeat + size);
            body(block, next);
            block = next;
            if (block == repeat + size) repeat = block;
        }
    }

    HeightRange range_of(const ReliefPiece& piece) const {
        const auto wrapped = [](std::int64_t index, int size) {
            return static_cast<int>(((index % size) + size) % size);
        };
        if (level_ > 0) {
            const int column = wrapped(piece.column, map_.width()) >> level_;
            const int row = wrapped(piece.row, map_.height()) >> level_;
            return {-static_cast<double>(minima_.at(level_, column, row)),
                    static_cast<double>(maxima_.at(level_, column, row))};
        }
        const float a = map_.texel(piece.column, piece.row);
        const float b = map_.texel(std::int64_t{piece.column} + 1, piece.row);
        const float c = map_.texel(piece.column, std::int64_t{piece.row} + 1);
        const float d = map_.texel(std::int64_t{piece.column} + 1, std::int64_t{piece.row} + 1);
        return {static_cast<double>(std::min({a, b, c, d})), static_cast<double>(std::max({a, b, c, d}))};
    }

    void add(const Prism& prism, const TexelPolygon& polygon, ReliefPiece piece, ReliefPieces& pieces) const {
        std::array<glm::dvec3, TexelPolygon::max_corners> feet;
        std::array<glm::dvec3, TexelPolygon::max_corners> normals;
        glm::dvec3 sum(0.0);
        double longest = 0;
        for (std::size_t index = 0; index < polygon.count; ++index) {
            const glm::dvec2 barycentric = prism.barycentric(polygon.corners[index]);
            feet[index] = prism.foot(barycentric);
            normals[index] = prism.linear_normal(barycentric);
            sum += normals[index];
            longest = std::max(longest, glm::length(normals[index]));
        }
        // |M| between the corners is no less than the least along any direction.
        const glm::dvec3 direction = glm::normalize(sum);
        double shortest = longest;
        for (std::size_t index = 0; index < polygon.count; ++index)
            shortest = std::min(shortest, glm::dot(normals[index], direction));
        if (!(shortest >= min_normal_length)) shortest = min_normal_length;
        const HeightRange range = range_of(piece);
        const double above_floor = range.low - height_slack;
        const double below_top = 1 - range.high - height_slack;
        const double lowest = (above_floor - 1) * scale_.height_scale / shortest;
        const double highest = -below_top * scale_.height_scale / (below_top > 0 ? longest : shortest);
        constexpr float beyond = std::numeric_limits<float>::infinity();
        piece.lowest = std::nextafter(static_cast<float>(lowest), -beyond);
        piece.highest = std::nextafter(static_cast<float>(highest), beyond);
        glm::dvec3 low(static_cast<double>(beyond));
        glm::dvec3 high(-static_cast<double>(beyond));
        for (std::size_t index = 0; index < polygon.count; ++index) {
            for (const double m : {static_cast<double>(piece.lowest), static_cast<double>(piece.highest)}) {
                const glm::dvec3 point = feet[index] + m * normals[index];
                low = glm::min(low, point);
                high = glm::max(high, point);
            }
        }
        Box box{};
        for (int axis = 0; axis < 3; ++axis) {
            const auto member = static_cast<std::size_t>(axis);
            box.low[member] = std::nextafter(static_cast<float>(low[axis] - margin_), -beyond);
            box.high[member] = std::nextafter(static_cast<float>(high[axis] + margin_), beyond);
        }
        pieces.pieces.push_back(piece);
        pieces.boxes.push_back(box);
    }

    TexelScale scale_;
    const HeightMap& map_;
    const MaximumMipChain& maxima_;
    const MaximumMipChain& minima_;
    double margin_;
    int level_;
};

double count_pieces(const std::vector<Prism>& prisms, int level) {
    const double side = std::ldexp(1.0, level);
    double count = 0;
    for (const Prism& prism : prisms) {
        const TexelRect bounds = texel_bounds(prism);
        const glm::dvec2 blocks = (bounds.high - bounds.low) / side;
        // Half of the rectangle's, and what its sides cut.
        count += 1 + blocks.x * blocks.y / 2 + blocks.x + blocks.y;
    }
    return count;
}

}  // namespace

ReliefPieces split_relief(const std::vector<Prism>& prisms, const TexelScale& scale, const HeightMap& map,
                          const MaximumMipChain& maxima, const MaximumMipChain& minima, double margin,
                          double max_pieces) {
    int level = 0;
    while (level < maxima.top_level() && count_pieces(prisms, level) > max_pieces)
        ++level;
    const Splitter splitter(scale, map, maxima, minima, margin, level);
    constexpr std::size_t triangles_per_task = 256;
    const std::size_t tasks = (prisms.size() + triangles_per_task - 1) / triangles_per_task;
    std::vector<ReliefPieces> parts(tasks);
    parallel_for(prisms.size(), triangles_per_task, [&](std::size_t begin, std::size_t end) {
        for (std::size_t triangle = begin; triangle < end; ++triangle)
            splitter.split(prisms[triangle], static_cast<std::uint32_t>(triangle), parts[begin / triangles_per_task]);
    });
    ReliefPieces all;
    all.level = level;
    std::size_t count = 0;
    for (const ReliefPieces& part : parts)
        count += part.pieces.size();
    all.pieces.reserve(count);
    all.boxes.reserve(count);
    for (ReliefPieces& part : parts) {
        all.pieces.insert(all.pieces.end(), part.pieces.begin(), part.pieces.end());
        all.boxes.insert(all.boxes.end(), part.boxes.begin(), part.boxes.end());
        part = {};
    }
    return all;
}

}  // namespace reliefbench
