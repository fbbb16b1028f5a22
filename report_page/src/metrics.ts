// Figures of cells as costs and errors: label, unit and direction are those of the page's list of figures.

import { type Cells, type Figure, hasFigure, numberOf, type Tolerance } from "./data.ts";
import {
  drawInterval,
  drawOutliers,
  drawSamples,
  drawTime,
  falseHits,
  missedHits,
  timePerPixel,
  wrongHits,
} from "./defaults.ts";
import { groupOf } from "./figures.ts";
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
  /** Of a percentile over the pixels of a picture. */
  percentOfPixels?: number | undefined;
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

/** What is known of a number of a cell; of one that the list does not declare, its path is its label. */
export type KnownFigure = Pick<Figure, "path" | "label" | "unit" | "infinite_at_zero">;

function valueOf(cells: Cells, figure: KnownFigure, cell: number): number | null {
  const value = numberOf(cells, figure.path, cell);
  if (value !== null || figure.infinite_at_zero === undefined) return value;
  return numberOf(cells, figure.infinite_at_zero, cell) === 0 ? Infinity : null;
}

/** By cell, in the unit that `shownUnit` gives. */
export function shownFigure(cells: Cells, figure: KnownFigure): (cell: number) => number | null {
  const scale = shownScale(figure.unit);
  return (cell) => {
    const value = valueOf(cells, figure, cell);
    return value === null ? null : scale * value;
  };
}

/**
 * What a cell takes: how well it was drawn is said by what is compared with a truth or better the higher, and by fractions of
 * pixels.
 */
function isCost(figure: Figure): boolean {
  return figure.better === "lower" && !figure.needs.includes("truth") && !fraction.test(figure.unit);
}

function metricOf(figure: Figure, better: Better): Metric {
  return {
    id: figure.path,
    label: figure.label,
    unit: shownUnit(figure.unit),
    better,
    role: isCost(figure) ? "cost" : "error",
    percentOfPixels: figure.percent_of_pixels,
    tolerance: { ...figure.tolerance, absolute: shownScale(figure.unit) * figure.tolerance.absolute },
    of: (cells, cell) => shownFigure(cells, figure)(cell),
  };
}

/** Whether it rests on samples of the draw. */
export const isTime = (metric: Pick<Metric, "id">) => groupOf(metric.id) === groupOf(drawTime);

/** A time with the relative 95 % interval of the draw's median, which is as good a guess for the others; else null. */
export function likelyInterval(metric: Pick<Metric, "id" | "of">, cells: Cells, cell: number): [number, number] | null {
  const value = isTime(metric) ? metric.of(cells, cell) : null;
  const median = numberOf(cells, drawTime, cell);
  const [low, high] = [numberOf(cells, drawInterval[0], cell), numberOf(cells, drawInterval[1], cell)];
  if (value === null || !median || low === null || high === null) return null;
  return [(value * low) / median, (value * high) / median];
}

/** Of these it is their own: the draw's median, and the same over pixels. */
const withInterval = [drawTime, timePerPixel];

/** The figure's 95 % interval, in its unit; null for figures and cells that have none. */
export function intervalOf(metric: Pick<Metric, "id" | "of">, cells: Cells, cell: number): [number, number] | null {
  return withInterval.includes(metric.id) ? likelyInterval(metric, cells, cell) : null;
}

/** More outliers than this fraction of the samples: something beside the cell took part in its times. */
export const outlierLimit = 0.1;

/** Outliers of the draw and its samples, where there are too many; else null. */
export function manyOutliers(cells: Cells, cell: number): { outliers: number; samples: number } | null {
  const outliers = numberOf(cells, drawOutliers, cell);
  const samples = numberOf(cells, drawSamples, cell);
  if (outliers === null || samples === null || outliers <= outlierLimit * samples) return null;
  return { outliers, samples };
}

/** Missed and false hits together, a fraction of the footprint; null where nothing was compared with a truth. */
export function wrongHitsOf(cells: Cells, cell: number): number | null {
  const missed = numberOf(cells, missedHits, cell);
  const invented = numberOf(cells, falseHits, cell);
  return missed === null || invented === null ? null : missed + invented;
}

/** Whether the cell's errors count. */
export function hitsWithinLimit(cells: Cells, cell: number): boolean {
  const wrong = wrongHitsOf(cells, cell);
  return wrong !== null && wrong <= hitLimit;
}

export const wrongHitsMetric: Metric = {
  id: wrongHits,
  label: "Missed and false hits",
  unit: "% of footprint",
  better: "lower",
  role: "error",
  tolerance: { absolute: 0.1, relative: 0 },
  of(cells, cell) {
    const wrong = wrongHitsOf(cells, cell);
    return wrong === null ? null : 100 * wrong;
  },
};

/** Whether any cell has the figure. */
export function hasValues(cells: Cells, path: string): boolean {
  return hasFigure(cells, path) && cells.numbers[path]!.some((value) => value !== null);
}

/** Those that some cell has and that have a direction, in the order of the list. */
function metricsOf(figures: readonly Figure[], cells: Cells, wanted: (figure: Figure) => boolean): Metric[] {
  return figures.flatMap((figure) => {
    const { path, better } = figure;
    return hasValues(cells, path) && better !== "neither" && wanted(figure) ? [metricOf(figure, better)] : [];
  });
}

export function errorMetrics(figures: readonly Figure[], cells: Cells): Metric[] {
  const metrics = metricsOf(figures, cells, (figure) => !isCost(figure));
  const behind = metrics.findIndex(({ id }) => id === falseHits);
  if (behind >= 0) metrics.splice(behind + 1, 0, wrongHitsMetric);
  return metrics;
}

export function costMetrics(figures: readonly Figure[], cells: Cells): Metric[] {
  return metricsOf(figures, cells, isCost);
}

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

export function declared(figures: readonly Figure[], path: string): KnownFigure {
  return figures.find((figure) => figure.path === path) ?? { path, label: path, unit: "" };
}

/** "Missed hits (% of footprint)" */
export function figureTitle(figure: Pick<Figure, "label" | "unit">): string {
  return metricTitle({ label: figure.label, unit: shownUnit(figure.unit) });
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
