#include "technique/failed_preparations.hpp"

#include "core/attempt.hpp"
#include "core/error.hpp"
#include "gpu/device.hpp"

namespace reliefbench {

const FailedPreparations::Failure* FailedPreparations::find(const std::string& maps) const {
    const auto found = failures_.find(maps);
    return found == failures_.end() ? nullptr : &found->second;
}

Preparation FailedPreparations::prepare(const gpu::Device& device, Renderer& renderer,
                                        const std::function<Preparation(Renderer&)>& prepare,
                                        const std::function<void(const std::string& maps)>& on_maps) {
    const std::string maps = renderer.maps_key();
    Preparation preparation;
    if (const Failure* known = find(maps)) {
        if (!known->given_up) fail("{}", known->reason);
        preparation.given_up = known->reason;
        return preparation;
    }
    if (on_maps) on_maps(maps);
    const std::string failure = failure_of([&] { preparation = prepare(renderer); });
    if (on_maps) on_maps({});
    if (!failure.empty()) {
        // A lost device, and memory that others have taken, say nothing of the maps.
        if (!device.is_lost() && failure != memory_used_up) add(maps, {false, failure});
        fail("{}", failure);
    }
    if (!preparation.given_up.empty()) add(maps, {true, preparation.given_up});
    return preparation;
}

}  // namespace reliefbench
