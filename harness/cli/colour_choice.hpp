#pragma once

#include <string>

/// Only forward: CLI11 costs seconds per file.
namespace CLI {
class App;
}

namespace reliefbench {

/// --color auto|always|never. auto: standard output is a terminal that has colours, and NO_COLOR (no-color.org) is not
/// set.
struct ColourChoice {
    std::string when = "auto";

    void add_to(CLI::App& command);
    bool is_wanted() const;
};

}  // namespace reliefbench
