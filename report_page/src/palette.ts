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

/** How lines of one technique, which share its mark, are told apart: in widths of the line, and which side is filled. */
export interface LineLook {
  dash: number[];
  filled: "full" | "left" | "right" | "bottom" | "top";
}

/** `at` counts the technique's lines from 0. Dashes and filling go on in other pairs where all are in use. */
export function lineLook(at: number): LineLook {
  const looks = marks.lines as LineLook[];
  const round = Math.floor(at / looks.length);
  return { dash: looks[at % looks.length]!.dash, filled: looks[(at + round) % looks.length]!.filled };
}

/** Where from and where to the filled half lies, as parts of the marker. */
function filledPart(filled: LineLook["filled"]): { x: number; y: number; x2: number; y2: number } {
  const ends = { full: [0, 0, 0, 0], left: [0, 0, 1, 0], right: [1, 0, 0, 0], top: [0, 0, 0, 1], bottom: [0, 1, 0, 0] };
  const [x, y, x2, y2] = ends[filled];
  return { x: x!, y: y!, x2: x2!, y2: y2! };
}

/** For ECharts: the colour, or half of it and half of `empty`. */
export function filling(colour: string, filled: LineLook["filled"], empty: string): string | object {
  if (filled === "full") return colour;
  const stops: [number, string][] = [
    [0, colour],
    [0.5, colour],
    [0.5, empty],
    [1, empty],
  ];
  return { type: "linear", ...filledPart(filled), colorStops: stops.map(([offset, color]) => ({ offset, color })) };
}

/** The mark on its line as an element for legends. */
export function lineElement(number: number, theme: Theme, { dash, filled }: LineLook): SVGSVGElement {
  const namespace = "http://www.w3.org/2000/svg";
  const colour = markOf(number, theme).colour;
  const add = (parent: Element, name: string, attributes: Record<string, string | number>) => {
    const element = document.createElementNS(namespace, name);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, String(value));
    parent.appendChild(element);
    return element;
  };
  const svg = document.createElementNS(namespace, "svg");
  svg.setAttribute("viewBox", "0 0 40 12");
  svg.setAttribute("class", "line-mark");
  svg.setAttribute("aria-hidden", "true");
  const width = 1.6;
  add(svg, "path", {
    d: "M0 6H40",
    stroke: colour,
    "stroke-width": width,
    "stroke-dasharray": dash.map((length) => length * width).join(" "),
  });
  const clip = { full: [0, 0, 10, 10], left: [0, 0, 5, 10], right: [5, 0, 5, 10], top: [0, 0, 10, 5], bottom: [0, 5, 10, 5] };
  const [x, y, across, down] = clip[filled];
  const marker = add(svg, "svg", { x: 15, y: 1, width: 10, height: 10, viewBox: "0 0 10 10", overflow: "visible" });
  const d = shapes[number % shapes.length]!.path;
  add(marker, "path", { d, fill: "var(--panel)", stroke: colour });
  const half = add(marker, "svg", { x: x!, y: y!, width: across!, height: down!, viewBox: `${x} ${y} ${across} ${down}` });
  add(half, "path", { d, fill: colour });
  return svg;
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
