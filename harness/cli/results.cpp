#include "cli/results.hpp"

#include <cstdio>

namespace reliefbench {

void print_results(std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stdout);
}

}  // namespace reliefbench
