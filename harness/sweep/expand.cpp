#include "core/error.hpp"
#include "core/log.hpp"
#include "core/suggest.hpp"
#include "scene/surface/generated_base.hpp"
#include "sweep/configuration.hpp"
#include "sweep/plan.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <unordered_map>
#include <unordered_set>

namespace reliefbench {

namespace {

/// Above this the matrix is a mistake: at a tenth of a second a cell it would run for a day and more.
constexpr double max_cells = 1e6;

/// Which value of a group's axes is taken.
struct GroupChoice {
    const AxisGroup* group = nullptr;
    std::size_t index = 0;
};
using GroupChoices = std::vector<GroupChoice>;

/// One set of parameters of one technique.
struct Assignment {
    const PlannedTechnique* technique = nullptr;
    ParameterValues values;
    /// Parameters that axes have set.
    std::vector<std::string> swept;
    std::string skip_reason;
    std::string id;
};

/// Calls `visit` with each combination of the groups' values, the last group's advancing fastest.
template <typename Visit>
void for_each_choice(const std::vector<const AxisGroup*>& groups, const Visit& visit) {
    GroupChoices choices;
    for (const AxisGroup* group : groups)
        choices.push_back({group, 0});
    for (;;) {
        visit(choices);
        std::size_t position = choices.size();
        while (position > 0 && ++choices[position - 1].index == choices[position - 1].group->length) {
            choices[--position].index = 0;
        }
        if (position == 0) return;
    }
}

bool is_set_by_name(const PlannedTechnique& technique, const std::string& parameter) {
    return std::ranges::any_of(technique.selection->parameters,
                               [&](const auto& named) { return named.first == parameter; });
}

/// Turns values of axes into the parameters of one technique.
class Assigner {
public:
    Assigner(const Plan& plan, const PlannedTechnique& technique)
        : plan_(plan), technique_(technique), unswept_(values_of_preset(*technique.manifest, technique.preset)) {
        for (const PlannedAxis& axis : plan.axes)
            axis_names_.insert(axis.name);
    }

    bool is_affected_by(const PlannedAxis& axis) const {
        const Manifest& manifest = *technique_.manifest;
        if (axis.view) return false;
        if (axis.name != "sample_count") {
            return manifest.find_parameter(axis.name) && !is_set_by_name(technique_, axis.name);
        }
        return manifest.sample_count && !is_set_by_name(technique_, *manifest.sample_count) &&
               !axis_names_.contains(*manifest.sample_count);
    }

    bool is_affected_by(const AxisGroup& group) const {
        return std::ranges::any_of(group.axes, [&](std::size_t axis) { return is_affected_by(plan_.axes[axis]); });
    }

    /// The defaults or the preset, changed by the axes; without the values set by name.
    Assignment assign(const GroupChoices& outer, const GroupChoices& inner) const {
        Assignment assignment{&technique_, unswept_, {}, {}, {}};
        // The sample count first: an axis of the adaptive minimum's own name then replaces what follows from it.
        for (const bool sample_count : {true, false}) {
            for (const GroupChoices* choices : {&outer, &inner}) {
                for (const GroupChoice& choice : *choices)
                    apply(choice, sample_count, assignment);
            }
        }
        return assignment;
    }

