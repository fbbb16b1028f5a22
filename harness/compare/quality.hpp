#pragma once

#include "store/cell_result.hpp"

#include <optional>
#include <string>
#include <vector>

namespace reliefbench {

/// Quality is deterministic on one device: any change beyond the tolerance is told.
struct QualityTolerance {
    /// Of an error's larger value.
    double relative = 1e-4;
    /// In the field's own unit, for what is next to nothing on both sides.
    double absolute = 1e-6;
};

/// One field of error, image, work or prepare.bytes that changed, by its name in cells.jsonl ("error.uv_texels.p99").
/// Work (taps, steps) and memory are costs, and counts of pixels are circumstances: such a change is neither better nor
/// worse.
struct QualityChange {
    std::string field;
    /// Empty: null on that side.
    std::optional<double> base;
    std::optional<double> changed;
    bool worse = false;
    bool better = false;
};

enum class QualityVerdict { same, better, worse };

struct QualityComparison {
    /// `worse` when any field is worse, even if others are better; `same` when all changes are neither.
    QualityVerdict verdict = QualityVerdict::same;
    std::vector<QualityChange> changes;
};

/// Of the mean depth error, which is signed, the magnitude decides. An image without an error has no PSNR and is the
/// best. A field that is null on one side only is a change that is neither.
QualityComparison compare_quality(const CellResult& base, const CellResult& changed, const QualityTolerance& tolerance);

}  // namespace reliefbench
