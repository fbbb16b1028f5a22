// Quality against cost: a scatter with the Pareto front.

import type { App, View } from "../app.ts";
import { Chart } from "../chart.ts";
import {
  axisColumn,
  axisValueText,
  type Cells,
  settingOf,
  sortedValues,
  techniqueOf,
  textOf,
  valueText,
  variedAxes,
  viewLabel,
  viewOf,
} from "../data.ts";
import { usualCost } from "../defaults.ts";
import { settingElement, sign, warning } from "../describe.ts";
import { choose, fill, h, segments } from "../dom.ts";
import { groupedChoices } from "../figures.ts";
import { reasonGroups } from "../filter.ts";
import {
  costMetrics,
  errorMetrics,
  hitsWithinLimit,
  intervalOf,
  isTime,
  manyOutliers,
  type Metric,
  metricById,
  metricText,
  metricTitle,
} from "../metrics.ts";
import { counted } from "../numbers.ts";
import { paretoFront } from "../pareto.ts";
import { settingPoints } from "../settings.ts";
import type { PointsMode } from "../state.ts";
import { truthNote, usualErrorsOf } from "../truth.ts";
import { chartOption, manyMarks, type Mark, type Panel, panelLayout } from "./cost_chart.ts";

const maxPanels = 12;
/** So many views are told apart by panels of their own, unless something else is chosen. */
const maxViewsByDefault = 6;

function facetOf(app: App): string {
  const { cells } = app.run();
  const { facet } = app.state;
  if (facet === "none" || facet === "view" || axisColumn(cells, facet) !== undefined) return facet;
  const views = new Set(app.measured().map((cell) => viewOf(cells.id[cell]!)));
  if (views.size <= 1) return "none";
  if (views.size <= maxViewsByDefault) return "view";
  return ["base", "curvature", "view_angle"].find((axis) => (axisColumn(cells, axis)?.values.length ?? 0) > 1) ?? "none";
}

/** The axes by which panels differ: what a base costs says little without how far it bends. */
function panelAxes(cells: Cells, facet: string): string[] {
  const varied = variedAxes(cells);
  return facet === "base" && varied.includes("curvature") ? ["base", "curvature"] : [facet];
}

/** The cells of each panel by its title, in the order of the axis' values. */
function panelCells(app: App, facet: string): [string, number[]][] {
  const { cells } = app.run();
  if (facet === "none") return [["", [...app.measured()]]];
  const axes = panelAxes(cells, facet);
  const orders = facet === "view" ? [] : axes.map((axis) => sortedValues(cells.axes[axis]!).map(valueText));
  const groups = new Map<string, { places: number[]; members: number[] }>();
  for (const cell of app.measured()) {
    const values = axes.map((axis) => textOf(cells.axes[axis], cell));
    const texts = values.flatMap((value, at) => (value === null ? [] : [axisValueText(axes[at]!, value)]));
    const title = facet === "view" ? viewLabel(cells, cell) : texts.join(" · ") || "–";
    const group = groups.get(title);
    if (group) group.members.push(cell);
    else {
      // A plane, which has no curvature, before what has one.
      const places = orders.map((order, at) => order.indexOf(values[at] ?? ""));
      groups.set(title, { places: facet === "view" ? [] : [texts.length, ...places], members: [cell] });
    }
  }
  const before = (a: number[], b: number[]) => a.map((place, at) => place - b[at]!).find((by) => by !== 0) ?? 0;
  return [...groups]
    .sort(([, a], [, b]) => before(a.places, b.places))
    .map(([title, { members }]) => [title, members]);
}

function cellMarks(cells: Cells, members: readonly number[], cost: Metric, error: Metric): Mark[] {
  const marks: Mark[] = [];
  for (const cell of members) {
    const x = cost.of(cells, cell);
    const y = error.of(cells, cell);
    if (x === null || y === null) continue;
    marks.push({
      cell,
      technique: techniqueOf(cells, cell),
      cost: x,
      error: y,
      counts: hitsWithinLimit(cells, cell),
      setting: null,
    });
  }
  return marks;
}

