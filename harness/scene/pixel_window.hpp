#pragma once

#include "scene/image.hpp"

#include <cstddef>
#include <filesystem>
#include <vector>

namespace reliefbench {

/// A rectangle of pixels of a plane that has no other limits.
struct PixelWindow {
    int left = 0;
    int top = 0;
    Resolution size;

    bool operator==(const PixelWindow&) const = default;
};

/// Of an OpenEXR file's data window (where there are numbers), what its display window (the picture) shows: what lies
/// beyond it is left out, and where there are none they are 0, with a warning. Interleaved channels. Throws Error where
/// the windows have no pixel in common.
std::vector<float> in_display_window(const std::vector<float>& values, const PixelWindow& data,
                                     const PixelWindow& display, std::size_t channels,
                                     const std::filesystem::path& path);

}  // namespace reliefbench
