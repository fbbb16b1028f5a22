#pragma once

#include "store/noise_record.hpp"

#include <optional>

namespace reliefbench {

/// What `reliefbench selfcheck` has kept of a machine, if anything.
std::optional<NoiseRecord> find_recorded_noise(const MachineKey& machine);

}  // namespace reliefbench
