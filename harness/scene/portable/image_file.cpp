#include "scene/image_file.hpp"

#include "scene/plain_image_file.hpp"

namespace reliefbench {

std::string readable_images() {
    return "a PNG, PFM, or binary PGM or PPM image";
}

RasterFile read_raster_file(const std::filesystem::path& path, const ImageChoice& choice) {
    return read_plain_image(path, choice);
}

RasterFile read_raster_header(const std::filesystem::path& path, const std::string& part) {
    return read_plain_header(path, part);
}

void write_raster_file(const std::filesystem::path& path, const RasterFile& raster) {
    write_plain_image(path, raster);
}

}  // namespace reliefbench
