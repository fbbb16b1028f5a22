#include "cli/run_sides.hpp"

#include "core/error.hpp"

#include <algorithm>

namespace reliefbench {

namespace {

/// No argument of a process can hold it.
const std::string separator(1, '\0');

}  // namespace

std::vector<std::string> keep_separator(std::vector<std::string> arguments) {
    if (!arguments.empty() && (arguments.front() == "compare" || arguments.front() == "report")) {
        std::replace(arguments.begin(), arguments.end(), std::string("--"), separator);
    }
    return arguments;
}

bool has_separator(const std::vector<std::string>& folders) {
    return std::find(folders.begin(), folders.end(), separator) != folders.end();
}

RunSides split_sides(const std::vector<std::string>& folders, std::string_view command) {
    const auto at = std::find(folders.begin(), folders.end(), separator);
    if (at == folders.end()) {
        if (folders.size() == 1) fail("{}: one run is nothing to compare; name a base and a new one", command);
        if (folders.size() > 2) {
            fail("{}: which of the {} runs are the base? Put -- between base and new runs: BASE... -- NEW...", command,
                 folders.size());
        }
        return {{folders.front()}, {folders.back()}};
    }
    const RunSides sides{{folders.begin(), at}, {at + 1, folders.end()}};
    if (std::find(sides.changed.begin(), sides.changed.end(), separator) != sides.changed.end()) {
        fail("{}: there is more than one --; one stands between base and new runs: BASE... -- NEW...", command);
    }
    if (sides.base.empty() || sides.changed.empty()) {
        fail("{}: there is no run {} the --; at least one stands on each side: BASE... -- NEW...", command,
             sides.base.empty() ? "before" : "after");
    }
    return sides;
}

}  // namespace reliefbench
