// Every cell in a table that sorts and filters.

import type { App, View } from "../app.ts";
import { hasFigure, reasonOf, settingOf, statusOf, techniqueOf, viewLabel } from "../data.ts";
import { missedHits, shortNames, usualColumns } from "../defaults.ts";
import { settingElement } from "../describe.ts";
import { fill, h } from "../dom.ts";
import { grouped } from "../figures.ts";
import { bareText, declared, figureTitle, hasValues, shownFigure, shownUnit } from "../metrics.ts";
import { counted } from "../numbers.ts";
import { type NamedFigure, searchCells, type SearchNote } from "../search.ts";
import { type Column, identity, sortRows, Table } from "../table.ts";

interface FigureColumn extends Column<number> {
  key(cell: number): number | null;
}

function figureColumn(app: App, path: string): FigureColumn {
  const { cells } = app.run();
  const figure = declared(app.data.figures, path);
  const of = shownFigure(cells, figure);
  const short = Object.keys(shortNames).filter((name) => shortNames[name]!.includes(path));
  return {
    id: path,
    title: figure.label,
    unit: shownUnit(figure.unit),
    help: [path, ...short].join("; in a search also "),
    number: true,
    key: of,
    content: (cell) => bareText({ unit: figure.unit }, of(cell)),
  };
}

function usualPaths(app: App): string[] {
  const { cells } = app.run();
  return usualColumns.flatMap((paths) => paths.find((path) => hasValues(cells, path)) ?? []);
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
      placeholder: "rock −perspective view_angle=60 uv<0.5 status=failed",
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
      h("div", { class: "controls" }, query, count, picker.element),
      notes,
      table.element,
      h(
        "p",
        { class: "note" },
        h(
          "span",
          {},
          `Words search technique, status, reason and the values of all axes and parameters, defaults included; −word leaves out. Any axis, parameter or figure can be compared: view_angle=0,60 technique=pom max_steps>=32 uv<0.5; short names are those of scripts/plot.py, in the table's unit, and a field of cells.jsonl goes by its path and in its unit there (${missedHits}<0.001).`,
        ),
      ),
    ),
    refresh() {
      if (document.activeElement !== query) query.value = app.state.query;
      picker.refresh();
      const figures = shownPaths(app).map((path) => figureColumn(app, path));
      const columns = [identityColumn(app), ...figures, ...(anyTrouble ? [reasonColumn(app)] : [])];
      const result = searchCells(cells, app.selection(), app.state.query, namedFigures(app));
      const rows = sortRows(result.found, columns, app.state.sort);
      fill(count, counted(rows.length, "cell"));
      fill(notes, ...result.notes.map((note) => noteElement(app, note)));
      table.show(rows, columns, app.state.sort);
      const pinned = rows.indexOf(app.pinned());
      if (pinned >= 0) table.reveal(pinned);
    },
  };
}

function shownPaths(app: App): string[] {
  const { cells } = app.run();
  const chosen = app.state.columns.filter((path) => hasFigure(cells, path));
  return chosen.length > 0 ? chosen : usualPaths(app);
}

/** Figures under the names that a search knows besides their paths. */
function namedFigures(app: App): NamedFigure[] {
  const { cells } = app.run();
  return Object.entries(shortNames).flatMap(([name, paths]) => {
    const path = paths.find((each) => hasFigure(cells, each));
    return path === undefined ? [] : [{ name, of: shownFigure(cells, declared(app.data.figures, path)) }];
  });
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

/** Any of the figures that the run has; a word leaves those that it is a part of. `refresh` ticks those shown. */
function columnPicker(app: App): { element: HTMLElement; refresh(): void } {
  const { cells } = app.run();
  const ranks = new Map(app.data.figures.map(({ path }, at) => [path, at]));
  const rank = (path: string) => ranks.get(path) ?? ranks.size;
  const paths = Object.keys(cells.numbers)
    .filter((path) => hasValues(cells, path))
    .sort((a, b) => rank(a) - rank(b));
  const boxes = new Map<string, HTMLInputElement>();
  const labelOf = (path: string) => {
    const box: HTMLInputElement = h("input", {
      attrs: { type: "checkbox" },
      on: {
        change: () => {
          const shown = shownPaths(app);
          app.update({ columns: box.checked ? [...shown, path] : shown.filter((each) => each !== path) });
        },
      },
    });
    boxes.set(path, box);
    const title = figureTitle(declared(app.data.figures, path));
    return h("label", { title: path, attrs: { "data-words": `${title} ${path}`.toLowerCase() } }, box, title);
  };
  const groups = grouped(paths, (path) => path).map(({ title, figures }) =>
    h("fieldset", {}, h("legend", {}, title), ...figures.map(labelOf)),
  );
  const words = h("input", {
    attrs: { type: "search", placeholder: "Find a figure", "aria-label": "Find a figure", spellcheck: false },
    on: {
      input: () => {
        const wanted = words.value.trim().toLowerCase();
        for (const group of groups) {
          const labels = [...group.querySelectorAll<HTMLElement>("label")];
          for (const label of labels) label.hidden = !label.dataset["words"]!.includes(wanted);
          group.hidden = labels.every((label) => label.hidden);
        }
      },
    },
  });
  return {
    element: h(
      "details",
      { class: "picker" },
      h("summary", {}, "Columns"),
      h(
        "div",
        { class: "picker-list" },
        words,
        h(
          "button",
          { class: "link", attrs: { type: "button" }, on: { click: () => app.update({ columns: [] }) } },
          "the usual ones",
        ),
        ...groups,
      ),
    ),
    refresh() {
      const shown = new Set(shownPaths(app));
      for (const [path, box] of boxes) box.checked = shown.has(path);
    },
  };
}
