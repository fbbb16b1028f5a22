#include "compare/quality.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reliefbench {

namespace {

enum class Better { lower, higher, nearer_to_zero, neither };

bool differs(double base, double changed, const QualityTolerance& tolerance) {
    if (std::isinf(base) || std::isinf(changed)) return base != changed;
    const double largest = std::max(std::abs(base), std::abs(changed));
    return std::abs(base - changed) > std::max(tolerance.absolute, tolerance.relative * largest);
}

/// Gathers the changes of one cell.
class Changes {
public:
    explicit Changes(const QualityTolerance& tolerance) : tolerance_(tolerance) {}

    void compare(std::string field, std::optional<double> base, std::optional<double> changed, Better better) {
        if (!base && !changed) return;
        QualityChange change{std::move(field), base, changed};
        if (base && changed) {
            if (!differs(*base, *changed, tolerance_)) return;
            judge(change, *base, *changed, better);
        }
        changes_.push_back(std::move(change));
    }

    /// Values that compare in place of what is told.
    void compare_as(std::string field, std::optional<double> base, std::optional<double> changed, double base_value,
                    double changed_value, Better better) {
        if (!differs(base_value, changed_value, tolerance_)) return;
        QualityChange change{std::move(field), base, changed};
        judge(change, base_value, changed_value, better);
        changes_.push_back(std::move(change));
    }

    QualityComparison take() {
        QualityComparison comparison;
        for (const QualityChange& change : changes_) {
            if (change.worse) comparison.verdict = QualityVerdict::worse;
            if (change.better && comparison.verdict == QualityVerdict::same) {
                comparison.verdict = QualityVerdict::better;
            }
        }
        comparison.changes = std::move(changes_);
        return comparison;
    }

private:
    void judge(QualityChange& change, double base, double changed, Better better) const {
        if (better == Better::neither) return;
        if (better == Better::nearer_to_zero) {
            base = std::abs(base);
            changed = std::abs(changed);
            if (!differs(base, changed, tolerance_)) return;
        }
        const bool higher = changed > base;
        change.better = higher == (better == Better::higher);
        change.worse = !change.better;
    }

