#include "scene/image_format.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>

namespace reliefbench {

namespace {

struct RefusedFormat {
    const char* name;
    std::string_view magic;
    std::size_t place;
    const char* instead;
};

using std::string_view_literals::operator""sv;

constexpr std::array<RefusedFormat, 5> refused_formats{{{"a BMP", "BM"sv, 0, "PNG"},
                                                        {"a GIF", "GIF8"sv, 0, "PNG"},
                                                        {"a WebP", "WEBP"sv, 8, "PNG"},
                                                        {"a Radiance HDR", "#?R"sv, 0, "OpenEXR or PFM"},
                                                        {"a DDS", "DDS "sv, 0, "PNG"}}};

bool has_extension(const std::filesystem::path& path, std::initializer_list<const char*> extensions) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return std::ranges::find(extensions, extension) != extensions.end();
}

}  // namespace

void check_is_image_file(const std::filesystem::path& path) {
    std::error_code error;
    if (!std::filesystem::exists(path, error)) {
        fail("cannot read image '{}': {}", path.string(), error ? error.message() : "no such file");
    }
    if (!std::filesystem::is_regular_file(path, error)) fail("cannot read image '{}': it is not a file", path.string());
}

std::string first_bytes(const std::filesystem::path& path, std::size_t count) {
    std::string bytes(count, '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(bytes.data(), static_cast<std::streamsize>(count));
    bytes.resize(static_cast<std::size_t>(file.gcount()));
    return bytes;
}

void fail_unread_format(const std::filesystem::path& path, std::string_view begin, const std::string& readable) {
    const auto refused = std::ranges::find_if(refused_formats, [&](const RefusedFormat& format) {
        return begin.size() >= format.place && begin.substr(format.place).starts_with(format.magic);
    });
    std::string what = ": it is not " + readable;
    if (refused != refused_formats.end()) {
        what += fmt::format(", but {}, which is not read: save it as {}", refused->name, refused->instead);
    } else if (has_extension(path, {".tga"})) {
        what += ", and TGA is not read: save it as PNG";  // which nothing at a file's begin tells
    } else if (has_extension(path, {".r16", ".r32", ".raw", ".hgt"})) {
        what += fmt::format(
            "; of numbers without a header give \"size\" (and \"sample_type\", \"byte_order\"): -a "
            "'heightmap={{\"file\": "
            "\"{}\", \"size\": \"WIDTHxHEIGHT\"}}'",
            path.string());
    }
    fail("cannot read image '{}'{}", path.string(), what);
}

}  // namespace reliefbench
