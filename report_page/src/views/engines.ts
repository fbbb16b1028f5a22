// What does my engine pay and miss, and what is better at the same cost? Per kind of view, as harness/report/engine_answers
// says: whatever is filtered, the answer is of the whole run, so that it is computed once, where the terminal has it from.

import type { App, View } from "../app.ts";
import { axisValueText, deep, type EngineAnswers, type EngineSetting, type Json, valueText } from "../data.ts";
import { drawTime, timePerPixel, usualError } from "../defaults.ts";
import { settingElement } from "../describe.ts";
import { h } from "../dom.ts";
import { declared, type KnownFigure, metricText } from "../metrics.ts";
import { significant } from "../numbers.ts";
import { truthNote } from "../truth.ts";
import { timesText } from "./advice_words.ts";

/** Above this a setting's errors do not count, as everywhere (report/ranking.hpp). */
const wrongHitsLimit = 0.005;

const wrongLabel = "Missed and false hits";
const betterLabel = "Better, no slower";
const cheaperLabel = "As good, faster";

interface Columns {
  cost: KnownFigure;
  perPixel: KnownFigure;
  rank: KnownFigure;
  uv: KnownFigure;
}

/** What run.json has of a preset. */
function recordOf(app: App, preset: EngineSetting, key: string): string {
  const text = deep(app.run().record, "presets", preset.technique, preset.preset ?? "", key);
  return typeof text === "string" ? text : "";
}

function figure(setting: EngineSetting, metric: KnownFigure): string {
  const value = setting.figures[metric.path];
  return value === null || value === undefined ? "–" : metricText(metric, value);
}

function title(axes: Record<string, Json>): string {
  const parts = Object.entries(axes).map(([axis, value]) =>
    axis === "view_angle" ? `${valueText(value)}°` : axisValueText(axis, valueText(value)),
  );
  return parts.join(", ") || "All views";
}

function hasManyWrong(setting: EngineSetting): boolean {
  return setting.wrong_hits > wrongHitsLimit;
}

function wrongText(setting: EngineSetting): string {
  return `${hasManyWrong(setting) ? "⚠ " : ""}${significant(100 * setting.wrong_hits, 2)} %`;
}

function otherElement(
  app: App,
  label: string,
  other: EngineSetting | null,
  of: EngineSetting,
  columns: Columns,
): HTMLElement {
  const attrs = { "data-label": label };
  if (other === null) return h("td", { class: "muted", attrs }, "nothing that was measured");
  const { rank, cost } = columns;
  const [value, before] = [other.figures[rank.path] ?? 0, of.figures[rank.path] ?? 0];
  return h(
    "td",
    { attrs },
    settingElement(app, other.setting, other.technique),
    h(
      "div",
      { class: "muted small" },
      `${figure(other, rank)}${timesText(value, before, "error")}, ${metricText(cost, other.ms)}${timesText(other.ms, of.ms, "time")}`,
      ...(hasManyWrong(other) ? [`; ${wrongText(other)} missed or false`] : []),
    ),
  );
}

function wrongElement(setting: EngineSetting): HTMLElement {
  return h(
    "td",
    {
      class: "number",
      attrs: { "data-label": wrongLabel },
      title: hasManyWrong(setting)
        ? "Above 0.5 % of the footprint: what it finds is often not there, and its errors are of the rest"
        : "",
    },
    wrongText(setting),
  );
}

function rowElement(
  app: App,
  { preset, better, cheaper }: { preset: EngineSetting; better: EngineSetting | null; cheaper: EngineSetting | null },
  columns: Columns,
): HTMLElement {
  const { cost, perPixel, rank, uv } = columns;
  const number = (of: KnownFigure, text: string, second: KnownFigure, secondText: string) =>
    h(
      "td",
      { class: "number", attrs: { "data-label": of.label } },
      text,
      h("div", { class: "muted small", attrs: { "data-label": second.label } }, secondText),
    );
  return h(
    "tr",
    {},
    h(
      "th",
      { attrs: { scope: "row" }, title: recordOf(app, preset, "source") },
      recordOf(app, preset, "title") || preset.preset || "",
      h("div", { class: "muted small" }, settingElement(app, preset.setting, preset.technique)),
    ),
    number(
      cost,
      metricText(cost, preset.ms),
      perPixel,
      preset.ns_per_pixel === null ? "–" : metricText(perPixel, preset.ns_per_pixel),
    ),
    number(rank, figure(preset, rank), uv, figure(preset, uv)),
    wrongElement(preset),
    otherElement(app, betterLabel, better, preset, columns),
    otherElement(app, cheaperLabel, cheaper, preset, columns),
  );
}

