#pragma once

#include "gpu/shader_compiler.hpp"

#include <cstdint>
#include <set>

namespace reliefbench::gpu {

/// The constant_id of each specialization constant that the module's functions refer to, directly or through
/// expressions of constants; those that are only declared are not among them.
std::set<std::uint32_t> used_constants(const SpirV& module);

}  // namespace reliefbench::gpu
