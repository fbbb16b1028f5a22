#pragma once

#include "scene/image.hpp"

#include <array>
#include <cassert>
#include <cstddef>

namespace reliefbench {

/// The mean of pictures of one size in linear light, of which none has to be kept.
class PictureMean {
public:
    /// Channels beyond the third are left out.
    template <std::size_t Channels>
    void add(const Image<std::array<float, Channels>>& picture) {
        static_assert(Channels >= 3);
        if (pictures_ == 0) sums_ = Image<std::array<double, 3>>(picture.size);
        assert(sums_.size == picture.size);
        for (std::size_t pixel = 0; pixel < picture.texels.size(); ++pixel) {
            for (std::size_t channel = 0; channel < 3; ++channel)
                sums_.texels[pixel][channel] += static_cast<double>(picture.texels[pixel][channel]);
        }
        ++pictures_;
    }

    /// Of at least one.
    Image<std::array<float, 3>> mean() const {
        assert(pictures_ > 0);
        Image<std::array<float, 3>> mean(sums_.size);
        for (std::size_t pixel = 0; pixel < mean.texels.size(); ++pixel) {
            for (std::size_t channel = 0; channel < 3; ++channel)
                mean.texels[pixel][channel] = static_cast<float>(sums_.texels[pixel][channel] / pictures_);
        }
        return mean;
    }

private:
    Image<std::array<double, 3>> sums_;
    int pictures_ = 0;
};

}  // namespace reliefbench
