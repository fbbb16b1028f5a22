#pragma once

#include "core/json.hpp"
#include "scene/surface/base_source.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace reliefbench {

/// "plane", "cylinder", "sphere" and "saddle", in the order of BaseSource::Kind.
const std::vector<std::string>& base_words();

/// A value of the axis `base`: one of base_words(), the path of a mesh file, or {"file": path}. Does not look for
/// files; what the other axes of the base say is at its default.
BaseSource read_base_value(const JsonView& view);

/// The same value with the absolute path of a file that exists: in the first of `folders` that has it. A file that none
/// has is an Error.
Json resolve_base_path(const JsonView& view, const std::vector<std::filesystem::path>& folders);

/// What ids and results call it, files by base name: "sphere", "my_mesh.glb".
std::string base_label(const BaseSource& source);

/// `list bases` as JSON: an array of {"base", "axes", "limits", "description"}, files last.
Json base_list_json();

}  // namespace reliefbench
