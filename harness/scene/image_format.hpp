#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace reliefbench {

/// Whether there is a file to read: an Error otherwise, with the reason.
void check_is_image_file(const std::filesystem::path& path);

/// The first bytes of a file, fewer where it is shorter.
std::string first_bytes(const std::filesystem::path& path, std::size_t count);

/// Says why a file that begins so is not read, and what to do. `readable` is "a PNG, ... image". BMP, TGA, GIF, WebP
/// and Radiance HDR are known and refused (docs/height_maps.md says why).
[[noreturn]] void fail_unread_format(const std::filesystem::path& path, std::string_view begin,
                                     const std::string& readable);

}  // namespace reliefbench
