#include "cli/report_pictures.hpp"

#include "picture/colour_map.hpp"
#include "picture/map_picture.hpp"
#include "picture/pixel_map.hpp"
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
constexpr std::string_view main_map = "uv_error";

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

std::uint8_t to_byte(double value) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
}

PagePicture read_picture(const std::filesystem::path& path, int& step) {
    const RasterFile raster = read_raster_file(path);
    PagePicture picture{raster.size.width, raster.size.height, {}};
    const std::size_t channels = raster.channel_names.size();
    for (std::size_t pixel = 0; pixel < raster.size.pixels(); ++pixel) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            // Grey files have one channel for all three.
            picture.rgb.push_back(to_byte(raster.fraction(pixel * channels + (channels < 3 ? 0 : channel))));
        }
    }
    const int needed = (std::max(picture.width, picture.height) + largest_side - 1) / largest_side;
    step = std::max(step, needed);
    return needed > 1 ? every_nth_pixel(picture, needed) : picture;
}

/// Cells on the Pareto front of their view, then the others.
std::vector<std::size_t> order_of_interest(const std::vector<CellResult>& cells, const Json& record) {
    std::set<const CellResult*> on_front;
    const QualityCostTable table = quality_cost_table(cells, record);
    for (const QualityCostView& view : table.views) {
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

/// A cell's files.
struct CellFiles {
    std::size_t cell = 0;
    std::filesystem::path stem;
    std::vector<std::string> maps;
    bool has_truth = false;
    bool has_technique = false;
};

/// The error that most people look at goes before the others.
void put_main_map_first(std::vector<std::string>& maps) {
    std::stable_partition(maps.begin(), maps.end(), [](const std::string& map) { return map == main_map; });
}

std::vector<CellFiles> files_by_interest(const StoredRun& run, const std::set<std::string>& names) {
    std::vector<CellFiles> files;
    for (const std::size_t cell : order_of_interest(run.run.cells, run.run.run)) {
        CellFiles of_cell{cell, image_path(run.name, run.run.cells[cell].cell, ""), {}};
        for (const std::string& kind : kinds_of(of_cell.stem.filename().string(), names)) {
            if (kind.empty()) {
                of_cell.has_technique = true;
            } else if (kind == truth_kind) {
                of_cell.has_truth = true;
            } else {
                of_cell.maps.push_back(kind);
            }
        }
        put_main_map_first(of_cell.maps);
        if (of_cell.has_technique || of_cell.has_truth || !of_cell.maps.empty()) files.push_back(std::move(of_cell));
    }
    return files;
}

std::filesystem::path file_of(const std::filesystem::path& stem, const std::string& kind) {
    return stem.string() + (kind.empty() ? "" : "." + kind) + std::string(extension);
}

MapLegend legend_of(const PixelMapScale& scale) {
    constexpr int colours = 256;
    MapLegend legend{scale.title, scale.unit, scale.dark, scale.light, scale.logarithmic, {}, scale.marks, {}};
    for (int colour = 0; colour < colours; ++colour) {
        for (const double channel : magma(colour / (colours - 1.0))) {
            legend.colours.push_back(to_byte(channel));
        }
    }
    for (const Swatch& swatch : swatches_of(scale)) {
        legend.others.push_back({swatch.colour, swatch.text});
    }
    return legend;
}

/// Adds to what is known of one run.
class Collector {
public:
    Collector(std::size_t cells, PagePictures& pictures) : pictures_(pictures) {
        of_run_.technique.assign(cells, -1);
        of_run_.truth.assign(cells, -1);
    }

    void add_scene(const CellFiles& files) {
        std::optional<std::size_t> truth;
        if (files.has_truth) {
            truth = pictures_.add(read_picture(file_of(files.stem, std::string(truth_kind)), of_run_.step));
            of_run_.truth[files.cell] = static_cast<int>(*truth);
        }
        if (files.has_technique) {
            const PagePicture picture = read_picture(file_of(files.stem, ""), of_run_.step);
            of_run_.technique[files.cell] = static_cast<int>(pictures_.add(picture, truth));
        }
    }

    void add_map(const CellFiles& files, const std::string& map) {
        std::vector<int>& positions = of_run_.maps[map];
        positions.resize(of_run_.technique.size(), -1);
        positions[files.cell] = static_cast<int>(pictures_.add(read_picture(file_of(files.stem, map), of_run_.step)));
    }

    void add_legends() {
        for (const PixelMapScale& scale : pixel_map_scales()) {
            if (of_run_.maps.contains(scale.name)) of_run_.legends[scale.name] = legend_of(scale);
        }
    }

    void leave_out() { ++of_run_.left_out; }
    CellPictures take() { return std::move(of_run_); }

private:
    PagePictures& pictures_;
    CellPictures of_run_;
};

}  // namespace

CellPictures collect_pictures(const StoredRun& run, std::size_t max_bytes, PagePictures& pictures) {
    const std::filesystem::path images = std::filesystem::path(run.name) / "images";
    const std::set<std::string> names = image_names(images);
    const std::vector<CellFiles> files = files_by_interest(run, names);
    Collector collector(run.run.cells.size(), pictures);
    for (const CellFiles& of_cell : files) {
        if (pictures.bytes() >= max_bytes) {
            collector.leave_out();
            continue;
        }
        collector.add_scene(of_cell);
        if (!of_cell.maps.empty()) collector.add_map(of_cell, of_cell.maps.front());
    }
    // Further maps take what room the others leave.
    for (const CellFiles& of_cell : files) {
        for (std::size_t map = 1; map < of_cell.maps.size() && pictures.bytes() < max_bytes; ++map) {
            collector.add_map(of_cell, of_cell.maps[map]);
        }
    }
    collector.add_legends();
    return collector.take();
}

}  // namespace reliefbench
