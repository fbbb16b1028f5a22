#include "cli/exit_code.hpp"

#include <algorithm>
#include <array>

namespace reliefbench {

ExitCode worse_of(ExitCode first, ExitCode second) {
    constexpr std::array worst_first = {ExitCode::internal_error, ExitCode::bad_input, ExitCode::cells_failed,
                                        ExitCode::regression,     ExitCode::undecided, ExitCode::done};
    const auto rank = [&](ExitCode code) { return std::find(worst_first.begin(), worst_first.end(), code); };
    return rank(first) < rank(second) ? first : second;
}

}  // namespace reliefbench
