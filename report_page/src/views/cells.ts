// Every cell in a table that sorts and filters.

import type { App, View } from "../app.ts";
import { type Cells, hasFigure, numberOf, reasonOf, settingOf, statusOf, techniqueOf, viewOf } from "../data.ts";
import { settingElement } from "../describe.ts";
import { fill, h } from "../dom.ts";
import { counted, significant } from "../numbers.ts";
import { matches, parseQuery } from "../query.ts";
import { type Column, sortRows, Table } from "../table.ts";

interface FigureColumn {
  id: string;
  title: string;
  help: string;
  scale?: number;
}

/** What is shown unless other columns are chosen. Titles, in one word, are the names that bounds in the search use. */
const usual: FigureColumn[] = [
  { id: "time.draw.median_ms", title: "ms", help: "Draw time, median, ms" },
  { id: "time.draw.mad_ms", title: "± MAD", help: "Median absolute deviation of the draw's samples, ms" },
  { id: "time.ns_per_pixel", title: "ns/px", help: "Draw time per covered pixel, ns" },
  { id: "work.taps_mean", title: "taps", help: "Taps per covered pixel, mean" },
  { id: "prepare.ms", title: "prep", help: "Making the technique's maps, ms" },
  { id: "error.uv_texels.p50", title: "uv50", help: "UV error, median, texels" },
  { id: "error.uv_texels.p99", title: "uv", help: "UV error, 99th percentile, texels" },
  { id: "error.depth.p99", title: "depth", help: "Depth error, 99th percentile, patch sides" },
  { id: "image.flip", title: "flip", help: "FLIP, mean" },
  { id: "error.missed", title: "missed", help: "Missed hits, % of the footprint", scale: 100 },
  { id: "error.false_hits", title: "false", help: "False hits, % of the footprint", scale: 100 },
];

function figureColumn(cells: Cells, figure: FigureColumn): Column<number> {
  const of = (cell: number) => {
    const value = numberOf(cells, figure.id, cell);
    return value === null ? null : (figure.scale ?? 1) * value;
  };
  return {
    id: figure.id,
    title: figure.title,
    help: figure.help,
    number: true,
    key: of,
    content: (cell) => significant(of(cell)),
  };
}

function wordColumns(app: App): Column<number>[] {
  const { cells } = app.run();
  const status: Column<number> = {
    id: "status",
    title: "Status",
    number: false,
    key: (cell) => statusOf(cells, cell),
    content: (cell) => h("span", { class: `status ${statusOf(cells, cell)}` }, statusOf(cells, cell)),
  };
  const setting: Column<number> = {
    id: "setting",
    title: "Technique and parameters",
    number: false,
    key: (cell) => settingOf(cells.id[cell]!),
    content: (cell) => settingElement(app, settingOf(cells.id[cell]!), techniqueOf(cells, cell)),
  };
  const view: Column<number> = {
    id: "view",
    title: "View",
    number: false,
    key: (cell) => viewOf(cells.id[cell]!),
    content: (cell) => viewOf(cells.id[cell]!),
  };
  const reason: Column<number> = {
    id: "reason",
    title: "Reason",
    number: false,
    key: (cell) => reasonOf(cells, cell) || null,
    content: (cell) => reasonOf(cells, cell),
  };
  return [status, setting, view, reason];
}

export function cellsView(app: App): View {
  const { cells } = app.run();
  const query = h("input", {
    class: "query",
    attrs: {
      id: "query",
      type: "search",
      placeholder: "pom rock uv<0.5 ms<2 −perspective status:failed",
      "aria-label": "Search",
      spellcheck: false,
    },
    on: { input: () => app.update({ query: query.value }) },
  });
  const count = h("span", { class: "muted", attrs: { id: "row-count" } });
  const picker = columnPicker(app);
  const table = new Table<number>({
    label: "Cells",
    onSort: (id) => app.update({ sort: app.state.sort === id ? `-${id}` : id }),
    onRow: (cell) => app.update({ pin: cells.id[cell]! }),
    rowClass: (cell) => `pinnable${cell === app.pinned() ? " pinned" : ""}`,
  });
  const anyTrouble = (cells.words["status"]?.values.length ?? 0) > 1;
  const [status, setting, view, reason] = wordColumns(app) as [
    Column<number>,
    Column<number>,
    Column<number>,
    Column<number>,
  ];

  return {
    name: "cells",
    title: "Cells",
    element: h(
      "section",
      { class: "view-cells" },
      h("div", { class: "controls" }, query, count, picker),
      table.element,
      h(
        "p",
        { class: "note" },
        h(
          "span",
          {},
          "Words search; −word leaves out; uv<0.5 bounds a column by its title or by its field (error.uv_texels.p99<0.5).",
        ),
      ),
    ),
    refresh() {
      if (document.activeElement !== query) query.value = app.state.query;
      const figures = figureColumns(app);
      const columns = [...(anyTrouble ? [status] : []), setting, view, ...figures, ...(anyTrouble ? [reason] : [])];
      const rows = sortRows(matchingCells(app, columns), columns, app.state.sort);
      fill(count, counted(rows.length, "cell"));
      table.show(rows, columns, app.state.sort);
      const pinned = rows.indexOf(app.pinned());
      if (pinned >= 0) table.reveal(pinned);
    },
  };
}

function figureColumns(app: App): Column<number>[] {
  const { cells } = app.run();
  const chosen = app.state.columns.filter((id) => hasFigure(cells, id));
  const figures =
    chosen.length === 0
      ? usual.filter(({ id }) => hasFigure(cells, id))
      : chosen.map(
          (id) =>
            usual.find((column) => column.id === id) ?? { id, title: id.replace(/^(time|error|work)\./, ""), help: id },
        );
  return figures.map((figure) => figureColumn(cells, figure));
}

function matchingCells(app: App, columns: Column<number>[]): number[] {
  const { cells } = app.run();
  // A minus as typographers set it is one, too.
  const query = parseQuery(app.state.query.replaceAll("−", "-"));
  return app.selection().filter((cell) => {
    const text = `${cells.id[cell]!} ${statusOf(cells, cell)} status:${statusOf(cells, cell)} ${reasonOf(cells, cell)}`;
    return matches(query, text, (name) => {
      const column = columns.find(({ id, title }) => title.toLowerCase() === name || id === name);
      if (column === undefined) return numberOf(cells, name, cell);
      const key = column.key(cell);
      return typeof key === "number" ? key : null;
    });
  });
}

/** Any of the figures that the run has. */
function columnPicker(app: App): HTMLElement {
  const { cells } = app.run();
  const shown = () => (app.state.columns.length > 0 ? app.state.columns : usual.map(({ id }) => id));
  return h(
    "details",
    { class: "picker" },
    h("summary", {}, "Columns"),
    h(
      "div",
      { class: "picker-list" },
      h(
        "button",
        { class: "link", attrs: { type: "button" }, on: { click: () => app.update({ columns: [] }) } },
        "the usual ones",
      ),
      ...Object.keys(cells.numbers).map((id) => {
        const box = h("input", {
          attrs: { type: "checkbox", checked: shown().includes(id) },
          on: {
            change: () => {
              const next = box.checked ? [...shown(), id] : shown().filter((each) => each !== id);
              app.update({ columns: next });
            },
          },
        });
        return h("label", {}, box, id);
      }),
    ),
  );
}
