// Cost and error over steps, view angle and every other number that was swept, and beside each other by values of any axis.

import type { App, View } from "../app.ts";
import { besideById, besideIds } from "../beside.ts";
import {
  axisStyle,
  Chart,
  currentInk,
  figureAxis,
  type Ink,
  insideZoom,
  intervalLine,
  type Option,
  ticked,
  tooltipStyle,
} from "../chart.ts";
import type { Cells, Figure } from "../data.ts";
import { usualCost, usualErrorOfSameHits } from "../defaults.ts";
import { figureElements, outlierWarning, settingElement } from "../describe.ts";
import { choose, fill, h } from "../dom.ts";
import { groupedChoices } from "../figures.ts";
import { measuredCells } from "../filter.ts";
import { axisTitle, costMetrics, errorMetrics, intervalOf, type Metric, metricById, metricTitle } from "../metrics.ts";
import { counted, extent, significant } from "../numbers.ts";
import { filling, lineElement, lineLook, markOf } from "../palette.ts";
import { figureScale, linearTicks, logRange, logTicks, tickText } from "../scales.ts";
import { type Abscissa, abscissas, type Line, type LinePoint, lines, mixesViews, sweptTitle } from "../series.ts";
import { usualErrorsOf } from "../truth.ts";
import { besideTable } from "./beside_table.ts";

const maxLines = 150;
const maxLinesWithIntervals = 40;
const maxNamedLines = 40;
/** Of an axis, each with its number below the chart. */
const maxNamedValues = 10;

interface Swept {
  id: string;
  title: string;
  /** Null for words: those stand in the table alone. */
  abscissa: Abscissa | null;
}

/** Numbers that a chart can stand over, and words whose values can stand beside each other. */
function sweptOf(figures: readonly Figure[], cells: Cells, measured: readonly number[]): Swept[] {
  const numbers = abscissas(figures, cells).map((abscissa) => ({ id: abscissa.id, title: abscissa.label, abscissa }));
  const words = besideIds(cells, measured).filter((id) => !numbers.some((number) => number.id === id));
  return [...numbers, ...words.map((id) => ({ id, title: sweptTitle(id.slice(id.indexOf(".") + 1)), abscissa: null }))];
}

export function axesView(app: App): View {
  const { cells } = app.run();
  const errors = errorMetrics(app.data.figures, cells);
  const costs = costMetrics(app.data.figures, cells);
  const all = sweptOf(app.data.figures, cells, measuredCells(cells, [...cells.id.keys()]));
  const x = choose(
    "Over",
    all.map(({ id, title }) => ({ value: id, label: title })),
    "",
    (value) => app.update({ x: value }),
  );
  const cost = choose("Cost", groupedChoices(costs, metricTitle), "", (value) => app.update({ cost: value }));
  const error = choose("Error", groupedChoices(errors, metricTitle), "", (value) => app.update({ error: value }));
  const pin = (data: unknown) => {
    const cell = (data as { point?: LinePoint } | null)?.point?.cells[0];
    if (cell !== undefined) app.update({ pin: app.run().cells.id[cell]! });
  };
  const costChart = new Chart("Cost over the chosen axis", pin);
  const errorChart = new Chart("Error over the chosen axis", pin);
  const charts = h("div", { class: "chart-pair" }, costChart.element, errorChart.element);
  const legend = h("ul", { class: "lines" });
  const note = h("p", { class: "note" });
  const table = h("div", {});
  const element = h(
    "section",
    { class: "view-axes" },
    h("div", { class: "controls" }, x.element, cost.element, error.element),
    charts,
    legend,
    note,
    table,
  );

  return {
    name: "axes",
    title: "Axes",
    element,
    refresh() {
      const swept = all.find(({ id }) => id === app.state.x) ?? all[0];
      const costMetric = metricById(costs, app.state.cost, ...usualCost);
      if (swept === undefined || costMetric === null || errors.length === 0) {
        fill(note, "Nothing was swept in this run.");
        charts.hidden = true;
        return;
      }
      const beside = besideById(cells, app.measured(), swept.id);
      const usual = beside?.sameHits ? usualErrorOfSameHits : usualErrorsOf(app.run());
      const errorMetric = metricById(errors, app.state.error, ...usual)!;
      x.select.value = swept.id;
      cost.select.value = costMetric.id;
      error.select.value = errorMetric.id;
      charts.hidden = swept.abscissa === null;
      fill(note);
      fill(legend);
      if (swept.abscissa !== null) {
        const found = lines(cells, app.measured(), swept.abscissa, costMetric, errorMetric);
        const drawn = found.slice(0, maxLines);
        const { abscissa } = swept;
        costChart.show(() => lineOption(app, drawn, abscissa, costMetric, (point) => point.cost));
        errorChart.show(() => lineOption(app, drawn, abscissa, errorMetric, (point) => point.error));
        fill(legend, ...legendItems(app, drawn));
        fill(note, ...notes(app, found, swept.abscissa).map((text) => h("span", {}, text)));
      } else if (beside === null) {
        fill(note, "The filter leaves no two cells that differ in nothing else.");
      }
      fill(table, beside === null ? null : besideTable(app, beside, swept.title, costMetric, errorMetric));
    },
  };
}

