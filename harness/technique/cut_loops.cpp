#include "technique/cut_loops.hpp"

#include "gpu/loop_limit.hpp"

#include <fmt/format.h>

#include <cstddef>

namespace reliefbench {

std::string describe_cut_loops(const gpu::Device& device, const Probe& probe) {
    std::size_t begun = 0;
    std::size_t cut = 0;
    for (std::size_t i = 0; i < probe.work.texels.size(); ++i) {
        const bool is_cut = probe.work.texels[i].cut;
        // What follows a loop without a way out, the count of covered pixels included, may never be run.
        if (is_cut || probe.covered.texels[i] != 0) ++begun;
        if (is_cut) ++cut;
    }
    if (cut == 0 && !probe.stages.cut) return {};
    const std::string whose =
        cut > 0 ? fmt::format("{:.3g} % of the pixels", 100 * static_cast<double>(cut) / static_cast<double>(begun))
                : "a tessellation stage";
    return fmt::format("the device ended the loops of {}: {}", whose, gpu::describe_loop_limit(device));
}

}  // namespace reliefbench
