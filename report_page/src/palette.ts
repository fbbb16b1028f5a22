// Techniques are told apart by colour and by shape, so that nobody needs to see colours. Hues: Okabe & Ito (2008),
// darkened for white paper and lightened for black.

export interface Mark {
  colour: string;
  /** An ECharts symbol. */
  symbol: string;
}

export type Theme = "light" | "dark";

const hues: Record<Theme, string[]> = {
  light: ["#0072b2", "#c85200", "#007f5f", "#a8328a", "#2f9bd8", "#b57900", "#4f545c", "#7d7a00"],
  dark: ["#4ea6e6", "#f2854a", "#2fc495", "#e086c4", "#9bd4f7", "#f0b73f", "#c3c9d1", "#dcd64f"],
};

const path = (d: string) => `path://${d}`;

// A box of 10 × 10 each.
const shapes: { symbol: string; d: string }[] = [
  { symbol: "circle", d: "M0.5 5a4.5 4.5 0 1 0 9 0a4.5 4.5 0 1 0-9 0Z" },
  { symbol: "triangle", d: "M5 0.7L9.8 9.2H0.2Z" },
  { symbol: "rect", d: "M1 1H9V9H1Z" },
  { symbol: "diamond", d: "M5 0L10 5L5 10L0 5Z" },
  { symbol: path("M5 9.3L0.2 0.8H9.8Z"), d: "M5 9.3L0.2 0.8H9.8Z" },
  {
    symbol: path("M3.5 0H6.5V3.5H10V6.5H6.5V10H3.5V6.5H0V3.5H3.5Z"),
    d: "M3.5 0H6.5V3.5H10V6.5H6.5V10H3.5V6.5H0V3.5H3.5Z",
  },
  {
    symbol: path("M5 0L6.3 3.5L10 3.8L7.1 6.1L8.1 10L5 7.8L1.9 10L2.9 6.1L0 3.8L3.7 3.5Z"),
    d: "M5 0L6.3 3.5L10 3.8L7.1 6.1L8.1 10L5 7.8L1.9 10L2.9 6.1L0 3.8L3.7 3.5Z",
  },
];

/** Eight hues and seven shapes: 56 techniques before a mark comes again. */
export function markOf(position: number, theme: Theme): Mark {
  return { colour: hues[theme][position % hues[theme].length]!, symbol: shapes[position % shapes.length]!.symbol };
}

/** The mark as an element for legends and tables. */
export function markElement(position: number, theme: Theme): SVGSVGElement {
  const namespace = "http://www.w3.org/2000/svg";
  const svg = document.createElementNS(namespace, "svg");
  svg.setAttribute("viewBox", "0 0 10 10");
  svg.setAttribute("class", "mark");
  svg.setAttribute("aria-hidden", "true");
  const shape = document.createElementNS(namespace, "path");
  shape.setAttribute("d", shapes[position % shapes.length]!.d);
  shape.setAttribute("fill", hues[theme][position % hues[theme].length]!);
  svg.appendChild(shape);
  return svg;
}
