#include "scene/stored_heights.hpp"

#include "core/error.hpp"
#include "core/log.hpp"
#include "core/number_text.hpp"
#include "core/suggest.hpp"
#include "scene/image_file.hpp"
#include "scene/raw_heights.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace reliefbench {

namespace {

using ChannelNumbers = std::vector<std::size_t>;

/// "R, G, B", and of many the first.
std::string channel_list(const std::vector<std::string>& names) {
    constexpr std::size_t most = 24;
    if (names.size() <= most) return join(names);
    const std::vector<std::string> first(names.begin(), names.begin() + most);
    return fmt::format("{} and {} more", join(first), names.size() - most);
}

std::size_t channel_by_text(const HeightMapSource& source, const std::vector<std::string>& names) {
    if (const auto named = std::ranges::find(names, source.channel); named != names.end()) {
        return static_cast<std::size_t>(named - names.begin());
    }
    const auto number = whole_text_as<std::size_t>(source.channel);
    if (number && *number < names.size()) return *number;
    fail("height map '{}' has no channel {}{}: it has {} ({}), counted from 0", source.name, source.channel,
         number ? "" : did_you_mean(source.channel, names), names.size(), channel_list(names));
}

bool is_one_colour_model(const std::vector<std::string>& names) {
    const auto are_of = [&](std::initializer_list<const char*> model) {
        return std::ranges::all_of(
            names, [&](const std::string& name) { return std::ranges::find(model, name) != model.end(); });
    };
    return are_of({"Y", "A"}) || are_of({"R", "G", "B", "A"});
}

ChannelNumbers packed_channels(const HeightMapSource& source, const RasterFile& header) {
    const std::vector<std::string> wanted =
        source.packing == Packing::rg16 ? std::vector<std::string>{"R", "G"} : std::vector<std::string>{"R", "G", "B"};
    ChannelNumbers channels;
    for (const std::string& name : wanted) {
        const auto found = std::ranges::find(header.channel_names, name);
        if (found != header.channel_names.end())
            channels.push_back(static_cast<std::size_t>(found - header.channel_names.begin()));
    }
    constexpr double byte = 255;
    if (channels.size() != wanted.size() || header.full_scale != byte) {
        fail("height map '{}' of channels {} up to {}: packing takes {} of 8 bits", source.name,
             channel_list(header.channel_names), header.full_scale, join(wanted));
    }
    return channels;
}

/// The first is the height's; of a colour picture that nothing else is said of, the other colours stand behind it.
ChannelNumbers chosen_channels(const HeightMapSource& source, const RasterFile& header) {
    const std::vector<std::string>& names = header.channel_names;
    if (source.packing != Packing::none) return packed_channels(source, header);
    if (!source.channel.empty()) return {channel_by_text(source, names)};
    if (names.size() == 1) return {0};
    if (!is_one_colour_model(names)) {
        fail("height map '{}' has {} channels ({}): choose one with \"channel\", by name or number", source.name,
             names.size(), channel_list(names));
    }
    ChannelNumbers channels;
    for (std::size_t channel = 0; channel < names.size(); ++channel) {
        if (names[channel] != "A") channels.push_back(channel);
    }
    return channels;
}

RasterFile stored_header(const HeightMapSource& source) {
    return source.raw ? read_raw_header(source.name, *source.raw) : read_raster_header(source.name, source.part);
}

/// Of colours that are read together. What a lossy format makes of grey is grey still.
bool is_grey(const RasterFile& raster) {
    constexpr double tolerance = 1.0 / 32;
    const auto channels = static_cast<std::size_t>(raster.channels());
    double largest = 0;
    double difference = 0;
    for (std::size_t index = 0; index < raster.values.size(); ++index) {
        const double value = raster.values[index];
        const double first = raster.values[index / channels * channels];
        if (!std::isfinite(value) || !std::isfinite(first)) continue;
        largest = std::max(largest, std::abs(value));
        difference = std::max(difference, std::abs(value - first));
    }
    return difference <= tolerance * largest;
}

/// Bottom row first, one number of the channels of each pixel.
Image<float> bottom_up(const RasterFile& raster, Packing packing) {
    Image<float> values(raster.size);
    const auto channels = static_cast<std::size_t>(raster.channels());
    for (int y = 0; y < raster.size.height; ++y) {
        const auto row = static_cast<std::size_t>(raster.size.height - 1 - y) * raster.size.width;
        for (int x = 0; x < raster.size.width; ++x) {
            const float* const pixel = raster.values.data() + (row + x) * channels;
            float value = *pixel;
            if (packing != Packing::none) {
                for (std::size_t channel = 1; channel < channels; ++channel)
                    value = value * 256 + pixel[channel];
            }
            values.at(x, y) = value;
        }
    }
    return values;
}

void add_channel_note(const HeightMapSource& source, const RasterFile& header, const ChannelNumbers& channels,
                      std::vector<std::string>& notes) {
    if (source.packing != Packing::none) {
        notes.push_back(source.packing == Packing::rg16 ? "packed rg16" : "packed rgb24");
    } else if (header.channels() > 1) {
        notes.push_back("channel " + header.channel_names[channels.front()]);
    }
}

}  // namespace

StoredHeights read_stored_heights(const HeightMapSource& source) {
    const RasterFile header = stored_header(source);
    const ChannelNumbers channels = chosen_channels(source, header);
    const RasterFile raster = source.raw ? read_raw_heights(source.name, *source.raw)
                                         : read_raster_file(source.name, {source.part, channels});
    StoredHeights heights;
    heights.full_scale = raster.full_scale;
    heights.zero_is_white = raster.zero_is_white;
    heights.nodata = raster.nodata;
    heights.unread_nodata = raster.unread_nodata;
    heights.notes = raster.notes;
    if (source.packing != Packing::none) {
        heights.full_scale = std::exp2(8.0 * static_cast<double>(channels.size())) - 1;
    } else if (raster.channels() > 1 && !is_grey(raster)) {
        log_warning(
            "height map '{}' is a colour picture: {} is taken for the height; name a \"channel\" to say that this is "
            "meant",
            source.name, raster.channel_names.front());
    }
    heights.values = bottom_up(raster, source.packing);
    add_channel_note(source, header, channels, heights.notes);
    return heights;
}

Resolution stored_heights_size(const HeightMapSource& source) {
    const RasterFile header = stored_header(source);
    chosen_channels(source, header);
    return header.size;
}

}  // namespace reliefbench