    /// The assignment with every combination of the values set by name.
    void append_named(const Assignment& base, bool on_flat_base, std::vector<Assignment>& assignments) const {
        std::vector<Assignment> named{base};
        for (const auto& [name, values] : technique_.selection->parameters) {
            std::vector<Assignment> extended;
            for (const Assignment& assignment : named) {
                for (const ParameterValue& value : values) {
                    extended.push_back(assignment);
                    extended.back().values[name] = value;
                }
            }
            named = std::move(extended);
        }
        for (Assignment& assignment : named) {
            reset_idle(*technique_.manifest, assignment.values, on_flat_base);
            assignment.skip_reason = complain_of_swept_values(assignment);
            assignment.id = technique_id(*technique_.manifest, assignment.values, technique_.preset);
            assignments.push_back(std::move(assignment));
        }
    }

private:
    void apply(const GroupChoice& choice, bool sample_count, Assignment& assignment) const {
        const Manifest& manifest = *technique_.manifest;
        for (const std::size_t index : choice.group->axes) {
            const PlannedAxis& axis = plan_.axes[index];
            if ((axis.name == "sample_count") != sample_count || !is_affected_by(axis)) continue;
            const Json& value = axis.values[choice.index];
            if (sample_count) {
                set_sample_count(manifest, assignment.values, value.get<std::int64_t>(), unswept_);
                assignment.swept.push_back(*manifest.sample_count);
                if (manifest.sample_count_minimum) assignment.swept.push_back(*manifest.sample_count_minimum);
            } else {
                assignment.values[axis.name] = axis_parameter_value(*manifest.find_parameter(axis.name), value);
                assignment.swept.push_back(axis.name);
            }
        }
    }

    std::string complain_of_swept_values(const Assignment& assignment) const {
        std::vector<std::string> complaints;
        for (const std::string& name : assignment.swept) {
            if (is_set_by_name(technique_, name)) continue;
            const Parameter& parameter = *technique_.manifest->find_parameter(name);
            const std::string complaint = check_parameter_value(parameter, assignment.values.at(name));
            if (!complaint.empty() && std::ranges::find(complaints, complaint) == complaints.end()) {
                complaints.push_back(complaint);
            }
        }
        return join(complaints, "; ");
    }

    const Plan& plan_;
    const PlannedTechnique& technique_;
    ParameterValues unswept_;
    std::unordered_set<std::string> axis_names_;
};

/// Notices values that are given to parameters without effect in any cell (has_effect).
class IdleValues {
public:
    void see(const Assignment& assignment, bool on_flat_base) {
        const TechniqueSelection& selection = *assignment.technique->selection;
        for (const auto& [name, values] : selection.parameters)
            see(assignment, on_flat_base, name, &selection);
        for (const std::string& name : assignment.swept)
            see(assignment, on_flat_base, name, nullptr);
    }

    void fail_if_any(const Configuration& configuration) const {
        for (const auto& [given, needs] : needs_) {
            const auto& [name, selection] = given;
            if (needs.empty()) continue;
            const auto axis = std::ranges::find(configuration.axes, name, &Axis::name);
            const Origin& origin = selection                          ? selection->origin
                                   : axis == configuration.axes.end() ? configuration.origin
                                                                      : axis->origin;
            fail("{}: {}: '{}' has no effect in any cell: it needs {}", origin.file, origin.path, name, needs);
        }
    }

private:
    void see(const Assignment& assignment, bool on_flat_base, const std::string& name,
             const TechniqueSelection* selection) {
        const Parameter& parameter = *assignment.technique->manifest->find_parameter(name);
        const auto [found, is_new] = needs_.try_emplace({name, selection}, describe_needs(parameter));
        if (has_effect(parameter, assignment.values, on_flat_base)) found->second.clear();
    }

