#include "core/error.hpp"
#include "core/suggest.hpp"
#include "manifest/included_sets.hpp"
#include "manifest/manifest.hpp"
#include "manifest/parse_names.hpp"
#include "manifest/parse_parameter.hpp"
#include "manifest/shader_names.hpp"
#include "manifest/words.hpp"

#include <algorithm>
#include <limits>
#include <set>

namespace reliefbench {

namespace {

/// What every Vulkan device must offer is 256; no device has more than this.
constexpr std::int64_t max_slices = 16384;
/// Some devices end all loops of an invocation together after 65,535.
constexpr std::int64_t max_slice_iterations = 32768;

/// The enumerators' words, in the order of the enumeration.
const std::vector<std::string> promises{"first_hit", "order_1", "order_2", "conservative"};
const std::vector<std::string> map_sizes{"height_map", "next_power_of_two"};
const std::vector<std::string> pass_levels{"base", "above_base"};
const std::vector<std::string> map_need_words{"square", "power_of_two", "untiled"};
const std::vector<std::string> slicings{"sources", "rows"};
const std::vector<std::string> shadow_searches{"own", "uniform_layers"};

const std::vector<std::string> kinds = words("texture parallax march hierarchy cone geometry");
const std::vector<std::string> map_formats{"r8", "r16", "rg16", "r32f", "rg32f", "rgba8", "rgba16", "rgba32f"};

std::string parse_sample_count_name(const JsonView& view, const Manifest& manifest) {
    const std::string name = parse_integer_name(view, manifest);
    if (manifest.find_parameter(name)->minimum < 1) {
        view.fail_here(fmt::format("the range of '{}' must begin at 1 or above, as it is a number of samples", name));
    }
    return name;
}

/// A name or several of them.
std::vector<std::string> parse_search_cap(const JsonView& view, const Manifest& manifest) {
    if (!view.json().is_array()) return {parse_integer_name(view, manifest)};
    std::vector<std::string> names;
    for (const JsonView& item : view.items()) {
        names.push_back(parse_integer_name(item, manifest));
        if (std::ranges::count(names, names.back()) > 1)
            item.fail_here(fmt::format("the parameter '{}' is given twice", names.back()));
    }
    return names;
}

std::vector<std::string> parse_features(const JsonView& view, const std::vector<std::string>& known) {
    std::vector<std::string> features;
    for (const JsonView& item : view.items()) {
        const std::string feature = known.empty() ? item.string() : known[item.choice(known)];
        if (std::ranges::find(features, feature) != features.end())
            item.fail_here(fmt::format("the feature '{}' is given twice", feature));
        features.push_back(feature);
    }
    return features;
}

std::vector<MapNeed> parse_needs(const JsonView& view) {
    view.require_only({"map"});
    std::vector<MapNeed> needs;
    for (const JsonView& item : view.at("map").items()) {
        const auto need = static_cast<MapNeed>(item.choice(map_need_words));
        if (std::ranges::find(needs, need) != needs.end())
            item.fail_here(fmt::format("'{}' is given twice", to_string(need)));
        needs.push_back(need);
    }
    return needs;
}

void parse_depth(const JsonView& view, const Manifest& manifest, MapDeclaration& map) {
    if (map.mip_chain) view.fail_here("a map of three dimensions has one level; leave \"mip_chain\" out");
    if (!view.json().is_string()) {
        map.depth = static_cast<int>(view.integer(1, max_slices));
        return;
    }
    map.depth_parameter = parse_integer_name(view, manifest);
    const Parameter& slices = *manifest.find_parameter(*map.depth_parameter);
    if (slices.minimum < 1 || slices.maximum > max_slices) {
        view.fail_here(fmt::format("the range of '{}' must lie within 1 and {}, as it is a number of slices",
                                   slices.name, max_slices));
    }
}

MapDeclaration parse_map(const JsonView& view, const Manifest& manifest, GlslNames& names) {
    view.require_only({"name", "format", "size", "mip_chain", "linear_filter", "depth", "only_with", "scratch"});
    MapDeclaration map;
    names.add_checked(view.at("name"));
    map.name = view.at("name").string();
    map.format = map_formats[view.at("format").choice(map_formats)];
    if (view.has("size")) map.size = static_cast<MapDeclaration::Size>(view.at("size").choice(map_sizes));
    if (view.has("mip_chain")) map.mip_chain = view.at("mip_chain").boolean();
    if (view.has("linear_filter")) map.linear_filter = view.at("linear_filter").boolean();
    if (view.has("depth")) parse_depth(view.at("depth"), manifest, map);
    if (view.has("only_with")) {
        if (map.is_volume()) view.at("only_with").fail_here("a map of three dimensions cannot be idle");
        map.only_with = parse_conditions(view.at("only_with"), manifest.parameters);
    }
    if (view.has("scratch")) map.scratch = view.at("scratch").boolean();
    return map;
}

std::string parse_shader_path(const JsonView& view) {
    const std::filesystem::path path = view.string();
    const bool climbs = std::ranges::any_of(path, [](const auto& component) { return component == ".."; });
    if (path.empty() || path.is_absolute() || climbs) view.fail_expected("a file inside the technique's folder");
    return path.string();
}

/// What the passes so far have written of a map.
struct Written {
    bool base = false;
    bool above_base = false;
};

/// Partial results are folded in the map itself, which must not round them.
Slicing parse_slicing(const JsonView& view, const PassDeclaration& pass, const MapDeclaration& map) {
    view.require_only({"over", "iterations", "ends_early"});
    if (pass.levels != PassDeclaration::Levels::base)
        view.fail_here("only a pass that writes the base is cut into slices");
    Slicing slicing;
    if (view.has("over")) slicing.over = static_cast<Slicing::Over>(view.at("over").choice(slicings));
    if (slicing.over == Slicing::Over::sources && !map.format.ends_with("32f")) {
        view.fail_here(fmt::format(
            "slices fold their results in the map '{}', which rounds them; give it a format of floats", map.name));
    }
    if (view.has("iterations")) {
        slicing.iterations = static_cast<int>(view.at("iterations").integer(1, max_slice_iterations));
    }
    if (view.has("ends_early")) slicing.ends_early = view.at("ends_early").boolean();
    return slicing;
}

PassDeclaration parse_pass(const JsonView& view, const Manifest& manifest, std::map<std::string, Written>& written) {
    view.require_only({"name", "shader", "writes", "levels", "only_with", "sliced"});
    PassDeclaration pass;
    pass.name = parse_line(view.at("name"));
    if (std::ranges::find(manifest.passes, pass.name, &PassDeclaration::name) != manifest.passes.end()) {
        view.at("name").fail_here(fmt::format("the name '{}' is given twice", pass.name));
    }
    if (pass.name == material_mips_pass)
        view.at("name").fail_here(fmt::format("'{}' is a pass of the harness; choose another name", pass.name));
    pass.shader = parse_shader_path(view.at("shader"));
    pass.writes = view.at("writes").string();
    if (view.has("levels")) pass.levels = static_cast<PassDeclaration::Levels>(view.at("levels").choice(pass_levels));

    const auto map = std::ranges::find(manifest.maps, pass.writes, &MapDeclaration::name);
    if (map == manifest.maps.end()) {
        std::vector<std::string> names;
        for (const MapDeclaration& declared : manifest.maps)
            names.push_back(declared.name);
        view.at("writes").fail_here(
            fmt::format("no map '{}' is declared{}", pass.writes, did_you_mean(pass.writes, names)));
    }
    if (view.has("only_with")) pass.only_with = parse_conditions(view.at("only_with"), manifest.parameters);
    if (view.has("sliced")) pass.sliced = parse_slicing(view.at("sliced"), pass, *map);
    Written& state = written[pass.writes];
    if (pass.levels == PassDeclaration::Levels::base) {
        state.base = true;
    } else if (!map->mip_chain) {
        view.fail_here(fmt::format("the map '{}' has no level above its base; give it \"mip_chain\": true", map->name));
    } else if (!state.base) {
        view.fail_here(fmt::format("no earlier pass writes the base of the map '{}'", map->name));
    } else {
        state.above_base = true;
    }
    return pass;
}

/// Those of the sets come first, so that the technique's own passes go on from what they leave. A pass may write a map
/// that another of them declares.
void parse_maps_and_passes(const JsonView& own, const std::vector<IncludedSet>& sets, Manifest& manifest,
                           GlslNames& names) {
    std::vector<JsonView> views;
    for (const IncludedSet& set : sets)
        views.push_back(set.view());
    views.push_back(own);
    std::vector<const JsonView*> declared_in;
    for (const JsonView& view : views) {
        if (!view.has("maps")) continue;
        for (const JsonView& item : view.at("maps").items()) {
            manifest.maps.push_back(parse_map(item, manifest, names));
            declared_in.push_back(&view);
        }
    }
    std::map<std::string, Written> written;
    for (const JsonView& view : views) {
        if (!view.has("passes")) continue;
        for (const JsonView& item : view.at("passes").items()) {
            manifest.passes.push_back(parse_pass(item, manifest, written));
            manifest.passes.back().is_shared = &view != &views.back();
        }
    }
    for (std::size_t i = 0; i < manifest.maps.size(); ++i) {
        const MapDeclaration& map = manifest.maps[i];
        const Written& state = written[map.name];
        if (!state.base) declared_in[i]->fail_here(fmt::format("no pass writes the map '{}'", map.name));
        if (map.mip_chain && !state.above_base) {
            declared_in[i]->fail_here(
                fmt::format("no pass writes the levels above the base of the map '{}'", map.name));
        }
    }
}

PromiseDeclaration parse_promise(const JsonView& view, const Manifest& manifest) {
    view.require_only({"promise", "with", "halvings", "within"});
    PromiseDeclaration declared;
    declared.promise = static_cast<Promise>(view.at("promise").choice(promises));
    const bool is_order = declared.promise == Promise::order_1 || declared.promise == Promise::order_2;
    if (is_order && !manifest.sample_count) {
        view.at("promise").fail_here("it needs a \"sample_count\", as it tells how errors fall with it");
    }
    if (view.has("with")) declared.with = parse_values(view.at("with"), manifest);
    for (const char* key : {"halvings", "within"}) {
        if (view.has(key) && declared.promise != Promise::order_1)
            view.at(key).fail_here("it belongs to the promise order_1 only");
    }
    if (view.has("within")) {
        declared.within = view.at("within").number(0, 1);
        if (declared.within == 0) view.at("within").fail_here("no error is within no part of a step");
    }
    if (view.has("halvings")) {
        declared.halvings = parse_integer_name(view.at("halvings"), manifest);
    }
    for (const PromiseDeclaration& earlier : manifest.promises) {
        if (earlier.promise == declared.promise && earlier.with == declared.with) {
            view.fail_here("the same promise is given twice");
        }
    }
    return declared;
}

/// In version 0.1.0, whose contract is 1, it hung on the kind.
ShadowSearch parse_shadow_search(const JsonView& view, const Manifest& manifest) {
    const bool traces = shape_kind(manifest.shape.kind).traces;
    if (view.has("shadow_search")) {
        const JsonView search = view.at("shadow_search");
        if (!traces)
            search.fail_here(fmt::format("a technique of the shape \"{}\" searches nothing", manifest.shape.kind));
        return static_cast<ShadowSearch>(search.choice(shadow_searches));
    }
    const bool searches =
        traces && (manifest.kind == "march" || manifest.kind == "hierarchy" || manifest.kind == "cone");
    return manifest.contract == 1 && searches ? ShadowSearch::own : ShadowSearch::uniform_layers;
}

int parse_contract(const JsonView& view) {
    const std::int64_t contract = view.integer(1, std::numeric_limits<int>::max());
    if (contract > newest_contract) {
        view.fail_here(fmt::format("this version of reliefbench knows the contracts 1 to {}, and not {}",
                                   newest_contract, contract));
    }
    return static_cast<int>(contract);
}

void check_id(const std::string& id, const std::string& file) {
    const bool fits = !id.empty() && id.front() >= 'a' && id.front() <= 'z' && std::ranges::all_of(id, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
    });
    if (!fits) {
        fail(
            "{}: the folder's name '{}' cannot be a technique's id; rename it to lower case letters, digits and '_', "
            "a letter first",
            file, id);
    }
}

}  // namespace

