#include "technique/answer_fault.hpp"

#include "core/counted.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>

namespace reliefbench {

namespace {

const char* name_of(AnswerFault::Quantity quantity) {
    switch (quantity) {
        case AnswerFault::Quantity::s:
            return "s";
        case AnswerFault::Quantity::uv:
            return "uv";
        case AnswerFault::Quantity::h:
            return "h";
        case AnswerFault::Quantity::steps:
            return "steps";
    }
    return "";
}

/// What the value ought to have been.
const char* range_of(AnswerFault::Quantity quantity) {
    switch (quantity) {
        case AnswerFault::Quantity::s:
            return "s of hit_on_ray lies in [0, s_end], which is 1 where rays are straight";
        case AnswerFault::Quantity::uv:
            return "texture coordinates are finite";
        case AnswerFault::Quantity::h:
            return "h lies in [0, 1]";
        case AnswerFault::Quantity::steps:
            return "steps lie in [0, 2^24]";
    }
    return "";
}

double excess(const AnswerFault& fault) {
    if (!std::isfinite(fault.value)) return std::numeric_limits<double>::infinity();
    return fault.value < 0 ? -fault.value : fault.value - 1;
}

}  // namespace

AnswerFault decode_answer_fault(std::uint32_t quantity, std::uint32_t bits) {
    const auto known = static_cast<AnswerFault::Quantity>(quantity);
    assert(quantity >= 1 && known <= AnswerFault::Quantity::steps);
    const bool counts = known == AnswerFault::Quantity::steps;
    return {known, counts ? static_cast<double>(std::bit_cast<std::int32_t>(bits))
                          : static_cast<double>(std::bit_cast<float>(bits))};
}

const AnswerFault& worst_fault(const std::vector<AnswerFault>& faults) {
    assert(!faults.empty());
    return *std::ranges::max_element(faults, {}, excess);
}

std::string describe(const AnswerFault& fault) {
    const std::string place =
        fault.pixel ? fmt::format("pixel ({}, {})", fault.pixel->column, fault.pixel->row) : "a vertex";
    return fmt::format("{} = {:.9g} at {}", name_of(fault.quantity), fault.value, place);
}

std::string reason_of_faults(const std::vector<AnswerFault>& faults, std::size_t pixels) {
    if (faults.empty()) return {};
    const AnswerFault& worst = worst_fault(faults);
    const std::string where =
        worst.pixel ? fmt::format("{} of {}", faults.size(), counted(pixels, "pixel")) : std::string("a vertex");
    return fmt::format("{} answered out of range, the worst {}; {} (docs/adding_a_technique.md, Ranges)", where,
                       describe(worst), range_of(worst.quantity));
}

}  // namespace reliefbench
