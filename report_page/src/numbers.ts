/** `digits` significant ones, without an exponent where it reads better; "–" for what is undefined. */
export function significant(value: number | null | undefined, digits = 3): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size < 1e-4 || size >= 1e7)
    return value
      .toExponential(digits - 1)
      .replace("e+", "e")
      .replace("-", "−")
      .replace("e-", "e−");
  const decimals = Math.max(0, digits - 1 - Math.floor(Math.log10(size)));
  return value.toFixed(decimals).replace("-", "−");
}

/** A figure, which may be infinite. */
export function figureText(value: number | null): string {
  return value === Infinity ? "∞" : significant(value);
}

/** A change that a ratio is: "+7.2 %". */
export function changeText(ratio: number | null | undefined): string {
  if (ratio === null || ratio === undefined || !Number.isFinite(ratio)) return "–";
  const change = 100 * (ratio - 1);
  const text = Math.abs(change).toFixed(Math.abs(change) >= 100 ? 0 : 1);
  if (text === "0.0") return "0 %";
  return `${change < 0 ? "−" : "+"}${text} %`;
}

export function bytesText(bytes: number | null): string {
  if (bytes === null) return "–";
  const units = ["B", "KiB", "MiB", "GiB"];
  let value = bytes;
  let unit = 0;
  while (value >= 1024 && unit < units.length - 1) {
    value /= 1024;
    ++unit;
  }
  return `${unit === 0 ? value : significant(value)} ${units[unit]}`;
}

export function counted(count: number, noun: string): string {
  return `${count.toLocaleString("en")} ${noun}${count === 1 ? "" : "s"}`;
}

export function median(values: number[]): number | null {
  if (values.length === 0) return null;
  const sorted = [...values].sort((a, b) => a - b);
  const middle = sorted.length >> 1;
  return sorted.length % 2 === 1 ? sorted[middle]! : (sorted[middle - 1]! + sorted[middle]!) / 2;
}

export function arithmeticMean(values: readonly number[]): number {
  return values.reduce((sum, value) => sum + value, 0) / values.length;
}

/** Arithmetic where there is a zero. */
export function geometricMean(values: readonly number[]): number {
  if (values.some((value) => value <= 0)) return arithmeticMean(values);
  return Math.exp(values.reduce((sum, value) => sum + Math.log(value), 0) / values.length);
}

/** Least and greatest; of no values, 0 and 0. */
export function extent(values: readonly number[]): [number, number] {
  let [least, greatest] = [values[0] ?? 0, values[0] ?? 0];
  for (const value of values) {
    least = Math.min(least, value);
    greatest = Math.max(greatest, value);
  }
  return [least, greatest];
}
