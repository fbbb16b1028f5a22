#include "report/sparkline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reliefbench {

namespace {

constexpr const char* blocks[] = {"▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
constexpr std::size_t highest_block = std::size(blocks) - 1;
constexpr const char* missing = "·";
constexpr const char* mark = "│";
/// Greatest / least value that the scale spans at least.
constexpr double min_span = 1.2;

bool is_drawn(const std::optional<double>& value) {
    return value && std::isfinite(*value) && *value > 0;
}

}  // namespace

std::string sparkline(std::span<const std::optional<double>> values, std::span<const std::size_t> marks) {
    double least = std::numeric_limits<double>::infinity();
    double greatest = 0;
    for (const std::optional<double>& value : values) {
        if (!is_drawn(value)) continue;
        least = std::min(least, *value);
        greatest = std::max(greatest, *value);
    }
    std::string line;
    for (std::size_t index = 0; index < values.size(); ++index) {
        if (std::find(marks.begin(), marks.end(), index) != marks.end()) line += mark;
        if (!is_drawn(values[index])) {
            line += missing;
            continue;
        }
        const double span = std::log(std::max(greatest / least, min_span));
        const double height = std::log(*values[index] / least) / span * static_cast<double>(highest_block);
        line += blocks[std::min(highest_block, static_cast<std::size_t>(std::lround(height)))];
    }
    return line;
}

}  // namespace reliefbench
