#pragma once

#include <cassert>
#include <cstddef>
#include <vector>

namespace reliefbench {

struct Resolution {
    int width = 0;
    int height = 0;

    std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
    bool operator==(const Resolution&) const = default;
};

/// Row-major texels; whoever makes the image says whether row 0 is its top or its bottom.
template <typename Texel>
struct Image {
    Resolution size;
    std::vector<Texel> texels;

    Image() = default;
    explicit Image(Resolution resolution, Texel fill = Texel{}) : size(resolution), texels(resolution.pixels(), fill) {}

    Texel& at(int x, int y) { return texels[index(x, y)]; }
    const Texel& at(int x, int y) const { return texels[index(x, y)]; }

    /// Of `texels`.
    std::size_t index(int x, int y) const {
        assert(x >= 0 && x < size.width && y >= 0 && y < size.height);
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x);
    }
};

}  // namespace reliefbench