function tableElement(app: App, view: EngineAnswers["views"][number], columns: Columns): HTMLElement | null {
  if (view.presets === undefined || view.presets.length === 0) return null;
  const { cost, perPixel, rank, uv } = columns;
  const heading = (text: string, isNumber: boolean, second = "") =>
    h(
      "th",
      { class: isNumber ? "number" : "", attrs: { scope: "col" } },
      text,
      ...(second === "" ? [] : [h("div", { class: "muted small" }, second)]),
    );
  return h(
    "div",
    { class: "engine-table" },
    h(
      "h3",
      {},
      title(view.axes),
      ...(view.views.length > 1 ? [h("span", { class: "muted" }, `, worst of ${view.views.length} views`)] : []),
    ),
    h(
      "table",
      { class: "engines" },
      h(
        "thead",
        {},
        h(
          "tr",
          {},
          heading("Engine", false),
          heading(cost.label, true, perPixel.label),
          heading(rank.label, true, uv.label),
          heading(wrongLabel, true),
          heading(betterLabel, false),
          heading(cheaperLabel, false),
        ),
      ),
      h("tbody", {}, ...view.presets.map((row) => rowElement(app, row, columns))),
    ),
  );
}

/** The technique and what is not at its defaults: "...: max_steps 32, min_steps 8" */
function parametersText(app: App, preset: EngineSetting): string {
  const values = deep(app.run().record, "presets", preset.technique, preset.preset ?? "", "parameters");
  const parts = Object.entries(values !== null && typeof values === "object" ? values : {}).map(
    ([name, value]) => `${name} ${valueText(value)}`,
  );
  return `${preset.technique}: ${parts.join(", ") || "all parameters at their defaults"}`;
}

/** By title: parameters, source, and what no parameter expresses. */
function sourcesElement(app: App, answers: EngineAnswers): HTMLElement {
  const presets = new Map<string, EngineSetting>();
  for (const { presets: rows = [] } of answers.views)
    for (const { preset } of rows) presets.set(recordOf(app, preset, "title"), preset);
  const entries = [...presets].sort(([a], [b]) => a.localeCompare(b, "en"));
  return h(
    "details",
    { class: "engine-sources" },
    h("summary", {}, "Parameters, sources, and what the presets do not express"),
    h(
      "dl",
      {},
      ...entries.flatMap(([name, preset]) => [
        h("dt", {}, name),
        h(
          "dd",
          {},
          h("div", {}, parametersText(app, preset)),
          recordOf(app, preset, "source"),
          ...[recordOf(app, preset, "not_expressed")].filter((note) => note !== "").map((note) => h("div", {}, note)),
        ),
      ]),
    ),
  );
}

export function enginesView(app: App): View | null {
  const answers = app.run().engines;
  if (answers === null || answers === undefined) return null;
  const columns: Columns = {
    cost: declared(app.data.figures, drawTime),
    perPixel: declared(app.data.figures, timePerPixel),
    rank: declared(app.data.figures, answers.rank_by),
    uv: declared(app.data.figures, usualError[0]!),
  };
  const device = deep(app.run().record, "device", "type");
  const element = h(
    "section",
    { class: "view-engines" },
    h("h2", {}, "What does my engine pay and miss, and what is better at the same cost?"),
    device === "CPU"
      ? h("p", { class: "note" }, "Times are of a CPU device: they say nothing of the order on a GPU. Errors are the same anywhere.")
      : null,
    h(
      "p",
      { class: "note" },
      h(
        "span",
        {},
        "Better, no slower: of the settings of no preset that cannot be told to take more time, nor take over 5 % longer, the least error, where that can be told from the preset's. As good, faster: the fastest whose error cannot be told to be more. Settings with missed and false hits above 0.5 % of the footprint are neither, unless nothing else is there and the preset has as many.",
      ),
      h("span", {}, "Of the whole run, whatever is filtered."),
    ),
    h("p", { class: "note" }, truthNote(app.run(), { id: columns.rank.path })),
    ...answers.views.map((view) => tableElement(app, view, columns)),
    sourcesElement(app, answers),
  );
  return { name: "engines", title: "Engines", element, refresh: () => {} };
}
