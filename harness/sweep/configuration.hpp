#pragma once

#include "core/json.hpp"
#include "manifest/manifest.hpp"
#include "scene/lighting.hpp"
#include "scene/scene_object.hpp"
#include "sweep/cell.hpp"
#include "sweep/override.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace reliefbench {

/// How a truth is traced.
struct TruthSettings {
    enum class Kind { exact, mesh };
    Kind kind = Kind::exact;
    /// mesh only: quads per texel and side.
    int subdivision = 4;
    /// Of a pixel of its picture (reference/truth.hpp).
    int samples = 1;
};

/// When a cell has been sampled enough. A rule is an object of its own (harness/measure/stopping_rule.hpp).
struct SamplingSettings {
    enum class Rule {
        /// Until the 95 % interval of the median is narrow enough, or more rounds do not narrow it, or the budget is
        /// spent.
        precision,
        /// So many rounds.
        fixed,
        /// Until the budget is spent.
        time,
    };
    /// With fewer rounds there is no 95 % order-statistic interval of a median.
    static constexpr int rounds_for_interval = 6;

    Rule rule = Rule::precision;
    /// Rounds over the cells of a block: the least of precision, the number of fixed.
    int rounds = 10;
    /// precision: half the interval's width, as a fraction of the median.
    double precision = 0.01;
    /// precision and time: the device's time in a cell's samples.
    double budget_s = 5;
    /// Samples of each pass per visit.
    int samples_per_visit = 3;
    /// Unrecorded draws before the first round.
    int warm_up = 2;
    /// A pass shorter than this is repeated inside one timestamp pair until it is not.
    double minimum_pass_ms = 0.2;
};

/// The camera moves along an arc, and what a technique's error does meanwhile is measured.
struct MotionSettings {
    enum class Along { view_angle, azimuth };

    /// The first is the cell's own view.
    int frames = 9;
    /// Between neighbouring frames; 0, a still camera, with a history only. Along the view angle the camera goes
    /// towards head-on, and beyond.
    double degrees = 0.25;
    Along along = Along::view_angle;
    /// Of a history that is carried along, the fraction that a frame leaves of it, in [0, 1); empty: there is none.
    std::optional<double> history_weight = {};
    /// Whether the history is clamped to the 3×3 neighbourhood of each frame's pixel.
    bool neighbourhood_clamp = false;
};

/// Of frame 0, 1, ....
Camera camera_in_motion(const Camera& camera, const MotionSettings& motion, int frame);

/// What making a technique's derived maps may cost.
struct PreparationLimit {
    /// A cell whose maps would take longer, in seconds on the device, is skipped with the estimated time.
    double limit_s = 60;
};

/// Where something was set, for messages: a file and a JSON path, or a command line argument and its name.
struct Origin {
    std::string file = "configuration";
    std::string path = "$";
};

/// One entry of "techniques": an id with the values swept for its parameters by name.
struct TechniqueSelection {
    std::string technique;
    std::vector<std::pair<std::string, std::vector<ParameterValue>>> parameters;
    Origin origin = {};
    /// Whose values each take the place of the technique's defaults in turn; empty: the defaults do.
    std::vector<std::string> presets = {};
};

/// One swept quantity: name and raw values, checked by the expansion.
struct Axis {
    std::string name;
    std::vector<Json> values;
    Origin origin = {};
};

/// A zip that lost axes to "-a" arguments.
struct LoosenedZip {
    /// Axes that were given values of their own, and the arguments that gave them.
    std::vector<std::string> taken;
    std::vector<std::string> arguments;
    /// Those that are left, tied to each other alone.
    std::vector<std::string> kept;
};

/// A configuration as read: configs/schema.json is its schema, docs/architecture.md its description.
struct Configuration {
    std::string name;
    std::vector<TechniqueSelection> techniques;
    std::vector<Axis> axes;
    /// Groups of axes that advance together instead of as a product.
    std::vector<std::vector<std::string>> zip;
    /// Each: conditions (technique, axis or parameter → values), all of which must hold for a cell to be dropped.
    std::vector<std::map<std::string, std::vector<Json>>> exclude;
    std::uint64_t seed = 1;
    TruthSettings truth;
    SamplingSettings sampling;
    PreparationLimit preparation;
    Lighting lighting;
    /// Stands in the relief.
    std::optional<SceneObject> object;
    /// Keep pictures and error maps of every cell in images/.
    bool images = false;
    std::optional<MotionSettings> motion;
    /// The whole as JSON after overrides: written to run.json, and reads back to the same configuration. Paths of files
    /// are absolute.
    Json expanded;
    Origin origin;
    /// What warn_of_overrides judges (sweep/override_effects.hpp): axes that "-a" arguments set, and zips that lost
    /// some.
    std::vector<std::string> overridden;
    std::vector<LoosenedZip> loosened_zips;
};

/// What a configuration that comes by standard input is called in place of its file.
inline constexpr std::string_view standard_input = "standard input";

/// The configuration that `json`, the content of `file`, is. One without a name is called as its file is; what comes by
/// standard input or a pipe of the shell (/dev/stdin, /dev/fd/63) is "configuration" and has no folder of its own.
/// `overrides` are "-a" arguments (sweep/override.hpp). They replace an axis, and take it out of its zip
/// (warn_of_overrides tells of it); a parameter wherever it is set; `sample_count` also the sample counts set by name;
/// `albedo` also those of height maps given as objects; and `technique=a,b` the selection, in which those selected
/// before keep their parameters; and `preset=a,b` the presets of the techniques that have them. Relative paths of
/// height maps are taken from the configuration file's folder when they exist there, else from the working directory;
/// those of overrides from the working directory. run.json of an earlier run is taken too.
Configuration parse_configuration(const Json& json, const std::string& file, const std::vector<std::string>& overrides,
                                  const std::vector<Manifest>& techniques);
/// The same with overrides that other options gave.
Configuration configuration_with(const Json& json, const std::string& file, const std::vector<Override>& overrides,
                                 const std::vector<Manifest>& techniques);

/// Both also in what is written to run.json.
void set_preparation_limit(Configuration& configuration, double limit_s);
/// `settings` are "--sampling" arguments, "name=value,name=value", which take the place of the configuration's; one
/// that is unknown or out of range is an Error.
void set_sampling(Configuration& configuration, const std::vector<std::string>& settings);

/// Product of the axes (zipped ones together) × techniques × their parameter values; excluded cells dropped.
/// Order: views outermost, so that cells of one view are neighbours. Errors: a technique, axis or value unknown to
/// everyone, a parameter set by name out of its range. A swept `sample_count` or parameter out of one technique's
/// range makes that cell skipped with the reason. No cell twice; no cell at all is an Error.
/// Where several set one parameter, the technique's own values win, then an axis of the parameter's name, then
/// `sample_count`, then a preset.
std::vector<Cell> expand(const Configuration& configuration, const std::vector<Manifest>& techniques);

/// "--filter" expressions: "technique=pom,qdm", "view_angle=60", "max_steps>=16"; values as "-a" takes them
/// (sweep/override.hpp); all must hold. Where no cell is left, the Error
/// says which values there are.
std::vector<Cell> filter_cells(std::vector<Cell> cells, const std::vector<std::string>& filters,
                               const std::vector<Manifest>& techniques);

}  // namespace reliefbench
