#pragma once

#include <string_view>

namespace reliefbench {

/// The figures that something goes by, or that are shown where nobody asks for others. No other source of the program
/// names a figure but the one that declares it; a test holds that these are declared. Beside the program,
/// report_page/src/defaults.ts and scripts/plotted_figures.py choose theirs, and scripts/short_names.json has words to
/// type.
namespace chosen_figures {

// What the Pareto front and advice weigh against each other.
inline constexpr std::string_view cost = "time.draw.median_ms";
inline constexpr std::string_view quality = "error.uv_texels.p99";
/// In advice where a run has it, and in every table of quality.
inline constexpr std::string_view flip = "image.footprint.flip";
inline constexpr std::string_view flip_of_whole_picture = "image.flip";

// A cell's errors count where these two together are within a limit.
inline constexpr std::string_view missed = "error.missed";
inline constexpr std::string_view false_hits = "error.false_hits";

// What cautions and shares are of.
inline constexpr std::string_view ties = "error.ties";
inline constexpr std::string_view covered_pixels = "work.covered_pixels";

// Shown beside them.
inline constexpr std::string_view ns_per_pixel = "time.ns_per_pixel";
inline constexpr std::string_view taps = "work.taps_mean";
inline constexpr std::string_view taps_p95 = "work.taps_p95";
inline constexpr std::string_view preparation = "prepare.ms";
inline constexpr std::string_view preparation_bytes = "prepare.bytes";
inline constexpr std::string_view median_uv = "error.uv_texels.p50";
inline constexpr std::string_view mean_uv = "error.uv_texels.mean";
inline constexpr std::string_view depth = "error.depth.p99";
inline constexpr std::string_view shadow_taps = "work.shadow_taps_mean";
inline constexpr std::string_view shadow = "error.shadow.mean";
inline constexpr std::string_view motion = "motion.texels.mean";
inline constexpr std::string_view motion_flip = "motion.flip.mean";
inline constexpr std::string_view ghosting = "motion.ghosting.mean";
inline constexpr std::string_view history_flip = "motion.history_flip.mean";

}  // namespace chosen_figures

}  // namespace reliefbench
