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

/// Numbers of a file without a header: one for each texel, rows from the top.
struct RawLayout {
    enum class SampleType { uint8, uint16, int16, float32 };

    Resolution size;
    SampleType sample_type = SampleType::uint16;
    bool big_endian = false;

    bool operator==(const RawLayout&) const = default;
};

/// One number of several channels of 8 bits, the first channel its highest byte: R·256 + G, (R·256 + G)·256 + B.
enum class Packing { none, rg16, rgb24 };

/// Where a height map comes from and how its values become heights (docs/height_maps.md). Plain data: nothing is
/// loaded.
struct HeightMapSource {
    /// A procedural map's name (see procedural.hpp), or the path of an image file.
    std::string name;
    /// Procedural maps only.
    Resolution size{256, 256};
    std::uint64_t seed = 1;
    /// What follows is for files only, and in the file's own numbers.
    /// Set: the file has no header.
    std::optional<RawLayout> raw;
    /// An OpenEXR part or TIFF page by name or number; empty: the only one.
    std::string part;
    /// By name or number from 0; empty: the only one, or the first of a picture in one colour model.
    std::string channel;
    Packing packing = Packing::none;
    /// White is deep.
    bool invert = false;
    /// Stretches the smallest value to 0 and the largest to 1.
    bool normalize = false;
    /// Maps [first, second] to [0, 1]; values outside are clamped. Not together with `normalize`.
    std::optional<std::array<double, 2>> height_range;
    /// The value of texels of which nothing is known, beside NaN; empty: what the file says (GDAL_NODATA).
    std::optional<double> nodata;
    /// The value that such texels get. Empty: a map that has any is an Error.
    std::optional<double> fill;
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
/// read, no such part or channel or several to choose from, texels without data that nothing fills, infinite values,
/// values outside [0, full scale] that nothing maps, a height_range that no value lies in, a size of zero or more than
/// 16384 on a side.
HeightMap load_height_map(const HeightMapSource& source, HeightFormat format);

/// Without loading it: what the source says, or its file's header. Errors as far as that tells.
Resolution height_map_size(const HeightMapSource& source);

/// A height map from numbers already at hand (row 0 is v = 0), quantised; values must lie in [0, 1].
HeightMap make_height_map(const Image<float>& heights, HeightFormat format, std::string name);

/// ∂h/∂(texture coordinate) at texel centres by central differences of the quantised heights, repeating:
/// ((h[i+1] − h[i−1])·width/2, (h[j+1] − h[j−1])·height/2). Interleaved pairs, as the GPU's derivative texture.
Image<std::array<float, 2>> height_derivatives(const HeightMap& map);

}  // namespace reliefbench
