#include "measure/run_pictures.hpp"

#include "picture/map_picture.hpp"
#include "scene/image_file.hpp"

#include <fmt/format.h>

#include <array>

namespace reliefbench {

namespace {

constexpr std::array written_maps{PixelMap::uv_error, PixelMap::flip, PixelMap::taps, PixelMap::depth_error};

std::string suffix_of(PixelMap map) {
    return fmt::format(".{}.png", scale_of(map).name);
}

}  // namespace

void write_cell_pictures(RunWriter& writer, const std::string& cell, const DrawnCell& drawn) {
    const auto write = [&](const std::string& suffix, const Picture& picture) {
        write_raster_file(writer.image_path(cell, suffix), to_raster(picture));
    };
    write(".png", display_picture(drawn.probe.colour));
    write(".truth.png", display_picture(drawn.truth.colour));
    for (const PixelMap map : written_maps) {
        write(suffix_of(map), map_picture(map, drawn));
    }
}

void write_legends(RunWriter& writer) {
    constexpr int width = 256;
    const Font font;
    for (const PixelMap map : written_maps) {
        write_raster_file(writer.image_path("legend", suffix_of(map)), to_raster(legend(scale_of(map), width, font)));
    }
}

}  // namespace reliefbench
