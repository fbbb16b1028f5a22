#pragma once

#include "sweep/cell.hpp"
#include "sweep/configuration.hpp"
#include "technique/renderer.hpp"

#include <cstdint>
#include <string>

namespace reliefbench {

/// Bytes at the peak. On lavapipe's 2048² targets 0.98 to 1.02 of what was estimated was taken, on 4096² height maps
/// 0.97; docs/reliability.md has the table.
struct MemoryNeed {
    std::uint64_t host = 0;
    std::uint64_t device = 0;
};

/// Sizes of a view's inputs, from their files' headers.
struct InputSizes {
    Resolution height_map;
    Resolution albedo;
};

InputSizes input_sizes(const HeightMapSource& source);

/// To load a height map with its albedo and to put them on the device.
MemoryNeed loading_need(const InputSizes& sizes, HeightFormat format);

/// Of the cell and its truth, once the inputs are there; the base is one of them.
MemoryNeed cell_need(const Technique& technique, const Cell& cell, const BaseSurface& base, const InputSizes& sizes,
                     const Configuration& configuration);

/// Of the cell with its inputs, which are still to be loaded.
MemoryNeed with_inputs(MemoryNeed cell, const InputSizes& sizes, HeightFormat format);

/// Empty where there is the memory, else "<what> takes about 18.2 GB of memory, and 12.1 GB is available". A device
/// that is a CPU, or shares its memory, takes from what is available here.
std::string lacking_memory(const gpu::Device& device, const std::string& what, MemoryNeed need);

}  // namespace reliefbench
