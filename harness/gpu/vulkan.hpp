#pragma once

// The one place that includes Vulkan's C++ bindings: they cost seconds per file. The loader is linked, not opened at
// run time, and structures stay aggregates, so that they can be written with designated initialisers.
#define VULKAN_HPP_ENABLE_DYNAMIC_LOADER_TOOL 0
#define VULKAN_HPP_NO_STRUCT_CONSTRUCTORS
#define VULKAN_HPP_NO_UNION_CONSTRUCTORS
#include <vulkan/vulkan_raii.hpp>
