// Figures of cells as costs and errors: label, unit and direction are those of the page's list of figures.

import { type Cells, type Figure, hasFigure, numberOf, type Tolerance } from "./data.ts";
import { bytesText, figureText } from "./numbers.ts";

/** Missed and false hits above this fraction of the footprint: discarding hard pixels wins nothing. */
export const hitLimit = 0.005;

export type Better = "lower" | "higher";

/** A figure of a cell with a direction. */
export interface Metric {
  id: string;
  label: string;
  unit: string;
  better: Better;
  role: "cost" | "error";
  /** In the unit. */
  tolerance: Tolerance;
  /** In the unit. Infinite for the PSNR of pictures that are equal. */
  of(cells: Cells, cell: number): number | null;
}

const fraction = /^fraction\b/;

/** Fractions are shown in per cent. */
function shownScale(unit: string): number {
  return fraction.test(unit) ? 100 : 1;
}

export function shownUnit(unit: string): string {
  return unit.replace(fraction, "%");
}

/** The ratio of a picture without an error to its noise has no number in JSON. */
function valueOf(cells: Cells, path: string, cell: number): number | null {
  const value = numberOf(cells, path, cell);
  if (value !== null || !path.endsWith(".psnr")) return value;
  return numberOf(cells, path.replace(/psnr$/, "rmse"), cell) === 0 ? Infinity : null;
}

/** By cell, in the unit that `shownUnit` gives. */
export function shownFigure(cells: Cells, figure: Pick<Figure, "path" | "unit">): (cell: number) => number | null {
  const scale = shownScale(figure.unit);
  return (cell) => {
    const value = valueOf(cells, figure.path, cell);
    return value === null ? null : scale * value;
  };
}

/** Time, work and memory; of these groups, fractions of pixels say how well the work was done. */
function isCost(figure: Figure): boolean {
  return /^(time|work|prepare)\./.test(figure.path) && !fraction.test(figure.unit);
}

function metricOf(figure: Figure, better: Better): Metric {
  return {
    id: figure.path,
    label: figure.label,
    unit: shownUnit(figure.unit),
    better,
    role: isCost(figure) ? "cost" : "error",
    tolerance: { ...figure.tolerance, absolute: shownScale(figure.unit) * figure.tolerance.absolute },
    of: (cells, cell) => shownFigure(cells, figure)(cell),
  };
}

/** A time with the relative 95 % interval of the draw's median, which is as good a guess for the others; else null. */
export function likelyInterval(metric: Pick<Metric, "id" | "of">, cells: Cells, cell: number): [number, number] | null {
  const value = metric.id.startsWith("time.") ? metric.of(cells, cell) : null;
  const median = numberOf(cells, "time.draw.median_ms", cell);
  const low = numberOf(cells, "time.draw.ci95_ms.low", cell);
  const high = numberOf(cells, "time.draw.ci95_ms.high", cell);
  if (value === null || !median || low === null || high === null) return null;
  return [(value * low) / median, (value * high) / median];
}

/** Of these it is their own: the draw's median, and the same over pixels. */
const withInterval = ["time.draw.median_ms", "time.ns_per_pixel"];

/** The figure's 95 % interval, in its unit; null for figures and cells that have none. */
export function intervalOf(metric: Pick<Metric, "id" | "of">, cells: Cells, cell: number): [number, number] | null {
  return withInterval.includes(metric.id) ? likelyInterval(metric, cells, cell) : null;
}

/** More outliers than this fraction of the samples: something beside the cell took part in its times. */
export const outlierLimit = 0.1;

/** Outliers of the draw and its samples, where there are too many; else null. */
export function manyOutliers(cells: Cells, cell: number): { outliers: number; samples: number } | null {
  const outliers = numberOf(cells, "time.draw.outliers", cell);
  const samples = numberOf(cells, "time.draw.n", cell);
  if (outliers === null || samples === null || outliers <= outlierLimit * samples) return null;
  return { outliers, samples };
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

export const wrongHitsMetric: Metric = {
  id: "error.wrong_hits",
  label: "Missed and false hits",
  unit: "% of footprint",
  better: "lower",
  role: "error",
  tolerance: { absolute: 0.1, relative: 0 },
  of(cells, cell) {
    const wrong = wrongHits(cells, cell);
    return wrong === null ? null : 100 * wrong;
  },
};

/** Those that some cell has and that have a direction, in the order of the list. */
function metricsOf(figures: readonly Figure[], cells: Cells, wanted: (figure: Figure) => boolean): Metric[] {
  return figures.flatMap((figure) => {
    const { path, better } = figure;
    const there = hasFigure(cells, path) && cells.numbers[path]!.some((value) => value !== null);
    return there && better !== "neither" && wanted(figure) ? [metricOf(figure, better)] : [];
  });
}

export function errorMetrics(figures: readonly Figure[], cells: Cells): Metric[] {
  const metrics = metricsOf(figures, cells, (figure) => !isCost(figure));
  const falseHits = metrics.findIndex(({ id }) => id === "error.false_hits");
  if (falseHits >= 0) metrics.splice(falseHits + 1, 0, wrongHitsMetric);
  return metrics;
}

export function costMetrics(figures: readonly Figure[], cells: Cells): Metric[] {
  return metricsOf(figures, cells, isCost);
}

/** What is shown unless something else is chosen, the first that the run has. */
export const usualError = ["error.uv_texels.p99"];
/** Of advice: what is seen decides; over the footprint, over the whole picture, where there are no pictures the hits. */
export const usualQuality = ["image.footprint.flip", "image.flip", ...usualError];
/** Where an axis changes no hit: what shadows, depth or filters do to the picture. */
export const usualErrorOfSameHits = ["error.shadow.mean", "image.footprint.flip", "image.flip"];
export const usualCost = ["time.draw.median_ms"];

/** The first of these ids that there is, else the first metric; null where there is none at all. */
export function metricById(metrics: readonly Metric[], ...ids: string[]): Metric | null {
  for (const id of ids) {
    const found = metrics.find((metric) => metric.id === id);
    if (found) return found;
  }
  return metrics[0] ?? null;
}

/** Above 0 where `a` is the better value. */
export function advantage(better: Better, a: number, b: number): number {
  if (a === b) return 0;
  return better === "higher" ? a - b : b - a;
}

/** The worst of the values; there must be one. */
export function worstOf(better: Better, values: readonly number[]): number {
  return values.reduce((worst, value) => (advantage(better, worst, value) > 0 ? value : worst));
}

/** "UV error, p99 (texels)" */
export function metricTitle(metric: Pick<Metric, "label" | "unit">): string {
  return metric.unit === "" ? metric.label : `${metric.label} (${metric.unit})`;
}

/** Of a chart's axis: "UV error, p99 (texels), lower is better"; in one line or two. */
export function axisTitle(metric: Metric, separator = ", "): string {
  return `${metricTitle(metric)}${separator}${metric.better} is better`;
}

/** Below a title that has the unit: "0.031" */
export function bareText(metric: Pick<Metric, "unit">, value: number | null): string {
  return metric.unit === "bytes" ? bytesText(value) : figureText(value);
}

/** "0.98 to 1.02 ms" */
export function intervalText(metric: Pick<Metric, "unit">, [low, high]: readonly [number, number]): string {
  return `${bareText(metric, low)} to ${metricText(metric, high)}`;
}

/** "0.031 texels" */
export function metricText(metric: Pick<Metric, "unit">, value: number | null): string {
  const text = bareText(metric, value);
  return metric.unit === "" || metric.unit === "bytes" || value === null ? text : `${text} ${metric.unit}`;
}
