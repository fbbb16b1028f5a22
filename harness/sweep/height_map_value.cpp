#include "sweep/height_map_value.hpp"

#include "core/number_text.hpp"
#include "core/suggest.hpp"
#include "scene/procedural.hpp"
#include "sweep/input_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace reliefbench {

namespace {

constexpr int largest_channel = 1023;

template <typename Value>
struct NamedValue {
    const char* name;
    Value value;
};

const std::vector<NamedValue<RawLayout::SampleType>> sample_types{{"uint8", RawLayout::SampleType::uint8},
                                                                  {"uint16", RawLayout::SampleType::uint16},
                                                                  {"int16", RawLayout::SampleType::int16},
                                                                  {"float32", RawLayout::SampleType::float32}};
/// Whether the most significant byte comes first.
const std::vector<NamedValue<bool>> byte_orders{{"little", false}, {"big", true}};
const std::vector<NamedValue<Packing>> packings{{"rg16", Packing::rg16}, {"rgb24", Packing::rgb24}};

template <typename Value>
const char* name_of(Value value, const std::vector<NamedValue<Value>>& choices) {
    return std::ranges::find(choices, value, &NamedValue<Value>::value)->name;
}

std::string base_name(const std::string& path) {
    return std::filesystem::path(path).filename().string();
}

std::optional<int> parse_side(std::string_view text) {
    const std::optional<int> side = whole_text_as<int>(text);
    return side && *side >= 1 && *side <= largest_side ? side : std::nullopt;
}

std::array<double, 2> read_height_range(const JsonView& view) {
    const std::vector<JsonView> ends = view.items();
    if (ends.size() != 2) view.fail_expected("[lowest, highest]");
    const std::array<double, 2> range{ends[0].number(), ends[1].number()};
    if (range[0] >= range[1]) view.fail_expected("two numbers, the first below the second");
    return range;
}

void refuse(const JsonView& view, const std::vector<std::string>& keys, std::string_view why) {
    for (const std::string& key : keys) {
        if (view.has(key)) view.at(key).fail_here(why);
    }
}

/// What belongs to files only, beside "size", which procedural maps have too.
const std::vector<std::string> file_keys{"part",   "channel",   "packing",      "sample_type", "byte_order",
                                         "invert", "normalize", "height_range", "nodata",      "fill"};

/// A name, or a number from 0.
std::string read_name_or_number(const JsonView& view) {
    if (view.json().is_number()) return std::to_string(view.integer(0, largest_channel));
    if (!view.json().is_string() || view.string().empty()) view.fail_expected("a name, or a number from 0");
    return view.string();
}

template <typename Value>
Value read_choice(const JsonView& view, const std::vector<NamedValue<Value>>& choices) {
    std::vector<std::string> names;
    for (const NamedValue<Value>& choice : choices) {
        if (view.json() == choice.name) return choice.value;
        names.push_back(choice.name);
    }
    view.fail_expected("one of " + join(names));
}

RawLayout read_raw_layout(const JsonView& view) {
    RawLayout layout;
    layout.size = read_resolution(view.at("size"));
    if (view.has("sample_type")) layout.sample_type = read_choice(view.at("sample_type"), sample_types);
    if (view.has("byte_order")) layout.big_endian = read_choice(view.at("byte_order"), byte_orders);
    refuse(view, {"part", "channel", "packing"}, "it applies to images, and \"size\" says that the file has no header");
    return layout;
}

void read_file_value(const JsonView& view, HeightMapSource& source) {
    if (view.has("size")) {
        source.raw = read_raw_layout(view);
    } else {
        refuse(view, {"sample_type", "byte_order"}, "it applies to files without a header: give their \"size\", too");
    }
    if (view.has("part")) source.part = read_name_or_number(view.at("part"));
    if (view.has("channel")) source.channel = read_name_or_number(view.at("channel"));
    if (view.has("packing")) {
        source.packing = read_choice(view.at("packing"), packings);
        refuse(view, {"channel"}, "packing says which channels are read");
    }
    if (view.has("invert")) source.invert = view.at("invert").boolean();
    if (view.has("normalize")) source.normalize = view.at("normalize").boolean();
    if (view.has("height_range")) source.height_range = read_height_range(view.at("height_range"));
    if (source.normalize && source.height_range) view.fail_here("give either normalize or height_range, not both");
    if (view.has("nodata")) source.nodata = view.at("nodata").number();
    if (view.has("fill")) source.fill = view.at("fill").number();
}

HeightMapValue read_height_map_object(const JsonView& view) {
    view.require_only(height_map_keys());
    if (view.has("name") == view.has("file")) {
        view.fail_here("give either \"name\", of a procedural map, or \"file\", of an image");
    }
    HeightMapValue value;
    if (view.has("name")) {
        value.source.name = view.at("name").string();
        if (!is_procedural(value.source.name)) {
            std::vector<std::string> known;
            for (const ProceduralMap& map : procedural_maps())
                known.push_back(map.name);
            view.at("name").fail_here(fmt::format("no procedural height map '{}'{}; known are {}", value.source.name,
                                                  did_you_mean(value.source.name, known), join(known)));
        }
        refuse(view, file_keys, "it applies to files only");
        value.has_own_size = view.has("size");
        if (value.has_own_size) value.source.size = read_resolution(view.at("size"));
        if (view.has("seed")) value.source.seed = static_cast<std::uint64_t>(view.at("seed").integer(0));
    } else {
        value.source.name = view.at("file").string();
        refuse(view, {"seed"}, "it applies to procedural height maps only");
        read_file_value(view, value.source);
    }
    if (view.has("albedo")) value.source.albedo = view.at("albedo").string();
    return value;
}

std::string resolve(const JsonView& view, const std::vector<std::filesystem::path>& folders, bool procedural_too) {
    if (!procedural_too) return resolve_input_path(view, folders);
    std::vector<std::string> known;
    for (const ProceduralMap& map : procedural_maps())
        known.push_back(map.name);
    return resolve_input_path(view, folders, "neither a procedural height map" + did_you_mean(view.string(), known),
                              "procedural are " + join(known));
}

}  // namespace

