#include "scene/raster_limits.hpp"

#include "core/counted.hpp"
#include "core/error.hpp"
#include "core/memory.hpp"

#include <algorithm>
#include <cmath>

namespace reliefbench {

namespace {

/// The largest height map (16384²) with four channels; what claims more is a broken header or a mistake.
constexpr double largest_value_count = 16384.0 * 16384.0 * 4.0;

}  // namespace

void check_raster_size(const std::filesystem::path& path, int width, int height, int channels) {
    if (width <= 0 || height <= 0 || channels <= 0) {
        fail("image '{}' has no pixels ({}x{}, {} channels): give one that has", path.string(), width, height,
             channels);
    }
    if (double(width) * double(height) * double(channels) > largest_value_count) {
        fail("image '{}' claims {}x{} pixels of {}, more than can be read: scale it down", path.string(), width, height,
             counted(static_cast<std::size_t>(channels), "channel"));
    }
}

void check_raster_memory(const std::filesystem::path& path, const RasterFile& header, Resolution decoded) {
    const std::uint64_t pixels = std::max(header.size.pixels(), decoded.pixels());
    const std::uint64_t values = pixels * header.channel_names.size();
    const std::uint64_t needed = values * (sizeof(float) + static_cast<std::uint64_t>(header.bits) / 8);
    const std::uint64_t available = available_memory();
    if (needed <= available) return;
    fail("image '{}' of {}x{} pixels and {} takes {} to read, and {} is available: scale it down", path.string(),
         header.size.width, header.size.height, counted(header.channel_names.size(), "channel"), memory_text(needed),
         memory_text(available));
}

void check_png_channels(const std::filesystem::path& path, int channels) {
    if (channels < 1 || channels > 4) {
        fail("cannot write image '{}': PNG takes one to four channels, not {}; use .exr", path.string(), channels);
    }
}

std::vector<std::uint8_t> to_bytes(const std::vector<float>& values) {
    std::vector<std::uint8_t> bytes(values.size());
    std::transform(values.begin(), values.end(), bytes.begin(), [](float value) {
        const float clamped = std::isnan(value) ? 0.0f : std::clamp(value, 0.0f, 1.0f);
        return static_cast<std::uint8_t>(std::lround(clamped * 255.0f));
    });
    return bytes;
}

}  // namespace reliefbench
