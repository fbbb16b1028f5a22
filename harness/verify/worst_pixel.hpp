#pragma once

#include "scene/pixel_place.hpp"
#include "verify/drawing.hpp"

#include <cstddef>
#include <optional>

namespace reliefbench {

/// The pixel with the largest value above 0 of those offered, the first of equal ones.
class WorstPixel {
public:
    /// A value that is not a number counts as none.
    void offer(double value, std::size_t pixel);

    /// 0 where there is none.
    double value() const { return value_; }
    std::optional<PixelPlace> place(Resolution size) const;

private:
    double value_ = 0;
    std::size_t pixel_ = 0;
};

/// Of the footprint: where the UV error is largest; of `coverage`, where a hit is missed or false.
std::optional<PixelPlace> worst_place(const TruthComparison& comparison, const HeightMap& map, const View& view,
                                      bool coverage);

}  // namespace reliefbench
