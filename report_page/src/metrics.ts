import { type Cells, numberOf } from "./data.ts";
import { bytesText, significant } from "./numbers.ts";

/** Missed and false hits above this fraction of the footprint: discarding hard pixels wins nothing. */
export const hitLimit = 0.005;

/** A figure of a cell that is better the smaller it is. */
export interface Metric {
  id: string;
  label: string;
  unit: string;
  of(cells: Cells, cell: number): number | null;
}

function field(id: string, label: string, unit: string, scale = 1): Metric {
  return {
    id,
    label,
    unit,
    of(cells, cell) {
      const value = numberOf(cells, id, cell);
      return value === null ? null : scale * value;
    },
  };
}

/** Missed and false hits together, a fraction of the footprint; null where nothing was compared with a truth. */
export function wrongHits(cells: Cells, cell: number): number | null {
  const missed = numberOf(cells, "error.missed", cell);
  const falseHits = numberOf(cells, "error.false_hits", cell);
  return missed === null || falseHits === null ? null : missed + falseHits;
}

/** Whether the cell's errors count. */
export function hitsWithinLimit(cells: Cells, cell: number): boolean {
  const wrong = wrongHits(cells, cell);
  return wrong !== null && wrong <= hitLimit;
}

const knownErrors: Metric[] = [
  field("error.uv_texels.p99", "UV error, p99", "texels"),
  field("error.uv_texels.p95", "UV error, p95", "texels"),
  field("error.uv_texels.p50", "UV error, median", "texels"),
  field("error.uv_texels.mean", "UV error, mean", "texels"),
  field("error.uv_texels.rms", "UV error, RMS", "texels"),
  field("error.uv_texels.max", "UV error, maximum", "texels"),
  field("error.depth.p99", "Depth error, p99", "patch sides"),
  field("error.depth.rms", "Depth error, RMS", "patch sides"),
  field("error.depth.max", "Depth error, maximum", "patch sides"),
  field("error.normal_deg.p99", "Normal error, p99", "degrees"),
  field("error.normal_deg.mean", "Normal error, mean", "degrees"),
  field("image.flip", "FLIP, mean", ""),
  {
    id: "image.dssim",
    label: "1 − SSIM",
    unit: "",
    of(cells, cell) {
      const ssim = numberOf(cells, "image.ssim", cell);
      return ssim === null ? null : Math.max(0, 1 - ssim);
    },
  },
  field("image.rmse", "RMSE of the picture", ""),
  field("error.missed", "Missed hits", "% of footprint", 100),
  field("error.false_hits", "False hits", "% of footprint", 100),
  {
    id: "error.wrong_hits",
    label: "Missed and false hits",
    unit: "% of footprint",
    of(cells, cell) {
      const wrong = wrongHits(cells, cell);
      return wrong === null ? null : 100 * wrong;
    },
  },
  field("motion.texels.mean", "Change of the UV error in motion, mean", "texels"),
  field("motion.texels.p95", "Change of the UV error in motion, p95", "texels"),
  field("motion.texels.max", "Change of the UV error in motion, maximum", "texels"),
  field("motion.flip.mean", "FLIP in motion, mean", ""),
  field("motion.flip.p95", "FLIP in motion, p95", ""),
  field("work.unconverged", "Unconverged searches", "% of pixels", 100),
];

const knownCosts: Metric[] = [
  field("time.draw.median_ms", "Draw time", "ms"),
  field("time.ns_per_pixel", "Time per covered pixel", "ns"),
  field("time.draw.lower_quartile_ms", "Draw time, lower quartile", "ms"),
  field("work.taps_mean", "Taps per pixel", ""),
  field("work.texels_mean", "Texels read per pixel", ""),
  field("work.steps_mean", "Steps per pixel", ""),
  field("prepare.ms", "Preparation time", "ms"),
  field("prepare.bytes", "Memory of prepared maps", "bytes"),
];

/** These are no errors (of those, the larger is the worse one), or one of many statistics of one. */
const noErrors =
  /^(error\.(compared|coverage_iou|outside_quad\..*|.*\.(p50|p95|p99|mean|rms|max))|image\.(psnr|ssim)|motion\.(flip\.max|compared|hit_once|unseen))$/;

/** Fields of later versions: errors by their group, under their own name. */
function unknownErrors(cells: Cells): Metric[] {
  const known = new Set(knownErrors.map((metric) => metric.id));
  return Object.keys(cells.numbers)
    .filter((path) => /^(error|image|motion)\./.test(path) && !known.has(path) && !noErrors.test(path))
    .map((path) => field(path, path, ""));
}

/** Those that at least one cell has. */
function present(metrics: Metric[], cells: Cells): Metric[] {
  return metrics.filter((metric) => {
    for (let cell = 0; cell < cells.count; ++cell) {
      if (metric.of(cells, cell) !== null) return true;
    }
    return false;
  });
}

export function errorMetrics(cells: Cells): Metric[] {
  return present([...knownErrors, ...unknownErrors(cells)], cells);
}

export function costMetrics(cells: Cells): Metric[] {
  return present(knownCosts, cells);
}

/** The one with this id, else the first; null where there is none at all. */
export function metricById(metrics: Metric[], id: string): Metric | null {
  return metrics.find((metric) => metric.id === id) ?? metrics[0] ?? null;
}

/** "UV error, 99th percentile (texels)" */
export function metricTitle(metric: Metric): string {
  return metric.unit === "" ? metric.label : `${metric.label} (${metric.unit})`;
}

/** "0.031 texels" */
export function metricText(metric: Metric, value: number | null): string {
  if (metric.unit === "bytes") return bytesText(value);
  if (metric.unit.startsWith("%")) return value === null ? "–" : `${significant(value)} ${metric.unit}`;
  return metric.unit === "" || value === null ? significant(value) : `${significant(value)} ${metric.unit}`;
}
