#pragma once

#include "core/json.hpp"
#include "manifest/parameter.hpp"
#include "manifest/preset.hpp"
#include "manifest/shape.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace reliefbench {

/// What a technique may promise; the conformance checks (harness/verify) hold it to them.
enum class Promise {
    /// Finds the first intersection, to the filter's floor.
    first_hit,
    /// On a smooth map the error halves as the sample count doubles, and stays below one step, or the part promised.
    order_1,
    /// On a smooth map the error falls by four as the sample count doubles, until the filter's floor.
    order_2,
    /// Never reports a point beyond the first hit by more than half a texel.
    conservative,
};

std::string to_string(Promise promise);

struct PromiseDeclaration {
    Promise promise = Promise::first_hit;
    /// The parameter values under which it holds; parameters not named here keep their defaults.
    ParameterValues with;
    /// order_1 only: the parameter that halves the step this many more times (a binary search), or none.
    std::optional<std::string> halvings;
    /// order_1 only: the largest error, in steps; above 0 and at most 1.
    double within = 1;
};

/// What a technique may need of the height map and of how it lies on the patch.
enum class MapNeed {
    /// As wide as it is high.
    square,
    /// Each side is a power of two.
    power_of_two,
    /// It lies on the patch once: tiling 1, and nothing goes on past the border (boundary clip).
    untiled,
};

std::string to_string(MapNeed need);

/// A texture that preparation passes derive from the height map, bound to every shader of the technique under its name.
struct MapDeclaration {
    enum class Size {
        /// Width and height of the height map.
        height_map,
        /// Each side rounded up to a power of two, so that every level halves exactly.
        next_power_of_two,
    };
    std::string name;
    /// "r8", "r16", "rg16", "r32f", "rg32f", "rgba8", "rgba16", "rgba32f".
    std::string format;
    Size size = Size::height_map;
    /// Down to 1×1 when true, else one level.
    bool mip_chain = false;
    /// Hardware filtering between texels; otherwise nearest.
    bool linear_filter = false;
    /// All must hold, or the map is idle: neither made nor counted, and a single texel is bound in its place.
    std::vector<ParameterCondition> only_with;
    /// For later passes only: no draw sees it, and it is freed when the others are made.
    bool scratch = false;
    /// How many slices a three-dimensional map has, over the height from 0 to 1: a number, or the integer parameter
    /// that has it. Neither: the map has two dimensions.
    int depth = 0;
    std::optional<std::string> depth_parameter;

    bool is_volume() const { return depth > 0 || depth_parameter.has_value(); }
    /// 0 for a map of two dimensions.
    int slices(const ParameterValues& values) const;
};

/// How a pass that takes long is cut into dispatches.
struct Slicing {
    enum class Over {
        /// Its search over the texels of the height map: each dispatch folds what it finds into the map.
        sources,
        /// The rows that it writes.
        rows,
    };
    Over over = Over::sources;
    /// The most loop iterations that an invocation spends on one texel searched, or on the one that it writes.
    int iterations = 1;
    /// Later slices cost less than earlier ones: what the first took says little about the rest.
    bool ends_early = false;
};

/// A compute pass of the preparation. Runs once for each level that it covers, in the order of the manifest.
struct PassDeclaration {
    enum class Levels { base, above_base };
    std::string name;
    /// A file that defines void prepare(ivec2 texel): of the technique's folder, or, of an included set, of the shared
    /// shaders.
    std::string shader;
    bool is_shared = false;
    /// The map that it writes.
    std::string writes;
    Levels levels = Levels::base;
    /// All must hold, or it does not run.
    std::vector<ParameterCondition> only_with = {};
    std::optional<Slicing> sliced = {};
};

/// Who searches along a light's ray for hard self-shadows.
enum class ShadowSearch {
    /// The technique's own trace().
    own,
    /// The harness's march in uniform layers.
    uniform_layers,
};

/// Contract 1 is that of version 0.1.0, 2 that of version 0.2.0.
inline constexpr int newest_contract = 2;

/// The pass of the harness that makes mips of albedo and normals where cells filter them: no technique has one of that
/// name.
inline constexpr const char* material_mips_pass = "material_mips";

/// technique.json, read and checked. Pure data. Its schema is told in docs/adding_a_technique.md.
struct Manifest {
    /// The folder's name.
    std::string id;
    std::string title;
    /// Of what its shaders see and answer (docs/adding_a_technique.md), from 1 to newest_contract.
    int contract = 1;
    /// For grouping in lists: texture, parallax, march, hierarchy, cone or geometry.
    std::string kind;
    std::string citation;
    std::vector<Parameter> parameters;
    /// The parameter that the axis `sample_count` sets, if any.
    std::optional<std::string> sample_count;
    /// The parameter that keeps its default ratio to the sample count when that is swept (an adaptive minimum).
    std::optional<std::string> sample_count_minimum;
    /// Integer parameters that cap the technique's search; what `unconverged` marks could have searched on with more.
    /// Empty: the manifest does not say.
    std::vector<std::string> search_cap = {};
    /// Device features it needs, as the device layer names them: "tessellationShader", ...
    std::vector<std::string> features;
    /// Without which a cell is skipped; each at most once.
    std::vector<MapNeed> map_needs = {};
    std::vector<MapDeclaration> maps;
    std::vector<PassDeclaration> passes;
    Shape shape;
    /// Of the shape quad.
    ShadowSearch shadow_search = ShadowSearch::uniform_layers;
    std::vector<PromiseDeclaration> promises;
    std::vector<Preset> presets = {};

    const Parameter* find_parameter(const std::string& name) const;
    ParameterValues defaults() const;
};

/// Strict: unknown keys, wrong types, names that GLSL cannot take, promises with unknown parameters, passes that write
/// undeclared maps, are Errors that name the file and the JSON path. The sets of parameters that it includes are files
/// of the folder `shared` (harness/shaders); a shape may have one that belongs to each of its techniques.
/// Names that these shaders use (names_of_shaders) are Errors, too; where `folder`, the technique's own, is not given,
/// only those of what is compiled with every technique of the shape.
/// Features are of `known_features`, which the device layer has; where there are none, by any name.
Manifest parse_manifest(const Json& json, const std::string& id, const std::string& file,
                        const std::filesystem::path& shared = {}, const std::filesystem::path& folder = {},
                        const std::vector<std::string>& known_features = {});

/// Reads <folder>/technique.json; the folder's name is the id. Missing shader files are Errors too.
Manifest load_manifest(const std::filesystem::path& folder, const std::filesystem::path& shared = {},
                       const std::vector<std::string>& known_features = {});

/// Sets parameters that have no effect beside the others' values, or over the plane, to their defaults, so that what
/// draws alike is alike.
void reset_idle(const Manifest& manifest, ParameterValues& values, bool on_flat_base);

/// Sets the sample count to `count`, and the adaptive minimum to round(count · the ratio that the two have in `from`),
/// at least 1. The manifest must have a sample count. Ranges are not checked.
void set_sample_count(const Manifest& manifest, ParameterValues& values, std::int64_t count,
                      const ParameterValues& from);

}  // namespace reliefbench