const std::vector<std::string>& height_map_keys() {
    static const std::vector<std::string> keys = [] {
        std::vector<std::string> all{"name", "file", "albedo", "size", "seed"};
        all.insert(all.end(), file_keys.begin(), file_keys.end());
        return all;
    }();
    return keys;
}

bool is_procedural(const std::string& name) {
    return std::ranges::find(procedural_maps(), name, &ProceduralMap::name) != procedural_maps().end();
}

HeightMapValue read_height_map_value(const JsonView& view) {
    if (view.json().is_object()) return read_height_map_object(view);
    if (!view.json().is_string() || view.string().empty()) {
        view.fail_expected("the name of a procedural height map, the path of an image file, or an object");
    }
    HeightMapValue value;
    value.source.name = view.string();
    return value;
}

Json resolve_height_map_paths(const JsonView& view, const std::vector<std::filesystem::path>& folders) {
    read_height_map_value(view);
    Json resolved = view.json();
    if (resolved.is_string()) {
        if (!is_procedural(view.string())) resolved = resolve(view, folders, true);
        return resolved;
    }
    for (const char* key : {"file", "albedo"}) {
        if (view.has(key)) resolved[key] = resolve(view.at(key), folders, false);
    }
    return resolved;
}

Json resolve_albedo_path(const JsonView& view, const std::vector<std::filesystem::path>& folders) {
    return view.json() == Json("none") ? view.json() : Json(resolve(view, folders, false));
}

std::string height_map_label(const HeightMapSource& source) {
    const HeightMapSource plain;
    std::string label = base_name(source.name);
    if (source.seed != plain.seed) label += fmt::format("+seed={}", source.seed);
    if (source.raw) {
        const RawLayout layout;
        label += "+size=" + to_string(source.raw->size);
        if (source.raw->sample_type != layout.sample_type)
            label += fmt::format("+sample_type={}", name_of(source.raw->sample_type, sample_types));
        if (source.raw->big_endian) label += "+byte_order=big";
    }
    if (!source.part.empty()) label += "+part=" + source.part;
    // The first is what a file without a choice has, and ids of version 0.1.0 leave it out.
    if (!source.channel.empty() && source.channel != "0") label += "+channel=" + source.channel;
    if (source.packing != plain.packing) label += fmt::format("+packing={}", name_of(source.packing, packings));
    if (source.invert) label += "+invert";
    if (source.normalize) label += "+normalize";
    if (source.height_range) {
        label += fmt::format("+height_range={}:{}", (*source.height_range)[0], (*source.height_range)[1]);
    }
    if (source.nodata) label += fmt::format("+nodata={}", *source.nodata);
    if (source.fill) label += fmt::format("+fill={}", *source.fill);
    if (!source.albedo.empty()) label += "+albedo=" + base_name(source.albedo);
    return label;
}

Resolution read_resolution(const JsonView& view) {
    if (view.json().is_number()) {
        const int side = static_cast<int>(view.integer(1, largest_side));
        return {side, side};
    }
    if (view.json().is_string()) {
        const std::string text = view.string();
        const std::size_t cross = text.find('x');
        const std::optional<int> width = parse_side(std::string_view(text).substr(0, cross));
        const std::optional<int> height =
            cross == std::string::npos ? width : parse_side(std::string_view(text).substr(cross + 1));
        if (width && height) return {*width, *height};
    }
    view.fail_expected(fmt::format("a size such as 256 or \"512x256\", each side from 1 to {}", largest_side));
}

std::string to_string(Resolution resolution) {
    return fmt::format("{}x{}", resolution.width, resolution.height);
}

}  // namespace reliefbench
