#include "compare/quality.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace reliefbench {

namespace {

/// Below both, of the larger value and in the figure's unit, a change is rounding.
constexpr double rounding_relative = 1e-4;
constexpr double rounding_absolute = 1e-6;

/// Of how many pixels, or pixels and lights, a figure is a statistic; null for none.
const FigureDeclaration* count_of(const FigureDeclaration& figure, const CellResult& cell) {
    return figure.over.empty() ? nullptr : cell.figures.list().find(figure.over);
}

/// A statistic over no pixel is none.
std::optional<double> compared_value(const FigureDeclaration& figure, const CellResult& cell) {
    const FigureDeclaration* count = count_of(figure, cell);
    if (count != nullptr && value_of(*count, cell) == 0.0) return std::nullopt;
    return value_of(figure, cell);
}

std::optional<double> compared_value(const DecidingFigure& figure, const CellResult& cell) {
    double sum = 0;
    for (const FigureDeclaration* term : figure.terms) {
        const std::optional<double> value = compared_value(*term, cell);
        if (!value) return std::nullopt;
        sum += *value;
    }
    return sum;
}

bool is_more_than_rounding(double base, double changed) {
    if (std::isinf(base) || std::isinf(changed)) return base != changed;
    const double larger = std::max(std::abs(base), std::abs(changed));
    return std::abs(base - changed) > std::max(rounding_absolute, rounding_relative * larger);
}

/// Empty where neither side has a value or both have the same.
std::optional<QualityChange> change_of(std::string field, const std::optional<double>& base,
                                       const std::optional<double>& changed, const FigureDeclaration& figure,
                                       const FigureTolerance& tolerance) {
    if (!base && !changed) return std::nullopt;
    if (base && changed && !is_more_than_rounding(*base, *changed)) return std::nullopt;
    QualityChange change;
    change.field = std::move(field);
    change.base = base;
    change.changed = changed;
    change.unit = figure.unit;
    change.tolerance = tolerance;
    if (base && changed) {
        change.better = is_better(*changed, *base, figure.better);
        change.worse = is_better(*base, *changed, figure.better);
    }
    return change;
}

/// What this version declares, and what a later one did for either side.
std::vector<const FigureDeclaration*> figures_of_both(const CellResult& base, const CellResult& changed) {
    const FigureList& first = base.figures.list();
    const FigureList& second = changed.figures.list();
    std::vector<const FigureDeclaration*> all;
    for (const FigureDeclaration& figure : first.all())
        all.push_back(&figure);
    if (&first == &second) return all;
    for (const FigureDeclaration& figure : second.all()) {
        if (first.find(figure.path) == nullptr) all.push_back(&figure);
    }
    return all;
}

/// 0 for the first that anybody wants to read.
int importance(const QualityChange& change) {
    const bool has_both = change.base && change.changed;
    if (change.decides) return 0;
    if (change.is_deciding) return has_both ? 2 : 1;
    return has_both ? 3 : 4;
}

class CellQuality {
public:
    CellQuality(const CellResult& base, const CellResult& changed) : base_(base), changed_(changed) {}

    void compare(const DecidingFigure& figure) {
        std::optional<double> before = compared_value(figure, base_);
        std::optional<double> after = compared_value(figure, changed_);
        const FigureDeclaration* stand_in = before && after ? nullptr : figure.stand_in;
        if (stand_in != nullptr && value_of(*stand_in, base_) && value_of(*stand_in, changed_)) {
            before = value_of(*stand_in, base_);
            after = value_of(*stand_in, changed_);
            comparison_.stand_ins.push_back({figure.name(), stand_in->path});
        } else {
            stand_in = nullptr;
        }
        any_compared_ = any_compared_ || (before && after);
        if (before.has_value() != after.has_value()) {
            for (const FigureDeclaration* term : figure.terms)
                compare_count_of(*term);
        }
        auto change = change_of(stand_in ? stand_in->path : figure.name(), before, after,
                                stand_in ? *stand_in : *figure.terms.front(), figure.tolerance);
        if (!change) return;
        change->is_deciding = true;
        change->decides = before && after && change->size() > 1;
        if (stand_in != nullptr) change->in_place_of = figure.name();
        add(std::move(*change));
    }

    void inform_of(const FigureDeclaration& figure) {
        auto change = change_of(figure.path, compared_value(figure, base_), compared_value(figure, changed_), figure,
                                tolerance_of(figure));
        if (change) add(std::move(*change));
    }

    QualityComparison take() {
        std::stable_sort(comparison_.changes.begin(), comparison_.changes.end(),
                         [](const QualityChange& a, const QualityChange& b) {
                             return std::pair(importance(a), -a.size()) < std::pair(importance(b), -b.size());
                         });
        comparison_.verdict = verdict();
        return std::move(comparison_);
    }

private:
    /// Where one side compared nothing, that side is worse.
    void compare_count_of(const FigureDeclaration& figure) {
        const FigureDeclaration* count = count_of(figure, base_);
        if (count == nullptr) return;
        const std::optional<double> before = value_of(*count, base_);
        const std::optional<double> after = value_of(*count, changed_);
        if (!before || !after || (*before == 0) == (*after == 0)) return;
        auto change = change_of(count->path, before, after, *count, {});
        change->better = *before == 0;
        change->worse = *after == 0;
        change->is_deciding = change->decides = true;
        add(std::move(*change));
    }

    /// The first to be added of a figure is the one that decides.
    void add(QualityChange change) {
        const bool known = std::any_of(comparison_.changes.begin(), comparison_.changes.end(),
                                       [&](const QualityChange& other) { return other.field == change.field; });
        if (!known) comparison_.changes.push_back(std::move(change));
    }

    QualityVerdict verdict() const {
        bool better = false;
        bool worse = false;
        for (const QualityChange& change : comparison_.changes) {
            better = better || (change.decides && change.better);
            worse = worse || (change.decides && change.worse);
        }
        if (better && worse) return QualityVerdict::mixed;
        if (worse) return QualityVerdict::worse;
        if (better) return QualityVerdict::better;
        return any_compared_ ? QualityVerdict::same : QualityVerdict::not_comparable;
    }

    const CellResult& base_;
    const CellResult& changed_;
    bool any_compared_ = false;
    QualityComparison comparison_;
};

}  // namespace

double QualityChange::size() const {
    if (!base || !changed) return 0;
    return size_in_tolerances(*base, *changed, tolerance);
}

QualityComparison compare_quality(const CellResult& base, const CellResult& changed,
                                  std::span<const DecidingFigure> deciding) {
    assert(!deciding.empty());
    CellQuality quality(base, changed);
    for (const DecidingFigure& figure : deciding) {
        quality.compare(figure);
    }
    for (const FigureDeclaration* figure : figures_of_both(base, changed)) {
        if (!is_time(*figure)) quality.inform_of(*figure);
    }
    return quality.take();
}

}  // namespace reliefbench
