#pragma once

#include "core/json.hpp"
#include "manifest/manifest.hpp"

#include <string>
#include <vector>

namespace reliefbench {

/// A stored run's configuration with what was the default then and is none now written out, so that it repeats the run:
/// parameters of its techniques and axes that nothing in it sets. `defaults` as run.json has them
/// (store/stored_format.hpp).
struct RepeatedConfiguration {
    Json configuration;
    /// "steep: step_rounding=integer, which is fractional by default now"; one for each default that changed.
    std::vector<std::string> changes;
};

RepeatedConfiguration with_recorded_defaults(Json configuration, const Json& defaults,
                                             const std::vector<Manifest>& manifests);

}  // namespace reliefbench
