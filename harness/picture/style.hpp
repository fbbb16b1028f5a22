#pragma once

#include "picture/picture.hpp"

/// How labelled pictures look.
namespace reliefbench::style {

constexpr Rgb8 paper{255, 255, 255};
constexpr Rgb8 ink{20, 20, 20};
constexpr Rgb8 pale_ink{110, 110, 110};
/// Heights of lines in pixels.
constexpr int small_text = 13;
constexpr int text = 15;
constexpr int title_text = 19;
/// Between pictures.
constexpr int gap = 6;
constexpr int margin = 10;

}  // namespace reliefbench::style
