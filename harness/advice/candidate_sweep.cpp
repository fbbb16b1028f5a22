#include "advice/candidate_sweep.hpp"

#include "manifest/parameter_json.hpp"
#include "report/view_groups.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace reliefbench {

namespace {

/// Degrees; 10, 38 and 25 off the rows and columns of texels, 35, 7 and 20 off the diagonals.
constexpr std::array candidate_azimuths{-80.0, -52.0, -25.0};
/// Half octaves below and above the default.
constexpr int rungs_below = 6;
constexpr int rungs_above = 8;
/// Where sweeps of a ladder begin: as many steps as marches need to look like something.
constexpr double first_sample_count = 16;
/// Maps that take longer are for a longer look than advice is: several techniques want some.
constexpr double preparation_limit_s = 10;

const Parameter* sample_parameter(const Manifest& manifest) {
    return manifest.sample_count ? manifest.find_parameter(*manifest.sample_count) : nullptr;
}

std::int64_t integer_of(const ParameterValues& values, const std::string& name) {
    return std::get<std::int64_t>(values.at(name));
}

Json rung_json(const Manifest& manifest, std::int64_t count) {
    const ParameterValues defaults = manifest.defaults();
    ParameterValues values = defaults;
    set_sample_count(manifest, values, count, defaults);
    Json parameters;
    for (const auto& [name, value] : values) {
        if (value != defaults.at(name)) parameters[name] = to_json(value);
    }
    Json selection = {{"technique", manifest.id}};
    if (!parameters.is_null()) selection["parameters"] = parameters;
    return selection;
}

/// What all settings of its ladder have in common.
std::string ladder_key(const Cell& cell, const Manifest& manifest) {
    std::string key = cell.technique + '\n' + cell.preset;
    for (const auto& [name, value] : cell.parameters) {
        const bool is_counted = name == manifest.sample_count || name == manifest.sample_count_minimum;
        if (!is_counted) key += '\n' + name + '=' + to_string(value);
    }
    return key;
}

bool needs_maps(const Cell& cell, const Manifest& manifest) {
    return std::ranges::any_of(manifest.passes, [&](const PassDeclaration& pass) {
        const auto map = std::ranges::find(manifest.maps, pass.writes, &MapDeclaration::name);
        return all_hold(pass.only_with, cell.parameters) &&
               (map == manifest.maps.end() || all_hold(map->only_with, cell.parameters));
    });
}

std::string contest_key(const ViewKey& view) {
    Json axes = axes_to_json(view);
    for (const std::string_view axis : pooled_axes)
        axes.erase(std::string(axis));
    return axes.dump();
}

}  // namespace

std::vector<std::int64_t> sample_ladder(const Manifest& manifest) {
    const Parameter* const parameter = sample_parameter(manifest);
    if (parameter == nullptr) return {};
    const auto start = static_cast<double>(std::get<std::int64_t>(parameter->default_value));
    std::set<std::int64_t> counts;
    for (int rung = -rungs_below; rung <= rungs_above; ++rung) {
        const double count = std::round(start * std::exp2(rung / 2.0));
        if (count >= parameter->minimum && count <= parameter->maximum) counts.insert(std::llround(count));
    }
    return {counts.begin(), counts.end()};
}

Json candidate_configuration(const SweepQuestion& question, const std::vector<Manifest>& techniques) {
    Json selections = Json::array();
    for (const Manifest& manifest : techniques) {
        const std::vector<std::int64_t> counts = sample_ladder(manifest);
        if (counts.empty()) selections.push_back({{"technique", manifest.id}});
        for (const std::int64_t count : counts)
            selections.push_back(rung_json(manifest, count));
        for (const Preset& preset : manifest.presets)
            selections.push_back({{"technique", manifest.id}, {"preset", preset.name}});
    }
    Json configuration;
    configuration["name"] = "advice";
    configuration["techniques"] = selections;
    Json& axes = configuration["axes"];
    axes["heightmap"] = Json::array({question.map});
    if (!question.albedo.empty()) axes["albedo"] = question.albedo;
    axes["view_angle"] = question.view_angles;
    axes["azimuth"] = candidate_azimuths;
    axes["projection"] = "parallel";
    axes["height_scale"] = question.height_scale;
    axes["resolution"] = question.resolution;
    configuration["preparation"]["limit_s"] = preparation_limit_s;
    return configuration;
}

CandidateSweep candidate_sweep(const std::vector<Cell>& cells, const std::vector<Manifest>& techniques) {
    std::map<std::string, const Manifest*> manifests;
    for (const Manifest& manifest : techniques)
        manifests[manifest.id] = &manifest;
    std::vector<ViewKey> views;
    std::map<std::string, std::size_t> setting_of;
    std::map<std::string, std::size_t> ladder_of;
    CandidateSweep sweep;
    for (std::size_t index = 0; index < cells.size(); ++index) {
        const Cell& cell = cells[index];
        const Manifest& manifest = *manifests.at(cell.technique);
        auto known_view = std::ranges::find(views, cell.view);
        if (known_view == views.end()) known_view = views.insert(views.end(), cell.view);
        const auto view = static_cast<std::size_t>(known_view - views.begin());
        const std::string name = cell.id.substr(0, cell.id.find(" | "));
        const auto [known, is_new] = setting_of.try_emplace(name, sweep.settings.size());
        if (is_new) {
            SweptSetting setting{.technique = cell.technique,
                                 .needs_maps = needs_maps(cell, manifest),
                                 .is_wanted = !cell.preset.empty()};
            setting.ladder = ladder_of.try_emplace(ladder_key(cell, manifest), ladder_of.size()).first->second;
            if (manifest.sample_count) {
                setting.sample_count = integer_of(cell.parameters, *manifest.sample_count);
                setting.distance_from_start =
                    std::abs(std::log2(static_cast<double>(setting.sample_count) / first_sample_count));
            }
            sweep.settings.push_back(std::move(setting));
        }
        std::vector<std::optional<std::size_t>>& of_views = sweep.settings[known->second].cells;
        if (of_views.size() <= view) of_views.resize(view + 1);
        of_views[view] = index;
    }
    for (SweptSetting& setting : sweep.settings)
        setting.cells.resize(views.size());
    std::map<std::string, std::size_t> contest_of;
    Contest all;
    for (std::size_t view = 0; view < views.size(); ++view) {
        const auto [known, is_new] = contest_of.try_emplace(contest_key(views[view]), sweep.contests.size());
        if (is_new) sweep.contests.emplace_back();
        sweep.contests[known->second].push_back(view);
        all.push_back(view);
    }
    if (sweep.contests.size() > 1) sweep.contests.push_back(std::move(all));
    return sweep;
}

}  // namespace reliefbench
