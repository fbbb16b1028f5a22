#include "report/benchmark_counters.hpp"

#include "store/chosen_figures.hpp"

#include <cmath>
#include <string_view>

namespace reliefbench {

namespace {

/// The sum of some figures under a name.
struct Counter {
    const char* name;
    std::vector<std::string_view> figures;
};

}  // namespace

std::vector<std::pair<std::string, double>> benchmark_counters(const CellResult& cell) {
    using namespace chosen_figures;
    static const std::vector<Counter> counters = {{"taps", {taps}},
                                                  {"uv_error_p99_texels", {quality}},
                                                  {"missed_and_false_hits", {missed, false_hits}},
                                                  {"prepare_bytes", {preparation_bytes}}};
    std::vector<std::pair<std::string, double>> values;
    for (const Counter& counter : counters) {
        double sum = 0;
        for (const std::string_view figure : counter.figures)
            sum += value_of(figure, cell).value_or(std::nan(""));
        if (std::isfinite(sum)) values.emplace_back(counter.name, sum);
    }
    return values;
}

}  // namespace reliefbench