/** Which line is whose, where colour and marker of the technique do not tell. */
function legendItems(app: App, drawn: readonly Line[]): HTMLElement[] {
  const several = new Set(drawn.filter((line) => line.ofTechnique > 0).map((line) => line.technique));
  const named = drawn.filter((line) => several.has(line.technique)).sort(byTechnique);
  const items = named
    .slice(0, maxNamedLines)
    .map((line) =>
      h(
        "li",
        { attrs: { "data-line": line.name } },
        lineElement(app.mark(line.technique), app.theme, lineLook(line.ofTechnique)),
        line.name,
      ),
    );
  const rest = named.length - items.length;
  return rest > 0 ? [...items, h("li", { class: "muted" }, `and ${rest} more: hover over them`)] : items;
}

const byTechnique = (a: Line, b: Line) =>
  a.technique === b.technique ? a.ofTechnique - b.ofTechnique : a.technique < b.technique ? -1 : 1;

function notes(app: App, found: Line[], x: Abscissa): string[] {
  const texts: string[] = [];
  if (found.length > maxLines)
    texts.push(`Showing ${maxLines} of ${counted(found.length, "line")}: filter to see the others.`);
  if (found.some((line) => line.points.some((point) => point.cells.length > 1))) {
    texts.push("Points of several cells are means: geometric of the cost, arithmetic of the error.");
  }
  if (
    found.some((line) => line.points.some((point) => point.cells.length === 1)) &&
    found.length <= maxLinesWithIntervals
  )
    texts.push("Bars: the 95 % interval of a single cell's time; means have none.");
  if (mixesViews(app.run().cells, found, x)) {
    texts.push(
      "Along a line other axes change too, and a slope may be theirs: filter for one height map or projection to compare like with like.",
    );
  }
  return texts;
}

function lineOption(
  app: App,
  all: Line[],
  x: Abscissa,
  metric: Metric,
  of: (point: LinePoint) => number | null,
): Option {
  const ink = currentInk();
  const points = all.flatMap((line) => line.points);
  const withIntervals = all.length <= maxLinesWithIntervals;
  const ends = withIntervals ? points.flatMap((point) => intervalOfPoint(app, point, metric) ?? []) : [];
  const y = figureScale([...points.map(of).filter((value): value is number => value !== null), ...ends], metric.better);
  const shownX = points.filter((point) => of(point) !== null).map((point) => point.x);
  const xRange = logRange(shownX);
  const [leastX, greatestX] = extent(shownX);
  const span = greatestX - leastX || 1;
  const room = 0.04;
  return {
    title: {
      text: axisTitle(metric),
      left: 0,
      top: 0,
      textStyle: { color: ink.text, fontFamily: ink.font, fontSize: ink.size * 1.1, fontWeight: 600 },
    },
    grid: { left: ink.size * 5, right: ink.size * 2, top: ink.size * 3, bottom: ink.size * 4.2 },
    xAxis: ticked(
      {
        ...axisStyle(ink, x.label),
        type: x.scale === "log" ? "log" : "value",
        nameGap: ink.size * 2.3,
        min: x.scale === "log" ? xRange.min : leastX - room * span,
        max: x.scale === "log" ? xRange.max : greatestX + room * span,
      },
      (from, to) => abscissaTicks(x, shownX, from, to),
      tickText,
    ),
    yAxis: figureAxis(ink, "", y, true),
    dataZoom: insideZoom(0),
    tooltip: {
      ...tooltipStyle(ink),
      formatter: (parameters: { data?: { line: Line; point: LinePoint } }) =>
        parameters.data ? pointTooltip(app, parameters.data.line, parameters.data.point, x, metric, of) : "",
    },
    series: all.flatMap((line) => [
      lineSeries(app, ink, line, y.place, of),
      ...(withIntervals ? [lineIntervals(app, line, y.place, metric)] : []),
    ]),
  };
}

