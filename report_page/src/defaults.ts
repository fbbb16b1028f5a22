// Which of a run's figures the page chooses, and which it reads itself: the only paths that stand in it. Labels, units and
// directions are those of the page's list of figures (PageData.figures), which every figure on offer comes from.

import names from "../../scripts/short_names.json";

/** What is shown unless something else is chosen: the first that the run has. */
export const usualError = ["error.uv_texels.p99"];
export const usualCost = ["time.draw.median_ms"];
/** Of advice: what is seen decides; over the footprint, over the whole picture, where there are no pictures the hits. */
export const usualQuality = ["image.footprint.flip", "image.flip", ...usualError];
/** Where an axis changes no hit: what shadows, depth or filters do to the picture. */
export const usualErrorOfSameHits = ["error.shadow.mean", "image.footprint.flip", "image.flip", ...usualError];
/** Columns of the table of cells. Time and quality come first. */
export const usualColumns = [
  ["time.draw.median_ms"],
  ["error.uv_texels.p99"],
  ["error.uv_texels.p50"],
  ["image.footprint.flip", "image.flip"],
  ["error.shadow.mean"],
  ["error.missed"],
  ["error.false_hits"],
  ["error.depth.p99"],
  ["work.taps_mean"],
  ["work.shadow_taps_mean"],
  ["time.ns_per_pixel"],
  ["time.draw.mad_ms"],
  ["prepare.ms"],
];
/** What a search may call figures, and scripts/plot.py, too: of several the first that there is. */
export const shortNames: Readonly<Record<string, readonly string[]>> = names;
/** Of the maps of errors beside the pictures. */
export const usualMap = "uv_error";

/** Groups of figures (the first part of their paths) that say what a cell takes besides the time of its passes. */
export const spentGroups = ["prepare", "work"];

/** The pass that cells are compared by. */
export const drawPass = "draw";
/** The draw's median, what its interval spans, and what of its samples is out of line. */
export const drawTime = "time.draw.median_ms";
export const drawInterval = ["time.draw.ci95_ms.low", "time.draw.ci95_ms.high"] as const;
export const drawOutliers = "time.draw.outliers";
export const drawSamples = "time.draw.n";
/** Why sampling stopped: a word. */
export const stopWord = "time.stop";
/** The draw's median over pixels, which has the same interval. */
export const timePerPixel = "time.ns_per_pixel";

/** How many pixels the time is of. */
export const coveredPixels = "work.covered_pixels";
/** What charts stand over besides axes and parameters. */
export const steps = "work.steps_mean";

/** Fractions of the footprint: a cell with too many of both together has no errors that count. */
export const missedHits = "error.missed";
export const falseHits = "error.false_hits";
/** Their sum, which the list lacks. */
export const wrongHits = "error.wrong_hits";
/** Equal for all of some cells: then their hits are. */
export const hitErrors = ["error.uv_texels.mean", "error.uv_texels.max", missedHits, falseHits];

/** Relief outside the footprint, which errors of whole pictures count. */
export const outsidePixels = "error.outside_quad.pixels";
