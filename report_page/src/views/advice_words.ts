// Figures of advice in words.

import type { Candidate, Question } from "../advice.ts";
import { drawTime } from "../defaults.ts";
import { type Metric, metricText } from "../metrics.ts";
import { significant } from "../numbers.ts";

/** Abbreviations keep their capitals. */
export const inSentence = (label: string) =>
  /^[A-Z][a-z]/.test(label) ? label.slice(0, 1).toLowerCase() + label.slice(1) : label;

export const labelled = (metric: Metric, value: number) => `${inSentence(metric.label)} ${metricText(metric, value)}`;

/** "0.002 and 2 %": what a difference must exceed to be told. */
export function toleranceWords({ tolerance: { absolute, relative }, unit }: Metric): string {
  const shortest = (value: number) => String(Number(value.toPrecision(3)));
  const parts = [
    ...(absolute > 0 ? [`${shortest(absolute)}${unit === "" ? "" : ` ${unit}`}`] : []),
    ...(relative > 0 ? [`${shortest(100 * relative)} %`] : []),
  ];
  return parts.join(" and ");
}

export function lessText(value: number, before: number): string {
  if (value <= 0) return "";
  const factor = before / value;
  return factor < 1.5 ? ` (${Math.round(100 * (1 - 1 / factor))} % less)` : ` (${significant(factor, 2)} times less)`;
}

/** "99 % of its pixels lie within 0.031 texels" */
export function errorWords(error: Metric, value: number): string {
  if (error.percentOfPixels !== undefined && error.better === "lower") {
    const bound = value === 0 ? "have no error" : `are within ${metricText(error, value)}`;
    return `${error.percentOfPixels} % of its pixels ${bound}`;
  }
  return labelled(error, value);
}

export function costWords(cost: Metric, value: number): string {
  if (cost.id === drawTime) return `in ${metricText(cost, value)}`;
  return `at ${metricText(cost, value)}${cost.unit === "" ? ` ${cost.label.toLowerCase()}` : ""}`;
}

/** " (2.7 times the error)" */
export function timesText(value: number, from: number, what: string): string {
  if (value <= 0 || from <= 0 || !Number.isFinite(value)) return "";
  const times = value / from;
  if (times > 1 / 1.05 && times < 1.05) return ` (nearly the same ${what})`;
  return ` (${significant(times, 2)} times the ${what})`;
}

export function comparedWords(winner: Candidate, other: Candidate, { cost, error }: Question): string {
  const errorRatio = error.better === "lower" ? timesText(other.error, winner.error, "error") : "";
  return `${errorWords(error, other.error)}${errorRatio}, ${costWords(cost, other.cost)}${timesText(other.cost, winner.cost, "cost")}`;
}
