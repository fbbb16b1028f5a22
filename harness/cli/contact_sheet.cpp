#include "cli/contact_sheet.hpp"

#include "core/attempt.hpp"
#include "core/log.hpp"
#include "manifest/parameter_json.hpp"
#include "metrics/window.hpp"
#include "picture/map_picture.hpp"
#include "picture/sheet.hpp"
#include "report/figure_lines.hpp"
#include "store/chosen_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <sstream>

namespace reliefbench {

namespace {

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream stream(text);
    return {std::istream_iterator<std::string>(stream), {}};
}

/// Parts of a cell's id: "pom max_steps=16 | heightmap=bricks view_angle=60".
struct IdParts {
    std::string technique;
    std::vector<std::string> axes;
};

IdParts parts_of(const Cell& cell) {
    IdParts parts;
    parts.technique = cell.technique;
    const std::size_t bar = cell.id.find(" | ");
    if (bar == std::string::npos) return parts;
    parts.axes = words_of(cell.id.substr(bar + 3));
    return parts;
}

/// What is said of every cell alike.
std::vector<std::string> common_axes(const std::vector<Cell>& cells) {
    std::vector<std::string> common = parts_of(cells.front()).axes;
    for (const Cell& cell : cells) {
        const std::vector<std::string> axes = parts_of(cell).axes;
        std::erase_if(common,
                      [&](const std::string& axis) { return std::find(axes.begin(), axes.end(), axis) == axes.end(); });
    }
    return common;
}

std::string words(const std::vector<std::string>& list) {
    return fmt::format("{}", fmt::join(list, "  "));
}

/// The sample count, and what is not at its default.
std::vector<std::string> parameter_words(const Manifest& manifest, const ParameterValues& values) {
    std::vector<std::string> list;
    for (const Parameter& parameter : manifest.parameters) {
        const ParameterValue& set = values.at(parameter.name);
        if (parameter.name != manifest.sample_count && set == parameter.default_value) continue;
        const Json value = to_json(set);
        list.push_back(
            fmt::format("{}={}", parameter.name, value.is_string() ? value.get<std::string>() : value.dump()));
    }
    return list;
}

/// Characters of a label's line.
constexpr std::size_t max_line = 38;

/// Words filled into lines of a label's width.
std::vector<std::string> in_lines(const std::vector<std::string>& list) {
    std::vector<std::string> lines;
    for (const std::string& word : list) {
        if (lines.empty() || lines.back().size() + 1 + word.size() > max_line) {
            lines.push_back(word);
        } else {
            lines.back() += " " + word;
        }
    }
    return lines;
}

void append(std::vector<std::string>& lines, const std::vector<std::string>& more) {
    lines.insert(lines.end(), more.begin(), more.end());
}

std::vector<std::string> captions_of(const CellResult& result) {
    using namespace chosen_figures;
    std::vector<std::string> lines;
    for (const std::string& caption :
         figure_lines(result, {quality, median_uv, missed, false_hits, flip, taps, taps_p95, shadow, shadow_taps}))
        append(lines, in_lines(words_of(caption)));
    return lines;
}

Sheet::Row row_of(const Cell& cell, const Manifest& manifest, const std::vector<std::string>& common) {
    Sheet::Row row;
    row.title = cell.technique;
    std::vector<std::string> own = parts_of(cell).axes;
    std::erase_if(
        own, [&](const std::string& axis) { return std::find(common.begin(), common.end(), axis) != common.end(); });
    row.lines = in_lines(parameter_words(manifest, cell.parameters));
    append(row.lines, in_lines(own));
    return row;
}

std::vector<Picture> cropped_pictures(const std::vector<Shown>& shown, const DrawnCell& drawn) {
    const Rectangle relief = relief_rectangle(drawn.truth);
    std::vector<Picture> pictures = pictures_of(shown, drawn);
    for (Picture& picture : pictures)
        picture = cropped(picture, relief);
    return pictures;
}

/// How a cell ended, in a label: of a compiler's message the first line.
std::vector<std::string> ending_lines(const CellResult& result) {
    if (result.status == CellStatus::ok) return {};
    const std::string ending = describe_ending(result);
    return in_lines(words_of(ending.substr(0, ending.find('\n'))));
}

}  // namespace

std::vector<Sheet::Column> columns_of(const std::vector<Shown>& shown, const Font& font) {
    constexpr int narrowest = 0;
    std::vector<Sheet::Column> columns;
    for (const Shown& what : shown) {
        switch (what.kind) {
            case Shown::Kind::picture:
                columns.push_back({"picture", {}});
                break;
            case Shown::Kind::truth:
                columns.push_back({"ground truth", {}});
                break;
            case Shown::Kind::map:
                columns.push_back({scale_of(what.map).title, legend(scale_of(what.map), narrowest, font)});
                break;
        }
    }
    return columns;
}

std::vector<Picture> pictures_of(const std::vector<Shown>& shown, const DrawnCell& drawn) {
    std::vector<Picture> pictures;
    for (const Shown& what : shown) {
        switch (what.kind) {
            case Shown::Kind::picture:
                pictures.push_back(display_picture(drawn.probe.colour));
                break;
            case Shown::Kind::truth:
                pictures.push_back(display_picture(drawn.truth.colour));
                break;
            case Shown::Kind::map:
                pictures.push_back(map_picture(what.map, drawn));
                break;
        }
    }
    return pictures;
}

Rectangle relief_rectangle(const Truth& truth) {
    constexpr int margin = 4;
    Image<std::uint8_t> relief = truth.footprint;
    for (std::size_t pixel = 0; pixel < relief.texels.size(); ++pixel) {
        if (truth.hits.texels[pixel].is_hit()) relief.texels[pixel] = 1;
    }
    const Window window = window_around(relief, margin);
    if (window.size.pixels() == 0) return {0, 0, relief.size};
    return {window.left, window.top, window.size};
}

ContactSheet make_contact_sheet(const std::vector<Cell>& cells, const std::vector<Shown>& shown, Laboratory& laboratory,
                                const LaboratoryCallbacks& callbacks, const Font& font) {
    ContactSheet made;
    const std::vector<std::string> common = common_axes(cells);
    made.sheet.title = words(common);
    made.sheet.columns = columns_of(shown, font);
    for (const Cell& cell : cells) {
        Sheet::Row row = row_of(cell, laboratory.manifest_of(cell), common);
        laboratory.keep_only({cell.view});
        PreparedCell prepared = laboratory.make_ready(cell, callbacks);
        const std::string failure = failure_of([&] {
            if (prepared.probe) row.pictures = cropped_pictures(shown, laboratory.beside_truth(cell, *prepared.probe));
        });
        if (!failure.empty()) prepared.result = ended_result(cell, CellStatus::failed, failure);
        append(row.lines, captions_of(prepared.result));
        append(row.lines, ending_lines(prepared.result));
        tell_ending(prepared.result);
        if (prepared.result.status == CellStatus::failed) ++made.failures;
        made.sheet.rows.push_back(std::move(row));
    }
    return made;
}

void tell_ending(const CellResult& result) {
    if (result.status == CellStatus::failed) log_error("failed: {}: {}", result.cell, result.reason);
    if (result.status == CellStatus::skipped) log_warning("skipped: {}: {}", result.cell, result.reason);
}

}  // namespace reliefbench
