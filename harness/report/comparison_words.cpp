#include "report/comparison_words.hpp"

#include "compare/describe.hpp"
#include "report/merged_reason.hpp"
#include "report/text_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace reliefbench {

namespace {

constexpr const char* undefined = "-";

/// Of the larger side; a value that one side lacks counts as a whole one.
double relative_size(const QualityChange& change) {
    if (!change.base || !change.changed) return 1;
    const double larger = std::max(std::abs(*change.base), std::abs(*change.changed));
    return larger > 0 ? std::abs(*change.changed - *change.base) / larger : 0;
}

/// Those of whom `is_wanted` says so, the largest change first.
template <typename IsWanted>
std::vector<const CellComparison*> changed_cells(const Comparison& comparison, IsWanted&& is_wanted) {
    std::vector<const CellComparison*> cells;
    for (const CellComparison& cell : comparison.cells) {
        if (is_wanted(cell.quality)) cells.push_back(&cell);
    }
    const auto largest = [](const CellComparison* cell) {
        double size = 0;
        for (const QualityChange& change : cell->quality.changes) {
            size = std::max(size, relative_size(change));
        }
        return size;
    };
    std::stable_sort(cells.begin(), cells.end(),
                     [&](const CellComparison* a, const CellComparison* b) { return largest(a) > largest(b); });
    return cells;
}

std::string value_text(const std::optional<double>& value, int digits) {
    return value && std::isfinite(*value) ? significant(*value, digits) : undefined;
}

}  // namespace

ComparisonCounts count(const Comparison& comparison) {
    ComparisonCounts counts;
    for (const CellComparison& cell : comparison.cells) {
        counts.slower += cell.verdict == Verdict::slower ? 1 : 0;
        counts.faster += cell.verdict == Verdict::faster ? 1 : 0;
        counts.same += cell.verdict == Verdict::same ? 1 : 0;
        counts.undecided += cell.verdict == Verdict::undecided ? 1 : 0;
        counts.worse += cell.quality.verdict == QualityVerdict::worse ? 1 : 0;
        counts.better += cell.quality.verdict == QualityVerdict::better ? 1 : 0;
    }
    for (const UncomparedCell& cell : comparison.uncompared) {
        ++counts.uncompared;
        counts.failed_now += cell.failed_now ? 1 : 0;
    }
    return counts;
}

std::string summary_line(const Comparison& comparison) {
    const ComparisonCounts counts = count(comparison);
    std::string line = fmt::format("{} compared", counted(comparison.cells.size(), "cell"));
    if (!comparison.cells.empty()) {
        line += fmt::format(": {} slower, {} undecided, {} faster, {} same; quality: {} worse, {} better",
                            counts.slower, counts.undecided, counts.faster, counts.same, counts.worse, counts.better);
    }
    if (counts.uncompared > 0) line += fmt::format("; {} not compared", counts.uncompared);
    if (counts.failed_now > 0) line += fmt::format(", {} of them failed now", counts.failed_now);
    return line;
}

std::vector<const CellComparison*> cells_with(const Comparison& comparison, Verdict verdict) {
    std::vector<const CellComparison*> cells;
    for (const CellComparison& cell : comparison.cells) {
        if (cell.verdict == verdict) cells.push_back(&cell);
    }
    std::stable_sort(cells.begin(), cells.end(), [verdict](const CellComparison* a, const CellComparison* b) {
        return verdict == Verdict::faster ? a->time.ratio < b->time.ratio : a->time.ratio > b->time.ratio;
    });
    return cells;
}

std::vector<const CellComparison*> cells_with(const Comparison& comparison, QualityVerdict verdict) {
    return changed_cells(comparison,
                         [verdict](const QualityComparison& quality) { return quality.verdict == verdict; });
}

std::vector<const CellComparison*> cells_with_other_changes(const Comparison& comparison) {
    return changed_cells(comparison, [](const QualityComparison& quality) {
        return quality.verdict == QualityVerdict::same && !quality.changes.empty();
    });
}

std::vector<UncomparedGroup> uncompared_by_reason(const Comparison& comparison) {
    std::vector<UncomparedGroup> groups;
    std::vector<MergedReason> reasons;
    for (const UncomparedCell& cell : comparison.uncompared) {
        std::size_t group = 0;
        while (group < groups.size() &&
               !(groups[group].failed_now == cell.failed_now && reasons[group].add(cell.reason)))
            ++group;
        if (group == groups.size()) {
            reasons.emplace_back(cell.reason);
            groups.push_back({{}, cell.failed_now, {}});
        }
        groups[group].cells.push_back(cell.cell);
    }
    for (std::size_t group = 0; group < groups.size(); ++group)
        groups[group].reason = reasons[group].text();
    std::stable_partition(groups.begin(), groups.end(), [](const UncomparedGroup& group) { return group.failed_now; });
    return groups;
}

std::string_view to_string(QualityVerdict verdict) {
    switch (verdict) {
        case QualityVerdict::same:
            return "same";
        case QualityVerdict::better:
            return "better";
        case QualityVerdict::worse:
            return "worse";
    }
    return "";
}

std::string change_text(double ratio) {
    return std::isfinite(ratio) ? signed_percent(ratio - 1) : undefined;
}

std::string change_interval_text(const Interval& ratios) {
    if (!std::isfinite(ratios.low) || !std::isfinite(ratios.high)) return undefined;
    constexpr std::string_view unit = " %";
    std::string low = signed_percent(ratios.low - 1);
    low.resize(low.size() - unit.size());
    return fmt::format("{} to {}", low, signed_percent(ratios.high - 1));
}

std::string percent_text(double fraction) {
    return std::isfinite(fraction) ? percent(fraction) : undefined;
}

std::string more_text(const RatioEstimate& estimate) {
    return estimate.more ? fmt::format("{}", *estimate.more) : undefined;
}

std::string reason_beyond_figures(const CellComparison& cell, const Comparison& comparison) {
    const std::string figures = describe(cell.time, cell.verdict, comparison.unit) + "; ";
    return cell.reason.starts_with(figures) ? cell.reason.substr(figures.size()) : "";
}

std::string quality_change_text(const QualityChange& change) {
    // As many digits as it takes to tell the sides apart.
    constexpr int most_digits = 17;
    int digits = 3;
    while (digits < most_digits && value_text(change.base, digits) == value_text(change.changed, digits)) {
        ++digits;
    }
    return fmt::format("{} {} → {}", change.field, value_text(change.base, digits), value_text(change.changed, digits));
}

std::vector<std::string> quality_change_texts(const QualityComparison& quality, std::size_t limit) {
    std::vector<const QualityChange*> changes;
    for (const QualityChange& change : quality.changes) {
        changes.push_back(&change);
    }
    std::stable_sort(changes.begin(), changes.end(), [](const QualityChange* a, const QualityChange* b) {
        if (a->worse != b->worse) return a->worse;
        if (a->better != b->better) return a->better;
        return relative_size(*a) > relative_size(*b);
    });
    std::vector<std::string> texts;
    for (std::size_t change = 0; change < std::min(limit, changes.size()); ++change) {
        texts.push_back(quality_change_text(*changes[change]));
    }
    if (changes.size() > limit) texts.push_back(fmt::format("and {} more", changes.size() - limit));
    return texts;
}

}  // namespace reliefbench
