// Environment and configuration in full.

import type { App, View } from "../app.ts";
import type { Json } from "../data.ts";
import { h } from "../dom.ts";

export function runView(app: App): View {
  const { record, summary, name } = app.run();
  const { configuration, ...rest } = record;
  const command = Array.isArray(record["command_line"]) ? record["command_line"].map(String).join(" ") : null;
  const element = h(
    "section",
    { class: "view-run" },
    h("p", { class: "muted" }, "Folder: ", h("code", {}, name)),
    command === null ? null : h("p", { class: "muted" }, "Command: ", h("code", {}, command)),
    h(
      "div",
      { class: "columns" },
      ...Object.entries(rest)
        .filter(([key]) => key !== "command_line")
        .map(([key, value]) => recordTable(key, value)),
      summary === null ? null : recordTable("summary", summary),
    ),
    h("h3", {}, "Configuration as expanded"),
    h("pre", { class: "json" }, JSON.stringify(configuration ?? null, null, 2)),
    h(
      "p",
      { class: "muted small" },
      `Made by reliefbench ${app.data.tool_version}. \`reliefbench run RUN/run.json\` repeats the run.`,
    ),
  );
  return { name: "run", title: "Run", element, refresh: () => {} };
}

/** Scalars by their path. */
function flat(value: Json, path: string): [string, string][] {
  if (value !== null && typeof value === "object") {
    const entries = Array.isArray(value)
      ? value.map((item, at): [string, Json] => [String(at + 1), item])
      : Object.entries(value);
    if (Array.isArray(value) && value.every((item) => item === null || typeof item !== "object"))
      return [[path, value.join(", ")]];
    return entries.flatMap(([key, item]) => flat(item, path === "" ? key : `${path} › ${key}`));
  }
  return [[path, scalarText(value)]];
}

function scalarText(value: Json): string {
  if (value === null) return "unknown";
  return typeof value === "number" ? String(Number(value.toPrecision(10))) : String(value);
}

function recordTable(name: string, value: Json): HTMLElement | null {
  const rows = flat(value, "");
  if (rows.length === 0 || (rows.length === 1 && rows[0]![1] === "")) return null;
  return h(
    "table",
    { class: "figures" },
    h("caption", {}, name.replaceAll("_", " ")),
    h("tbody", {}, ...rows.map(([key, text]) => h("tr", {}, h("td", {}, key), h("td", { class: "value" }, text)))),
  );
}
