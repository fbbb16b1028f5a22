// The cell of the views that show one: the pinned one, else the best.

import type { App } from "../app.ts";
import { bestCell } from "../best.ts";
import { cellSummary, fact, shownMetrics } from "../describe.ts";
import { h } from "../dom.ts";

export interface ShownCell {
  /** -1 for none. */
  cell: number;
  /** Which cell it is and why, unless it is pinned, or why there is none. */
  why: HTMLElement | null;
}

/** `has` tells of a measured cell whether there is anything to show of it. */
export function shownCell(app: App, has: (cell: number) => boolean): ShownCell {
  const pinned = app.pinned();
  if (pinned >= 0) return { cell: pinned, why: null };
  const { cells } = app.run();
  const { cost, error } = shownMetrics(app);
  const best = cost === null || error === null ? null : bestCell(cells, app.measured().filter(has), cost, error);
  if (best === null)
    return {
      cell: -1,
      why: h("p", { class: "empty" }, "Nothing is pinned, and the filter leaves no cell to show instead."),
    };
  const where =
    best.views > 1 ? `Best cell of the hardest view (largest median of ${error!.label}) of ${best.views}` : "Best cell";
  return {
    cell: best.cell,
    why: h(
      "div",
      { class: "best", attrs: { "data-best": cells.id[best.cell]! } },
      h(
        "div",
        { class: "pin" },
        h("span", { class: "pin-label" }, "Best"),
        ...cellSummary(app, best.cell),
        h(
          "span",
          { class: "pin-buttons" },
          h(
            "button",
            { attrs: { type: "button" }, on: { click: () => app.update({ pin: cells.id[best.cell]! }) } },
            "Pin it",
          ),
        ),
      ),
      fact(
        `Nothing is pinned. ${where}: the cheapest of those whose ${error!.label} cannot be told from the ${error!.better === "lower" ? "least" : "greatest"}. Click a point of a chart or a row of a table, or press j, to see another.`,
      ),
    ),
  };
}
