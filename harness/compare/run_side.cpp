#include "compare/run_side.hpp"

#include "compare/run_differences.hpp"
#include "core/error.hpp"

#include <cassert>
#include <cmath>

#include <algorithm>

namespace reliefbench {

namespace {

/// Half the width of a 95 % interval in standard deviations.
constexpr double half_width_of_95 = 1.96;

RunSide gather_by_cell(std::span<const StoredRun> runs, bool (*is_measured)(const CellResult&)) {
    RunSide side;
    side.runs = runs;
    for (const StoredRun& run : runs) {
        for (const CellResult& result : run.run.cells) {
            const auto [place, is_new] = side.cells.try_emplace(result.cell);
            if (is_new) side.order.push_back(result.cell);
            SideCell& cell = place->second;
            if (is_measured(result)) {
                cell.measured.push_back(&result);
                cell.runs.push_back(&run);
            } else if (cell.unmeasured == nullptr) {
                cell.unmeasured = &result;
            }
        }
    }
    return side;
}

void require_one_device(std::span<const StoredRun> runs) {
    for (const StoredRun& run : runs.subspan(1)) {
        const std::string difference = device_difference(runs.front(), run);
        if (!difference.empty()) {
            fail("the runs of one side must come from one device, but {}; leave {} out", difference, run.name);
        }
    }
}

void require_one_subject(const RunSide& side) {
    for (const std::string& id : side.order) {
        const SideCell& cell = side.cells.at(id);
        for (std::size_t index = 1; index < cell.measured.size(); ++index) {
            const std::string difference =
                subject_difference(*cell.runs[0], *cell.measured[0], *cell.runs[index], *cell.measured[index]);
            if (!difference.empty()) {
                fail(
                    "the runs of one side must measure the same, but {} and {} differ in the cell '{}': {}; leave one "
                    "of them out",
                    cell.runs[0]->name, cell.runs[index]->name, id, difference);
            }
        }
    }
}

}  // namespace

double figure_of(const PassTiming& timing, Figure figure) {
    return figure == Figure::lower_quartile ? timing.lower_quartile_ms.value() : timing.median_ms;
}

bool SideCell::has_lower_quartiles() const {
    return std::all_of(measured.begin(), measured.end(), [](const CellResult* result) {
        return result->time.at(compared_pass).lower_quartile_ms.has_value();
    });
}

std::vector<double> SideCell::milliseconds(Figure figure) const {
    std::vector<double> values;
    for (const CellResult* result : measured) {
        values.push_back(figure_of(result->time.at(compared_pass), figure));
    }
    return values;
}

bool is_timed(const CellResult& result) {
    const auto draw = result.time.find(compared_pass);
    return result.status == CellStatus::ok && draw != result.time.end() && draw->second.median_ms > 0;
}

bool has_figures(const CellResult& result) {
    return result.status == CellStatus::ok;
}

RunSide gather_side(std::span<const StoredRun> runs, bool (*is_measured)(const CellResult&)) {
    assert(!runs.empty());
    require_one_device(runs);
    RunSide side = gather_by_cell(runs, is_measured);
    require_one_subject(side);
    return side;
}

std::string unmeasured_text(const SideCell& cell) {
    if (cell.unmeasured == nullptr) return "missing";
    const std::string reason = cell.unmeasured->reason.empty() ? "" : ": " + cell.unmeasured->reason;
    switch (cell.unmeasured->status) {
        case CellStatus::skipped:
            return "skipped" + reason;
        case CellStatus::failed:
            return "failed" + reason;
        case CellStatus::ok:
            break;
    }
    return fmt::format("without a time of the pass {}", compared_pass);
}

std::string partial_text(const SideCell& cell, std::size_t runs, std::string_view side) {
    if (cell.measured.size() == runs) return "";
    return fmt::format("; measured in {} of {} {} runs only (in the others {})", cell.measured.size(), runs, side,
                       unmeasured_text(cell));
}

double deviation_within_runs(const SideCell& base, const SideCell& changed) {
    double variance = 0;
    double count = 0;
    for (const SideCell* cell : {&base, &changed}) {
        for (const CellResult* result : cell->measured) {
            const Interval& interval = result->time.at(compared_pass).ci95_ms;
            if (interval.low <= 0 || interval.high < interval.low) continue;
            const double deviation = std::log(interval.high / interval.low) / (2 * half_width_of_95);
            variance += deviation * deviation;
            ++count;
        }
    }
    return count == 0 ? 0 : std::sqrt(variance / count);
}

}  // namespace reliefbench
