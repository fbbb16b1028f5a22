#pragma once

#include "gpu/shader_compiler.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace reliefbench::gpu {

/// The text of a file named in GLSL, without a byte order mark; an Error says why it may not or cannot be read.
std::string read_source(const ShaderSource& source, const std::string& name);

/// The .glsl files of its folders, those of sub-folders left out: what could be included.
std::vector<std::filesystem::path> shader_files(const ShaderSource& source);

}  // namespace reliefbench::gpu
