#pragma once

#include "core/limited_child.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace reliefbench::gpu {

enum class ShaderStage { vertex, tessellation_control, tessellation_evaluation, fragment, compute };

using SpirV = std::vector<std::uint32_t>;

/// What one stage is compiled from.
struct ShaderSource {
    ShaderStage stage = ShaderStage::compute;
    /// The file with main(), looked for as an #include is.
    std::string file;
    /// Folders that files are taken from. No #include may leave them, and a name found in two of them is an error, so
    /// that one folder cannot replace another's files.
    std::vector<std::filesystem::path> roots;
    /// Files that exist in memory only, by the name that #include uses.
    std::map<std::string, std::string> generated;
    /// Text put in front of the file, after #version.
    std::string preamble;
    /// Called with the same module with its files and lines (OpLine), in the compiler's process; what it throws is
    /// thrown by compile_shader. May be empty.
    std::function<void(const SpirV&)> inspect = {};
};

/// GLSL 4.60 for Vulkan 1.3, #include enabled. An Error tells the first complaint, "file:line:column: sentence", and
/// shows the line with a caret; the column is one of bytes, and missing where it is not known. Those of `inspect` come
/// as they are. A byte order mark at the beginning of a file is passed over. glslang has no bounds of its own (a few
/// lines of macros can expand without end): it runs in a child process with `limits`.
SpirV compile_shader(const ShaderSource& source, const ChildLimits& limits = {});

}  // namespace reliefbench::gpu