Manifest parse_manifest(const Json& json, const std::string& id, const std::string& file,
                        const std::filesystem::path& shared, const std::filesystem::path& folder,
                        const std::vector<std::string>& known_features) {
    check_id(id, file);
    const JsonView view(json, file);
    view.require_only({"title", "contract", "kind", "citation", "include", "parameters", "sample_count",
                       "sample_count_minimum", "search_cap", "features", "needs", "maps", "passes", "shape",
                       "shadow_search", "promises", "presets"});
    Manifest manifest;
    manifest.id = id;
    manifest.title = parse_line(view.at("title"));
    if (view.has("contract")) manifest.contract = parse_contract(view.at("contract"));
    manifest.kind = kinds[view.at("kind").choice(kinds)];
    manifest.citation = parse_line(view.at("citation"));

    const std::vector<IncludedSet> sets = read_included_sets(view, shared);
    GlslNames names(manifest.contract);
    manifest.parameters = parse_parameters(view.at("parameters"), sets, names);
    if (view.has("sample_count")) manifest.sample_count = parse_sample_count_name(view.at("sample_count"), manifest);
    if (view.has("sample_count_minimum")) {
        const JsonView minimum = view.at("sample_count_minimum");
        manifest.sample_count_minimum = parse_sample_count_name(minimum, manifest);
        if (!manifest.sample_count || manifest.sample_count == manifest.sample_count_minimum) {
            minimum.fail_here("it needs a \"sample_count\", another parameter");
        }
    }
    if (view.has("search_cap")) manifest.search_cap = parse_search_cap(view.at("search_cap"), manifest);
    if (view.has("features")) manifest.features = parse_features(view.at("features"), known_features);
    if (view.has("needs")) manifest.map_needs = parse_needs(view.at("needs"));
    parse_maps_and_passes(view, sets, manifest, names);
    manifest.shape = parse_shape(view.at("shape"), manifest);
    for (const std::string& feature : shape_kind(manifest.shape.kind).features) {
        if (std::ranges::find(manifest.features, feature) == manifest.features.end())
            manifest.features.push_back(feature);
    }
    manifest.shadow_search = parse_shadow_search(view, manifest);
    if (!shared.empty()) names.require_none_of(names_of_shaders(manifest, shared, folder));
    for (const JsonView& item : view.at("promises").items()) {
        manifest.promises.push_back(parse_promise(item, manifest));
    }
    if (view.has("presets")) manifest.presets = parse_presets(view.at("presets"), manifest);
    return manifest;
}

}  // namespace reliefbench