function makePanel(app: App, title: string, members: readonly number[], cost: Metric, error: Metric): Panel {
  const { cells } = app.run();
  const { points } = app.state;
  const views = new Set(members.map((cell) => viewOf(cells.id[cell]!))).size;
  const marks =
    points === "cells"
      ? cellMarks(cells, members, cost, error)
      : settingPoints(cells, members, cost, error, points).points.map((point) => ({ ...point, cell: point.cells[0]! }));
  const counted = marks.filter((mark) => mark.counts);
  const front = paretoFront(counted, error.better).map((at) => marks.indexOf(counted[at]!));
  return { title, marks, front, views };
}

export function costView(app: App): View {
  const { cells } = app.run();
  const errors = errorMetrics(app.data.figures, cells);
  const costs = costMetrics(app.data.figures, cells);
  const error = choose("Error", groupedChoices(errors, metricTitle), "", (value) => app.update({ error: value }));
  const cost = choose("Cost", groupedChoices(costs, metricTitle), "", (value) => app.update({ cost: value }));
  const facets = [
    { value: "none", label: "one for all" },
    { value: "view", label: "one per view" },
    ...variedAxes(cells).map((axis) => ({ value: axis, label: `by ${axis.replaceAll("_", " ")}` })),
  ];
  const facet = choose("Panels", facets, "none", (value) => app.update({ facet: value }));
  const mode = segments(
    "Points",
    [
      { value: "cells", label: "Each cell" },
      { value: "mean", label: "Mean over views" },
      { value: "worst", label: "Worst view" },
    ],
    (value) => app.update({ points: value as PointsMode }),
  );
  const chart = new Chart("Scatter of error against cost with the Pareto front", (data) => {
    const cell = (data as { cell?: number } | null)?.cell;
    if (cell !== undefined) app.update({ pin: app.run().cells.id[cell]! });
  });
  const note = h("p", { class: "note" });
  const disturbed = h("div", { class: "disturbed" });
  const front = h("div", { class: "front" });
  const element = h(
    "section",
    { class: "view-cost" },
    troubles(app),
    disturbed,
    h("div", { class: "controls" }, error.element, cost.element, facet.element, mode.element),
    chart.element,
    note,
    front,
  );

  return {
    name: "cost",
    title: "Quality against cost",
    element,
    refresh() {
      const errorMetric = metricById(errors, app.state.error, ...usualErrorsOf(app.run()));
      const costMetric = metricById(costs, app.state.cost, ...usualCost);
      mode.set(app.state.points);
      facet.select.value = facetOf(app);
      if (errorMetric === null || costMetric === null) {
        fill(note, "No cell of this run was measured.");
        chart.element.hidden = true;
        return;
      }
      error.select.value = errorMetric.id;
      cost.select.value = costMetric.id;
      fill(disturbed, disturbedWarning(app, costMetric));
      const all = panelCells(app, facetOf(app));
      const panels = all
        .slice(0, maxPanels)
        .map(([title, members]) => makePanel(app, title, members, costMetric, errorMetric));
      chart.element.hidden = panels.length === 0;
      chart.show((width) => {
        chart.element.style.setProperty("--rows", String(panelLayout(panels.length, width).rows));
        return chartOption(app, panels, costMetric, errorMetric, width);
      });
      fill(note, ...noteTexts(app, panels, all.length, costMetric, errorMetric).map((text) => h("span", {}, text)));
      fill(front, panels.length === 1 ? frontTable(app, panels[0]!, costMetric, errorMetric) : null);
    },
  };
}

