#pragma once

#include "technique/renderer.hpp"

#include <functional>
#include <map>
#include <string>

namespace reliefbench {

/// Preparations that could not be made, by the maps that they would have made (Renderer::maps_key): what else needs the
/// same maps with the same settings would wait for the same end. Of one execution, whose limit is one.
class FailedPreparations {
public:
    struct Failure {
        /// Given up at the limit, which skips the cell; else it fails.
        bool given_up = false;
        std::string reason;
    };

    /// Null where it is not known to fail.
    const Failure* find(const std::string& maps) const;
    void add(const std::string& maps, Failure failure) { failures_.emplace(maps, std::move(failure)); }

    /// What `prepare` makes of the renderer's maps; of those that are known to fail, how they end, at once. An Error
    /// where it fails. `on_maps`, unless empty, is told the maps that are being made, and nothing when they are.
    Preparation prepare(const gpu::Device& device, Renderer& renderer,
                        const std::function<Preparation(Renderer&)>& prepare,
                        const std::function<void(const std::string& maps)>& on_maps = {});

private:
    std::map<std::string, Failure> failures_;
};

}  // namespace reliefbench
