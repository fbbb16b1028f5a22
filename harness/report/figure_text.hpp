#pragma once

#include "core/figure.hpp"

#include <string>
#include <string_view>

namespace reliefbench {

/// Of a fraction its per cent, as people see it; any other value as it is.
double figure_as_shown(double value, std::string_view unit);

/// A figure's value before people, without its unit: fractions per cent, and an infinite one (the PSNR of a picture
/// without an error) as "∞".
std::string figure_value_text(double value, std::string_view unit, int digits = 3);

/// " texels", " % of footprint", or nothing: with the space before it.
std::string figure_unit_text(std::string_view unit);

/// Of a narrow column: its short name ("uv p99"), or else its label; with " %" where it is of a fraction.
std::string column_title(const FigureDeclaration& figure);

}  // namespace reliefbench
