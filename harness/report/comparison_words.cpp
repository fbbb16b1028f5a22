#include "report/comparison_words.hpp"

#include "compare/describe.hpp"
#include "core/counted.hpp"
#include "core/suggest.hpp"
#include "report/figure_text.hpp"
#include "report/merged_reason.hpp"
#include "report/text_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace reliefbench {

namespace {

/// Those of whom `is_wanted` says so, the largest change of the most important figure first.
template <typename IsWanted>
std::vector<const CellComparison*> changed_cells(const Comparison& comparison, IsWanted&& is_wanted) {
    std::vector<const CellComparison*> cells;
    for (const CellComparison& cell : comparison.cells) {
        if (is_wanted(cell.quality)) cells.push_back(&cell);
    }
    const auto size = [](const CellComparison* cell) {
        return cell->quality.changes.empty() ? 0 : cell->quality.changes.front().size();
    };
    std::stable_sort(cells.begin(), cells.end(),
                     [&](const CellComparison* a, const CellComparison* b) { return size(a) > size(b); });
    return cells;
}

bool matters(const QualityChange& change) {
    const bool on_one_side_only = !(change.base && change.changed);
    return change.decides || change.size() > 1 || (on_one_side_only && change.is_deciding);
}

std::string value_text(const std::optional<double>& value, std::string_view unit, int digits) {
    return value ? figure_value_text(*value, unit, digits) : undefined;
}

/// By how much, where that can be said: of the base, or where that says little in the figure's unit.
std::string amount_text(const QualityChange& change) {
    constexpr double least_factor = 10;
    if (!std::isfinite(*change.base) || !std::isfinite(*change.changed)) return "";
    const double difference = std::abs(*change.changed - *change.base);
    const bool in_unit = *change.base == 0 || (change.tolerance.relative == 0 && change.tolerance.absolute > 0);
    if (in_unit) return " by " + figure_value_text(difference, change.unit, 2) + figure_unit_text(change.unit);
    const double share = difference / std::abs(*change.base);
    if (share >= least_factor) return fmt::format(" by a factor of {}", significant(share + 1, 2));
    return fmt::format(" by {} %", significant(100 * share, 2));
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
        counts.mixed += cell.quality.verdict == QualityVerdict::mixed ? 1 : 0;
        counts.better += cell.quality.verdict == QualityVerdict::better ? 1 : 0;
        counts.same_quality += cell.quality.verdict == QualityVerdict::same ? 1 : 0;
        counts.not_comparable += cell.quality.verdict == QualityVerdict::not_comparable ? 1 : 0;
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
        if (!comparison.quality_only) {
            line += fmt::format(": {} slower, {} undecided, {} faster, {} same", counts.slower, counts.undecided,
                                counts.faster, counts.same);
        }
        line += fmt::format("; quality: {} worse, {} mixed, {} better, {} same", counts.worse, counts.mixed,
                            counts.better, counts.same_quality);
        if (counts.not_comparable > 0) line += fmt::format(", {} not comparable", counts.not_comparable);
    }
    if (counts.uncompared > 0) line += fmt::format("; {} not compared", counts.uncompared);
    if (counts.failed_now > 0) line += fmt::format(", {} of them failed now", counts.failed_now);
    return line;
}

std::vector<const CellComparison*> cells_with(const Comparison& comparison, Verdict verdict) {
    std::vector<const CellComparison*> cells;
    if (comparison.quality_only) return cells;
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

std::vector<const CellComparison*> cells_with_other_changes(const Comparison& comparison, QualityVerdict verdict,
                                                            bool any) {
    return changed_cells(comparison, [&](const QualityComparison& quality) {
        return quality.verdict == verdict &&
               std::any_of(quality.changes.begin(), quality.changes.end(),
                           [&](const QualityChange& each) { return any || matters(each); });
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
        case QualityVerdict::mixed:
            return "mixed";
        case QualityVerdict::not_comparable:
            return "not comparable";
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
    constexpr int max_digits = 17;
    int digits = 3;
    const auto value = [&](const std::optional<double>& side) { return value_text(side, change.unit, digits); };
    while (digits < max_digits && value(change.base) == value(change.changed)) {
        ++digits;
    }
    std::string judgement;
    if (!change.base || !change.changed) {
        judgement = change.is_deciding ? "not compared: " : "";
    } else if (change.worse || change.better) {
        judgement = fmt::format("{}{}{}: ", change.worse ? "worse" : "better", amount_text(change),
                                change.is_deciding && !change.decides ? ", within the tolerance" : "");
    }
    return fmt::format("{}{} {} → {}{}{}", judgement, change.field, value(change.base), value(change.changed),
                       figure_unit_text(change.unit),
                       change.in_place_of.empty() ? "" : fmt::format(" (in place of {})", change.in_place_of));
}

std::vector<std::string> quality_change_texts(const QualityComparison& quality, std::optional<std::size_t> limit) {
    std::vector<std::string> texts;
    for (const QualityChange& change : quality.changes) {
        if (limit && (texts.size() == *limit || !matters(change))) continue;
        texts.push_back(quality_change_text(change));
    }
    const std::size_t left_out = quality.changes.size() - texts.size();
    if (left_out > 0) texts.push_back(fmt::format("and {} more", left_out));
    return texts;
}

std::string tolerance_text(const DecidingFigure& figure) {
    const std::string_view unit = figure.terms.front()->unit;
    const auto& [absolute, relative] = figure.tolerance;
    std::vector<std::string> parts;
    if (absolute > 0) parts.push_back(fmt::format("{:g}{}", figure_as_shown(absolute, unit), figure_unit_text(unit)));
    if (relative > 0) parts.push_back(fmt::format("{:g} %", 100 * relative));
    return parts.empty() ? "nothing" : join(parts, " and ");
}

std::string deciding_figures_text(const std::vector<DecidingFigure>& figures) {
    std::string text;
    for (std::size_t figure = 0; figure < figures.size(); ++figure) {
        const std::string tolerance = tolerance_text(figures[figure]);
        const bool alike = figure + 1 < figures.size() && tolerance_text(figures[figure + 1]) == tolerance;
        text += figures[figure].name() + (alike ? ", " : ": " + tolerance + "; ");
    }
    return text.substr(0, text.size() - 2);
}

}  // namespace reliefbench
