#include "store/cell_result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace reliefbench {

namespace {

using Member = FigureList::Member;

const std::vector<std::string> status_names = {"ok", "skipped", "failed"};

/// In the order of StopReason.
const std::vector<std::string> stop_reason_names = {"precise", "stalled", "budget", "rounds", "time", "narrowed"};

constexpr std::string_view stop_key = "stop";
constexpr std::string_view time_group = "time";
constexpr std::string_view prepare_group = "prepare";

/// A pass, among the members of "time".
bool is_pass(const Member& time, std::string_view key) {
    if (key == stop_key) return false;
    const Member* const member = time.find(key);
    return member == nullptr || !member->figure;
}

const Member& group_of_line(const FigureList& list, std::string_view key) {
    const Member* const group = list.line().find(key);
    assert(group != nullptr);
    return *group;
}

/// What every pass has: the draw's figures.
const Member& pass_group(const FigureList& list) {
    const Member* const group = group_of_line(list, time_group).find(draw_pass);
    assert(group != nullptr);
    return *group;
}

Json number_to_json(const FigureDeclaration& figure, const std::optional<double>& value) {
    if (!value || !std::isfinite(*value)) return nullptr;
    return figure.is_count ? Json(static_cast<std::uint64_t>(*value)) : Json(*value);
}

/// Of figures by their place in a list.
struct FigureSource {
    const FigureList& list;
    std::function<std::optional<double>(std::size_t)> value;
    /// Given, be it undefined.
    std::function<bool(std::size_t)> is_given;
};

bool has_any(const Member& member, const FigureSource& source) {
    if (member.figure) return source.is_given(*member.figure);
    return std::any_of(member.members.begin(), member.members.end(),
                       [&](const Member& each) { return has_any(each, source); });
}

/// A group in which nothing is given is null.
Json member_to_json(const Member& member, const FigureSource& source) {
    if (member.figure) return number_to_json(source.list.all()[*member.figure], source.value(*member.figure));
    if (!has_any(member, source)) return nullptr;
    Json json = member.is_interval() ? Json::array() : Json::object();
    for (const Member& each : member.members) {
        if (member.is_interval()) {
            json.push_back(member_to_json(each, source));
        } else {
            json[each.key] = member_to_json(each, source);
        }
    }
    return json;
}

/// Numbers that are not finite are undefined.
std::optional<double> stored_value(std::size_t figure, const CellResult& result) {
    return figure < time_figure_count() ? time_value(figure, result) : result.figures.value(figure);
}

FigureSource source_of(const CellResult& result) {
    const auto value = [&result](std::size_t figure) { return stored_value(figure, result); };
    const auto is_given = [&result](std::size_t figure) {
        return figure < time_figure_count() ? time_value(figure, result).has_value() : result.figures.is_given(figure);
    };
    return {result.figures.list(), value, is_given};
}

Json times_to_json(const CellResult& result) {
    const FigureList& list = result.figures.list();
    const Member& time = group_of_line(list, time_group);
    const FigureSource of_cell = source_of(result);
    Json json = Json::object();
    for (const auto& [pass, timing] : result.time) {
        assert(is_pass(time, pass));
        const bool is_draw = pass == draw_pass;
        const PassTiming& of_pass = timing;
        const auto value = [&](std::size_t figure) {
            return is_draw ? of_cell.value(figure) : pass_value(figure, of_pass);
        };
        json[pass] = member_to_json(pass_group(list),
                                    {list, value, [&](std::size_t figure) { return value(figure).has_value(); }});
    }
    json[stop_key] = result.stop ? Json(to_string(*result.stop)) : Json(nullptr);
    for (const Member& member : time.members) {
        if (member.figure) json[member.key] = member_to_json(member, of_cell);
    }
    return json;
}

/// Takes the value of a figure; empty for null.
using TakeFigure = std::function<void(std::size_t figure, std::optional<double> value)>;

void read_member(const JsonView& view, const Member& member, const FigureList& list, const TakeFigure& take) {
    if (member.figure) {
        if (view.json().is_null()) return take(*member.figure, std::nullopt);
        const bool is_count = list.all()[*member.figure].is_count;
        return take(*member.figure, is_count ? static_cast<double>(view.integer(0)) : view.number());
    }
    if (view.json().is_null()) return;
    if (member.is_interval()) {
        if (!view.json().is_array() || view.json().size() != 2) view.fail_expected("[low, high]");
        const std::vector<JsonView> bounds = view.items();
        for (std::size_t bound = 0; bound < bounds.size(); ++bound)
            read_member(bounds[bound], member.members[bound], list, take);
        return;
    }
    for (const auto& [key, value] : view.members()) {
        const Member* const known = member.find(key);
        if (known != nullptr) {
            read_member(value, *known, list, take);
            continue;
        }
        std::vector<std::string> keys;
        for (const Member& each : member.members)
            keys.push_back(each.key);
        view.require_only(keys);
    }
}

void take_figure(CellResult& result, std::size_t figure, std::optional<double> value) {
    if (figure >= time_figure_count()) {
        result.figures.set(figure, value.value_or(std::numeric_limits<double>::quiet_NaN()));
    } else if (value) {
        set_time_value(figure, result, *value);
    }
}

void read_group(const JsonView& view, const Member& group, CellResult& result) {
    read_member(view, group, result.figures.list(),
                [&](std::size_t figure, std::optional<double> value) { take_figure(result, figure, value); });
}

PassTiming read_timing(const JsonView& view, const std::string& pass, CellResult& result) {
    const FigureList& list = result.figures.list();
    PassTiming timing;
    read_member(view, pass_group(list), list, [&](std::size_t figure, std::optional<double> value) {
        if (figure >= time_figure_count()) {
            if (pass == draw_pass) take_figure(result, figure, value);
        } else if (value) {
            set_pass_value(figure, timing, *value);
        } else if (is_of_every_pass(figure)) {
            view.fail_here(fmt::format("{} is null, which every pass has", list.all()[figure].label));
        }
    });
    for (const Member& member : pass_group(list).members) {
        const std::size_t first = member.figure ? *member.figure : *member.members.front().figure;
        if (is_of_every_pass(first)) view.at(member.key);
    }
    return timing;
}

void read_times(const JsonView& view, CellResult& result) {
    const Member& time = group_of_line(result.figures.list(), time_group);
    for (const auto& [key, value] : view.members()) {
        if (is_pass(time, key)) {
            result.time[key] = read_timing(value, key, result);
        } else if (key != stop_key) {
            read_group(value, *time.find(key), result);
        } else if (!value.json().is_null()) {
            result.stop = static_cast<StopReason>(value.choice(stop_reason_names));
        }
    }
}

std::map<std::string, std::map<std::string, double>> read_executable(const JsonView& view) {
    std::map<std::string, std::map<std::string, double>> executable;
    for (const auto& [stage, statistics] : view.members()) {
        for (const auto& [statistic, value] : statistics.members()) {
            executable[stage][statistic] = value.number();
        }
    }
    return executable;
}

Json read_object(const JsonView& view) {
    if (!view.json().is_object()) view.fail_expected("an object");
    return view.json();
}

}  // namespace

