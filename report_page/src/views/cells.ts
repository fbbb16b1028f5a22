// Every cell in a table that sorts and filters.

import type { App, View } from "../app.ts";
import { hasFigure, reasonOf, settingOf, statusOf, techniqueOf, viewLabel } from "../data.ts";
import { settingElement } from "../describe.ts";
import { fill, h } from "../dom.ts";
import { metricTitle, shownFigure, shownUnit } from "../metrics.ts";
import { counted, figureText } from "../numbers.ts";
import { type NamedFigure, searchCells, type SearchNote } from "../search.ts";
import { type Column, identity, sortRows, Table } from "../table.ts";

/**
 * What is shown unless other columns are chosen: titles, which a search knows too, and the first figure that there is. Time
 * and quality come first.
 */
const usual: [title: string, ...paths: string[]][] = [
  ["ms", "time.draw.median_ms"],
  ["uv", "error.uv_texels.p99"],
  ["uv50", "error.uv_texels.p50"],
  ["flip", "image.footprint.flip", "image.flip"],
  ["shadow", "error.shadow.mean"],
  ["missed", "error.missed"],
  ["false", "error.false_hits"],
  ["depth", "error.depth.p99"],
  ["taps", "work.taps_mean"],
  ["shadow_taps", "work.shadow_taps_mean"],
  ["ns/px", "time.ns_per_pixel"],
  ["± MAD", "time.draw.mad_ms"],
  ["prep", "prepare.ms"],
];

interface FigureColumn extends Column<number> {
  key(cell: number): number | null;
}

/** Of a number that is no declared figure, only its path is known. */
function figureColumn(app: App, path: string, title: string): FigureColumn {
  const { cells } = app.run();
  const declared = app.data.figures.find((figure) => figure.path === path);
  const figure = declared ?? { path, label: path, unit: "" };
  const of = shownFigure(cells, figure);
  const metric = { label: figure.label, unit: shownUnit(figure.unit) };
  return {
    id: path,
    title,
    help: `${metricTitle(metric)}: ${path}`,
    number: true,
    key: of,
    content: (cell) => figureText(of(cell)),
  };
}

function usualColumns(app: App): FigureColumn[] {
  const { cells } = app.run();
  return usual.flatMap(([title, ...paths]) => {
    const path = paths.find((each) => hasFigure(cells, each));
    return path === undefined ? [] : [figureColumn(app, path, title)];
  });
}

/** Whose row it is: technique and parameters, what became of it where it was not measured, and below the view. */
function identityColumn(app: App): Column<number> {
  const { cells } = app.run();
  return identity({
    id: (cell) => cells.id[cell]!,
    content: (cell) => settingElement(app, settingOf(cells.id[cell]!), techniqueOf(cells, cell)),
    below: (cell) => {
      const status = statusOf(cells, cell);
      return [status === "ok" ? null : h("span", { class: `status ${status}` }, status), viewLabel(cells, cell)];
    },
  });
}

function reasonColumn(app: App): Column<number> {
  const { cells } = app.run();
  return {
    id: "reason",
    title: "Reason",
    number: false,
    key: (cell) => reasonOf(cells, cell) || null,
    content: (cell) => reasonOf(cells, cell),
  };
}

export function cellsView(app: App): View {
  const { cells } = app.run();
  const query = h("input", {
    class: "query",
    attrs: {
      id: "query",
      type: "search",
      placeholder: "pom rock −perspective view_angle=60 uv<0.5 status=failed",
      "aria-label": "Search",
      spellcheck: false,
    },
    on: { input: () => app.update({ query: query.value }) },
  });
  const count = h("span", { class: "muted", attrs: { id: "row-count" } });
  const notes = h("div", { class: "search-notes", attrs: { role: "status" } });
  const picker = columnPicker(app);
  const table = new Table<number>({
    label: "Cells",
    onSort: (id) => app.update({ sort: app.state.sort === id ? `-${id}` : id }),
    onRow: (cell) => app.update({ pin: cells.id[cell]! }),
    rowClass: (cell) => `pinnable${cell === app.pinned() ? " pinned" : ""}`,
    instead: (cell) => reasonOf(cells, cell) || null,
  });
  const anyTrouble = cells.words["status"]?.values.some((status) => status !== "ok") ?? false;

  return {
    name: "cells",
    title: "Cells",
    element: h(
      "section",
      { class: "view-cells" },
      h("div", { class: "controls" }, query, count, picker),
      notes,
      table.element,
      h(
        "p",
        { class: "note" },
        h(
          "span",
          {},
          "Words search technique, status, reason and the values of all axes and parameters, defaults included; −word leaves out. Any axis, parameter or column can be compared: view_angle=0,60 technique=pom max_steps>=32 uv<0.5; a field of cells.jsonl by its path and in its unit there (error.missed<0.001).",
        ),
      ),
    ),
    refresh() {
      if (document.activeElement !== query) query.value = app.state.query;
      const figures = figureColumns(app);
      const columns = [identityColumn(app), ...figures, ...(anyTrouble ? [reasonColumn(app)] : [])];
      const result = searchCells(cells, app.selection(), app.state.query, namedFigures(app, figures));
      const rows = sortRows(result.found, columns, app.state.sort);
      fill(count, counted(rows.length, "cell"));
      fill(notes, ...result.notes.map((note) => noteElement(app, note)));
      table.show(rows, columns, app.state.sort);
      const pinned = rows.indexOf(app.pinned());
      if (pinned >= 0) table.reveal(pinned);
    },
  };
}

function figureColumns(app: App): FigureColumn[] {
  const { cells } = app.run();
  const chosen = app.state.columns.filter((path) => hasFigure(cells, path));
  const usualOnes = usualColumns(app);
  if (chosen.length === 0) return usualOnes;
  return chosen.map(
    (path) =>
      usualOnes.find(({ id }) => id === path) ?? figureColumn(app, path, path.replace(/^(time|error|work)\./, "")),
  );
}

/** Titles of columns in one word, those that are not shown included. */
function namedFigures(app: App, shown: FigureColumn[]): NamedFigure[] {
  return [...usualColumns(app), ...shown].map(({ title, key }) => ({ name: title.replace("± ", ""), of: key }));
}

function noteElement(app: App, note: SearchNote): HTMLElement {
  const { correction } = note;
  return h(
    "p",
    {},
    note.text,
    correction === null
      ? null
      : h(
          "span",
          {},
          " Did you mean ",
          h(
            "button",
            {
              class: "link",
              attrs: { type: "button" },
              on: { click: () => app.update({ query: correction.query }) },
            },
            correction.label,
          ),
          "?",
        ),
  );
}

/** Any of the figures that the run has. */
function columnPicker(app: App): HTMLElement {
  const { cells } = app.run();
  const shown = () => (app.state.columns.length > 0 ? app.state.columns : usualColumns(app).map(({ id }) => id));
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
