#pragma once

#include "core/glsl_tokens.hpp"

#include <filesystem>
#include <vector>

namespace reliefbench {

struct IncludedGlsl {
    /// Its folder, as a position among those that were given.
    std::size_t root = 0;
    /// Below the folder, without "." and "..".
    std::filesystem::path name;
    std::vector<GlslToken> tokens;
};

/// The files named and what they include, directly or through others, each once: of every folder of `roots` that has a
/// file of the name. What stands in comments is not included; what conditions leave out is. A name that leaves the
/// folders, and a file that is missing, are left out: the compiler complains of them.
std::vector<IncludedGlsl> glsl_with_includes(const std::vector<std::filesystem::path>& files,
                                             const std::vector<std::filesystem::path>& roots);

}  // namespace reliefbench