std::string_view to_string(StopReason reason) {
    return stop_reason_names[static_cast<std::size_t>(reason)];
}

std::optional<double> value_of(const FigureDeclaration& figure, const CellResult& cell) {
    const FigureList& list = cell.figures.list();
    const std::optional<std::size_t> index = list.index_of(figure);
    if (!index) return std::nullopt;
    const std::optional<double> value = stored_value(*index, cell);
    const bool may_be_infinite = !value && !figure.infinite_at_zero.empty();
    if (may_be_infinite && value_of(figure.infinite_at_zero, cell) == 0.0)
        return std::numeric_limits<double>::infinity();
    return value;
}

std::optional<double> value_of(std::string_view path, const CellResult& cell) {
    const FigureDeclaration* const figure = cell.figures.list().find(path);
    return figure == nullptr ? std::nullopt : value_of(*figure, cell);
}

bool is_given(const FigureDeclaration& figure, const CellResult& cell) {
    const std::optional<std::size_t> index = cell.figures.list().index_of(figure);
    return index && source_of(cell).is_given(*index);
}

Json to_json(const CellResult& result) {
    const FigureSource source = source_of(result);
    Json json;
    json["cell"] = result.cell;
    json["technique"] = result.technique;
    if (!result.preset.empty()) json["preset"] = result.preset;
    json["axes"] = result.axes.is_null() ? Json::object() : result.axes;
    json["parameters"] = result.parameters.is_null() ? Json::object() : result.parameters;
    json["status"] = status_names[static_cast<std::size_t>(result.status)];
    json["reason"] = result.reason.empty() ? Json(nullptr) : Json(result.reason);
    json["time"] = times_to_json(result);
    for (const Member& member : group_of_line(source.list, prepare_group).members)
        json[prepare_group][member.key] = member_to_json(member, source);
    json["pipeline"] = Json::object();
    for (const auto& [statistic, value] : result.pipeline) {
        json["pipeline"][statistic] = value;
    }
    json["executable"] = Json::object();
    for (const auto& [stage, statistics] : result.executable) {
        for (const auto& [statistic, value] : statistics) {
            json["executable"][stage][statistic] = finite_or_null(value);
        }
    }
    for (const Member& group : source.list.line().members) {
        if (group.key != time_group && group.key != prepare_group) json[group.key] = member_to_json(group, source);
    }
    if (result.forced_resume) json["forced_resume"] = true;
    return json;
}

CellResult parse_cell_result(const Json& json, const std::string& file, const std::shared_ptr<const FigureList>& list) {
    const JsonView view(json, file);
    // Runs of version 0.1.0 have the short key.
    const std::string parameters = view.has("params") ? "params" : "parameters";
    std::vector<std::string> known = keys_beside_figures();
    std::erase(known, parameters == "params" ? "parameters" : "params");
    for (const Member& group : list->line().members)
        known.push_back(group.key);
    view.require_only(known);
    CellResult result(list);
    result.cell = view.at("cell").string();
    result.technique = view.at("technique").string();
    if (view.has("preset")) result.preset = view.at("preset").string();
    result.axes = read_object(view.at("axes"));
    result.parameters = read_object(view.at(parameters));
    result.status = static_cast<CellStatus>(view.at("status").choice(status_names));
    if (const JsonView reason = view.at("reason"); !reason.json().is_null()) result.reason = reason.string();
    read_times(view.at(std::string(time_group)), result);
    for (const Member& group : list->line().members) {
        if (group.key != time_group && view.has(group.key)) read_group(view.at(group.key), group, result);
    }
    for (const auto& [statistic, value] : view.at("pipeline").members()) {
        result.pipeline[statistic] = static_cast<std::uint64_t>(value.integer(0));
    }
    if (view.has("executable")) result.executable = read_executable(view.at("executable"));
    if (view.has("forced_resume")) result.forced_resume = view.at("forced_resume").boolean();
    return result;
}

}  // namespace reliefbench
