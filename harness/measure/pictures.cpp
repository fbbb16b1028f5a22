#include "measure/pictures.hpp"

#include "metrics/error_maps.hpp"
#include "metrics/image_errors.hpp"
#include "picture/map_picture.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <vector>

namespace reliefbench {

namespace {

Image<float> taps_map(const Probe& probe) {
    const auto covered = std::count_if(probe.covered.texels.begin(), probe.covered.texels.end(),
                                       [](std::uint8_t value) { return value != 0; });
    const float of_stages = covered > 0 ? static_cast<float>(probe.stages.taps) / static_cast<float>(covered) : 0;
    Image<float> taps(probe.hits.size, std::numeric_limits<float>::quiet_NaN());
    for (std::size_t pixel = 0; pixel < taps.texels.size(); ++pixel) {
        if (probe.covered.texels[pixel] != 0) {
            taps.texels[pixel] = static_cast<float>(probe.work.texels[pixel].taps) + of_stages;
        }
    }
    return taps;
}

Image<Coverage> coverage_of(const DrawnCell& cell) {
    return coverage_map(compared_hits(cell));
}

Image<float> coverage_values(const DrawnCell& cell) {
    const Image<Coverage> coverage = coverage_of(cell);
    Image<float> values(coverage.size);
    std::transform(coverage.texels.begin(), coverage.texels.end(), values.texels.begin(),
                   [](Coverage pixel) { return static_cast<float>(pixel); });
    return values;
}

}  // namespace

ComparedHits compared_hits(const DrawnCell& cell) {
    const Truth& truth = cell.truth;
    ComparedHits hits{cell.probe.hits, truth.hits, truth.footprint, cell.map, cell.relief};
    if (truth.curved) {
        assert(cell.probe.normals);
        const CurvedTruth& curved = *truth.curved;
        hits.curved.emplace(CurvedHits{*cell.probe.normals, curved.normals, curved.entry_triangles, curved.off_chart});
    }
    return hits;
}

Image<float> pixel_map(PixelMap map, const DrawnCell& cell) {
    const Probe& probe = cell.probe;
    const Truth& truth = cell.truth;
    switch (map) {
        case PixelMap::uv_error:
            return uv_error_map(compared_hits(cell));
        case PixelMap::depth_error:
            return depth_error_map(compared_hits(cell));
        case PixelMap::normal_error:
            return normal_error_map(compared_hits(cell));
        case PixelMap::flip:
            return footprint_flip_map(probe.colour, truth.colour, {truth.footprint, truth.background});
        case PixelMap::ssim:
            return footprint_ssim_map(probe.colour, truth.colour, {truth.footprint, truth.background});
        case PixelMap::taps:
            return taps_map(probe);
        case PixelMap::coverage:
            break;
    }
    return coverage_values(cell);
}

Picture map_picture(PixelMap map, const DrawnCell& cell) {
    return map_picture(scale_of(map), pixel_map(map, cell), coverage_of(cell));
}

RasterFile layers(const DrawnCell& cell) {
    RasterFile raster;
    raster.size = cell.probe.hits.size;
    raster.bits = 32;
    raster.channel_names = {"hit.u",   "hit.v",         "hit.h",         "hit.t",        "truth.u",
                            "truth.v", "truth.h",       "truth.t",       "color.R",      "color.G",
                            "color.B", "truth_color.R", "truth_color.G", "truth_color.B"};
    std::vector<Image<float>> maps;
    for (const PixelMapScale& scale : pixel_map_scales()) {
        raster.channel_names.push_back(scale.name);
        maps.push_back(pixel_map(scale.map, cell));
    }
    raster.values.reserve(raster.size.pixels() * raster.channel_names.size());
    for (std::size_t pixel = 0; pixel < raster.size.pixels(); ++pixel) {
        for (const HitImage* hits : {&cell.probe.hits, &cell.truth.hits}) {
            const Hit& hit = hits->texels[pixel];
            raster.values.insert(raster.values.end(), {hit.u, hit.v, hit.h, hit.t});
        }
        for (const auto* colours : {&cell.probe.colour, &cell.truth.colour}) {
            const std::array<float, 3>& colour = colours->texels[pixel];
            raster.values.insert(raster.values.end(), colour.begin(), colour.end());
        }
        for (const Image<float>& map : maps) {
            raster.values.push_back(map.texels[pixel]);
        }
    }
    return raster;
}

}  // namespace reliefbench
