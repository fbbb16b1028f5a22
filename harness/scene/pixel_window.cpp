#include "scene/pixel_window.hpp"

#include "core/error.hpp"
#include "core/log.hpp"

#include <algorithm>
#include <cstdint>

namespace reliefbench {

namespace {

/// First pixel and the one past the last that both have.
struct Overlap {
    std::int64_t begin;
    std::int64_t end;
};

Overlap overlap(std::int64_t a, int a_length, std::int64_t b, int b_length) {
    return {std::max(a, b), std::min(a + a_length, b + b_length)};
}

}  // namespace

std::vector<float> in_display_window(const std::vector<float>& values, const PixelWindow& data,
                                     const PixelWindow& display, std::size_t channels,
                                     const std::filesystem::path& path) {
    const Overlap columns = overlap(data.left, data.size.width, display.left, display.size.width);
    const Overlap rows = overlap(data.top, data.size.height, display.top, display.size.height);
    if (columns.begin >= columns.end || rows.begin >= rows.end) {
        fail("cannot read image '{}': its data window lies outside its display window", path.string());
    }
    const auto width = static_cast<std::size_t>(columns.end - columns.begin);
    const std::size_t covered = width * static_cast<std::size_t>(rows.end - rows.begin);
    if (covered < display.size.pixels()) {
        log_warning("image '{}': its data window has {} of the {} pixels of its display window; the others are 0",
                    path.string(), covered, display.size.pixels());
    }
    std::vector<float> shown(display.size.pixels() * channels);
    const auto place = [&](const PixelWindow& window, std::int64_t row) {
        const std::int64_t pixel = (row - window.top) * window.size.width + (columns.begin - window.left);
        return pixel * static_cast<std::int64_t>(channels);
    };
    for (std::int64_t row = rows.begin; row < rows.end; ++row)
        std::copy_n(values.begin() + place(data, row), width * channels, shown.begin() + place(display, row));
    return shown;
}

}  // namespace reliefbench
