// A cell in elements that several views share.

import type { App } from "./app.ts";
import { type Cells, reasonOf, settingOf, statusOf, techniqueOf, viewLabel, viewOf } from "./data.ts";
import { usualCost } from "./defaults.ts";
import { h } from "./dom.ts";
import {
  costMetrics,
  errorMetrics,
  hitsWithinLimit,
  intervalOf,
  intervalText,
  manyOutliers,
  type Metric,
  metricById,
  metricText,
} from "./metrics.ts";
import { markElement } from "./palette.ts";
import { usualErrorsOf } from "./truth.ts";

/** Technique with its mark, and its parameters. */
export function settingElement(app: App, setting: string, technique: string): HTMLElement {
  const rest = setting.startsWith(technique) ? setting.slice(technique.length).trim() : setting;
  return h(
    "span",
    { class: "setting" },
    markElement(app.mark(technique), app.theme),
    h("b", {}, technique),
    rest === "" ? null : h("span", { class: "parameters" }, rest),
  );
}

/** The chosen cost and error; null where the run has none. */
export function shownMetrics(app: App): { cost: Metric | null; error: Metric | null } {
  const { cells } = app.run();
  return {
    cost: metricById(costMetrics(app.data.figures, cells), app.state.cost, ...usualCost),
    error: metricById(errorMetrics(app.data.figures, cells), app.state.error, ...usualErrorsOf(app.run())),
  };
}

/** A cell in a line: setting, view, and its figures or what became of it. */
export function cellSummary(app: App, cell: number): HTMLElement[] {
  const { cells } = app.run();
  const id = cells.id[cell]!;
  const { cost, error } = shownMetrics(app);
  const figures = [cost, error].flatMap((metric) => {
    const value = metric === null ? null : metric.of(cells, cell);
    if (metric === null || value === null) return [];
    const interval = intervalOf(metric, cells, cell);
    const title =
      interval === null ? metric.label : `${metric.label}; 95 % interval: ${intervalText(metric, interval)}`;
    return [h("span", { title }, h("b", { class: "figure" }, metricText(metric, value)))];
  });
  const outcome = statusElement(cells, cell);
  return [
    settingElement(app, settingOf(id), techniqueOf(cells, cell)),
    h("span", { class: "muted", title: viewOf(id) }, viewLabel(cells, cell)),
    ...figures,
    ...(outcome === null ? [] : [outcome]),
  ];
}

/** A figure's name and value, with its interval below where it has one: for a list of definitions. */
export function figureElements(cells: Cells, metric: Metric, value: number | null, cell: number | null): HTMLElement[] {
  const interval = cell === null ? null : intervalOf(metric, cells, cell);
  return [
    h("dt", {}, metric.label),
    h("dd", {}, metricText(metric, value)),
    ...(interval === null
      ? []
      : [h("dt", { class: "muted" }, "95 % interval"), h("dd", { class: "interval" }, intervalText(metric, interval))]),
  ];
}

/** That a cell has too many outliers; null where it has not. */
export function outlierWarning(cells: Cells, cell: number): HTMLElement | null {
  const many = manyOutliers(cells, cell);
  if (many === null) return null;
  const { outliers, samples } = many;
  return warning(`${outliers} of ${samples} samples are outliers: something disturbed its times.`);
}

/** Of a warning, so that nobody needs to see colours. */
export const sign = () => h("span", { class: "sign" }, "⚠ ");

/** What spoils a figure or an answer. */
export function warning(...content: (Node | string)[]): HTMLElement {
  return h("p", { class: "warning" }, sign(), ...content);
}

/** What is worth knowing, with nothing wrong about it. */
export function fact(...content: (Node | string)[]): HTMLElement {
  return h("p", { class: "fact" }, ...content);
}

export function factList(texts: readonly string[]): HTMLElement | null {
  return texts.length === 0 ? null : h("ul", { class: "fact" }, ...texts.map((text) => h("li", {}, text)));
}

/** What became of a cell that was not measured, and why; null of one that was. */
export function statusElement(cells: Cells, cell: number): HTMLElement | null {
  const status = statusOf(cells, cell);
  if (status === "ok") return null;
  return h(
    "span",
    { class: "outcome" },
    h("span", { class: `status ${status}` }, status),
    h("span", { class: "reason" }, reasonOf(cells, cell) || "no reason given"),
  );
}

export function cellTooltip(app: App, cell: number, metrics: (Metric | null)[]): HTMLElement {
  const { cells } = app.run();
  const id = cells.id[cell]!;
  const rows = metrics.filter((metric): metric is Metric => metric !== null);
  return h(
    "div",
    { class: "tip" },
    settingElement(app, settingOf(id), techniqueOf(cells, cell)),
    h("div", { class: "muted" }, viewLabel(cells, cell)),
    h("dl", {}, ...rows.flatMap((metric) => figureElements(cells, metric, metric.of(cells, cell), cell))),
    hitsWithinLimit(cells, cell)
      ? null
      : warning("Missed and false hits above 0.5 % of the footprint: its errors do not count."),
    outlierWarning(cells, cell),
    h("div", { class: "muted" }, cell === app.pinned() ? "pinned" : "click to pin"),
  );
}