/** The values themselves where they are few, else round numbers. */
function abscissaTicks(x: Abscissa, values: readonly number[], from: number, to: number): number[] {
  const distinct = [...new Set(values)].filter((value) => value >= from && value <= to);
  if (x.id !== "steps" && distinct.length >= 2 && distinct.length <= maxNamedValues) return distinct;
  return x.scale === "log" ? logTicks(from, to) : linearTicks(from, to);
}

function lineSeries(
  app: App,
  ink: Ink,
  line: Line,
  place: (value: number) => number,
  of: (point: LinePoint) => number | null,
): object {
  const mark = markOf(app.mark(line.technique), app.theme);
  const look = lineLook(line.ofTechnique);
  const width = 1.6;
  const color = filling(mark.colour, look.filled, ink.panel);
  const border = look.filled === "full" ? ink.panel : mark.colour;
  const pinned = app.pinned();
  return {
    type: "line",
    name: line.name,
    data: line.points
      .filter((point) => of(point) !== null)
      .map((point) => ({
        value: [point.x, place(of(point)!)],
        line,
        point,
        ...(point.cells.includes(pinned)
          ? { symbolSize: ink.size * 1.3, itemStyle: { color, borderColor: ink.accent, borderWidth: 2.5 } }
          : {}),
      })),
    symbol: mark.symbol,
    symbolSize: ink.size * 0.72,
    showAllSymbol: true,
    lineStyle: {
      color: mark.colour,
      width,
      opacity: 0.75,
      type: look.dash.length > 0 ? look.dash.map((length) => length * width) : "solid",
    },
    itemStyle: { color, borderColor: border, borderWidth: 1 },
    emphasis: { focus: "series", lineStyle: { width: 2.6 } },
    triggerLineEvent: false,
  };
}

/** Of a point that is one cell; of a mean nothing tells how sure it is. */
function intervalOfPoint(app: App, { cells }: LinePoint, metric: Metric): [number, number] | null {
  return cells.length === 1 ? intervalOf(metric, app.run().cells, cells[0]!) : null;
}

function lineIntervals(app: App, line: Line, place: (value: number) => number, metric: Metric): object {
  const bars = line.points.flatMap((point) => {
    const interval = intervalOfPoint(app, point, metric);
    return interval === null ? [] : [...interval.map((end) => [point.x, place(end)]), [null, null]];
  });
  return intervalLine(bars, markOf(app.mark(line.technique), app.theme).colour);
}

function pointTooltip(
  app: App,
  line: Line,
  point: LinePoint,
  x: Abscissa,
  metric: Metric,
  of: (point: LinePoint) => number | null,
): HTMLElement {
  const { cells } = app.run();
  const only = point.cells.length === 1 ? point.cells[0]! : null;
  return h(
    "div",
    { class: "tip" },
    settingElement(app, line.name, line.technique),
    h(
      "dl",
      {},
      h("dt", {}, x.label),
      h("dd", {}, significant(point.x)),
      ...figureElements(cells, metric, of(point), only),
    ),
    only === null ? null : outlierWarning(cells, only),
    h(
      "div",
      { class: "muted" },
      point.cells.length > 1
        ? `mean of ${counted(point.cells.length, "cell")}; click to pin the first`
        : "click to pin",
    ),
  );
}
