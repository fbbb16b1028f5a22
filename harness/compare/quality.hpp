#pragma once

#include "compare/deciding_figures.hpp"
#include "store/cell_result.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace reliefbench {

/// A figure that changed.
struct QualityChange {
    /// By its name in cells.jsonl ("error.uv_texels.p99"), or several joined by "+".
    std::string field;
    /// Empty: null on that side. Infinite: the PSNR of an image without an error.
    std::optional<double> base;
    std::optional<double> changed;
    /// Neither where a side has no value or the figure no direction.
    bool worse = false;
    bool better = false;
    /// Part of the verdict: a deciding figure that changed by more than its tolerance.
    bool decides = false;
    /// A deciding figure, whether or not it decides.
    bool is_deciding = false;
    /// The deciding figure in whose place this one stands; empty for none.
    std::string in_place_of = {};
    std::string_view unit = {};
    FigureTolerance tolerance = {};

    /// In tolerances, from 0; above 1 the change matters. 0 where a side has no value.
    double size() const;
};

/// `mixed`: some deciding figures are better, others worse. `not_comparable`: no deciding figure is known of both
/// sides.
enum class QualityVerdict { same, better, worse, mixed, not_comparable };

/// A figure that decided in place of a deciding one, which a side lacks.
struct StandIn {
    std::string figure;
    std::string decided;
};

struct QualityComparison {
    QualityVerdict verdict = QualityVerdict::same;
    /// The most important first: what decides, then other deciding figures, then all others; of each the largest in
    /// tolerances first.
    std::vector<QualityChange> changes;
    std::vector<StandIn> stand_ins = {};
};

/// Everything that was measured of both but times, of which quality is deterministic on one device: any change beyond
/// rounding is among `changes`. Only `deciding` figures decide, each by its tolerance and its direction. One that is
/// null on one side decides nothing, and is named; but where that side is the only one on which there was nothing to
/// compare (no pixel that both the technique and the truth hit), that side is worse.
QualityComparison compare_quality(const CellResult& base, const CellResult& changed,
                                  std::span<const DecidingFigure> deciding);

}  // namespace reliefbench
