#include "cli/report_pictures.hpp"

#include "report/quality_cost.hpp"
#include "scene/image_file.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <system_error>

namespace reliefbench {

namespace {

constexpr int largest_side = 512;
constexpr std::string_view extension = ".png";
constexpr std::string_view truth_kind = "truth";

/// Names of the PNG files in the run's folder of images, without their extension; sorted.
std::set<std::string> image_names(const std::filesystem::path& images) {
    std::set<std::string> names;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(images, ignored)) {
        if (entry.path().extension() == extension) names.insert(entry.path().stem().string());
    }
    return names;
}

/// What the folder has of a cell: "" is the technique's picture, "truth" the truth's, others are maps.
std::vector<std::string> kinds_of(const std::string& name, const std::set<std::string>& names) {
    std::vector<std::string> kinds;
    if (names.contains(name)) kinds.emplace_back();
    const std::string prefix = name + '.';
    for (auto at = names.lower_bound(prefix); at != names.end() && at->starts_with(prefix); ++at) {
        const std::string kind = at->substr(prefix.size());
        if (kind.find_first_of("@+=") == std::string::npos) kinds.push_back(kind);  // else another cell's
    }
    return kinds;
}

PagePicture read_picture(const std::filesystem::path& path, int& step) {
    const RasterFile raster = read_raster_file(path);
    PagePicture picture{raster.size.width, raster.size.height, {}};
    const std::size_t channels = raster.channel_names.size();
    for (std::size_t pixel = 0; pixel < raster.size.pixels(); ++pixel) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            // Grey files have one channel for all three.
            const float value = raster.values[pixel * channels + (channels < 3 ? 0 : channel)];
            picture.rgb.push_back(static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(value, 0.0F, 1.0F))));
        }
    }
    const int needed = (std::max(picture.width, picture.height) + largest_side - 1) / largest_side;
    step = std::max(step, needed);
    return needed > 1 ? every_nth_pixel(picture, needed) : picture;
}

/// Cells on the Pareto front of their view, then the others.
std::vector<std::size_t> order_of_interest(const std::vector<CellResult>& cells) {
    std::set<const CellResult*> on_front;
    for (const QualityCostView& view : quality_cost_views(cells)) {
        for (const QualityCostRow& row : view.rows) {
            if (row.mark == '*') on_front.insert(row.cell);
        }
    }
    std::vector<std::size_t> order(cells.size());
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
        order[cell] = cell;
    }
    std::stable_partition(order.begin(), order.end(),
                          [&](std::size_t cell) { return on_front.contains(&cells[cell]); });
    return order;
}

void add_cell(const std::filesystem::path& stem, const std::vector<std::string>& kinds, std::size_t cell,
              PagePictures& pictures, CellPictures& of_run) {
    const auto read = [&](const std::string& kind) {
        const std::string suffix = kind.empty() ? "" : "." + kind;
        return read_picture(stem.string() + suffix + std::string(extension), of_run.step);
    };
    std::optional<std::size_t> truth;
    if (std::find(kinds.begin(), kinds.end(), truth_kind) != kinds.end()) {
        truth = pictures.add(read(std::string(truth_kind)));
        of_run.truth[cell] = static_cast<int>(*truth);
    }
    for (const std::string& kind : kinds) {
        if (kind.empty()) {
            of_run.technique[cell] = static_cast<int>(pictures.add(read(kind), truth));
        } else if (kind != truth_kind) {
            std::vector<int>& map = of_run.maps[kind];
            map.resize(of_run.technique.size(), -1);
            map[cell] = static_cast<int>(pictures.add(read(kind)));
        }
    }
}

}  // namespace

CellPictures collect_pictures(const StoredRun& run, std::size_t most_bytes, PagePictures& pictures) {
    const std::vector<CellResult>& cells = run.run.cells;
    CellPictures of_run;
    of_run.technique.assign(cells.size(), -1);
    of_run.truth.assign(cells.size(), -1);
    const std::set<std::string> names = image_names(std::filesystem::path(run.name) / "images");
    if (names.empty()) return of_run;
    for (const std::size_t cell : order_of_interest(cells)) {
        const std::filesystem::path stem = image_path(run.name, cells[cell].cell, "");
        const std::vector<std::string> kinds = kinds_of(stem.filename().string(), names);
        if (kinds.empty()) continue;
        if (pictures.bytes() < most_bytes) {
            add_cell(stem, kinds, cell, pictures, of_run);
        } else {
            ++of_run.left_out;
        }
    }
    return of_run;
}

}  // namespace reliefbench
