// Axes of charts: their bounds and labels.

import { extent } from "./numbers.ts";

export interface LogRange {
  min: number;
  max: number;
  /** Where values of 0 are drawn, which have no place on such an axis. */
  zero: number;
  hasZero: boolean;
}

/** Bounds of a logarithmic axis around the values; zeros, if any, lie on its lower end. */
export function logRange(values: Iterable<number>): LogRange {
  let least = Infinity;
  let greatest = 0;
  let hasZero = false;
  for (const value of values) {
    if (value > 0) {
      least = Math.min(least, value);
      greatest = Math.max(greatest, value);
    } else {
      hasZero = true;
    }
  }
  if (least === Infinity) [least, greatest] = [0.1, 1];
  const zero = least / 4;
  const room = 1.2;
  return { min: hasZero ? zero : least / room, max: greatest * room, zero, hasZero };
}

/** What a logarithmic axis counts in: powers of two where powers of ten are too few to read from. */
export function logBase(range: { min: number; max: number }): number {
  return range.max / range.min < 300 ? 2 : 10;
}

const superscripts = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** 0.01, 1, 100; 10⁻⁵ where that is shorter. */
export function powerText(value: number): string {
  if (value === 0) return "0";
  const exponent = Math.log10(Math.abs(value));
  if (exponent >= -3.01 && exponent <= 4.01) return String(Number(value.toPrecision(3)));
  const whole = Math.round(exponent);
  const digits = [...String(Math.abs(whole))].map((digit) => superscripts[Number(digit)]).join("");
  const factor = value / 10 ** whole;
  const mantissa = Math.abs(factor - 1) < 0.01 ? "" : `${Number(factor.toPrecision(2))}·`;
  return `${mantissa}10${whole < 0 ? "⁻" : ""}${digits}`;
}

/** A chart's axis for a figure. */
export interface FigureScale {
  type: "log" | "value";
  min: number;
  max: number;
  /** Where a value is drawn: zeros of a logarithmic axis and infinite values lie on the axis' end. */
  place(value: number): number;
  /** What stands at a tick. */
  text(value: number): string;
  /** Whether the ends have a meaning of their own, and so a text. */
  endTexts: { min: boolean; max: boolean };
}

/**
 * What is better the lower it is shrinks by factors, and has a logarithmic axis; what is better the higher it is nears a
 * bound (SSIM, coverage) or is a logarithm already (PSNR), and has a linear one.
 */
export function figureScale(values: readonly number[], better: "lower" | "higher"): FigureScale {
  if (better === "lower") {
    const range = logRange(values);
    return {
      type: "log",
      min: range.min,
      max: range.max,
      place: (value) => (value > 0 ? value : range.zero),
      text: (value) => (range.hasZero && value === range.min ? "0" : powerText(value)),
      endTexts: { min: range.hasZero, max: false },
    };
  }
  const finite = values.filter(Number.isFinite);
  const [least, greatest] = extent(finite);
  const room = 0.06 * (greatest - least || Math.abs(greatest) || 1);
  const hasInfinite = finite.length < values.length;
  const max = greatest + (hasInfinite ? 3 : 1) * room;
  return {
    type: "value",
    min: least - room,
    max,
    place: (value) => Math.min(value, max),
    text: (value) => (hasInfinite && value === max ? "∞" : String(Number(value.toPrecision(4)))),
    endTexts: { min: false, max: hasInfinite },
  };
}