    const QualityTolerance& tolerance_;
    std::vector<QualityChange> changes_;
};

/// A member of what may be missing altogether.
template <typename Fields, typename Value>
std::optional<double> get(const std::optional<Fields>& fields, Value Fields::*member) {
    if (!fields) return std::nullopt;
    return static_cast<double>((*fields).*member);
}
template <typename Fields>
std::optional<double> get(const std::optional<Fields>& fields, std::optional<double> Fields::*member) {
    return fields ? (*fields).*member : std::nullopt;
}

void compare_summary(Changes& changes, const std::string& name, const std::optional<CellResult::Errors>& base,
                     const std::optional<CellResult::Errors>& changed,
                     std::optional<Summary> CellResult::Errors::*member, Better mean_better) {
    const std::optional<Summary> before = base ? (*base).*member : std::nullopt;
    const std::optional<Summary> after = changed ? (*changed).*member : std::nullopt;
    changes.compare(name + ".mean", get(before, &Summary::mean), get(after, &Summary::mean), mean_better);
    changes.compare(name + ".rms", get(before, &Summary::rms), get(after, &Summary::rms), Better::lower);
    changes.compare(name + ".p50", get(before, &Summary::p50), get(after, &Summary::p50), Better::lower);
    changes.compare(name + ".p95", get(before, &Summary::p95), get(after, &Summary::p95), Better::lower);
    changes.compare(name + ".p99", get(before, &Summary::p99), get(after, &Summary::p99), Better::lower);
    changes.compare(name + ".max", get(before, &Summary::max), get(after, &Summary::max), Better::lower);
}

void compare_shadows(Changes& changes, const std::optional<CellResult::ShadowErrors>& base,
                     const std::optional<CellResult::ShadowErrors>& changed) {
    using Shadow = CellResult::ShadowErrors;
    const auto field = [&](const char* name, auto member, Better better) {
        changes.compare(name, get(base, member), get(changed, member), better);
    };
    field("error.shadow.mean", &Shadow::mean, Better::lower);
    field("error.shadow.false_shadow", &Shadow::false_shadow, Better::lower);
    field("error.shadow.missed_shadow", &Shadow::missed_shadow, Better::lower);
    field("error.shadow.compared", &Shadow::compared, Better::neither);
}

void compare_errors(Changes& changes, const std::optional<CellResult::Errors>& base,
                    const std::optional<CellResult::Errors>& changed) {
    using Errors = CellResult::Errors;
    compare_summary(changes, "error.uv_texels", base, changed, &Errors::uv_texels, Better::lower);
    compare_summary(changes, "error.depth", base, changed, &Errors::depth, Better::nearer_to_zero);
    compare_summary(changes, "error.normal_deg", base, changed, &Errors::normal_deg, Better::lower);
    const auto field = [&](const char* name, auto member, Better better) {
        changes.compare(name, get(base, member), get(changed, member), better);
    };
    field("error.compared", &Errors::compared, Better::neither);
    field("error.missed", &Errors::missed, Better::lower);
    field("error.false_hits", &Errors::false_hits, Better::lower);
    field("error.outside_quad.pixels", &Errors::outside_quad_pixels, Better::neither);
    field("error.outside_quad.covered", &Errors::outside_quad_covered, Better::higher);
    field("error.coverage_iou", &Errors::coverage_iou, Better::higher);
    field("error.wrong_surface", &Errors::wrong_surface, Better::lower);
    compare_shadows(changes, base ? base->shadow : std::nullopt, changed ? changed->shadow : std::nullopt);
}

/// Infinite for the image without an error, which has none in the file.
std::optional<double> psnr_of(const std::optional<CellResult::ImageFields>& image) {
    if (!image) return std::nullopt;
    if (!image->psnr && image->rmse && *image->rmse == 0) return std::numeric_limits<double>::infinity();
    return image->psnr;
}

void compare_images(Changes& changes, const std::optional<CellResult::ImageFields>& base,
                    const std::optional<CellResult::ImageFields>& changed) {
    using Image = CellResult::ImageFields;
    const auto field = [&](const char* name, auto member, Better better) {
        changes.compare(name, get(base, member), get(changed, member), better);
    };
    field("image.flip", &Image::flip, Better::lower);
    const std::optional<double> psnr_before = psnr_of(base);
    const std::optional<double> psnr_after = psnr_of(changed);
    if (psnr_before && psnr_after) {
        changes.compare_as("image.psnr", get(base, &Image::psnr), get(changed, &Image::psnr), *psnr_before, *psnr_after,
                           Better::higher);
    } else {
        field("image.psnr", &Image::psnr, Better::higher);
    }
    field("image.ssim", &Image::ssim, Better::higher);
    field("image.rmse", &Image::rmse, Better::lower);
}

void compare_motion_figure(Changes& changes, const std::string& name, const std::optional<CellResult::Motion>& base,
                           const std::optional<CellResult::Motion>& changed,
                           std::optional<CellResult::MotionFigure> CellResult::Motion::*member) {
    using Figure = CellResult::MotionFigure;
    const std::optional<Figure> before = base ? (*base).*member : std::nullopt;
    const std::optional<Figure> after = changed ? (*changed).*member : std::nullopt;
    changes.compare(name + ".mean", get(before, &Figure::mean), get(after, &Figure::mean), Better::lower);
    changes.compare(name + ".p95", get(before, &Figure::p95), get(after, &Figure::p95), Better::lower);
    changes.compare(name + ".max", get(before, &Figure::max), get(after, &Figure::max), Better::lower);
}

/// One side that did not measure it says nothing.
void compare_motion(Changes& changes, const std::optional<CellResult::Motion>& base,
                    const std::optional<CellResult::Motion>& changed) {
    if (!base || !changed) return;
    using Motion = CellResult::Motion;
    compare_motion_figure(changes, "motion.texels", base, changed, &Motion::texels);
    compare_motion_figure(changes, "motion.flip", base, changed, &Motion::flip);
    const auto field = [&](const char* name, auto member, Better better) {
        changes.compare(name, get(base, member), get(changed, member), better);
    };
    field("motion.compared", &Motion::compared, Better::neither);
    field("motion.hit_once", &Motion::hit_once, Better::lower);
    field("motion.unseen", &Motion::unseen, Better::neither);
}

void compare_work(Changes& changes, const std::optional<CellResult::Work>& base,
                  const std::optional<CellResult::Work>& changed) {
    using Work = CellResult::Work;
    const auto field = [&](const char* name, auto member, Better better) {
        changes.compare(name, get(base, member), get(changed, member), better);
    };
    field("work.taps_mean", &Work::taps_mean, Better::neither);
    field("work.taps_p95", &Work::taps_p95, Better::neither);
    field("work.texels_mean", &Work::texels_mean, Better::neither);
    field("work.steps_mean", &Work::steps_mean, Better::neither);
    field("work.steps_p95", &Work::steps_p95, Better::neither);
    field("work.unconverged", &Work::unconverged, Better::lower);
    field("work.covered_pixels", &Work::covered_pixels, Better::neither);
    field("work.shadow_taps_mean", &Work::shadow_taps_mean, Better::neither);
    field("work.shadow_taps_p95", &Work::shadow_taps_p95, Better::neither);
}

std::optional<double> number(const std::optional<std::uint64_t>& count) {
    if (!count) return std::nullopt;
    return static_cast<double>(*count);
}

}  // namespace

QualityComparison compare_quality(const CellResult& base, const CellResult& changed,
                                  const QualityTolerance& tolerance) {
    Changes changes(tolerance);
    compare_errors(changes, base.error, changed.error);
    compare_images(changes, base.image, changed.image);
    compare_motion(changes, base.motion, changed.motion);
    compare_work(changes, base.work, changed.work);
    changes.compare("prepare.bytes", number(base.prepare_bytes), number(changed.prepare_bytes), Better::neither);
    return changes.take();
}

}  // namespace reliefbench
