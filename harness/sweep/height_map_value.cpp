#include "sweep/height_map_value.hpp"

#include "core/number_text.hpp"
#include "core/suggest.hpp"
#include "scene/procedural.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace reliefbench {

namespace {

constexpr int largest_side = 16384;
constexpr int largest_channel = 1023;

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

/// What belongs to an image file only.
void read_mapping(const JsonView& view, HeightMapSource& source) {
    if (view.has("channel")) source.channel = static_cast<int>(view.at("channel").integer(0, largest_channel));
    if (view.has("invert")) source.invert = view.at("invert").boolean();
    if (view.has("normalize")) source.normalize = view.at("normalize").boolean();
    if (view.has("height_range")) source.height_range = read_height_range(view.at("height_range"));
    if (source.normalize && source.height_range) view.fail_here("give either normalize or height_range, not both");
}

void refuse(const JsonView& view, const std::vector<std::string>& keys, std::string_view why) {
    for (const std::string& key : keys) {
        if (view.has(key)) view.at(key).fail_here(why);
    }
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
        refuse(view, {"channel", "invert", "normalize", "height_range"}, "it applies to image files only");
        value.has_own_size = view.has("size");
        if (value.has_own_size) value.source.size = read_resolution(view.at("size"));
        if (view.has("seed")) value.source.seed = static_cast<std::uint64_t>(view.at("seed").integer(0));
    } else {
        value.source.name = view.at("file").string();
        refuse(view, {"size", "seed"}, "it applies to procedural height maps only");
        read_mapping(view, value.source);
    }
    if (view.has("albedo")) value.source.albedo = view.at("albedo").string();
    return value;
}

/// An absolute path, so that the value means the same file wherever the configuration is read again.
std::string resolve(const JsonView& view, const std::vector<std::filesystem::path>& folders, bool procedural_too) {
    const std::string name = view.string();
    for (const std::filesystem::path& folder : folders) {
        const std::filesystem::path candidate = std::filesystem::absolute(folder / name).lexically_normal();
        if (std::filesystem::is_regular_file(candidate)) return candidate.string();
    }
    std::vector<std::string> tried;
    for (const std::filesystem::path& folder : folders) {
        const std::string absolute = std::filesystem::weakly_canonical(folder).string();
        if (std::ranges::find(tried, absolute) == tried.end()) tried.push_back(absolute);
    }
    if (!procedural_too) view.fail_here(fmt::format("no file '{}' in {}", name, join(tried, " or ")));
    std::vector<std::string> known;
    for (const ProceduralMap& map : procedural_maps())
        known.push_back(map.name);
    view.fail_here(fmt::format("'{}' is neither a procedural height map{} nor a file in {}; procedural are {}", name,
                               did_you_mean(name, known), join(tried, " or "), join(known)));
}

}  // namespace

const std::vector<std::string>& height_map_keys() {
    static const std::vector<std::string> keys{"name",         "file",   "channel", "invert", "normalize",
                                               "height_range", "albedo", "size",    "seed"};
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

std::string height_map_label(const HeightMapSource& source) {
    const HeightMapSource plain;
    std::string label = base_name(source.name);
    if (source.seed != plain.seed) label += fmt::format("+seed={}", source.seed);
    if (source.channel != plain.channel) label += fmt::format("+channel={}", source.channel);
    if (source.invert) label += "+invert";
    if (source.normalize) label += "+normalize";
    if (source.height_range) {
        label += fmt::format("+height_range={}:{}", (*source.height_range)[0], (*source.height_range)[1]);
    }
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
