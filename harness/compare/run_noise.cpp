#include "compare/run_noise.hpp"

#include "core/error.hpp"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/special_functions/digamma.hpp>
#include <boost/math/special_functions/polygamma.hpp>
#include <boost/math/special_functions/trigamma.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

namespace reliefbench {

namespace {

/// As good as knowing a variance exactly.
constexpr double max_degrees_of_freedom = 1000;
constexpr std::size_t min_cells = 3;

double mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) {
        sum += value;
    }
    return sum / static_cast<double>(values.size());
}

double sum_of_squares(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) {
        sum += value * value;
    }
    return sum;
}

void append_residuals(std::vector<double>& residuals, const std::vector<double>& milliseconds) {
    std::vector<double> logs;
    for (const double value : milliseconds) {
        assert(value > 0);
        logs.push_back(std::log(value));
    }
    for (const double value : logs) {
        residuals.push_back(value - mean(logs));
    }
}

/// The x > 0 with trigamma(x) = y (Newton's method on 1 / trigamma, Smyth 2004, appendix).
double inverse_trigamma(double y) {
    double x = 0.5 + 1 / y;
    for (int iteration = 0; iteration < 50; ++iteration) {
        const double value = boost::math::trigamma(x);
        const double step = value * (1 - value / y) / boost::math::polygamma(2, x);
        x += step;
        if (-step < 1e-8 * x) break;
    }
    return x;
}

/// log of a variance estimate expects log σ² + this.
double bias_of_log(double degrees_of_freedom) {
    return boost::math::digamma(degrees_of_freedom / 2) - std::log(degrees_of_freedom / 2);
}

struct CellVariance {
    /// Within-side deviations of the log medians from their means.
    std::vector<double> residuals;
    double degrees_of_freedom = 0;
    double variance = 0;
};

std::vector<CellVariance> variances_of(std::span<const CellMedians> cells) {
    std::vector<CellVariance> variances;
    for (const CellMedians& cell : cells) {
        CellVariance result;
        append_residuals(result.residuals, cell.base_ms);
        append_residuals(result.residuals, cell.new_ms);
        const int sides = (cell.base_ms.empty() ? 0 : 1) + (cell.new_ms.empty() ? 0 : 1);
        result.degrees_of_freedom = static_cast<double>(result.residuals.size()) - sides;
        if (result.degrees_of_freedom <= 0) continue;
        result.variance = sum_of_squares(result.residuals) / result.degrees_of_freedom;
        if (result.variance > 0) variances.push_back(std::move(result));
    }
    return variances;
}

/// The correlation of cells that it would take to see so little of it once in a hundred: few runs may happen to show
/// too little of what moves all cells together, and just then the variances look small as well.
double cautious_correlation(double correlation, double degrees_of_freedom) {
    const double caution =
        degrees_of_freedom / boost::math::quantile(boost::math::chi_squared(degrees_of_freedom), 0.01);
    return caution * correlation / (caution * correlation + 1 - correlation);
}

/// How many degrees of freedom the mean of the cells' variances has: with one correlation ρ between any two cells, the
/// squares of their deviations correlate by ρ². Only cells that no run lacks say how they move together.
double freedom_of_mean_variance(const std::vector<CellVariance>& cells) {
    std::size_t runs = 0;
    for (const CellVariance& cell : cells) {
        runs = std::max(runs, cell.residuals.size());
    }
    std::vector<double> sums(runs, 0.0);
    double variances = 0;
    double deviations = 0;
    double freedom = 0;
    double complete = 0;
    for (const CellVariance& cell : cells) {
        if (cell.residuals.size() != runs) continue;
        for (std::size_t run = 0; run < runs; ++run) {
            sums[run] += cell.residuals[run];
        }
        variances += cell.variance;
        deviations += std::sqrt(cell.variance);
        freedom = cell.degrees_of_freedom;
        ++complete;
    }
    if (complete < static_cast<double>(min_cells)) return freedom;
    const double between_cells = sum_of_squares(sums) / freedom - variances;
    const double seen = std::clamp(between_cells / (deviations * deviations - variances), 0.0, 1.0);
    const double correlation = cautious_correlation(seen, freedom);
    return freedom * complete / (1 + (complete - 1) * correlation * correlation);
}

}  // namespace

RunNoise pool_noise(std::span<const NoiseRecord::Cell> cells, const std::string& time) {
    double variance = 0;
    std::size_t counted = 0;
    std::size_t min_processes = 0;
    for (const NoiseRecord::Cell& cell : cells) {
        const std::size_t processes = cell.log_median_ms.size();
        if (processes < 2) continue;
        const double centre = mean(cell.log_median_ms);
        double squares = 0;
        for (const double value : cell.log_median_ms) {
            squares += (value - centre) * (value - centre);
        }
        variance += squares / static_cast<double>(processes - 1);
        min_processes = counted == 0 ? processes : std::min(min_processes, processes);
        ++counted;
    }
    if (counted == 0) {
        fail(
            "no cell was measured by two processes or more, so nothing is known of the noise between runs; check more");
    }
    RunNoise noise;
    noise.log_sd = std::sqrt(variance / static_cast<double>(counted));
    noise.degrees_of_freedom = static_cast<double>(min_processes - 1);
    noise.source =
        fmt::format("measured on this machine by `reliefbench selfcheck`, {}, {} processes", time, min_processes);
    return noise;
}

RunNoise noise_of_runs(std::span<const CellMedians> cells) {
    RunNoise noise;
    noise.log_sd = 0;
    noise.degrees_of_freedom = 0;
    noise.source = "the runs compared";
    const std::vector<CellVariance> variances = variances_of(cells);
    if (variances.size() < min_cells) return noise;

    std::vector<double> logs;
    double scatter_of_chance = 0;
    double mean_freedom = 0;
    for (const CellVariance& cell : variances) {
        logs.push_back(std::log(cell.variance) - bias_of_log(cell.degrees_of_freedom));
        scatter_of_chance += boost::math::trigamma(cell.degrees_of_freedom / 2);
        mean_freedom += cell.degrees_of_freedom;
    }
    const auto count = static_cast<double>(variances.size());
    scatter_of_chance /= count;
    mean_freedom /= count;
    const double centre = mean(logs);
    double scatter = 0;
    for (const double value : logs) {
        scatter += (value - centre) * (value - centre) / (count - 1);
    }
    const double excess = scatter - scatter_of_chance;
    // Cells no less alike than chance makes them share one variance.
    double freedom = max_degrees_of_freedom;
    double log_variance = centre;
    if (excess > 0) {
        freedom = std::min(freedom, 2 * inverse_trigamma(excess));
        log_variance += bias_of_log(freedom);
    }
    // What a cell's own runs tell is counted apart.
    const double lent = freedom_of_mean_variance(variances) - mean_freedom;
    noise.degrees_of_freedom = std::max(0.0, std::min(freedom, lent));
    noise.log_sd = std::exp(log_variance / 2);
    return noise;
}

}  // namespace reliefbench
