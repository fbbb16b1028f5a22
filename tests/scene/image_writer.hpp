#pragma once

#include "scene/image.hpp"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <type_traits>
#include <vector>

namespace reliefbench {

/// Writes stored numbers (rows from the top, channels interleaved) with OpenImageIO itself, so that reading is not
/// checked against our own writing.
template <typename Value>
void write_with_openimageio(const std::filesystem::path& path, Resolution size, int channels,
                            const std::vector<Value>& values) {
    constexpr auto type = std::is_same_v<Value, std::uint8_t>    ? OIIO::TypeDesc::UINT8
                          : std::is_same_v<Value, std::uint16_t> ? OIIO::TypeDesc::UINT16
                                                                 : OIIO::TypeDesc::FLOAT;
    static_assert(type != OIIO::TypeDesc::FLOAT || std::is_same_v<Value, float>);
    ASSERT_EQ(values.size(), size.pixels() * channels);
    OIIO::ImageSpec spec(size.width, size.height, channels, type);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    const auto output = OIIO::ImageOutput::create(path.string());
    ASSERT_TRUE(output);
    ASSERT_TRUE(output->open(path.string(), spec));
    ASSERT_TRUE(output->write_image(type, values.data()));
    ASSERT_TRUE(output->close());
}

/// Pixels as OpenImageIO itself reads them, which read_raster_file does not for every format.
inline std::vector<float> read_with_openimageio(const std::filesystem::path& path) {
    const auto input = OIIO::ImageInput::open(path.string());
    if (!input) return {};
    const OIIO::ImageSpec& spec = input->spec();
    std::vector<float> values(static_cast<std::size_t>(spec.width) * spec.height * spec.nchannels);
    return input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, values.data()) ? values
                                                                                            : std::vector<float>{};
}

}  // namespace reliefbench
