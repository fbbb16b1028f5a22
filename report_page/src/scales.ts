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

/** Numbers at an axis: fewer than these and more than those are not to be read from. */
const minTicks = 4;
const maxTicks = 9;

/** What is multiplied by powers of ten, from coarse to fine. */
const decadeSteps = [[1], [1, 3], [1, 2, 5], [1, 2, 3, 4, 5, 6, 7, 8, 9]];

const exact = (value: number) => Number(value.toPrecision(12));

/** Round numbers of a logarithmic axis from `min` to `max`, both above 0; two at least where the two differ. */
export function logTicks(min: number, max: number): number[] {
  const [first, last] = [Math.floor(Math.log10(min)), Math.floor(Math.log10(max))];
  const every = Math.max(1, Math.ceil((last - first) / maxTicks));
  const within = (steps: number[]) => {
    const ticks: number[] = [];
    for (let exponent = Math.ceil(first / every) * every - every; exponent <= last; exponent += every) {
      for (const step of steps) ticks.push(exact(step * 10 ** exponent));
    }
    return ticks.filter((tick) => tick >= min && tick <= max);
  };
  if (every > 1) return within([1]);
  const choices = decadeSteps.map(within).filter((ticks) => ticks.length <= maxTicks);
  const chosen = choices.find((ticks) => ticks.length >= minTicks) ?? choices.at(-1) ?? [];
  return chosen.length >= minTicks ? chosen : linearTicks(min, max);
}

/** Round numbers from `min` to `max` in equal steps; two at least where the two differ. */
export function linearTicks(min: number, max: number): number[] {
  if (!(max > min)) return [min];
  const rough = (max - min) / (minTicks + 2);
  const decade = 10 ** Math.floor(Math.log10(rough));
  const step = exact(decade * [1, 2, 2.5, 5, 10].find((factor) => factor * decade >= 0.999 * rough)!);
  const ticks: number[] = [];
  for (let at = Math.ceil(min / step - 1e-9); at * step <= max + 1e-9 * step; ++at) ticks.push(exact(at * step));
  return ticks;
}

const superscripts = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** Where nobody would count the zeros it does not. */
function readsWrittenOut(value: number): boolean {
  const size = Math.abs(value);
  return size === 0 || (size > 0.99e-6 && size < 0.99e7);
}

/**
 * 0.03, 1024; 10⁻⁷, 3·10⁷ where the value does not read written out, or one of the others at its axis does not: all of an
 * axis have one form.
 */
export function tickText(value: number, ofAxis: readonly number[] = [value]): string {
  const size = Math.abs(value);
  if (size === 0 || ofAxis.every(readsWrittenOut)) return String(exact(value)).replace("-", "−");
  const exponent = Math.floor(Math.log10(size) + 1e-9);
  const digits = [...String(Math.abs(exponent))].map((digit) => superscripts[Number(digit)]).join("");
  const factor = Number((value / 10 ** exponent).toPrecision(6));
  const mantissa = factor === 1 ? "" : `${String(factor).replace("-", "−")}·`;
  return `${mantissa}10${exponent < 0 ? "⁻" : ""}${digits}`;
}

/** A chart's axis for a figure. */
export interface FigureScale {
  type: "log" | "value";
  min: number;
  max: number;
  /** Where a value is drawn: zeros of a logarithmic axis and infinite values lie on the axis' end. */
  place(value: number): number;
  /** What stands at a tick, of those of the axis. */
  text(value: number, ofAxis?: readonly number[]): string;
  /** Where numbers stand of what is seen of the axis. */
  ticks(from: number, to: number): number[];
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
      text: (value, ofAxis) =>
        range.hasZero && value === range.min ? "0" : tickText(value, range.hasZero ? ofAxis?.filter((each) => each !== range.min) : ofAxis),
      ticks: (from, to) => {
        if (!range.hasZero || from > range.zero) return logTicks(from, to);
        const room = 1.6;
        return [range.zero, ...logTicks(range.zero, to).filter((tick) => tick > room * range.zero)];
      },
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
    text: (value, ofAxis) => (hasInfinite && value === max ? "∞" : tickText(value, ofAxis)),
    ticks: (from, to) => {
      if (!hasInfinite || to < max) return linearTicks(from, to);
      return [...linearTicks(from, to).filter((tick) => tick <= greatest + room), max];
    },
  };
}
