// Techniques are told apart by colour and by shape, so that nobody needs to see colours, and keep both in every report and
// in the figures of scripts/plot.py: scripts/marks.json has the marks, and a technique's name chooses among them.

import marks from "../../scripts/marks.json";

export interface Mark {
  colour: string;
  /** An ECharts symbol. */
  symbol: string;
}

export type Theme = "light" | "dark";

const shapes: { path: string; echarts?: string }[] = marks.shapes;

/** Colours and shapes have no common divisor, so that no two of these numbers have both in common. */
const markCount = marks.colours.light.length * shapes.length;

/** FNV-1a of the text's UTF-8 bytes, 32 bits. */
export function fnv1a(text: string, basis: number): number {
  return new TextEncoder().encode(text).reduce((hash, byte) => Math.imul(hash ^ byte, 16777619) >>> 0, basis);
}

/**
 * The number of each name's mark, the same for a name wherever it is: its hash, from a basis by which no two techniques of
 * this repository meet. Where two names do, the later one in the order of code points takes the next mark that is free.
 */
export function markNumbers(names: Iterable<string>): Map<string, number> {
  const numbers = new Map<string, number>();
  const taken = new Set<number>();
  for (const name of [...new Set(names)].sort(byCodePoints)) {
    let number = Math.floor((fnv1a(name, marks.basis) / 2 ** 32) * markCount);
    if (taken.size < markCount) while (taken.has(number)) number = (number + 1) % markCount;
    taken.add(number);
    numbers.set(name, number);
  }
  return numbers;
}

/** Not the order of UTF-16 units, which is JavaScript's and no other language's. */
function byCodePoints(a: string, b: string): number {
  const [x, y] = [[...a], [...b]];
  const at = x.findIndex((character, place) => character !== y[place]);
  if (at < 0) return x.length - y.length;
  return at >= y.length ? 1 : x[at]!.codePointAt(0)! - y[at]!.codePointAt(0)!;
}

export function markOf(number: number, theme: Theme): Mark {
  const colours = marks.colours[theme];
  const { path, echarts } = shapes[number % shapes.length]!;
  return { colour: colours[number % colours.length]!, symbol: echarts ?? `path://${path}` };
}

/** The mark as an element for legends and tables. */
export function markElement(number: number, theme: Theme): SVGSVGElement {
  const namespace = "http://www.w3.org/2000/svg";
  const svg = document.createElementNS(namespace, "svg");
  svg.setAttribute("viewBox", "0 0 10 10");
  svg.setAttribute("class", "mark");
  svg.setAttribute("aria-hidden", "true");
  const shape = document.createElementNS(namespace, "path");
  shape.setAttribute("d", shapes[number % shapes.length]!.path);
  shape.setAttribute("fill", markOf(number, theme).colour);
  svg.appendChild(shape);
  return svg;
}
