#pragma once

#include "manifest/manifest.hpp"

#include <filesystem>
#include <set>
#include <string>

namespace reliefbench {

/// Every global name that files of `shared` (harness/shaders) declare in a compilation of the technique: of the stages
/// of its draw, of its passes, and of a pass that it may come to have. What the technique's own files declare, in
/// `folder`, is left out; what they include is not. A file that is missing has none.
std::set<std::string> names_of_shaders(const Manifest& manifest, const std::filesystem::path& shared,
                                       const std::filesystem::path& folder);

}  // namespace reliefbench
