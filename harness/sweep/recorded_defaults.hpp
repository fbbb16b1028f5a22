#pragma once

#include "core/json.hpp"
#include "manifest/manifest.hpp"

#include <string>
#include <vector>

namespace reliefbench {

struct ChangedDefault {
    /// Empty for an axis.
    std::string technique;
    /// "steep: step_rounding=integer, which is fractional by default now"
    std::string text;
};

/// A stored run's configuration with what was the default then, or a preset's value, and is none now written out, so
/// that it repeats the run: parameters of its techniques and axes that nothing in it sets.
struct RepeatedConfiguration {
    Json configuration;
    /// One for each default that changed.
    std::vector<ChangedDefault> changes;
    /// Techniques with parameters of whose defaults nothing is known.
    std::vector<std::string> unknown;
};

/// `defaults`: as run.json has them (store/stored_format.hpp), beside its "presets". `overridden`: names of axes and
/// parameters that the command line sets.
RepeatedConfiguration with_recorded_defaults(Json configuration, const Json& defaults,
                                             const std::vector<Manifest>& manifests,
                                             const std::vector<std::string>& overridden = {});

}  // namespace reliefbench
