#pragma once

#include "sweep/condition.hpp"
#include "sweep/configuration.hpp"
#include "sweep/view_axes.hpp"

#include <string>
#include <utility>
#include <vector>

namespace reliefbench {

/// An axis with its values checked.
struct PlannedAxis {
    std::string name;
    /// Of the view; null for `sample_count` and for parameters.
    const ViewAxis* view = nullptr;
    /// One for each value of a view's axis.
    std::vector<ViewSetting> settings;
    /// The raw values of the others.
    std::vector<Json> values;
};

/// Axes that advance together: one axis, or those of a zip. All have `length` values.
struct AxisGroup {
    std::vector<std::size_t> axes;
    std::size_t length = 0;
    bool sets_view = false;
    bool sets_parameters = false;
};

struct PlannedTechnique {
    const Manifest* manifest = nullptr;
    const TechniqueSelection* selection = nullptr;
    /// Null without.
    const Preset* preset = nullptr;
};

/// Quantities and values, all of which must hold for a cell to be dropped.
using Exclusion = std::vector<std::pair<std::string, std::vector<Json>>>;

/// A configuration checked against the techniques, ready to be expanded. Refers to both.
struct Plan {
    std::vector<PlannedAxis> axes;
    /// In the order of their first axes.
    std::vector<AxisGroup> groups;
    std::vector<PlannedTechnique> techniques;
    std::vector<Exclusion> exclusions;
    ManifestIndex manifests;
};

/// All that can be wrong with a configuration apart from having no cells is an Error here.
Plan plan_sweep(const Configuration& configuration, const std::vector<Manifest>& techniques);

/// The manifest of the id; an unknown one is an Error with a "did you mean".
const Manifest& require_technique(const ManifestIndex& manifests, const std::string& id, const JsonView& where);

/// The parameter of the technique; an unknown one is an Error with a "did you mean".
const Parameter& require_parameter(const Manifest& manifest, const std::string& name, const JsonView& where);

/// The preset of the technique; an unknown one, or one of another technique, is an Error that says so.
const Preset& require_preset(const Manifest& manifest, const std::string& name, const ManifestIndex& manifests,
                             const JsonView& where);

/// The value of an axis that sets a parameter, as the technique's type.
ParameterValue axis_parameter_value(const Parameter& parameter, const Json& value);

}  // namespace reliefbench
