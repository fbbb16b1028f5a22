#pragma once

#include "store/run_folder.hpp"

#include <string>

namespace reliefbench {

/// A run and what messages call it: its folder.
struct StoredRun {
    std::string name;
    Run run;
};

}  // namespace reliefbench
