// A cell in elements that several views share.

import type { App } from "./app.ts";
import { settingOf, techniqueOf, viewLabel } from "./data.ts";
import { h } from "./dom.ts";
import { hitsWithinLimit, type Metric, metricText } from "./metrics.ts";
import { markElement } from "./palette.ts";

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

export function cellTooltip(app: App, cell: number, metrics: (Metric | null)[]): HTMLElement {
  const { cells } = app.run();
  const id = cells.id[cell]!;
  const rows = metrics.filter((metric): metric is Metric => metric !== null);
  return h(
    "div",
    { class: "tip" },
    settingElement(app, settingOf(id), techniqueOf(cells, cell)),
    h("div", { class: "muted" }, viewLabel(cells, cell)),
    h(
      "dl",
      {},
      ...rows.flatMap((metric) => [h("dt", {}, metric.label), h("dd", {}, metricText(metric, metric.of(cells, cell)))]),
    ),
    hitsWithinLimit(cells, cell)
      ? null
      : h("div", { class: "warning" }, "Missed and false hits above 0.5 % of the footprint: its errors do not count."),
    h("div", { class: "muted" }, cell === app.pinned() ? "pinned" : "click to pin"),
  );
}