    /// By parameter and, where it is set by name, selection: what it would need, or nothing once it had an effect.
    std::map<std::pair<std::string, const TechniqueSelection*>, std::string> needs_;
};

/// Every technique with every set of parameters that a view is drawn with, no two alike.
std::vector<Assignment> assignments_of(const Plan& plan, const GroupChoices& outer, bool on_flat_base,
                                       IdleValues& idle_values) {
    std::vector<Assignment> assignments;
    for (const PlannedTechnique& technique : plan.techniques) {
        const Assigner assigner(plan, technique);
        std::vector<const AxisGroup*> groups;
        for (const AxisGroup& group : plan.groups) {
            if (!group.sets_view && assigner.is_affected_by(group)) groups.push_back(&group);
        }
        for_each_choice(groups, [&](const GroupChoices& inner) {
            assigner.append_named(assigner.assign(outer, inner), on_flat_base, assignments);
        });
    }
    for (const Assignment& assignment : assignments)
        idle_values.see(assignment, on_flat_base);
    std::unordered_set<std::string> ids;
    std::erase_if(assignments, [&](const Assignment& assignment) { return !ids.insert(assignment.id).second; });
    return assignments;
}

ViewKey view_of(const Plan& plan, const GroupChoices& outer) {
    std::vector<ViewChoice> choices;
    for (const GroupChoice& choice : outer) {
        for (const std::size_t index : choice.group->axes) {
            const PlannedAxis& axis = plan.axes[index];
            if (axis.view) choices.push_back({axis.view, &axis.settings[choice.index]});
        }
    }
    return make_view(choices);
}

/// Decides which cells are dropped, and notices exclusions that drop none.
class Excluder {
public:
    explicit Excluder(const Plan& plan) : plan_(plan), used_(plan.exclusions.size(), false) {}

    bool drops(const Cell& cell) {
        bool dropped = false;
        for (std::size_t index = 0; index < plan_.exclusions.size(); ++index) {
            const bool matches = std::ranges::all_of(plan_.exclusions[index], [&](const auto& condition) {
                // Not a structured binding: Clang 14 takes none into a lambda.
                const std::string& name = condition.first;
                const std::vector<Json>& values = condition.second;
                const Json quantity = cell_quantity(cell, name, plan_.manifests);
                return std::ranges::any_of(values,
                                           [&](const Json& value) { return quantity_equals(name, quantity, value); });
            });
            if (matches) used_[index] = true;
            dropped = dropped || matches;
        }
        return dropped;
    }

    void warn_of_unused(const Origin& origin) const {
        for (std::size_t index = 0; index < used_.size(); ++index) {
            if (!used_[index]) log_warning("{}: {}.exclude[{}] drops no cell", origin.file, origin.path, index);
        }
    }

private:
    const Plan& plan_;
    std::vector<bool> used_;
};

/// Of two views with one id: the axis of the files in which they differ.
std::array<std::string, 3> differing_files(const ViewKey& one, const ViewKey& other) {
    if (one.base != other.base) return {"base", one.base.file.string(), other.base.file.string()};
    if (one.height_map.name != other.height_map.name) return {"heightmap", one.height_map.name, other.height_map.name};
    return {"albedo", one.height_map.albedo, other.height_map.albedo};
}

/// Why relief above the polygon cannot be drawn in this view.
std::string polygon_problem(const ViewKey& key) {
    const View& view = key.view;
    if (view.relief.polygon_height == 1) return {};
    if (!key.base.is_flat()) return "a polygon_height below 1 is known of the plane alone";
    if (view.depth_write == DepthWrite::conservative)
        return "relief above the polygon is nearer than it, which depth_write conservative rules out";
    if (view.camera.projection == Projection::perspective && camera_frame(view.camera).eye.z <= 0)
        return "the eye would lie beneath the highest relief; move it away or towards head-on";
    return {};
}

/// Why there is no relief on this base: it overlaps itself, or the relief would fold. Of a product of axes these are
/// single cells.
std::string base_problem(const ViewKey& view) {
    if (std::string problem = polygon_problem(view); !problem.empty()) return problem;
    const std::string problem = curvature_problem(view.base);
    return problem.empty() ? folding_problem(view.base, view.view.relief.height_scale) : problem;
}

/// The cells gathered by view, so that those of one view are neighbours even where a zip meets a view twice.
class Matrix {
public:
    Matrix(const Plan& plan, const Origin& origin) : excluder_(plan), origin_(origin) {}

