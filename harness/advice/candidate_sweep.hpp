#pragma once

#include "advice/narrowing.hpp"
#include "core/json.hpp"
#include "manifest/manifest.hpp"
#include "sweep/cell.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace reliefbench {

/// What advice for one map is asked about.
struct SweepQuestion {
    /// A value of the axis `heightmap`.
    Json map;
    /// Empty: the default albedo.
    std::string albedo;
    std::vector<double> view_angles;
    /// A value of the axis `resolution`.
    std::string resolution;
    double height_scale = 0.05;
};

/// Sample counts √2 apart, from an eighth of the default to sixteen times it, within the parameter's range; the default
/// is one of them. Ascending, each once. Empty where the technique has no sample count.
std::vector<std::int64_t> sample_ladder(const Manifest& manifest);

/// The configuration whose cells are all that may be advised: each technique at its defaults and along its ladder, and
/// each preset, from azimuths that are off the texels' rows and diagonals. The picture is filled with relief, whose
/// rays are parallel.
Json candidate_configuration(const SweepQuestion& question, const std::vector<Manifest>& techniques);

/// The cells of a configuration as the narrowing knows them. Views that differ in height map or azimuth alone are one
/// contest, as in advice (report/advice.hpp), and where there are several all views together are another one.
struct CandidateSweep {
    std::vector<SweptSetting> settings;
    std::vector<Contest> contests;
};

CandidateSweep candidate_sweep(const std::vector<Cell>& cells, const std::vector<Manifest>& techniques);

}  // namespace reliefbench
