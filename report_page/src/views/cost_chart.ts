// The scatters of error against cost, one per panel, on shared scales.

import type { App } from "../app.ts";
import { currentInk, figureAxis, type Ink, insideZoom, intervalLine, type Option, tooltipStyle } from "../chart.ts";
import { settingOf } from "../data.ts";
import { cellTooltip, settingElement } from "../describe.ts";
import { h } from "../dom.ts";
import { axisTitle, intervalOf, type Metric, metricText } from "../metrics.ts";
import { markOf } from "../palette.ts";
import { type FigureScale, figureScale } from "../scales.ts";

/** One point of the scatter: a cell, or a setting over several. */
export interface Mark {
  /** The cell that a click pins: the setting's first. */
  cell: number;
  technique: string;
  cost: number;
  error: number;
  counts: boolean;
  setting: string | null;
}

export interface Panel {
  title: string;
  marks: Mark[];
  front: number[];
  views: number;
}

/** More are drawn smaller, and without their intervals. */
export const manyMarks = 1500;

/** Pixels that a panel needs across. */
const minPanelWidth = 230;

export function panelLayout(count: number, chartWidth: number): { columns: number; rows: number } {
  const wanted = count <= 3 ? Math.max(1, count) : count === 4 ? 2 : count <= 6 ? 3 : 4;
  const columns = Math.min(wanted, Math.max(1, Math.floor(chartWidth / minPanelWidth)));
  return { columns, rows: Math.ceil(count / columns) };
}

interface PlotDatum {
  value: [number, number];
  cell: number;
  mark: Mark;
}

export function chartOption(app: App, panels: Panel[], cost: Metric, error: Metric, chartWidth: number): Option {
  const ink = currentInk();
  const { columns, rows } = panelLayout(panels.length, chartWidth);
  const marks = panels.flatMap((panel) => panel.marks);
  const many = marks.length > manyMarks;
  const ends = (metric: Metric) => (many ? [] : marks.flatMap((mark) => intervalOfMark(app, mark, metric) ?? []));
  const x = figureScale([...marks.map((mark) => mark.cost), ...ends(cost)], cost.better);
  const y = figureScale([...marks.map((mark) => mark.error), ...ends(error)], error.better);
  const grids = panels.map((panel, at) => panelGrid(ink, panel, at, columns, rows, chartWidth));
  const isLeft = (at: number) => at % columns === 0;
  const isLowest = (at: number) => at + columns >= panels.length;
  return {
    title: grids.map((grid) => grid.title),
    grid: grids.map((grid) => grid.grid),
    xAxis: panels.map((_, at) => ({
      ...figureAxis(ink, isLowest(at) ? axisTitle(cost) : "", x, isLowest(at)),
      nameGap: ink.size * 2.1,
      gridIndex: at,
    })),
    yAxis: panels.map((_, at) => ({
      ...figureAxis(ink, isLeft(at) ? axisTitle(error, "\n") : "", y, isLeft(at)),
      nameGap: ink.size * 3.9,
      gridIndex: at,
    })),
    dataZoom: panels.flatMap((_, at) => insideZoom(at)),
    tooltip: {
      ...tooltipStyle(ink),
      formatter: (parameters: { data?: PlotDatum }) =>
        parameters.data?.mark ? markTooltip(app, parameters.data.mark, cost, error) : "",
    },
    series: panels.flatMap((panel, at) => [
      ...panelSeries(app, ink, panel, at, x, y, many),
      ...(many ? [] : intervalSeries(app, panel, at, x, y, cost, error)),
    ]),
  };
}

/** Panels share their scales, and only those at the left and at the bottom have labels. Per cent of the chart. */
function panelGrid(
  ink: Ink,
  panel: Panel,
  at: number,
  columns: number,
  rows: number,
  chartWidth: number,
): { title: object; grid: object } {
  const left = (100 * 7.6 * ink.size) / chartWidth;
  const bottom = 12 / rows;
  const width = (100 - left - 1) / columns;
  const height = (100 - bottom - 1) / rows;
  const x = left + (at % columns) * width;
  const y = 1 + Math.floor(at / columns) * height;
  const titleRoom = panel.title === "" ? 1 : 9 / rows;
  return {
    title: {
      text: panel.title,
      left: `${x}%`,
      top: `${y + 0.5}%`,
      padding: [5, 0],
      textStyle: {
        color: ink.text,
        fontFamily: ink.font,
        fontSize: ink.size * 1.05,
        fontWeight: 600,
        overflow: "truncate",
        width: (chartWidth * (width - 1)) / 100,
      },
    },
    grid: {
      left: `${x}%`,
      top: `${y + titleRoom}%`,
      width: `${width - 1.8}%`,
      height: `${height - titleRoom - 2}%`,
      containLabel: false,
    },
  };
}

