#include "technique/resolved_picture.hpp"

#include <algorithm>
#include <cassert>

namespace reliefbench {

View through_centres(View view) {
    view.samples_per_pixel = 1;
    view.frames = 1;
    return view;
}

View frame_of(View view, int frame) {
    if (view.frames == 1) return view;
    view.camera.shift += frame_shift(frame, view.frames, view.resolution);
    view.frame = frame;
    view.frames = 1;
    return view;
}

void PictureMean::add(const TimedPicture& picture) {
    assert(picture.colour.size == sum_.size);
    ++pictures_;
    for (std::size_t i = 0; i < sum_.texels.size(); ++i) {
        for (std::size_t channel = 0; channel < 3; ++channel)
            sum_.texels[i][channel] += static_cast<double>(picture.colour.texels[i][channel]);
    }
}

Image<std::array<float, 3>> PictureMean::mean() const {
    Image<std::array<float, 3>> mean(sum_.size);
    std::ranges::transform(sum_.texels, mean.texels.begin(), [this](const std::array<double, 3>& sum) {
        const auto channel = [&](std::size_t i) { return static_cast<float>(sum[i] / pictures_); };
        return std::array<float, 3>{channel(0), channel(1), channel(2)};
    });
    return mean;
}

}  // namespace reliefbench
