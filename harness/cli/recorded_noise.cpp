#include "cli/recorded_noise.hpp"

#include "core/error.hpp"

namespace reliefbench {

std::optional<NoiseRecord> find_recorded_noise(const MachineKey& machine) {
    std::filesystem::path folder;
    try {
        folder = state_folder();
    } catch (const Error&) {
        return std::nullopt;  // nowhere to keep one: none is kept
    }
    return read_noise_record(folder, machine);
}

}  // namespace reliefbench
