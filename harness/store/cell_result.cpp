#include "store/cell_result.hpp"

#include <cassert>
#include <cmath>

namespace reliefbench {

namespace {

const std::vector<std::string> status_names = {"ok", "skipped", "failed"};

/// In the order of StopReason.
const std::vector<std::string> stop_reason_names = {"precise", "stalled", "budget", "rounds", "time"};

// Beside the passes, members of "time".
constexpr std::string_view ns_per_pixel_key = "ns_per_pixel";
constexpr std::string_view stop_key = "stop";
constexpr std::string_view throttled_rounds_key = "throttled_rounds";

bool is_pass(std::string_view key) {
    return key != ns_per_pixel_key && key != stop_key && key != throttled_rounds_key;
}

Json to_json(const PassTiming& timing) {
    Json json;
    json["median_ms"] = finite_or_null(timing.median_ms);
    json["mad_ms"] = finite_or_null(timing.mad_ms);
    json["ci95_ms"] = {finite_or_null(timing.ci95_ms.low), finite_or_null(timing.ci95_ms.high)};
    json["n"] = timing.n;
    json["repeats"] = timing.repeats;
    json["rounds"] = timing.rounds;
    json["outliers"] = timing.outliers;
    if (timing.lower_quartile_ms) json["lower_quartile_ms"] = finite_or_null(*timing.lower_quartile_ms);
    return json;
}

Json to_json(const CellResult::Work& work) {
    Json json;
    json["taps_mean"] = finite_or_null(work.taps_mean);
    json["taps_p95"] = finite_or_null(work.taps_p95);
    json["texels_mean"] = finite_or_null(work.texels_mean);
    json["steps_mean"] = finite_or_null(work.steps_mean);
    json["steps_p95"] = finite_or_null(work.steps_p95);
    json["unconverged"] = finite_or_null(work.unconverged);
    json["covered_pixels"] = work.covered_pixels;
    json["shadow_taps_mean"] = finite_or_null(work.shadow_taps_mean);
    json["shadow_taps_p95"] = finite_or_null(work.shadow_taps_p95);
    return json;
}

Json to_json(const std::optional<Summary>& summary) {
    if (!summary) return nullptr;
    Json json;
    json["mean"] = finite_or_null(summary->mean);
    json["rms"] = finite_or_null(summary->rms);
    json["p50"] = finite_or_null(summary->p50);
    json["p95"] = finite_or_null(summary->p95);
    json["p99"] = finite_or_null(summary->p99);
    json["max"] = finite_or_null(summary->max);
    return json;
}

Json to_json(const CellResult::ShadowErrors& shadow) {
    Json json;
    json["mean"] = finite_or_null(shadow.mean);
    json["false_shadow"] = finite_or_null(shadow.false_shadow);
    json["missed_shadow"] = finite_or_null(shadow.missed_shadow);
    json["compared"] = shadow.compared;
    json["truth_standard_error"] = finite_or_null(shadow.truth_standard_error);
    return json;
}

Json to_json(const CellResult::Errors& errors) {
    Json json;
    json["uv_texels"] = to_json(errors.uv_texels);
    json["depth"] = to_json(errors.depth);
    json["normal_deg"] = to_json(errors.normal_deg);
    json["compared"] = errors.compared;
    json["missed"] = finite_or_null(errors.missed);
    json["false_hits"] = finite_or_null(errors.false_hits);
    json["ties"] = finite_or_null(errors.ties);
    json["outside_quad"]["pixels"] = errors.outside_quad_pixels;
    json["outside_quad"]["covered"] = finite_or_null(errors.outside_quad_covered);
    json["coverage_iou"] = finite_or_null(errors.coverage_iou);
    json["wrong_surface"] = finite_or_null(errors.wrong_surface);
    json["shadow"] = errors.shadow ? to_json(*errors.shadow) : Json(nullptr);
    return json;
}

template <typename Fields>
Json image_errors_to_json(const Fields& errors) {
    Json json;
    json["flip"] = finite_or_null(errors.flip);
    json["psnr"] = finite_or_null(errors.psnr);
    json["ssim"] = finite_or_null(errors.ssim);
    json["rmse"] = finite_or_null(errors.rmse);
    return json;
}

Json to_json(const CellResult::ImageFields& image) {
    Json json = image_errors_to_json(image);
    if (image.footprint) json["footprint"] = image_errors_to_json(*image.footprint);
    return json;
}

Json to_json(const std::optional<CellResult::MotionFigure>& figure) {
    if (!figure) return nullptr;
    Json json;
    json["mean"] = finite_or_null(figure->mean);
    json["p95"] = finite_or_null(figure->p95);
    json["max"] = finite_or_null(figure->max);
    return json;
}

Json to_json(const CellResult::Motion& motion) {
    Json json;
    json["texels"] = to_json(motion.texels);
    json["flip"] = to_json(motion.flip);
    json["compared"] = motion.compared;
    json["hit_once"] = motion.hit_once;
    json["unseen"] = motion.unseen;
    return json;
}

template <typename Fields>
Json fields_or_null(const std::optional<Fields>& fields) {
    return fields ? to_json(*fields) : Json(nullptr);
}

std::uint64_t count(const JsonView& view) {
    return static_cast<std::uint64_t>(view.integer(0));
}

/// `read` of a value that may be null.
template <typename Read>
auto optional(const JsonView& view, Read read) -> std::optional<decltype(read(view))> {
    if (view.json().is_null()) return std::nullopt;
    return read(view);
}

std::optional<double> optional_number(const JsonView& view) {
    return optional(view, [](const JsonView& present) { return present.number(); });
}

PassTiming read_timing(const JsonView& view) {
    view.require_only({"median_ms", "mad_ms", "ci95_ms", "n", "repeats", "rounds", "outliers", "lower_quartile_ms"});
    const std::vector<JsonView> interval = view.at("ci95_ms").items();
    if (interval.size() != 2) view.at("ci95_ms").fail_expected("[low, high]");
    PassTiming timing;
    timing.median_ms = view.at("median_ms").number();
    timing.mad_ms = view.at("mad_ms").number();
    timing.ci95_ms = {interval[0].number(), interval[1].number()};
    timing.n = count(view.at("n"));
    timing.repeats = static_cast<int>(view.at("repeats").integer(1, std::numeric_limits<int>::max()));
    // Runs before these were recorded have neither.
    if (view.has("rounds")) timing.rounds = count(view.at("rounds"));
    if (view.has("lower_quartile_ms")) timing.lower_quartile_ms = view.at("lower_quartile_ms").number();
    if (view.has("outliers")) timing.outliers = count(view.at("outliers"));
    return timing;
}

CellResult::Work read_work(const JsonView& view) {
    view.require_only({"taps_mean", "taps_p95", "texels_mean", "steps_mean", "steps_p95", "unconverged",
                       "covered_pixels", "shadow_taps_mean", "shadow_taps_p95"});
    CellResult::Work work;
    work.taps_mean = view.at("taps_mean").number();
    work.taps_p95 = view.at("taps_p95").number();
    work.texels_mean = view.at("texels_mean").number();
    work.steps_mean = view.at("steps_mean").number();
    work.steps_p95 = view.at("steps_p95").number();
    work.unconverged = view.at("unconverged").number();
    work.covered_pixels = count(view.at("covered_pixels"));
    // Runs before there were shadows have neither.
    if (view.has("shadow_taps_mean")) work.shadow_taps_mean = optional_number(view.at("shadow_taps_mean"));
    if (view.has("shadow_taps_p95")) work.shadow_taps_p95 = optional_number(view.at("shadow_taps_p95"));
    return work;
}

Summary read_summary(const JsonView& view) {
    view.require_only({"mean", "rms", "p50", "p95", "p99", "max"});
    Summary summary;
    summary.mean = view.at("mean").number();
    summary.rms = view.at("rms").number();
    summary.p50 = view.at("p50").number();
    summary.p95 = view.at("p95").number();
    summary.p99 = view.at("p99").number();
    summary.max = view.at("max").number();
    return summary;
}

CellResult::ShadowErrors read_shadow_errors(const JsonView& view) {
    view.require_only({"mean", "false_shadow", "missed_shadow", "compared", "truth_standard_error"});
    CellResult::ShadowErrors shadow;
    shadow.mean = view.at("mean").number();
    shadow.false_shadow = view.at("false_shadow").number();
    shadow.missed_shadow = view.at("missed_shadow").number();
    shadow.compared = count(view.at("compared"));
    shadow.truth_standard_error = optional_number(view.at("truth_standard_error"));
    return shadow;
}

CellResult::Errors read_errors(const JsonView& view) {
    view.require_only({"uv_texels", "depth", "normal_deg", "compared", "missed", "false_hits", "ties", "outside_quad",
                       "coverage_iou", "shadow", "wrong_surface"});
    const JsonView outside_quad = view.at("outside_quad");
    outside_quad.require_only({"pixels", "covered"});
    CellResult::Errors errors;
    errors.uv_texels = optional(view.at("uv_texels"), read_summary);
    errors.depth = optional(view.at("depth"), read_summary);
    errors.normal_deg = optional(view.at("normal_deg"), read_summary);
    errors.compared = count(view.at("compared"));
    errors.missed = view.at("missed").number();
    errors.false_hits = view.at("false_hits").number();
    if (view.has("ties")) errors.ties = optional_number(view.at("ties"));
    errors.outside_quad_pixels = count(outside_quad.at("pixels"));
    errors.outside_quad_covered = optional_number(outside_quad.at("covered"));
    errors.coverage_iou = view.at("coverage_iou").number();
    // Runs before there were shadows and objects have neither.
    if (view.has("wrong_surface")) errors.wrong_surface = optional_number(view.at("wrong_surface"));
    if (view.has("shadow")) errors.shadow = optional(view.at("shadow"), read_shadow_errors);
    return errors;
}

template <typename Fields>
Fields read_image_errors(const JsonView& view) {
    Fields errors;
    errors.flip = optional_number(view.at("flip"));
    errors.psnr = optional_number(view.at("psnr"));
    errors.ssim = optional_number(view.at("ssim"));
    errors.rmse = optional_number(view.at("rmse"));
    return errors;
}

CellResult::ImageFields read_image(const JsonView& view) {
    view.require_only({"flip", "psnr", "ssim", "rmse", "footprint"});
    auto image = read_image_errors<CellResult::ImageFields>(view);
    if (view.has("footprint")) {
        image.footprint = optional(view.at("footprint"), [](const JsonView& footprint) {
            footprint.require_only({"flip", "psnr", "ssim", "rmse"});
            return read_image_errors<CellResult::FootprintFields>(footprint);
        });
    }
    return image;
}

CellResult::MotionFigure read_motion_figure(const JsonView& view) {
    view.require_only({"mean", "p95", "max"});
    return {view.at("mean").number(), view.at("p95").number(), view.at("max").number()};
}

CellResult::Motion read_motion(const JsonView& view) {
    view.require_only({"texels", "flip", "compared", "hit_once", "unseen"});
    CellResult::Motion motion;
    motion.texels = optional(view.at("texels"), read_motion_figure);
    motion.flip = optional(view.at("flip"), read_motion_figure);
    motion.compared = count(view.at("compared"));
    motion.hit_once = count(view.at("hit_once"));
    motion.unseen = count(view.at("unseen"));
    return motion;
}

void read_beside_passes(const JsonView& time, CellResult& result) {
    result.ns_per_pixel = optional_number(time.at(std::string(ns_per_pixel_key)));
    const std::string stop(stop_key);
    const std::string throttled_rounds(throttled_rounds_key);
    if (time.has(stop)) {
        result.stop = optional(time.at(stop), [](const JsonView& reason) {
            return static_cast<StopReason>(reason.choice(stop_reason_names));
        });
    }
    if (time.has(throttled_rounds)) result.throttled_rounds = count(time.at(throttled_rounds));
}

std::map<std::string, std::map<std::string, double>> read_executable(const JsonView& view) {
    std::map<std::string, std::map<std::string, double>> executable;
    for (const auto& [stage, statistics] : view.members()) {
        for (const auto& [statistic, value] : statistics.members()) {
            executable[stage][statistic] = value.number();
        }
    }
    return executable;
}

Json read_object(const JsonView& view) {
    if (!view.json().is_object()) view.fail_expected("an object");
    return view.json();
}

}  // namespace

std::string_view to_string(StopReason reason) {
    return stop_reason_names[static_cast<std::size_t>(reason)];
}

Json to_json(const CellResult& result) {
    Json json;
    json["cell"] = result.cell;
    json["technique"] = result.technique;
    json["axes"] = result.axes.is_null() ? Json::object() : result.axes;
    json["parameters"] = result.parameters.is_null() ? Json::object() : result.parameters;
    json["status"] = status_names[static_cast<std::size_t>(result.status)];
    json["reason"] = result.reason.empty() ? Json(nullptr) : Json(result.reason);
    json["time"] = Json::object();
    for (const auto& [pass, timing] : result.time) {
        assert(is_pass(pass));
        json["time"][pass] = to_json(timing);
    }
    json["time"][ns_per_pixel_key] = finite_or_null(result.ns_per_pixel);
    json["time"][stop_key] = result.stop ? Json(to_string(*result.stop)) : Json(nullptr);
    json["time"][throttled_rounds_key] = result.throttled_rounds;
    json["prepare"]["ms"] = finite_or_null(result.prepare_ms);
    json["prepare"]["bytes"] = result.prepare_bytes ? Json(*result.prepare_bytes) : Json(nullptr);
    json["work"] = fields_or_null(result.work);
    json["pipeline"] = Json::object();
    for (const auto& [statistic, value] : result.pipeline) {
        json["pipeline"][statistic] = value;
    }
    json["executable"] = Json::object();
    for (const auto& [stage, statistics] : result.executable) {
        for (const auto& [statistic, value] : statistics) {
            json["executable"][stage][statistic] = finite_or_null(value);
        }
    }
    json["error"] = fields_or_null(result.error);
    json["image"] = fields_or_null(result.image);
    json["motion"] = fields_or_null(result.motion);
    if (result.forced_resume) json["forced_resume"] = true;
    return json;
}

CellResult parse_cell_result(const Json& json, const std::string& file) {
    const JsonView view(json, file);
    // Runs of version 0.1.0 have the short key.
    const std::string parameters = view.has("params") ? "params" : "parameters";
    view.require_only({"cell", "technique", "axes", parameters, "status", "reason", "time", "prepare", "work",
                       "pipeline", "executable", "error", "image", "motion", "forced_resume"});
    const JsonView prepare = view.at("prepare");
    prepare.require_only({"ms", "bytes"});
    CellResult result;
    result.cell = view.at("cell").string();
    result.technique = view.at("technique").string();
    result.axes = read_object(view.at("axes"));
    result.parameters = read_object(view.at(parameters));
    result.status = static_cast<CellStatus>(view.at("status").choice(status_names));
    result.reason = optional(view.at("reason"), [](const JsonView& reason) { return reason.string(); }).value_or("");
    for (const auto& [pass, timing] : view.at("time").members()) {
        if (is_pass(pass)) result.time[pass] = read_timing(timing);
    }
    read_beside_passes(view.at("time"), result);
    result.prepare_ms = optional_number(prepare.at("ms"));
    result.prepare_bytes = optional(prepare.at("bytes"), count);
    result.work = optional(view.at("work"), read_work);
    for (const auto& [statistic, value] : view.at("pipeline").members()) {
        result.pipeline[statistic] = count(value);
    }
    if (view.has("executable")) result.executable = read_executable(view.at("executable"));
    result.error = optional(view.at("error"), read_errors);
    result.image = optional(view.at("image"), read_image);
    if (view.has("motion")) result.motion = optional(view.at("motion"), read_motion);
    if (view.has("forced_resume")) result.forced_resume = view.at("forced_resume").boolean();
    return result;
}

}  // namespace reliefbench
