// Cost and error of an axis' or a parameter's values, side by side.

import type { App } from "../app.ts";
import { type Beside, type BesideRow } from "../beside.ts";
import { viewLabel } from "../data.ts";
import { settingElement } from "../describe.ts";
import { h } from "../dom.ts";
import { advantage, bareText, type Metric, metricTitle } from "../metrics.ts";
import { arithmeticMean, counted, geometricMean, significant } from "../numbers.ts";
import { lineName } from "../series.ts";

const maxRows = 100;
/** With more values settings take several lines. */
const maxWithWideSettings = 3;

/** Of the first value in the row that was measured: what the others' costs are multiples of. */
function ratioTo(app: App, metric: Metric, from: number, cell: number): number | null {
  const { cells } = app.run();
  if (from < 0 || cell < 0) return null;
  const [base, value] = [metric.of(cells, from), metric.of(cells, cell)];
  return base === null || value === null || base <= 0 ? null : value / base;
}

const timesText = (ratio: number | null) => (ratio === null ? "–" : `× ${significant(ratio)}`);

function figureCells(app: App, row: BesideRow, cost: Metric, error: Metric): HTMLElement[] {
  const { cells } = app.run();
  const of = (metric: Metric, cell: number) => (cell < 0 ? null : metric.of(cells, cell));
  const errors = row.cells.map((cell) => of(error, cell));
  const known = errors.filter((value): value is number => value !== null);
  const isBest = (value: number | null) =>
    value !== null &&
    known.some((other) => other !== value) &&
    known.every((other) => advantage(error.better, value, other) >= 0);
  return row.cells.flatMap((cell, at) => {
    const pin = cell < 0 ? {} : { on: { click: () => app.update({ pin: cells.id[cell]! }) } };
    const number = (text: string, more = "") => h("td", { class: `number ${more}`, ...pin }, text);
    return [
      number(bareText(cost, of(cost, cell)), "first"),
      ...(at === 0 ? [] : [number(timesText(ratioTo(app, cost, row.cells[0]!, cell)))]),
      number(bareText(error, errors[at]!), isBest(errors[at]!) ? "best" : ""),
    ];
  });
}

function meanCells(app: App, beside: Beside, cost: Metric, error: Metric): HTMLElement[] {
  const { cells } = app.run();
  return beside.columns.flatMap((_, at) => {
    const ratios = beside.rows
      .map((row) => ratioTo(app, cost, row.cells[0]!, row.cells[at]!))
      .filter((ratio): ratio is number => ratio !== null);
    const errors = beside.rows
      .map((row) => (row.cells[at]! < 0 ? null : error.of(cells, row.cells[at]!)))
      .filter((value): value is number => value !== null);
    return [
      h("td", { class: "number first" }),
      ...(at === 0 ? [] : [h("td", { class: "number" }, timesText(ratios.length > 0 ? geometricMean(ratios) : null))]),
      h("td", { class: "number" }, bareText(error, errors.length > 0 ? arithmeticMean(errors) : null)),
    ];
  });
}

/** `title` names the axis or parameter. */
export function besideTable(app: App, beside: Beside, title: string, cost: Metric, error: Metric): HTMLElement {
  const { cells } = app.run();
  const first = (row: BesideRow) => row.cells.find((cell) => cell >= 0)!;
  const views = new Set(beside.rows.map((row) => viewLabel(cells, first(row), beside.names)));
  const heads = beside.columns.map((text, at) =>
    h("th", { class: "value-head first", attrs: { colspan: at === 0 ? 2 : 3, scope: "colgroup" } }, text),
  );
  return h(
    "div",
    { class: `beside${beside.columns.length > maxWithWideSettings ? " tight" : ""}` },
    h("h3", {}, `Values of ${title} beside each other`),
    h(
      "div",
      { class: "beside-scroll", attrs: { tabindex: 0, role: "region", "aria-label": `Values of ${title}` } },
      h(
        "table",
        { class: "figures" },
        h(
          "thead",
          {},
          h("tr", {}, h("th", {}), ...heads),
          h(
            "tr",
            {},
            h("th", {}, "Setting"),
            ...beside.columns.flatMap((_, at) => [
              h("th", { class: "number first" }, metricTitle(cost)),
              at === 0 ? null : h("th", { class: "number", title: `Cost over that of ${beside.columns[0]}` }, "cost"),
              h("th", { class: "number" }, metricTitle(error)),
            ]),
          ),
        ),
        h(
          "tbody",
          {},
          ...beside.rows
            .slice(0, maxRows)
            .map((row) =>
              h(
                "tr",
                { class: "pinnable" },
                h(
                  "td",
                  {},
                  settingElement(app, lineName(cells, first(row), beside.names), row.technique),
                  views.size > 1
                    ? h("div", { class: "muted small" }, viewLabel(cells, first(row), beside.names))
                    : null,
                ),
                ...figureCells(app, row, cost, error),
              ),
            ),
        ),
        beside.rows.length > 1
          ? h(
              "tfoot",
              {},
              h(
                "tr",
                {},
                h("td", {}, `Mean of ${counted(beside.rows.length, "row")}`),
                ...meanCells(app, beside, cost, error),
              ),
            )
          : null,
      ),
    ),
    h("p", { class: "note" }, ...notes(beside, error).map((text) => h("span", {}, text))),
  );
}

function notes(beside: Beside, error: Metric): string[] {
  const texts = [
    `Cells of a row differ in nothing else. Factors are of the cost over that of ${beside.columns[0]}; their mean is geometric, that of errors arithmetic. ${error.label}: ${error.better} is better, bold is the best of the row.`,
  ];
  if (beside.sameHits) {
    texts.push("The hits are the same at every value (their errors are equal): only what is made of them differs.");
  }
  if (beside.id.startsWith("axis.") && !beside.sameHits) {
    texts.push("The axis moves the hits of the truth, too: errors at its values are of different views.");
  }
  if (beside.rows.length > maxRows)
    texts.push(`Showing ${maxRows} of ${beside.rows.length} rows: filter to see the others.`);
  return texts;
}
