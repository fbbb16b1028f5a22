#include "compare/history.hpp"

#include "compare/optimal_segments.hpp"
#include "compare/run_differences.hpp"
#include "compare/run_side.hpp"
#include "core/error.hpp"
#include "core/statistics.hpp"

#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>

namespace reliefbench {

namespace {

/// Two values more than a mean needs: one outlier never makes a segment.
constexpr std::size_t shortest_segment = 3;

struct Moments {
    double mean = 0;
    double squares = 0;
    double count = 0;
};

Moments moments_of(std::span<const double> values) {
    Moments moments;
    moments.count = static_cast<double>(values.size());
    for (const double value : values) {
        moments.mean += value / moments.count;
    }
    for (const double value : values) {
        moments.squares += (value - moments.mean) * (value - moments.mean);
    }
    return moments;
}

/// Two-sided, of a step between two neighbouring segments, times the places where it could have been.
double p_of_step(std::span<const double> before, std::span<const double> after) {
    const Moments left = moments_of(before);
    const Moments right = moments_of(after);
    const double freedom = left.count + right.count - 2;
    const double standard_error =
        std::sqrt((left.squares + right.squares) / freedom * (1 / left.count + 1 / right.count));
    const double step = std::abs(right.mean - left.mean);
    if (standard_error == 0) return step > 0 ? 0 : 1;
    const boost::math::students_t distribution(freedom);
    const double p = 2 * boost::math::cdf(boost::math::complement(distribution, step / standard_error));
    const double places = left.count + right.count - 2 * static_cast<double>(shortest_segment) + 1;
    return std::min(1.0, p * places);
}

ChangePoint change_at(std::span<const double> series, std::size_t begin, std::size_t at, std::size_t end,
                      double minimum_effect) {
    const std::span<const double> before = series.subspan(begin, at - begin);
    const std::span<const double> after = series.subspan(at, end - at);
    const double step = median(after) - median(before);
    ChangePoint change;
    change.run = at;
    change.previous = at - 1;
    change.ratio = std::exp(step);
    change.p = std::abs(step) < std::log1p(minimum_effect) ? 1 : p_of_step(before, after);
    return change;
}

/// "1.21 to 1.34 times", or "1.21 times".
std::string ratios_text(double smallest, double largest) {
    const std::string low = fmt::format("{:.2f}", smallest);
    const std::string high = fmt::format("{:.2f}", largest);
    return low == high ? low + " times" : fmt::format("{} to {} times", low, high);
}

/// A change point and whose it is.
struct Move {
    std::size_t cell = 0;
    ChangePoint change;
};

MovedTogether make_group(const std::vector<Move>& moves, std::size_t run, bool slower) {
    MovedTogether group;
    group.run = run;
    group.slower = slower;
    std::size_t previous = 0;
    bool first = true;
    for (const Move& move : moves) {
        group.cells.push_back(move.cell);
        group.smallest_ratio = first ? move.change.ratio : std::min(group.smallest_ratio, move.change.ratio);
        group.largest_ratio = first ? move.change.ratio : std::max(group.largest_ratio, move.change.ratio);
        if (move.change.run == run) previous = std::max(previous, move.change.previous);
        first = false;
    }
    group.text = fmt::format("between run {} and {}: {} {} {}, {}", previous + 1, run + 1, moves.size(),
                             moves.size() == 1 ? "cell" : "cells", slower ? "slower" : "faster",
                             ratios_text(group.smallest_ratio, group.largest_ratio));
    return group;
}

/// The run that most moves fall on, give or take one: ties go to the run with more moves of its own, then to the first.
std::size_t busiest_run(const std::vector<Move>& moves) {
    std::map<std::size_t, std::size_t> counts;
    for (const Move& move : moves) {
        ++counts[move.change.run];
    }
    std::size_t busiest = 0;
    std::pair<std::size_t, std::size_t> most{0, 0};
    for (const auto& [run, own] : counts) {
        std::size_t near = own;
        if (const auto before = counts.find(run - 1); run > 0 && before != counts.end()) near += before->second;
        if (const auto after = counts.find(run + 1); after != counts.end()) near += after->second;
        if (std::pair(near, own) > most) {
            most = {near, own};
            busiest = run;
        }
    }
    return busiest;
}

std::vector<MovedTogether> group_moves(const std::vector<CellHistory>& cells) {
    std::vector<MovedTogether> groups;
    for (const bool slower : {true, false}) {
        std::vector<Move> left;
        for (std::size_t cell = 0; cell < cells.size(); ++cell) {
            for (const ChangePoint& change : cells[cell].changes) {
                if ((change.ratio > 1) == slower) left.push_back({cell, change});
            }
        }
        while (!left.empty()) {
            const std::size_t run = busiest_run(left);
            const auto outside = std::stable_partition(left.begin(), left.end(), [run](const Move& move) {
                return move.change.run + 1 >= run && move.change.run <= run + 1;
            });
            groups.push_back(make_group({left.begin(), outside}, run, slower));
            left.erase(left.begin(), outside);
        }
    }
    std::stable_sort(groups.begin(), groups.end(),
                     [](const MovedTogether& a, const MovedTogether& b) { return a.run < b.run; });
    return groups;
}

struct Measured {
    const StoredRun* run = nullptr;
    const CellResult* result = nullptr;
};

/// By run; null where the run did not measure the cell.
std::map<std::string, std::vector<Measured>> results_by_cell(std::span<const StoredRun> runs,
                                                             std::vector<std::string>& order) {
    std::map<std::string, std::vector<Measured>> results;
    for (std::size_t index = 0; index < runs.size(); ++index) {
        for (const CellResult& result : runs[index].run.cells) {
            if (!is_timed(result)) continue;
            const auto [place, is_new] = results.try_emplace(result.cell);
            if (is_new) {
                order.push_back(result.cell);
                place->second.resize(runs.size());
            }
            place->second[index] = {&runs[index], &result};
        }
    }
    return results;
}

CellHistory series_of(const std::string& cell, const std::vector<Measured>& results) {
    const auto newest = std::find_if(results.rbegin(), results.rend(),
                                     [](const Measured& measured) { return measured.result != nullptr; });
    CellHistory history;
    history.cell = cell;
    const bool quartiles = std::all_of(results.begin(), results.end(), [](const Measured& measured) {
        return measured.result == nullptr || measured.result->time.at(compared_pass).lower_quartile_ms;
    });
    const Figure figure = quartiles ? Figure::lower_quartile : Figure::median;
    for (const Measured& measured : results) {
        const bool comparable =
            measured.result != nullptr &&
            subject_difference(*measured.run, *measured.result, *newest->run, *newest->result).empty();
        history.median_ms.push_back(
            comparable ? std::optional(figure_of(measured.result->time.at(compared_pass), figure)) : std::nullopt);
    }
    return history;
}

void find_changes_of(CellHistory& cell, const HistoryOptions& options) {
    std::vector<double> logs;
    std::vector<std::size_t> runs;
    for (std::size_t run = 0; run < cell.median_ms.size(); ++run) {
        if (!cell.median_ms[run]) continue;
        logs.push_back(std::log(*cell.median_ms[run]));
        runs.push_back(run);
    }
    cell.changes = find_change_points(logs, options.minimum_effect, options.false_discovery_rate);
    for (ChangePoint& change : cell.changes) {
        change.run = runs[change.run];
        change.previous = runs[change.previous];
    }
}

/// Benjamini & Hochberg over all cells: a cell without a change point counts as a test that found nothing.
void drop_chance_findings(std::vector<CellHistory>& cells, double false_discovery_rate) {
    std::vector<double> p_values;
    std::size_t tests = 0;
    for (const CellHistory& cell : cells) {
        tests += std::max<std::size_t>(cell.changes.size(), 1);
        for (const ChangePoint& change : cell.changes) {
            p_values.push_back(change.p);
        }
    }
    std::sort(p_values.begin(), p_values.end());
    double highest = -1;
    for (std::size_t rank = 1; rank <= p_values.size(); ++rank) {
        const double p = p_values[rank - 1];
        if (p <= false_discovery_rate * static_cast<double>(rank) / static_cast<double>(tests)) highest = p;
    }
    for (CellHistory& cell : cells) {
        std::erase_if(cell.changes, [highest](const ChangePoint& change) { return change.p > highest; });
    }
}

}  // namespace

std::vector<ChangePoint> find_change_points(std::span<const double> log_ms, double minimum_effect, double p_limit) {
    std::vector<std::size_t> starts = optimal_segments(log_ms, shortest_segment);
    for (;;) {
        std::vector<ChangePoint> changes;
        std::size_t weakest = 0;
        for (std::size_t index = 1; index < starts.size(); ++index) {
            const std::size_t end = index + 1 < starts.size() ? starts[index + 1] : log_ms.size();
            changes.push_back(change_at(log_ms, starts[index - 1], starts[index], end, minimum_effect));
            if (changes.back().p >= changes[weakest].p) weakest = changes.size() - 1;
        }
        if (changes.empty() || changes[weakest].p <= p_limit) return changes;
        starts.erase(starts.begin() + static_cast<std::ptrdiff_t>(weakest) + 1);
    }
}

History make_history(std::span<const StoredRun> runs, const HistoryOptions& options) {
    assert(!runs.empty());
    History history;
    for (std::size_t index = 0; index < runs.size(); ++index) {
        history.runs.push_back(runs[index].name);
        if (index == 0) continue;
        const std::string device = device_difference(runs.front(), runs[index]);
        if (!device.empty()) fail("a history is of one device, but {}; leave {} out", device, runs[index].name);
        std::vector<std::string> differences = run_differences(runs[index - 1], runs[index]);
        if (!differences.empty()) history.record_changes.push_back({index, std::move(differences)});
    }
    std::vector<std::string> order;
    const auto results = results_by_cell(runs, order);
    for (const std::string& cell : order) {
        history.cells.push_back(series_of(cell, results.at(cell)));
        find_changes_of(history.cells.back(), options);
    }
    drop_chance_findings(history.cells, options.false_discovery_rate);
    history.groups = group_moves(history.cells);
    return history;
}

}  // namespace reliefbench
