#pragma once

#include "scene/image.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace reliefbench {

struct ProceduralMap {
    std::string name;
    /// One line for `reliefbench list heightmaps`.
    std::string description;
};

/// bricks, cobbles, rock, waves, spikes, steps, ...: all repeat seamlessly and reach both 0 and 1 or nearly so.
const std::vector<ProceduralMap>& procedural_maps();

/// Heights in [0, 1], row 0 is v = 0. The same numbers for the same arguments on every machine up to the last bits of
/// the mathematical library. `name` must be one of procedural_maps().
Image<float> generate_height_map(const std::string& name, Resolution size, std::uint64_t seed);

}  // namespace reliefbench
