#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace reliefbench {

/// 128-bit content hash (XXH3) as 32 hexadecimal digits. It identifies inputs in results; it is not cryptographic.
std::string content_hash(std::span<const std::byte> bytes);
std::string content_hash(std::string_view text);

}  // namespace reliefbench
