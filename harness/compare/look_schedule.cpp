#include "compare/look_schedule.hpp"

#include <algorithm>
#include <bit>

namespace reliefbench {

namespace {

constexpr std::size_t first_look = 16;

}  // namespace

bool is_look(std::size_t rounds) {
    return rounds >= first_look && std::has_single_bit(rounds);
}

double level_of_look(std::size_t rounds) {
    const std::size_t look = std::bit_floor(std::max(rounds, first_look));
    const auto number = static_cast<double>(std::countr_zero(look / first_look) + 1);
    return 0.05 / (number * (number + 1));
}

std::size_t next_look(std::size_t rounds) {
    return rounds < first_look ? first_look : 2 * std::bit_floor(rounds);
}

}  // namespace reliefbench
