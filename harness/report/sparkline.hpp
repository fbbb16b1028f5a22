#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace reliefbench {

/// A series as blocks of eight heights, one column each, on a logarithmic scale from its least to its greatest value;
/// `·` where a value is missing, and `│` before each of `marks`. A series that varies by less than a fifth does not
/// fill the scale, so that noise does not look like change.
std::string sparkline(std::span<const std::optional<double>> values, std::span<const std::size_t> marks);

}  // namespace reliefbench
