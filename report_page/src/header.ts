import type { App } from "./app.ts";
import { deep, type Json, type RunData, statusOf, valueText } from "./data.ts";
import { warning } from "./describe.ts";
import { h } from "./dom.ts";
import { counted } from "./numbers.ts";
import { truthSamples } from "./truth.ts";

function timeText(time: Json): string {
  return typeof time === "string" ? time.replace("T", " ").replace(/:\d\dZ$/, " UTC") : "";
}

function countsOf(run: RunData): Record<string, number> {
  const counts: Record<string, number> = { ok: 0, failed: 0, skipped: 0 };
  for (let cell = 0; cell < run.cells.count; ++cell) {
    const status = statusOf(run.cells, cell);
    counts[status] = (counts[status] ?? 0) + 1;
  }
  return counts;
}

function statusButton(app: App, status: string, count: number): HTMLElement | null {
  if (count === 0) return null;
  return h(
    "button",
    {
      class: `status ${status}`,
      title: `List the ${status} cells with their reasons`,
      attrs: { type: "button", "data-status": status },
      on: { click: () => app.update({ view: "cells", query: `status=${status}`, filters: {}, techniques: [] }) },
    },
    `${count} ${status}`,
  );
}

export function headerElement(app: App, onTheme: () => void, onHelp: () => void): HTMLElement {
  const run = app.run();
  const { record } = run;
  const counts = countsOf(run);
  const device = [deep(record, "device", "name"), deep(record, "device", "driver_version")]
    .filter((value) => value !== null && value !== "")
    .map(valueText)
    .join(" · ");
  const runs = app.data.runs;
  return h(
    "div",
    { class: "header" },
    h(
      "h1",
      {},
      h("span", { class: "brand" }, "reliefbench"),
      valueText(deep(record, "configuration", "name") ?? run.name),
    ),
    h(
      "p",
      { class: "facts" },
      h("span", {}, device),
      h("span", {}, timeText(deep(record, "environment", "time"))),
      h("span", {}, `${counted(counts["ok"] ?? 0, "cell")} measured`),
      truthSamples(run) > 1 ? h("span", {}, `truth of ${truthSamples(run)} samples a pixel`) : null,
      statusButton(app, "failed", counts["failed"] ?? 0),
      statusButton(app, "skipped", counts["skipped"] ?? 0),
    ),
    h(
      "div",
      { class: "tools" },
      runs.length > 1 ? runSwitch(app) : null,
      h(
        "button",
        {
          title: "Light or dark (t)",
          attrs: { type: "button", "aria-label": "Light or dark" },
          on: { click: onTheme },
        },
        app.theme === "dark" ? "☀" : "☾",
      ),
      h("button", { title: "Keys (?)", attrs: { type: "button", "aria-label": "Keys" }, on: { click: onHelp } }, "?"),
    ),
    ...[...(run.summary === null ? ["the run did not end"] : []), ...run.cautions].map((text) => warning(text)),
  );
}

function runSwitch(app: App): HTMLElement {
  return h(
    "div",
    { class: "segments", title: "Next run: r", attrs: { role: "group", "aria-label": "Run" } },
    ...app.data.runs.map((run, at) =>
      h(
        "button",
        {
          attrs: { type: "button", "aria-pressed": String(at === app.state.run), "data-run": at },
          on: { click: () => app.update({ run: at }) },
        },
        run.name.split("/").pop() ?? run.name,
      ),
    ),
  );
}
