// Filters, which are the charts' legend too.

import type { App } from "./app.ts";
import { sortedValues, statusOf, techniqueOf, techniques, valueText, variedAxes } from "./data.ts";
import { h } from "./dom.ts";
import { measuredCells } from "./filter.ts";
import { counted } from "./numbers.ts";
import { markElement } from "./palette.ts";
import { toggled } from "./state.ts";

/** A click takes a value in or out; with Alt or Shift, or twice, it alone stays. */
function chip(
  content: (Node | string)[],
  pressed: boolean,
  value: string,
  onToggle: () => void,
  onOnly: () => void,
): HTMLElement {
  return h(
    "button",
    {
      class: "chip",
      title: "Click: in or out. Shift-click: this alone.",
      attrs: { type: "button", "aria-pressed": String(pressed), "data-value": value },
      on: { click: (event) => (event.shiftKey || event.altKey ? onOnly() : onToggle()) },
    },
    ...content,
  );
}

/** A name that is too long for its line breaks after an underscore. */
function breakable(name: string): (Node | string)[] {
  return name.split(/(?<=_)/).flatMap((part, at) => (at === 0 ? [part] : [h("wbr"), part]));
}

function techniqueGroup(app: App): HTMLElement {
  const { cells } = app.run();
  const every = [...cells.id.keys()];
  const anyMeasured = new Set(measuredCells(cells, every).map((cell) => techniqueOf(cells, cell)));
  const failed = new Set(
    every.filter((cell) => statusOf(cells, cell) === "failed").map((cell) => techniqueOf(cells, cell)),
  );
  // What no figure is of comes last.
  const all = techniques(cells).sort((a, b) => Number(!anyMeasured.has(a)) - Number(!anyMeasured.has(b)));
  const countOf = (technique: string) => {
    if (anyMeasured.has(technique)) return String(counts.get(technique) ?? 0);
    return failed.has(technique) ? "failed" : "skipped";
  };
  const shown = app.state.techniques;
  const counts = new Map<string, number>();
  for (const cell of app.measured()) {
    const technique = techniqueOf(cells, cell);
    counts.set(technique, (counts.get(technique) ?? 0) + 1);
  }
  return h(
    "fieldset",
    { attrs: { "data-filter": "technique" } },
    h("legend", {}, "Technique"),
    ...all.map((technique) =>
      chip(
        [
          markElement(app.mark(technique), app.theme),
          h("span", { class: "chip-name" }, ...breakable(technique)),
          h("span", { class: "count" }, countOf(technique)),
        ],
        shown.length === 0 || shown.includes(technique),
        technique,
        () => app.update({ techniques: toggled(shown, technique, all) }),
        () => app.update({ techniques: [technique] }),
      ),
    ),
  );
}

function axisGroup(app: App, axis: string): HTMLElement {
  const column = app.run().cells.axes[axis]!;
  const all = sortedValues(column).map(valueText);
  const shown = app.state.filters[axis] ?? [];
  const set = (values: string[]) => app.update({ filters: { ...app.state.filters, [axis]: values } });
  return h(
    "fieldset",
    { class: "values", attrs: { "data-filter": axis } },
    h("legend", {}, axis.replaceAll("_", " ")),
    ...all.map((value) =>
      chip(
        [value],
        shown.length === 0 || shown.includes(value),
        value,
        () => set(toggled(shown, value, all)),
        () => set([value]),
      ),
    ),
  );
}

/** `open`: whether the axes are shown, which a narrow window has no room for at all times. */
export function sidebar(app: App, open: boolean, onToggle: (open: boolean) => void): HTMLElement {
  const { cells } = app.run();
  const filtered =
    app.state.techniques.length > 0 || Object.values(app.state.filters).some((values) => values.length > 0);
  const axes: HTMLDetailsElement = h(
    "details",
    { class: "axis-filters", attrs: { open }, on: { toggle: () => onToggle(axes.open) } },
    h("summary", {}, "Filter by axes"),
    ...variedAxes(cells).map((axis) => axisGroup(app, axis)),
  );
  return h(
    "div",
    { class: "sidebar" },
    techniqueGroup(app),
    axes,
    h(
      "p",
      { class: "muted shown" },
      `${app.selection().length.toLocaleString("en")} of ${counted(cells.count, "cell")}`,
      filtered
        ? h(
            "button",
            {
              class: "link",
              title: "x",
              attrs: { type: "button" },
              on: { click: () => app.update({ filters: {}, techniques: [] }) },
            },
            "show all",
          )
        : null,
    ),
  );
}
