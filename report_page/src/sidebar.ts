// Filters, which are the charts' legend too.

import type { App } from "./app.ts";
import { sortedValues, techniqueOf, techniques, valueText, variedAxes } from "./data.ts";
import { h } from "./dom.ts";
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

function techniqueGroup(app: App): HTMLElement {
  const { cells } = app.run();
  const all = techniques(cells);
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
          h("span", { class: "chip-name" }, technique),
          h("span", { class: "count" }, String(counts.get(technique) ?? 0)),
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

export function sidebar(app: App): HTMLElement {
  const { cells } = app.run();
  const filtered =
    app.state.techniques.length > 0 || Object.values(app.state.filters).some((values) => values.length > 0);
  return h(
    "div",
    { class: "sidebar" },
    techniqueGroup(app),
    ...variedAxes(cells).map((axis) => axisGroup(app, axis)),
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
