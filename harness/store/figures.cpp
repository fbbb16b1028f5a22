#include "store/figures.hpp"

#include <algorithm>
#include <limits>
#include <string>

namespace reliefbench {

namespace {

using Cell = CellResult;
using Work = CellResult::Work;
using Errors = CellResult::Errors;
using Shadow = CellResult::ShadowErrors;
using Image = CellResult::ImageFields;
using Footprint = CellResult::FootprintFields;
using Motion = CellResult::Motion;
using Change = CellResult::MotionFigure;
using Draw = PassTiming;

template <typename Value>
std::optional<double> number(const Value& value) {
    return static_cast<double>(value);
}
template <typename Value>
std::optional<double> number(const std::optional<Value>& value) {
    if (!value) return std::nullopt;
    return static_cast<double>(*value);
}

/// The number at the end of a way of members, any of which may be empty.
template <auto First, auto... Rest, typename Fields>
std::optional<double> follow(const Fields& fields) {
    if constexpr (requires { fields.has_value(); }) {
        return fields ? follow<First, Rest...>(*fields) : std::nullopt;
    } else if constexpr (sizeof...(Rest) > 0) {
        return follow<Rest...>(fields.*First);
    } else {
        return number(fields.*First);
    }
}

template <auto... Members>
std::optional<double> member(const CellResult& cell) {
    return follow<Members...>(cell);
}

template <auto... Members>
std::optional<double> of_draw(const CellResult& cell) {
    const auto draw = cell.time.find(draw_pass);
    if (draw == cell.time.end()) return std::nullopt;
    return follow<Members...>(draw->second);
}

/// Of the image errors at the end of a way of members.
template <auto Psnr, auto Rmse, auto... Members>
std::optional<double> psnr(const CellResult& cell) {
    const std::optional<double> rmse = member<Members..., Rmse>(cell);
    if (rmse && *rmse == 0) return std::numeric_limits<double>::infinity();
    return member<Members..., Psnr>(cell);
}

constexpr Better lower = Better::lower;
constexpr Better higher = Better::higher;
constexpr Better neither = Better::neither;

constexpr std::string_view of_footprint = "fraction of footprint";
constexpr std::string_view of_covered = "fraction of covered pixels";
constexpr std::string_view texels = "texels";
constexpr std::string_view sides = "patch sides";
constexpr std::string_view degrees = "degrees";
constexpr std::string_view pixels = "pixels";

constexpr FigureDeclaration declarations[] = {
    {"time.draw.median_ms", "Draw time", "ms", lower, of_draw<&Draw::median_ms>},
    {"time.draw.mad_ms", "Draw time, MAD", "ms", neither, of_draw<&Draw::mad_ms>},
    {"time.draw.ci95_ms.low", "Draw time, 95 % interval, low", "ms", lower, of_draw<&Draw::ci95_ms, &Interval::low>},
    {"time.draw.ci95_ms.high", "Draw time, 95 % interval, high", "ms", lower, of_draw<&Draw::ci95_ms, &Interval::high>},
    {"time.draw.n", "Samples of the draw", "", neither, of_draw<&Draw::n>},
    {"time.draw.repeats", "Draws per sample", "", neither, of_draw<&Draw::repeats>},
    {"time.draw.rounds", "Rounds of the draw", "", neither, of_draw<&Draw::rounds>},
    {"time.draw.outliers", "Outliers of the draw", "samples", neither, of_draw<&Draw::outliers>},
    {"time.draw.lower_quartile_ms", "Draw time, lower quartile", "ms", lower, of_draw<&Draw::lower_quartile_ms>},
    {"time.ns_per_pixel", "Draw time per covered pixel", "ns", lower, member<&Cell::ns_per_pixel>},
    {"time.throttled_rounds", "Throttled rounds", "", neither, member<&Cell::throttled_rounds>},

    {"prepare.ms", "Preparation of maps", "ms", lower, member<&Cell::prepare_ms>},
    {"prepare.bytes", "Memory of maps", "bytes", lower, member<&Cell::prepare_bytes>},

    {"work.taps_mean", "Taps per pixel", "", lower, member<&Cell::work, &Work::taps_mean>},
    {"work.taps_p95", "Taps per pixel, p95", "", lower, member<&Cell::work, &Work::taps_p95>},
    {"work.texels_mean", "Texels read per pixel", "", lower, member<&Cell::work, &Work::texels_mean>},
    {"work.steps_mean", "Steps per pixel", "", lower, member<&Cell::work, &Work::steps_mean>},
    {"work.steps_p95", "Steps per pixel, p95", "", lower, member<&Cell::work, &Work::steps_p95>},
    {"work.unconverged", "Unconverged searches", of_covered, lower, member<&Cell::work, &Work::unconverged>},
    {"work.covered_pixels", "Covered pixels", pixels, neither, member<&Cell::work, &Work::covered_pixels>},
    {"work.shadow_taps_mean", "Shadow taps per pixel", "", lower, member<&Cell::work, &Work::shadow_taps_mean>},
    {"work.shadow_taps_p95", "Shadow taps per pixel, p95", "", lower, member<&Cell::work, &Work::shadow_taps_p95>},

    {"error.uv_texels.mean", "UV error, mean", texels, lower, member<&Cell::error, &Errors::uv_texels, &Summary::mean>},
    {"error.uv_texels.rms", "UV error, RMS", texels, lower, member<&Cell::error, &Errors::uv_texels, &Summary::rms>},
    {"error.uv_texels.p50", "UV error, median", texels, lower, member<&Cell::error, &Errors::uv_texels, &Summary::p50>},
    {"error.uv_texels.p95", "UV error, p95", texels, lower, member<&Cell::error, &Errors::uv_texels, &Summary::p95>},
    {"error.uv_texels.p99", "UV error, p99", texels, lower, member<&Cell::error, &Errors::uv_texels, &Summary::p99>},
    {"error.uv_texels.max", "UV error, maximum", texels, lower,
     member<&Cell::error, &Errors::uv_texels, &Summary::max>},
    {"error.depth.mean", "Depth error, signed mean", sides, neither,
     member<&Cell::error, &Errors::depth, &Summary::mean>},
    {"error.depth.rms", "Depth error, RMS", sides, lower, member<&Cell::error, &Errors::depth, &Summary::rms>},
    {"error.depth.p50", "Depth error, median", sides, lower, member<&Cell::error, &Errors::depth, &Summary::p50>},
    {"error.depth.p95", "Depth error, p95", sides, lower, member<&Cell::error, &Errors::depth, &Summary::p95>},
    {"error.depth.p99", "Depth error, p99", sides, lower, member<&Cell::error, &Errors::depth, &Summary::p99>},
    {"error.depth.max", "Depth error, maximum", sides, lower, member<&Cell::error, &Errors::depth, &Summary::max>},
    {"error.normal_deg.mean", "Normal error, mean", degrees, lower,
     member<&Cell::error, &Errors::normal_deg, &Summary::mean>},
    {"error.normal_deg.rms", "Normal error, RMS", degrees, lower,
     member<&Cell::error, &Errors::normal_deg, &Summary::rms>},
    {"error.normal_deg.p50", "Normal error, median", degrees, lower,
     member<&Cell::error, &Errors::normal_deg, &Summary::p50>},
    {"error.normal_deg.p95", "Normal error, p95", degrees, lower,
     member<&Cell::error, &Errors::normal_deg, &Summary::p95>},
    {"error.normal_deg.p99", "Normal error, p99", degrees, lower,
     member<&Cell::error, &Errors::normal_deg, &Summary::p99>},
    {"error.normal_deg.max", "Normal error, maximum", degrees, lower,
     member<&Cell::error, &Errors::normal_deg, &Summary::max>},
    {"error.compared", "Pixels compared", pixels, neither, member<&Cell::error, &Errors::compared>},
    {"error.missed", "Missed hits", of_footprint, lower, member<&Cell::error, &Errors::missed>},
    {"error.false_hits", "False hits", of_footprint, lower, member<&Cell::error, &Errors::false_hits>},
    {"error.ties", "Ties", of_footprint, neither, member<&Cell::error, &Errors::ties>},
    {"error.outside_quad.pixels", "Relief outside the quad", pixels, neither,
     member<&Cell::error, &Errors::outside_quad_pixels>},
    {"error.outside_quad.covered", "Relief outside the quad, covered", "fraction of its pixels", higher,
     member<&Cell::error, &Errors::outside_quad_covered>},
    {"error.coverage_iou", "Intersection over union of the coverage", "", higher,
     member<&Cell::error, &Errors::coverage_iou>},
    {"error.wrong_surface", "Wrong one of relief and object in front", of_footprint, lower,
     member<&Cell::error, &Errors::wrong_surface>},
    {"error.shadow.mean", "Shadow error, mean", "visibility", lower,
     member<&Cell::error, &Errors::shadow, &Shadow::mean>},
    {"error.shadow.false_shadow", "False shadow", "visibility", lower,
     member<&Cell::error, &Errors::shadow, &Shadow::false_shadow>},
    {"error.shadow.missed_shadow", "Missed shadow", "visibility", lower,
     member<&Cell::error, &Errors::shadow, &Shadow::missed_shadow>},
    {"error.shadow.compared", "Visibilities compared", "", neither,
     member<&Cell::error, &Errors::shadow, &Shadow::compared>},
    {"error.shadow.truth_standard_error", "Standard error of the truth's soft shadows", "visibility", neither,
     member<&Cell::error, &Errors::shadow, &Shadow::truth_standard_error>},

    {"image.flip", "FLIP, whole picture", "", lower, member<&Cell::image, &Image::flip>},
    {"image.psnr", "PSNR, whole picture", "dB", higher, psnr<&Image::psnr, &Image::rmse, &Cell::image>},
    {"image.ssim", "SSIM, whole picture", "", higher, member<&Cell::image, &Image::ssim>},
    {"image.rmse", "RMSE, whole picture", "", lower, member<&Cell::image, &Image::rmse>},
    {"image.footprint.flip", "FLIP, footprint", "", lower, member<&Cell::image, &Image::footprint, &Footprint::flip>},
    {"image.footprint.psnr", "PSNR, footprint", "dB", higher,
     psnr<&Footprint::psnr, &Footprint::rmse, &Cell::image, &Image::footprint>},
    {"image.footprint.ssim", "SSIM, footprint", "", higher, member<&Cell::image, &Image::footprint, &Footprint::ssim>},
    {"image.footprint.rmse", "RMSE, footprint", "", lower, member<&Cell::image, &Image::footprint, &Footprint::rmse>},

    {"motion.texels.mean", "Change of the UV error between frames, mean", texels, lower,
     member<&Cell::motion, &Motion::texels, &Change::mean>},
    {"motion.texels.p95", "Change of the UV error between frames, p95", texels, lower,
     member<&Cell::motion, &Motion::texels, &Change::p95>},
    {"motion.texels.max", "Change of the UV error between frames, maximum", texels, lower,
     member<&Cell::motion, &Motion::texels, &Change::max>},
    {"motion.flip.mean", "FLIP between frames, mean", "", lower, member<&Cell::motion, &Motion::flip, &Change::mean>},
    {"motion.flip.p95", "FLIP between frames, p95", "", lower, member<&Cell::motion, &Motion::flip, &Change::p95>},
    {"motion.flip.max", "FLIP between frames, maximum", "", lower, member<&Cell::motion, &Motion::flip, &Change::max>},
    {"motion.compared", "Pixels of pairs of frames compared", pixels, neither,
     member<&Cell::motion, &Motion::compared>},
    {"motion.hit_once", "Pixels hit in one of two frames only", pixels, lower,
     member<&Cell::motion, &Motion::hit_once>},
    {"motion.unseen", "Pixels seen in one of two frames only", pixels, neither, member<&Cell::motion, &Motion::unseen>},
};

}  // namespace

std::string_view to_string(Better better) {
    switch (better) {
        case Better::lower:
            return "lower";
        case Better::higher:
            return "higher";
        case Better::neither:
            return "neither";
    }
    return "";
}

bool is_better(double value, double other, Better better) {
    switch (better) {
        case Better::lower:
            return value < other;
        case Better::higher:
            return value > other;
        case Better::neither:
            return false;
    }
    return false;
}

std::span<const FigureDeclaration> figures() {
    return declarations;
}

bool is_time(const FigureDeclaration& figure) {
    return figure.path.starts_with("time.") || figure.path == "prepare.ms";
}

bool is_error(const FigureDeclaration& figure) {
    return figure.path.starts_with("error.") || figure.path.starts_with("image.") || figure.path.starts_with("motion.");
}

const FigureDeclaration* find_figure(std::string_view path) {
    const auto* found = std::find_if(std::begin(declarations), std::end(declarations),
                                     [path](const FigureDeclaration& each) { return each.path == path; });
    return found == std::end(declarations) ? nullptr : found;
}

Json figures_to_json() {
    Json json = Json::array();
    for (const FigureDeclaration& figure : figures()) {
        json.push_back({{"path", figure.path},
                        {"label", figure.label},
                        {"unit", figure.unit},
                        {"better", to_string(figure.better)}});
    }
    return json;
}

}  // namespace reliefbench
