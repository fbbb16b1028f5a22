#include "scene/raster_file.hpp"

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/suggest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace reliefbench {

namespace {

/// "0 'beauty'", "1".
std::string part_text(std::size_t number, const std::string& name) {
    return name.empty() ? fmt::format("{}", number) : fmt::format("{} '{}'", number, name);
}

}  // namespace

double RasterFile::fraction(std::size_t index) const {
    const double share = values[index] / full_scale;
    return zero_is_white && index % channel_names.size() == 0 ? 1 - share : share;
}

RasterFile with_channels(const RasterFile& raster, const std::vector<std::size_t>& channels) {
    RasterFile picked = raster;
    picked.channel_names.clear();
    for (const std::size_t channel : channels)
        picked.channel_names.push_back(raster.channel_names.at(channel));
    picked.zero_is_white = raster.zero_is_white && channels.front() == 0;
    if (raster.values.empty()) return picked;
    picked.values.resize(raster.size.pixels() * channels.size());
    auto target = picked.values.begin();
    for (std::size_t pixel = 0; pixel < raster.size.pixels(); ++pixel) {
        for (const std::size_t channel : channels)
            *target++ = raster.values[pixel * raster.channel_names.size() + channel];
    }
    return picked;
}

RasterFile oriented(RasterFile raster, int orientation) {
    if (orientation < 2 || orientation > 8) return raster;
    raster.notes.push_back(fmt::format("orientation {}", orientation));
    const bool transposed = orientation >= 5;
    const bool right_to_left = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
    const bool bottom_up = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
    const Resolution stored = raster.size;
    if (transposed) std::swap(raster.size.width, raster.size.height);
    if (raster.values.empty()) return raster;

    const auto channels = raster.channel_names.size();
    const std::vector<float> before = std::exchange(raster.values, std::vector<float>(raster.values.size()));
    auto target = raster.values.begin();
    for (int y = 0; y < raster.size.height; ++y) {
        for (int x = 0; x < raster.size.width; ++x) {
            int column = transposed ? y : x;
            int row = transposed ? x : y;
            if (right_to_left) column = stored.width - 1 - column;
            if (bottom_up) row = stored.height - 1 - row;
            const std::size_t from = static_cast<std::size_t>(row) * static_cast<std::size_t>(stored.width) +
                                     static_cast<std::size_t>(column);
            target = std::copy_n(before.begin() + static_cast<std::ptrdiff_t>(from * channels), channels, target);
        }
    }
    return raster;
}

void check_single_part(const std::filesystem::path& path, const std::string& part) {
    if (!part.empty()) chosen_part(path, part, {""}, {0});
}

std::size_t chosen_part(const std::filesystem::path& path, const std::string& part,
                        const std::vector<std::string>& names, const std::vector<std::size_t>& pictures) {
    std::vector<std::string> known;
    for (std::size_t number = 0; number < names.size(); ++number)
        known.push_back(part_text(number, names[number]));
    if (part.empty()) {
        if (pictures.size() == 1) return pictures.front();
        fail("image '{}' has {} parts ({}): choose one with \"part\", by name or number", path.string(), names.size(),
             join(known));
    }
    if (const auto named = std::ranges::find(names, part); named != names.end()) {
        return static_cast<std::size_t>(named - names.begin());
    }
    const auto number = whole_text_as<std::size_t>(part);
    if (number && *number < names.size()) return *number;
    std::vector<std::string> named_parts;
    std::ranges::copy_if(names, std::back_inserter(named_parts), [](const std::string& name) { return !name.empty(); });
    fail("image '{}' has no part '{}'{}: it has {}", path.string(), part, did_you_mean(part, named_parts),
         known.size() == 1 ? "one only, 0" : join(known));
}

}  // namespace reliefbench
