#pragma once

#include "core/json.hpp"
#include "manifest/manifest.hpp"
#include "sweep/cell.hpp"

#include <map>
#include <string>
#include <vector>

namespace reliefbench {

/// The manifests by id.
using ManifestIndex = std::map<std::string, const Manifest*>;

ManifestIndex index_manifests(const std::vector<Manifest>& manifests);

/// What can be asked of a cell: its technique, its preset, an axis of its view, its sample count or a parameter. An
/// unknown name is an Error with a "did you mean".
void check_quantity_name(const JsonView& where, const std::string& name, const ManifestIndex& manifests);

/// For a name that is none of `known`: " (did you mean 'x'?)" by its spelling, else what other words for it are called
/// here, where a setting that is no axis stands, or the list of axes.
std::string suggest_quantity(const std::string& name, const std::vector<std::string>& known);

/// Of all techniques.
std::vector<std::string> preset_names(const ManifestIndex& manifests);

/// "technique", "preset", the axes of the view, "sample_count" and every parameter of the manifests.
std::vector<std::string> quantity_names(const ManifestIndex& manifests);

/// Null where the cell has no such quantity.
Json cell_quantity(const Cell& cell, const std::string& name, const ManifestIndex& manifests);

/// The values that cells have of a quantity, numbers in their order and others as they come; none that is null.
std::vector<Json> distinct_quantities(const std::vector<Cell>& cells, const std::string& name,
                                      const ManifestIndex& manifests);

/// "0, 45 or 60"; the first ones where there are many.
std::string alternatives(const std::vector<Json>& values);

/// A scalar as "-a" and "--filter" take it: a word, or JSON where a word would be read otherwise.
std::string value_as_argument(const Json& value);

/// A value to compare that quantity with, in the form that cell_quantity has. A value that no cell can have is an
/// Error.
Json read_quantity_value(const JsonView& view, const std::string& name, const ManifestIndex& manifests);

/// Numbers by value, words as they are; a height map also by the base name of its file alone.
bool quantity_equals(const std::string& name, const Json& quantity, const Json& value);

}  // namespace reliefbench
