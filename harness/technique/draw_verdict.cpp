#include "technique/draw_verdict.hpp"

#include "manifest/search_advice.hpp"
#include "technique/cut_loops.hpp"

#include <fmt/format.h>

namespace reliefbench {

namespace {

/// Fraction of covered pixels: a picture with more is not the technique's.
constexpr double max_unconverged = 0.5;

}  // namespace

DrawVerdict judge_draw(const gpu::Device& device, const Manifest& manifest, const ParameterValues& parameters,
                       const Probe& probe) {
    if (!probe.faults.empty()) {
        return {.reason = reason_of_faults(probe.faults, probe.hits.texels.size()),
                .is_meaningless = true,
                .worst = worst_fault(probe.faults).pixel};
    }
    const std::string cut = describe_cut_loops(device, probe);
    if (!cut.empty()) {
        return {.reason = fmt::format("{}, so that neither its picture nor its time is the technique's; {}", cut,
                                      advise_shorter_search(manifest, parameters))};
    }
    const double unconverged = unconverged_fraction(probe.covered, probe.work);
    if (unconverged <= max_unconverged) return {};
    return {.reason = fmt::format("{:.0f} % of its pixels left their loop at the iteration cap, unconverged, so that "
                                  "its time would say nothing; {}",
                                  100 * unconverged, advise_longer_search(manifest, parameters))};
}

}  // namespace reliefbench
