#pragma once

#include "scene/image.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace reliefbench {

/// The format that the GPU samples. Heights are quantised to it before anything reads them, the CPU included.
enum class HeightFormat { r8, r16, r32f };

std::string to_string(HeightFormat format);
std::optional<HeightFormat> parse_height_format(const std::string& name);

/// The value that the format stores for `height` in [0, 1]: k/255, k/65535, or the float itself.
float quantise(double height, HeightFormat format);

/// Where a height map comes from and how its values become heights. Plain data: nothing is loaded.
struct HeightMapSource {
    /// A procedural map's name (see procedural.hpp), or the path of an image file.
    std::string name;
    /// Procedural maps only.
    Resolution size{256, 256};
    std::uint64_t seed = 1;
    /// Image files only. The channel by index; white = deep when inverted.
    int channel = 0;
    bool invert = false;
    /// Stretches the smallest value to 0 and the largest to 1.
    bool normalize = false;
    /// Maps [first, second] to [0, 1]; values outside are clamped. Not together with `normalize`.
    std::optional<std::array<double, 2>> height_range;
    /// An albedo image of any size; values are taken as sRGB. Empty: the default albedo (see albedo.hpp).
    std::string albedo;

    bool operator==(const HeightMapSource&) const = default;
};

/// A square-cornered grid of heights in [0, 1], bilinear between texel centres, repeating.
/// Row 0 is v = 0, the *bottom* row of an image file. Texel (i, j) has its centre at ((i+½)/width, (j+½)/height).
struct HeightMap {
    Image<float> heights;
    HeightFormat format = HeightFormat::r16;
    /// Procedural name or file name without folders: part of a cell's id.
    std::string name;
    /// Content hash of size, format and heights.
    std::string hash;
    /// What was done to the values, for the record: "as stored", "inverted", "[0.1, 0.8] → [0, 1]", ...
    std::string mapping;
    /// All heights are equal: allowed, and a warning.
    bool constant = false;

    int width() const { return heights.size.width; }
    int height() const { return heights.size.height; }

    /// Height of a texel; indices repeat.
    float texel(std::int64_t x, std::int64_t y) const;
    /// Bilinear height at texture coordinates (any real numbers; repeating).
    double sample(double u, double v) const;
};

/// Loads or generates, maps, checks and quantises. Errors: an unknown name (with what is known), a file that cannot be
/// read, no such channel, NaN or infinite values, values outside [0, 1] that nothing maps, a size of zero or more than
/// 16384 on a side.
HeightMap load_height_map(const HeightMapSource& source, HeightFormat format);

/// Without loading it: what the source says, or its file's header.
Resolution height_map_size(const HeightMapSource& source);

/// A height map from numbers already at hand (row 0 is v = 0), quantised; values must lie in [0, 1].
HeightMap make_height_map(const Image<float>& heights, HeightFormat format, std::string name);

/// ∂h/∂(texture coordinate) at texel centres by central differences of the quantised heights, repeating:
/// ((h[i+1] − h[i−1])·width/2, (h[j+1] − h[j−1])·height/2). Interleaved pairs, as the GPU's derivative texture.
Image<std::array<float, 2>> height_derivatives(const HeightMap& map);

}  // namespace reliefbench
