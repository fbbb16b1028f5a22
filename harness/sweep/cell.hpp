#pragma once

#include "core/json.hpp"
#include "manifest/manifest.hpp"
#include "scene/height_map.hpp"
#include "scene/relief.hpp"

#include <string>
#include <vector>

namespace reliefbench {

/// What a truth depends on: one height map in one format on one base, seen by one view.
struct ViewKey {
    HeightMapSource height_map;
    HeightFormat height_format = HeightFormat::r16;
    BaseSource base;
    /// Its relief's base is a plane: whoever draws or traces takes the one loaded from `base` (SharedInputs::view).
    View view;

    bool operator==(const ViewKey&) const = default;
};

/// One point of the matrix.
struct Cell {
    /// Technique, preset, parameters and axes only; never order, path or machine. Values at their defaults, or at those
    /// of the preset, are left out, so that a new axis or parameter with a neutral default leaves ids alone:
    /// "pom max_steps=16 | heightmap=bricks view_angle=60".
    std::string id;
    std::string technique;
    /// Whose values those are that nothing else sets; empty: the technique's defaults.
    std::string preset = {};
    ParameterValues parameters;
    ViewKey view;
    /// Not empty: the cell is skipped from the start, for this reason.
    std::string skip_reason;
};

/// Axes of the view as the result file writes them: heightmap (name), heightmap_size, view_angle, ....
Json axes_to_json(const ViewKey& view);
Json parameters_to_json(const ParameterValues& values);

/// The technique's part of an id: "pom max_steps=16", with a preset behind the technique as
/// "preset=godot_4 max_steps=16". `preset` may be null.
std::string technique_id(const Manifest& manifest, const ParameterValues& values, const Preset* preset = nullptr);

/// The stable id of a cell without a preset; see Cell::id.
std::string cell_id(const Manifest& manifest, const ParameterValues& values, const ViewKey& view);

/// Whole views, at most `max_cells` cells (a view with more is split): what is measured together. Indices into the
/// cells given, in their order; skipped cells belong to no block.
struct Block {
    std::vector<std::size_t> cells;
};

std::vector<Block> make_blocks(const std::vector<Cell>& cells, std::size_t max_cells = 64);

}  // namespace reliefbench
