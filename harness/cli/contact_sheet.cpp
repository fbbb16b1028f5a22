#include "cli/contact_sheet.hpp"

#include "core/error.hpp"
#include "core/log.hpp"
#include "manifest/parameter_json.hpp"
#include "measure/cell_figures.hpp"
#include "metrics/window.hpp"
#include "picture/map_picture.hpp"
#include "picture/sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <sstream>

namespace reliefbench {

namespace {

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
    std::istringstream words(cell.id.substr(bar + 3));
    for (std::string word; words >> word;) {
        parts.axes.push_back(word);
    }
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

/// Words filled into lines of a label's width.
std::vector<std::string> in_lines(const std::vector<std::string>& list, std::size_t longest) {
    std::vector<std::string> lines;
    for (const std::string& word : list) {
        if (lines.empty() || lines.back().size() + 1 + word.size() > longest) {
            lines.push_back(word);
        } else {
            lines.back() += " " + word;
        }
    }
    return lines;
}

std::vector<std::string> figures_of(const DrawnCell& drawn, const std::optional<ShadowErrors>& shadow) {
    const HitErrors errors = hit_errors_of(drawn);
    const ImageErrors image = image_errors_of(drawn).footprint;
    const std::optional<WorkSummary> work = summarize_work(drawn.probe, shadow.has_value());
    std::vector<std::string> lines;
    lines.push_back(errors.uv_texels ? fmt::format("UV error p99 {:.3g}, p50 {:.2g} texels", errors.uv_texels->p99,
                                                   errors.uv_texels->p50)
                                     : "UV error undefined");
    lines.push_back(fmt::format("missed {:.3g} %, false hits {:.3g} %", 100 * errors.missed, 100 * errors.false_hits));
    if (image.flip) lines.push_back(fmt::format("FLIP {:.3f}", *image.flip));
    if (work) lines.push_back(fmt::format("taps {:.4g} (p95 {:.4g})", work->taps_mean(), work->taps_p95()));
    if (work && shadow) {
        lines.push_back(fmt::format("shadow error {:.3g}, taps {:.4g}", shadow->mean, work->shadow_taps->mean));
    }
    return lines;
}

Sheet::Row row_of(const Cell& cell, const Manifest& manifest, const std::vector<std::string>& common) {
    constexpr std::size_t longest_line = 38;
    Sheet::Row row;
    row.title = cell.technique;
    std::vector<std::string> own = parts_of(cell).axes;
    std::erase_if(
        own, [&](const std::string& axis) { return std::find(common.begin(), common.end(), axis) != common.end(); });
    row.lines = in_lines(parameter_words(manifest, cell.parameters), longest_line);
    const std::vector<std::string> axes = in_lines(own, longest_line);
    row.lines.insert(row.lines.end(), axes.begin(), axes.end());
    return row;
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

Sheet make_contact_sheet(const std::vector<Cell>& cells, const std::vector<Shown>& shown, CellDrawing& drawing,
                         const Font& font, std::size_t& failures) {
    Sheet sheet;
    const std::vector<std::string> common = common_axes(cells);
    sheet.title = words(common);
    sheet.columns = columns_of(shown, font);
    for (const Cell& cell : cells) {
        Sheet::Row row = row_of(cell, drawing.manifest_of(cell), common);
        if (!cell.skip_reason.empty()) {
            row.lines.push_back("skipped: " + cell.skip_reason);
            sheet.rows.push_back(std::move(row));
            continue;
        }
        try {
            const Probe probe = drawing.probe(cell);
            const DrawnCell drawn = drawing.beside_truth(cell, probe);
            const Rectangle relief = relief_rectangle(drawn.truth);
            for (const Picture& picture : pictures_of(shown, drawn)) {
                row.pictures.push_back(cropped(picture, relief));
            }
            const std::vector<std::string> figures = figures_of(drawn, drawing.shadow_errors(cell, drawn));
            row.lines.insert(row.lines.end(), figures.begin(), figures.end());
            if (const std::string failure = failure_of(probe); !failure.empty()) {
                log_error("{}: {}", cell.id, failure);
                row.lines.push_back("failed: " + failure);
                ++failures;
            }
        } catch (const Error& error) {
            log_error("{}", error.what());
            row.lines.push_back(error.what());
            ++failures;
        }
        sheet.rows.push_back(std::move(row));
    }
    return sheet;
}

}  // namespace reliefbench
