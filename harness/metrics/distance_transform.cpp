#include "metrics/distance_transform.hpp"

#include "core/parallel.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace reliefbench {

namespace {

/// Of each pixel, to the nearest one of `to` in its column; without any there, farther than all that an image has.
Image<std::int32_t> distances_in_columns(const Image<std::uint8_t>& to) {
    const auto [width, height] = to.size;
    Image<std::int32_t> distances(to.size);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::int32_t from_above = y == 0 ? width + height : distances.at(x, y - 1) + 1;
            distances.at(x, y) = to.at(x, y) != 0 ? 0 : std::min(from_above, width + height);
        }
    }
    for (int y = height - 2; y >= 0; --y) {
        for (int x = 0; x < width; ++x) {
            distances.at(x, y) = std::min(distances.at(x, y), distances.at(x, y + 1) + 1);
        }
    }
    return distances;
}

/// The lower envelope of the parabolas (x − i)² + columns[i]² over one row: from `begin` on `column` is the lowest.
struct EnvelopePart {
    std::int64_t column = 0;
    std::int64_t begin = 0;
};

std::int64_t parabola(std::int64_t x, std::int64_t column, const std::int32_t* columns) {
    const std::int64_t height = columns[column];
    return (x - column) * (x - column) + height * height;
}

void find_envelope(const std::int32_t* columns, std::int64_t width, std::vector<EnvelopePart>& parts) {
    parts.clear();
    for (std::int64_t column = 0; column < width; ++column) {
        while (!parts.empty() && parabola(parts.back().begin, parts.back().column, columns) >
                                     parabola(parts.back().begin, column, columns))
            parts.pop_back();
        if (parts.empty()) {
            parts.push_back({column, 0});
            continue;
        }
        // The first x at which the later one is the lower: where they cross, rounded down, and 1.
        const std::int64_t last = parts.back().column;
        const std::int64_t numerator = parabola(0, column, columns) - parabola(0, last, columns);
        const std::int64_t begin = numerator / (2 * (column - last)) + 1;
        if (begin < width) parts.push_back({column, begin});
    }
}

}  // namespace

/// After Meijster, Roerdink and Hesselink (2000), and Felzenszwalb and Huttenlocher (2012): columns, then rows, in
/// whole numbers.
std::vector<double> distances_between(const Image<std::uint8_t>& from, const Image<std::uint8_t>& to) {
    assert(from.size == to.size &&
           std::any_of(to.texels.begin(), to.texels.end(), [](std::uint8_t value) { return value != 0; }));
    constexpr std::size_t rows_at_once = 16;
    const auto width = static_cast<std::size_t>(from.size.width);
    const auto height = static_cast<std::size_t>(from.size.height);
    const Image<std::int32_t> in_columns = distances_in_columns(to);
    std::vector<std::size_t> first_of_row(height + 1, 0);
    for (std::size_t row = 0; row < height; ++row) {
        const auto begin = from.texels.begin() + static_cast<std::ptrdiff_t>(row * width);
        const auto zeros = std::count(begin, begin + static_cast<std::ptrdiff_t>(width), 0);
        first_of_row[row + 1] = first_of_row[row] + width - static_cast<std::size_t>(zeros);
    }
    std::vector<double> distances(first_of_row.back());
    parallel_for(height, rows_at_once, [&](std::size_t begin, std::size_t end) {
        std::vector<EnvelopePart> parts;
        for (std::size_t row = begin; row < end; ++row) {
            if (first_of_row[row] == first_of_row[row + 1]) continue;
            const std::int32_t* const columns = in_columns.texels.data() + row * width;
            find_envelope(columns, from.size.width, parts);
            std::size_t part = 0;
            std::size_t next = first_of_row[row];
            for (std::size_t x = 0; x < width; ++x) {
                if (from.texels[row * width + x] == 0) continue;
                const auto place = static_cast<std::int64_t>(x);
                while (part + 1 < parts.size() && parts[part + 1].begin <= place)
                    ++part;
                distances[next++] = std::sqrt(static_cast<double>(parabola(place, parts[part].column, columns)));
            }
        }
    });
    return distances;
}

}  // namespace reliefbench