    void add(const ViewKey& view, const std::vector<Assignment>& assignments) {
        const std::string id = view_id(view);
        const auto [found, is_new] = bucket_of_view_.try_emplace(id, buckets_.size());
        if (is_new) buckets_.push_back({view, {}, {}});
        Bucket& bucket = buckets_[found->second];
        if (bucket.view != view) {
            const auto [axis, one, other] = differing_files(bucket.view, view);
            fail(
                "{}: {}.axes.{}: '{}' and '{}' would both be called '{}' in results, which tell files by base "
                "name; rename one",
                origin_.file, origin_.path, axis, one, other, id);
        }
        const std::string problem = base_problem(view);
        for (const Assignment& assignment : assignments) {
            if (!is_new && bucket.assignments.contains(assignment.id)) continue;
            bucket.assignments.insert(assignment.id);
            Cell cell;
            cell.id = assignment.id + " | " + id;
            cell.technique = assignment.technique->manifest->id;
            if (assignment.technique->preset != nullptr) cell.preset = assignment.technique->preset->name;
            cell.parameters = assignment.values;
            cell.view = view;
            cell.skip_reason = assignment.skip_reason.empty() ? problem : assignment.skip_reason;
            if (!excluder_.drops(cell)) bucket.cells.push_back(std::move(cell));
        }
    }

    std::vector<Cell> take() {
        excluder_.warn_of_unused(origin_);
        std::vector<Cell> cells;
        for (Bucket& bucket : buckets_) {
            std::ranges::move(bucket.cells, std::back_inserter(cells));
        }
        return cells;
    }

private:
    struct Bucket {
        ViewKey view;
        std::vector<Cell> cells;
        std::unordered_set<std::string> assignments;
    };
    Excluder excluder_;
    const Origin& origin_;
    std::vector<Bucket> buckets_;
    std::unordered_map<std::string, std::size_t> bucket_of_view_;
};

/// Before anything of that size is made.
void check_size(const Plan& plan, const Origin& origin) {
    double views = 1;
    for (const AxisGroup& group : plan.groups)
        views *= group.sets_view ? static_cast<double>(group.length) : 1;
    double cells = 0;
    for (const PlannedTechnique& technique : plan.techniques) {
        const Assigner assigner(plan, technique);
        double count = views;
        for (const AxisGroup& group : plan.groups) {
            if (!group.sets_view && assigner.is_affected_by(group)) count *= static_cast<double>(group.length);
        }
        for (const auto& [name, values] : technique.selection->parameters)
            count *= static_cast<double>(values.size());
        cells += count;
    }
    if (cells > max_cells) {
        fail("{}: {}.axes: {:.0f} cells are more than {:.0f}; take fewer values, or tie axes with \"zip\"", origin.file,
             origin.path, cells, max_cells);
    }
}

}  // namespace

std::vector<Cell> expand(const Configuration& configuration, const std::vector<Manifest>& techniques) {
    const Plan plan = plan_sweep(configuration, techniques);
    std::vector<const AxisGroup*> outer_groups;
    bool outer_sets_parameters = false;
    for (const AxisGroup& group : plan.groups) {
        if (!group.sets_view) continue;
        outer_groups.push_back(&group);
        outer_sets_parameters = outer_sets_parameters || group.sets_parameters;
    }
    check_size(plan, configuration.origin);

    Matrix matrix(plan, configuration.origin);
    IdleValues idle_values;
    std::vector<Assignment> assignments;
    bool of_flat_base = true;
    for_each_choice(outer_groups, [&](const GroupChoices& outer) {
        const ViewKey view = view_of(plan, outer);
        if (assignments.empty() || outer_sets_parameters || of_flat_base != view.base.is_flat()) {
            of_flat_base = view.base.is_flat();
            assignments = assignments_of(plan, outer, of_flat_base, idle_values);
        }
        matrix.add(view, assignments);
    });
    idle_values.fail_if_any(configuration);
    std::vector<Cell> cells = matrix.take();
    if (cells.empty()) {
        fail("{}: no cell is left: \"exclude\" drops all of them; drop fewer", configuration.origin.file);
    }
    return cells;
}

}  // namespace reliefbench