function panelSeries(
  app: App,
  ink: Ink,
  panel: Panel,
  at: number,
  x: FigureScale,
  y: FigureScale,
  many: boolean,
): object[] {
  const place = (mark: Mark): [number, number] => [x.place(mark.cost), y.place(mark.error)];
  const byTechnique = new Map<string, PlotDatum[]>();
  for (const mark of panel.marks) {
    const datum = {
      value: place(mark),
      cell: mark.cell,
      mark,
      ...(mark.counts ? {} : { itemStyle: { opacity: 0.28 } }),
    };
    const data = byTechnique.get(mark.technique);
    if (data) data.push(datum);
    else byTechnique.set(mark.technique, [datum]);
  }
  const scatters = [...byTechnique].map(([technique, data]) => {
    const mark = markOf(app.mark(technique), app.theme);
    return {
      type: "scatter",
      name: technique,
      xAxisIndex: at,
      yAxisIndex: at,
      data,
      symbol: mark.symbol,
      symbolSize: many ? ink.size * 0.5 : ink.size * 0.85,
      itemStyle: { color: mark.colour, opacity: many ? 0.65 : 0.92, borderColor: ink.panel, borderWidth: many ? 0 : 1 },
      emphasis: { scale: 1.6 },
      progressive: 0,
      z: 3,
    };
  });
  const front = {
    type: "line",
    xAxisIndex: at,
    yAxisIndex: at,
    data: panel.front.map((mark) => place(panel.marks[mark]!)),
    step: "end",
    symbol: "none",
    silent: true,
    lineStyle: { color: ink.text, width: 1.5, opacity: many ? 0.9 : 0.55 },
    // Under few points, over a cloud of them.
    z: many ? 4 : 2,
  };
  return [front, ...scatters, pinRing(app, ink, panel, at, place)];
}

/** Of a mark that is one cell; of a mean nothing tells how sure it is. */
function intervalOfMark(app: App, mark: Mark, metric: Metric): [number, number] | null {
  return mark.setting === null ? intervalOf(metric, app.run().cells, mark.cell) : null;
}

/** The 95 % intervals of the cells' figures, along either axis: one line for each technique, with gaps. */
function intervalSeries(
  app: App,
  panel: Panel,
  at: number,
  x: FigureScale,
  y: FigureScale,
  cost: Metric,
  error: Metric,
): object[] {
  const bars = new Map<string, (number | null)[][]>();
  for (const mark of panel.marks) {
    const points = bars.get(mark.technique) ?? [];
    bars.set(mark.technique, points);
    const along = intervalOfMark(app, mark, cost)?.map((end) => [x.place(end), y.place(mark.error)]);
    const across = intervalOfMark(app, mark, error)?.map((end) => [x.place(mark.cost), y.place(end)]);
    for (const ends of [along, across]) if (ends !== undefined) points.push(...ends, [null, null]);
  }
  return [...bars]
    .filter(([, points]) => points.length > 0)
    .map(([technique, data]) =>
      intervalLine(data, markOf(app.mark(technique), app.theme).colour, { xAxisIndex: at, yAxisIndex: at }),
    );
}

function pinRing(app: App, ink: Ink, panel: Panel, at: number, place: (mark: Mark) => [number, number]): object {
  const pinned = app.pinned();
  const setting = pinned < 0 ? "" : settingOf(app.run().cells.id[pinned]!);
  const marks = panel.marks.filter((mark) => (mark.setting === null ? mark.cell === pinned : mark.setting === setting));
  return {
    type: "scatter",
    xAxisIndex: at,
    yAxisIndex: at,
    data: marks.map(place),
    symbol: "circle",
    symbolSize: ink.size * 1.9,
    itemStyle: { color: "transparent", borderColor: ink.accent, borderWidth: 2.5 },
    silent: true,
    z: 5,
  };
}

function markTooltip(app: App, mark: Mark, cost: Metric, error: Metric): HTMLElement {
  if (mark.setting === null) return cellTooltip(app, mark.cell, [cost, error]);
  return h(
    "div",
    { class: "tip" },
    settingElement(app, mark.setting, mark.technique),
    h(
      "dl",
      {},
      h("dt", {}, cost.label),
      h("dd", {}, metricText(cost, mark.cost)),
      h("dt", {}, error.label),
      h("dd", {}, metricText(error, mark.error)),
    ),
    h("div", { class: "muted" }, "click to pin its first cell"),
  );
}
