// What the colours of a map of errors mean.

import type { MapLegend } from "../data.ts";
import { h } from "../dom.ts";
import { significant } from "../numbers.ts";
import { bytesOfBase64, draw, legendPosition, valueOfColour } from "../pictures.ts";
import { tickText } from "../scales.ts";

/** Drawn here and not a picture of the run's, so that its words have the page's colours, light or dark. */
export function legendElement(legend: MapLegend): HTMLElement {
  const colours = bytesOfBase64(legend.colours);
  const count = colours.length / 3;
  const bar = h("canvas", { class: "legend-bar", attrs: { "aria-hidden": true } });
  draw({ width: count, height: 1, rgb: colours }, bar);
  const swatch = (colour: readonly number[], text: string) =>
    h("li", {}, h("span", { class: "swatch", attrs: { style: `background: rgb(${colour.join(" ")})` } }), text);
  const mark = (value: number) => {
    const along = legendPosition(legend, value);
    return h("span", { attrs: { style: `left: ${100 * along}%; translate: ${-100 * along}%` } }, tickText(value));
  };
  return h(
    "figure",
    { class: "legend" },
    h("figcaption", {}, legend.unit === "" ? legend.title : `${legend.title}, ${legend.unit}`),
    legend.marks.length > 0 ? bar : null,
    legend.marks.length > 0 ? h("div", { class: "legend-marks" }, ...legend.marks.map(mark)) : null,
    h("ul", {}, ...legend.others.map(({ colour, text }) => swatch(colour, text))),
  );
}

/** "0.31 texels", as exactly as a colour tells; "" where the colour is no value's. */
export function legendValueText(colour: readonly number[], legend: MapLegend): string {
  const value = valueOfColour(colour, legend, bytesOfBase64(legend.colours));
  if (value === null) return "";
  const least = value === legend.dark && legend.logarithmic ? "at most " : "";
  const most = value === legend.light && legend.logarithmic ? "at least " : "";
  return `${least}${most}${significant(value, 2)} ${legend.unit}`;
}
