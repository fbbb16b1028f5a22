#pragma once

#include "scene/image.hpp"
#include "scene/relief.hpp"
#include "technique/renderer.hpp"

#include <array>

namespace reliefbench {

/// One sample through each pixel's centre, of a picture by itself or of one of its frames.
View through_centres(View view);

/// Of a view with several frames that one; else the view itself.
View frame_of(View view, int frame);

/// The mean of pictures, in linear light.
class PictureMean {
public:
    explicit PictureMean(Resolution size) : sum_(size, {0, 0, 0}) {}

    void add(const TimedPicture& picture);
    Image<std::array<float, 3>> mean() const;

private:
    Image<std::array<double, 3>> sum_;
    int pictures_ = 0;
};

}  // namespace reliefbench
