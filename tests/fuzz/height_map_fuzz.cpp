// An image file as a height map and as an albedo. The last two bytes choose how it is read.

#include "core/error.hpp"
#include "fuzz/fuzz_target.hpp"
#include "scene/albedo.hpp"
#include "scene/height_map.hpp"
#include "scene/plain_image_file.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <string>

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

/// The last bytes choose how a file is read.
HeightMapSource source_of(const std::string& path, unsigned options) {
    HeightMapSource source;
    source.name = path;
    source.albedo = path;
    source.channel = (options & 256u) != 0 ? "" : std::to_string(options % 4);
    if ((options & 512u) != 0) source.part = std::to_string(options >> 14u);
    source.invert = (options & 4u) != 0;
    source.normalize = (options & 8u) != 0;
    if ((options & 16u) != 0) source.height_range = {{-2, 3}};
    if ((options & 1024u) != 0) source.fill = 0.5;
    if ((options & 2048u) != 0) source.nodata = 7;
    if ((options & 4096u) != 0) {
        source.channel.clear();
        source.packing = (options & 8192u) != 0 ? Packing::rgb24 : Packing::rg16;
    }
    return source;
}

void load(const HeightMapSource& source, unsigned options) {
    const HeightMap map = load_height_map(source, static_cast<HeightFormat>((options >> 5u) % 3));
    for (const float height : map.heights.texels)
        fuzz_require(height >= 0 && height <= 1);
    fuzz_require(height_map_size(source) == map.heights.size);
    for (const std::array<float, 4>& texel : load_albedo(source, map).texels.texels)
        fuzz_require(std::isfinite(texel[0]) && std::isfinite(texel[1]) && std::isfinite(texel[2]));
}

/// Of a file without a header, a row of as many numbers as it has.
void load_raw(HeightMapSource source, std::size_t size, unsigned options) {
    if (size == 0 || size > 16384) return;
    source.raw = RawLayout{.size = {static_cast<int>(size), 1},
                           .sample_type = RawLayout::SampleType::uint8,
                           .big_endian = (options & 1u) != 0};
    if (size % 4 == 0 && (options & 2u) != 0) {
        source.raw->size.width /= 4;
        source.raw->sample_type = RawLayout::SampleType::float32;
    }
    source.channel.clear();
    source.part.clear();
    source.packing = Packing::none;
    source.albedo.clear();
    load(source, options);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 2) return 0;
    // A small file may claim, and hold, a large image.
    static const int limited = setenv("RELIEFBENCH_MEMORY_MB", "64", 1);
    fuzz_require(limited == 0);
    const FileInMemory file(data, size - 2);
    const unsigned options = data[size - 1] | unsigned{data[size - 2]} << 8u;
    const HeightMapSource source = source_of(file.path(), options);
    may_refuse([&] { load(source, options); });
    may_refuse([&] { load_raw(source, size - 2, options); });
    // The portable build's own reader, which every build has.
    may_refuse([&] { read_plain_image(file.path()); });
    return 0;
}
