#pragma once

#include "metrics/compared_hits.hpp"
#include "scene/image.hpp"

#include <cstdint>

namespace reliefbench {

/// What became of a pixel.
enum class Coverage : std::uint8_t {
    /// Neither the technique nor the truth hits, or the pixel lies outside the footprint where the truth ends with it.
    neither,
    both,
    /// Truth hits inside the footprint and the technique does not.
    missed,
    /// The technique hits and truth does not.
    false_hit,
    /// Truth hits outside the footprint, where what draws the base alone cannot draw, and the technique does not.
    missed_outside,
    /// The truth marks the pixel as a tie: whatever the technique answers is no error.
    tie,
};

Image<Coverage> coverage_map(const ComparedHits& hits);

}  // namespace reliefbench
