#pragma once

#include "core/json.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace reliefbench {

/// 8-bit RGB, interleaved, row 0 on top.
struct PagePicture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;
};

/// Every `step`-th pixel of every `step`-th row: pixels stay what they are.
PagePicture every_nth_pixel(const PagePicture& picture, int step);

/// Base64 as RFC 4648 section 4 has it, with padding.
std::string base64(const std::vector<std::uint8_t>& bytes);

/// The pictures of a report's page, without loss and small, each once however many cells show it. In JSON a picture is
/// `{"width", "height", "packing", "data", ...}`, in whichever packing is smallest once deflated (zlib, RFC 1950):
/// - `rgb`: the bytes as they are;
/// - `difference`: less those of the picture at `base`, modulo 256 (a technique's picture less its truth's);
/// - `palette`: one index per pixel into `palette`, RGB of each colour; where there are more than 256 colours, all low
///   bytes of the indices and then all high ones (an error map).
/// Bytes are written as base64.
class PagePictures {
public:
    /// Returns its position among the pictures. `base` is a position, too.
    std::size_t add(const PagePicture& picture, std::optional<std::size_t> base = {});

    /// Bytes that they take in the page, nearly.
    std::size_t bytes() const { return bytes_; }
    /// An array, in the order of the positions.
    const Json& json() const { return pool_; }

private:
    std::vector<PagePicture> pictures_;
    Json pool_ = Json::array();
    std::map<std::string, std::size_t> by_content_;
    std::size_t bytes_ = 0;
};

}  // namespace reliefbench
