#pragma once

#include "report/advice.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace reliefbench {

/// How advice is written.
enum class AdviceFormat { table, json };

/// In the order of the enumerators, as the command line writes them.
const std::vector<std::string>& advice_format_names();
/// An unknown name is an Error.
AdviceFormat parse_advice_format(const std::string& name);

/// "within 2 ms, FLIP over the footprint at most 0.02"
std::string limits_words(const AdviceRequest& request);
/// What a kind of view differs from the others in: "view_angle=60"; else its only view, or "all views".
std::string axes_words(const ViewAdvice& view);

/// As `AdviceFormat::json` writes it.
Json to_json(const Advice& advice);

/// `columns`: the widest line of a table, unless a single word is wider.
std::string format_advice(const Advice& advice, AdviceFormat format, std::size_t columns);

}  // namespace reliefbench
