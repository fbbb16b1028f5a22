#pragma once

#include "scene/pixel_place.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace reliefbench {

/// An answer of a technique outside the range that docs/adding_a_technique.md gives: the mirror of answer_range.glsl,
/// which finds it in the probed compilation.
struct AnswerFault {
    /// In the order of the shader's numbers, which begin at 1; none of them is 0.
    enum class Quantity : std::uint32_t { s = 1, uv, h, steps };

    Quantity quantity = Quantity::s;
    /// May be not finite.
    double value = 0;
    /// Empty for a vertex of real geometry.
    std::optional<PixelPlace> pixel = {};
};

/// `bits` of a float, or for steps of a signed integer, as the shader leaves them.
AnswerFault decode_answer_fault(std::uint32_t quantity, std::uint32_t bits);

/// The one farthest outside its range, one that is not finite before all others; the first of equal ones. Needs one.
const AnswerFault& worst_fault(const std::vector<AnswerFault>& faults);

/// "s = -1.5 at pixel (12, 40)".
std::string describe(const AnswerFault& fault);

/// Why a draw with these faults cannot be used, with the worst and the range that it left; empty where there is none.
std::string reason_of_faults(const std::vector<AnswerFault>& faults, std::size_t pixels);

}  // namespace reliefbench
