// Logarithmic axes: their bounds and labels.

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
