#include "store/figures.hpp"

#include "core/error.hpp"
#include "core/split.hpp"
#include "metrics/history_errors.hpp"
#include "metrics/hit_errors.hpp"
#include "metrics/image_errors.hpp"
#include "metrics/motion_errors.hpp"
#include "metrics/outline_errors.hpp"
#include "metrics/raster_mismatch.hpp"
#include "metrics/shadow_errors.hpp"
#include "metrics/truth_noise.hpp"
#include "metrics/work.hpp"
#include "metrics/wrong_surface.hpp"
#include "store/cell_times.hpp"

#include <algorithm>
#include <cassert>
#include <functional>
#include <iterator>
#include <utility>

namespace reliefbench {

namespace {

/// The families, in the order of the file.
std::vector<FigureDeclaration> all_declarations() {
    std::vector<FigureDeclaration> all;
    for (std::vector<FigureDeclaration> family :
         {time_figures(), work_figures(), hit_error_figures(), outline_error_figures(), raster_mismatch_figures(),
          wrong_surface_figures(), shadow_error_figures(), image_error_figures(), truth_noise_figures(),
          motion_figures(), history_figures()})
        std::move(family.begin(), family.end(), std::back_inserter(all));
    return all;
}

/// A run that declares more, or deeper ones, is none: every cell has room for each.
constexpr std::size_t max_figures = 1000;
constexpr std::size_t max_path_parts = 8;

const std::vector<std::string> direction_names = {"lower", "higher", "neither"};

FigureDeclaration read_figure(const JsonView& view) {
    const auto text = [&](const char* key) { return view.has(key) ? view.at(key).string() : std::string(); };
    FigureDeclaration figure;
    figure.path = view.at("path").string();
    figure.label = view.at("label").string();
    figure.unit = text("unit");
    figure.better = static_cast<Better>(view.at("better").choice(direction_names));
    if (view.has("needs")) {
        for (const JsonView& need : view.at("needs").items())
            figure.needs.push_back(need.string());
    }
    figure.is_count = view.has("count") && view.at("count").boolean();
    figure.over = text("over");
    figure.infinite_at_zero = text("infinite_at_zero");
    figure.stand_in = text("stand_in");
    if (view.has("percent_of_pixels")) figure.percent_of_pixels = view.at("percent_of_pixels").number();
    figure.short_label = text("short_label");
    figure.legend = text("legend");
    const std::vector<std::string> parts = split(figure.path, '.');
    const std::vector<std::string>& others = keys_beside_figures();
    if (parts.size() < 2 || parts.size() > max_path_parts ||
        std::find(others.begin(), others.end(), parts.front()) != others.end() ||
        std::any_of(parts.begin(), parts.end(), [](const std::string& part) { return part.empty(); }))
        view.at("path").fail_expected("a path such as error.uv_texels.p99");
    return figure;
}

/// Puts a figure where its path leads; false where another stands in the way.
bool place(FigureList::Member& group, std::string_view path, std::size_t figure) {
    const std::size_t dot = path.find('.');
    const std::string_view key = path.substr(0, dot);
    auto at =
        std::find_if(group.members.begin(), group.members.end(), [&](const auto& each) { return each.key == key; });
    if (dot == std::string_view::npos) {
        if (at != group.members.end()) return false;
        group.members.push_back({std::string(key), figure});
        return true;
    }
    if (at == group.members.end()) at = group.members.insert(at, FigureList::Member{std::string(key)});
    return !at->figure && place(*at, path.substr(dot + 1), figure);
}

}  // namespace

bool is_time(const FigureDeclaration& figure) {
    return figure.has_need(figure_needs::timing);
}

bool is_error(const FigureDeclaration& figure) {
    return figure.has_need(figure_needs::truth);
}

const std::vector<std::string>& keys_beside_figures() {
    static const std::vector<std::string> keys = {"cell",     "technique",  "preset",       "axes",
                                                  "params",   "parameters", "status",       "reason",
                                                  "pipeline", "executable", "forced_resume"};
    return keys;
}

const FigureList::Member* FigureList::Member::find(std::string_view member) const {
    const auto found =
        std::find_if(members.begin(), members.end(), [&](const Member& each) { return each.key == member; });
    return found == members.end() ? nullptr : &*found;
}

FigureList::FigureList(std::vector<FigureDeclaration> figures) : figures_(std::move(figures)) {
    for (std::size_t index = 0; index < figures_.size(); ++index) {
        const std::string& path = figures_[index].path;
        if (!place(line_, path, index)) fail("the figure {} cannot stand beside the others in cells.jsonl", path);
        index_by_path_.emplace(path, index);
    }
}

const FigureDeclaration* FigureList::find(std::string_view path) const {
    const auto found = index_by_path_.find(path);
    return found == index_by_path_.end() ? nullptr : &figures_[found->second];
}

std::optional<std::size_t> FigureList::index_of(const FigureDeclaration& figure) const {
    const std::less<> before;
    if (!before(&figure, figures_.data()) && before(&figure, figures_.data() + figures_.size()))
        return static_cast<std::size_t>(&figure - figures_.data());
    const auto found = index_by_path_.find(figure.path);
    return found == index_by_path_.end() ? std::nullopt : std::optional(found->second);
}

std::shared_ptr<const FigureList> declared_figures() {
    static const auto list = std::make_shared<const FigureList>(all_declarations());
    return list;
}

std::span<const FigureDeclaration> figures() {
    return declared_figures()->all();
}

const FigureDeclaration* find_figure(std::string_view path) {
    return declared_figures()->find(path);
}

const FigureDeclaration& known_figure(std::string_view path) {
    const FigureDeclaration* const figure = find_figure(path);
    assert(figure != nullptr);
    return *figure;
}

Json figures_to_json(std::span<const FigureDeclaration> list) {
    Json json = Json::array();
    for (const FigureDeclaration& figure : list) {
        Json entry = {{"path", figure.path},
                      {"label", figure.label},
                      {"unit", figure.unit},
                      {"better", to_string(figure.better)},
                      {"needs", figure.needs}};
        if (figure.is_count) entry["count"] = true;
        if (figure.percent_of_pixels) entry["percent_of_pixels"] = *figure.percent_of_pixels;
        for (const auto& [key, text] :
             {std::pair("over", &figure.over), std::pair("infinite_at_zero", &figure.infinite_at_zero),
              std::pair("stand_in", &figure.stand_in), std::pair("short_label", &figure.short_label),
              std::pair("legend", &figure.legend)}) {
            if (!text->empty()) entry[key] = *text;
        }
        json.push_back(std::move(entry));
    }
    return json;
}

std::shared_ptr<const FigureList> figures_of_record(const Json& record, const std::string& file) {
    const auto known = declared_figures();
    const JsonView view(record, file);
    if (!view.has("figures")) return known;
    const JsonView list = view.at("figures");
    const std::vector<JsonView> entries = list.items();
    if (entries.size() > max_figures) list.fail_here("more figures than any version has");
    std::vector<FigureDeclaration> later;
    for (const JsonView& entry : entries) {
        FigureDeclaration figure = read_figure(entry);
        if (known->find(figure.path) == nullptr) later.push_back(std::move(figure));
    }
    if (later.empty()) return known;
    std::vector<FigureDeclaration> all(known->all().begin(), known->all().end());
    std::move(later.begin(), later.end(), std::back_inserter(all));
    try {
        return std::make_shared<const FigureList>(std::move(all));
    } catch (const Error& error) {
        list.fail_here(error.what());
    }
}

}  // namespace reliefbench