/** How many of the cells shown have too many outliers. */
function disturbedWarning(app: App, cost: Metric): HTMLElement | null {
  const { cells } = app.run();
  const many = app.measured().filter((cell) => manyOutliers(cells, cell) !== null).length;
  if (many === 0 || !isTime(cost)) return null;
  const all = counted(app.measured().length, "cell");
  return warning(`More than 10 % of the samples are outliers in ${many} of ${all}: something disturbed their times.`);
}

/** What became of cells that were not measured. */
function troubles(app: App): HTMLElement | null {
  const groups = reasonGroups(app.run().cells);
  if (groups.length === 0) return null;
  const count = groups.reduce((sum, group) => sum + group.cells.length, 0);
  const failed = groups.some((group) => group.status !== "skipped");
  return h(
    "details",
    { class: failed ? "warning" : "fact" },
    h("summary", {}, failed ? sign() : null, `${counted(count, "cell")} ${count === 1 ? "was" : "were"} not measured`),
    h(
      "ul",
      {},
      ...groups
        .slice(0, 20)
        .map((group) =>
          h(
            "li",
            {},
            h("b", {}, `${group.cells.length} ${group.status}`),
            ": ",
            h("span", { class: "reason" }, group.reason),
          ),
        ),
    ),
  );
}

function noteTexts(app: App, panels: Panel[], wanted: number, cost: Metric, error: Metric): string[] {
  const texts: string[] = [];
  if (panels.length === 0) texts.push("The filter leaves no measured cell.");
  if (wanted > panels.length) texts.push(`Showing ${panels.length} of ${wanted} panels: filter to see the others.`);
  if (app.state.points === "cells" && panels.some((panel) => panel.views > 1)) {
    texts.push(
      "Panels here mix several views, and easy ones lead the front: filter, use one panel per view, or take the mean over views.",
    );
  }
  const hidden = panels.reduce((sum, panel) => sum + panel.marks.filter((mark) => !mark.counts).length, 0);
  if (hidden > 0) {
    const where = app.state.points === "cells" ? "" : " in one of their views";
    texts.push(
      `Faint: ${hidden} with missed and false hits above 0.5 % of the footprint${where}, whose errors do not count; they are kept off the front.`,
    );
  }
  const { cells } = app.run();
  const shown = panels.flatMap((panel) => panel.marks);
  if (shown.length > 0 && app.state.points === "cells" && shown.some(({ cell }) => intervalOf(cost, cells, cell))) {
    texts.push(
      shown.length > manyMarks
        ? `Times have bars for their 95 % intervals where ${manyMarks.toLocaleString("en")} points or fewer are shown.`
        : "Bars: the 95 % interval of the time.",
    );
  }
  const against = truthNote(app.run(), error);
  if (panels.length > 0 && against !== null) texts.push(against);
  if (panels.length > 0) {
    const corner = error.better === "lower" ? "Lower" : "Upper";
    texts.push(`${corner} left is better. The line is the Pareto front: nothing is both cheaper and better.`);
  }
  return texts;
}

/** The front in figures. */
function frontTable(app: App, panel: Panel, cost: Metric, error: Metric): HTMLElement | null {
  if (panel.front.length === 0) return null;
  return h(
    "table",
    { class: "figures" },
    h("caption", {}, "The Pareto front"),
    h(
      "thead",
      {},
      h(
        "tr",
        {},
        h("th", {}, "Setting"),
        h("th", { class: "number" }, metricTitle(cost)),
        h("th", { class: "number" }, metricTitle(error)),
      ),
    ),
    h(
      "tbody",
      {},
      ...panel.front.slice(0, 40).map((at) => {
        const mark = panel.marks[at]!;
        const id = app.run().cells.id[mark.cell]!;
        return h(
          "tr",
          { class: "pinnable", on: { click: () => app.update({ pin: id }) } },
          h("td", {}, settingElement(app, settingOf(id), mark.technique)),
          h("td", { class: "number" }, metricText(cost, mark.cost)),
          h("td", { class: "number" }, metricText(error, mark.error)),
        );
      }),
    ),
  );
}
