// An image file as a height map and as an albedo. The last byte chooses how it is read.

#include "core/error.hpp"
#include "fuzz/fuzz_target.hpp"
#include "scene/albedo.hpp"
#include "scene/height_map.hpp"
#include "scene/image_file.hpp"
#include "scene/plain_image_file.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cmath>

namespace {

using namespace reliefbench;

/// A file that exists in memory only.
class FileInMemory {
public:
    FileInMemory(const std::uint8_t* data, std::size_t size) : descriptor_(memfd_create("image", MFD_CLOEXEC)) {
        fuzz_require(descriptor_ >= 0 && write(descriptor_, data, size) == static_cast<ssize_t>(size));
    }
    ~FileInMemory() { close(descriptor_); }
    FileInMemory(const FileInMemory&) = delete;
    FileInMemory& operator=(const FileInMemory&) = delete;

    std::string path() const { return fmt::format("/proc/self/fd/{}", descriptor_); }

private:
    int descriptor_;
};

template <typename Action>
void may_refuse(const Action& action) {
    try {
        action();
    } catch (const Error&) {
        // Refused, as it may be.
    }
}

void load(const std::string& path, unsigned options) {
    HeightMapSource source;
    source.name = path;
    source.albedo = path;
    source.channel = options % 4;
    source.invert = (options & 4u) != 0;
    source.normalize = (options & 8u) != 0;
    if ((options & 16u) != 0) source.height_range = {{-2, 3}};
    const HeightMap map = load_height_map(source, static_cast<HeightFormat>((options >> 5u) % 3));
    for (const float height : map.heights.texels)
        fuzz_require(height >= 0 && height <= 1);
    fuzz_require(read_raster_header(path).size == map.heights.size);
    for (const std::array<float, 4>& texel : load_albedo(source, map).texels.texels)
        fuzz_require(std::isfinite(texel[0]) && std::isfinite(texel[1]) && std::isfinite(texel[2]));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    // A small file may claim, and hold, a large image.
    static const int limited = setenv("RELIEFBENCH_MEMORY_MB", "64", 1);
    fuzz_require(limited == 0);
    const FileInMemory file(data, size - 1);
    may_refuse([&] { load(file.path(), data[size - 1]); });
    // The portable build's own reader, which every build has.
    may_refuse([&] { read_plain_image(file.path()); });
    return 0;
}
