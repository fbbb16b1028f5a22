// The pinned cell's timing: samples over rounds pass by pass, preparation, pipeline statistics.

import type { App, View } from "../app.ts";
import { axisStyle, Chart, currentInk, type Option, tooltipStyle } from "../chart.ts";
import { numberOf, type RunData, textOf } from "../data.ts";
import { fill, h } from "../dom.ts";
import { bytesText, counted, significant } from "../numbers.ts";

/** Samples of consecutive rounds of one pass of a cell. */
interface Group {
  firstRound: number;
  samples: number;
  /** Minimum, quartiles, maximum, ms. */
  ms: number[];
}

interface Pass {
  name: string;
  groups: Group[];
}

function passesOf(run: RunData, cell: number): Pass[] {
  const passes: Pass[] = [];
  for (const samples of run.samples) {
    const at = samples.cell.indexOf(cell);
    if (at < 0) continue;
    let first = 0;
    for (let before = 0; before < at; ++before) first += samples.groups[before]!;
    const groups = Array.from({ length: samples.groups[at]! }, (_, group) => ({
      firstRound: samples.first_round[first + group]!,
      samples: samples.samples[first + group]!,
      ms: samples.ms.slice(5 * (first + group), 5 * (first + group + 1)),
    }));
    passes.push({ name: samples.pass, groups });
  }
  // The draw is what cells are compared by.
  return passes.sort((a, b) => Number(b.name === "draw") - Number(a.name === "draw") || a.name.localeCompare(b.name));
}

export function timingView(app: App): View {
  const content = h("div", { class: "timing" });
  return {
    name: "timing",
    title: "Timing",
    element: h("section", { class: "view-timing" }, content),
    refresh() {
      const cell = app.pinned();
      if (cell < 0) {
        fill(content, pinFirst());
        return;
      }
      fill(
        content,
        passTable(app.run(), cell),
        ...passesOf(app.run(), cell).map((pass) => passElement(app, pass, cell)),
        h("div", { class: "columns" }, preparationTable(app.run(), cell), ...statisticsTables(app.run(), cell)),
      );
    },
  };
}

export function pinFirst(): HTMLElement {
  return h("p", { class: "empty" }, "Pin a cell first: click a point of a chart or a row of the table, or press j.");
}

const figures: [string, string][] = [
  ["median_ms", "Median, ms"],
  ["mad_ms", "MAD, ms"],
  ["ci95_ms.low", "95 % from, ms"],
  ["ci95_ms.high", "to, ms"],
  ["lower_quartile_ms", "Lower quartile, ms"],
  ["n", "Samples"],
  ["rounds", "Rounds"],
  ["repeats", "Repeats"],
  ["outliers", "Outliers"],
];

function figureText(key: string, value: number | null): string {
  return key.includes("ms") ? significant(value, 4) : (value ?? "–").toLocaleString("en");
}

function passTable(run: RunData, cell: number): HTMLElement {
  const passes = new Set(
    Object.keys(run.cells.numbers)
      .map((path) => /^time\.(.+)\.median_ms$/.exec(path)?.[1])
      .filter((pass): pass is string => pass !== undefined && numberOf(run.cells, `time.${pass}.median_ms`, cell) !== null),
  );
  const stop = textOf(run.cells.words["time.stop"], cell);
  return h(
    "table",
    { class: "figures" },
    h("caption", {}, "Passes", stop === null ? null : h("span", { class: "muted" }, ` (sampling stopped: ${stop})`)),
    h("thead", {}, h("tr", {}, h("th", {}, "Pass"), ...figures.map(([, title]) => h("th", { class: "number" }, title)))),
    h(
      "tbody",
      {},
      ...[...passes].map((pass) =>
        h("tr", {}, h("td", {}, pass), ...figures.map(([key]) => h("td", { class: "number" }, figureText(key, numberOf(run.cells, `time.${pass}.${key}`, cell))))),
      ),
    ),
  );
}

function passElement(app: App, pass: Pass, cell: number): HTMLElement {
  const samples = pass.groups.reduce((sum, group) => sum + group.samples, 0);
  const chart = new Chart(`Samples of the pass ${pass.name} over rounds`);
  chart.show(passOption(app, pass, cell));
  const rounds = pass.groups.length;
  const together = rounds > 1 && pass.groups[1]!.firstRound - pass.groups[0]!.firstRound > 1;
  return h(
    "figure",
    {},
    h(
      "figcaption",
      {},
      h("b", {}, pass.name),
      h(
        "span",
        { class: "muted" },
        ` ${counted(samples, "sample")}${rounds > 1 ? (together ? `, ${rounds} groups of rounds` : ` in ${counted(rounds, "round")}`) : ", before the rounds"}. Boxes: quartiles; whiskers: least and greatest.`,
      ),
    ),
    chart.element,
  );
}

function passOption(app: App, pass: Pass, cell: number): Option {
  const ink = currentInk();
  const median = numberOf(app.run().cells, `time.${pass.name}.median_ms`, cell);
  const low = numberOf(app.run().cells, `time.${pass.name}.ci95_ms.low`, cell);
  const high = numberOf(app.run().cells, `time.${pass.name}.ci95_ms.high`, cell);
  const last = pass.groups.length - 1;
  const level = (value: number, style: object) => ({
    type: "line",
    data: [
      [-0.5, value],
      [last + 0.5, value],
    ],
    xAxisIndex: 1,
    symbol: "none",
    silent: true,
    lineStyle: { color: ink.accent, width: 1.2, ...style },
    z: 1,
  });
  return {
    grid: { left: ink.size * 5, right: ink.size * 2, top: ink.size, bottom: ink.size * 3.6 },
    xAxis: [
      {
        ...axisStyle(ink, pass.groups.length > 1 ? "round" : ""),
        type: "category",
        data: pass.groups.map((group) => String(group.firstRound)),
        nameGap: ink.size * 2,
        splitLine: { show: false },
      },
      { type: "value", min: -0.5, max: last + 0.5, show: false },
    ],
    yAxis: { ...axisStyle(ink, "ms"), type: "value", scale: true, nameGap: ink.size * 3.6 },
    tooltip: {
      ...tooltipStyle(ink),
      formatter: (parameters: { dataIndex: number; seriesType: string }) => groupTooltip(pass.groups[parameters.dataIndex]!),
    },
    series: [
      {
        type: "boxplot",
        data: pass.groups.map((group) => group.ms),
        itemStyle: { color: ink.panel, borderColor: ink.text, borderWidth: 1.2 },
        boxWidth: [4, 26],
      },
      ...(median === null ? [] : [level(median, {})]),
      ...(low === null || high === null ? [] : [level(low, { type: "dashed", opacity: 0.7 }), level(high, { type: "dashed", opacity: 0.7 })]),
    ],
  };
}

function groupTooltip(group: Group): HTMLElement {
  const names = ["least", "lower quartile", "median", "upper quartile", "greatest"];
  return h(
    "div",
    { class: "tip" },
    h("b", {}, `Round ${group.firstRound}`),
    h("div", { class: "muted" }, counted(group.samples, "sample")),
    h("dl", {}, ...names.flatMap((name, at) => [h("dt", {}, name), h("dd", {}, `${significant(group.ms[at], 4)} ms`)])),
  );
}

function rowsTable(caption: string, rows: [string, string][]): HTMLElement | null {
  if (rows.length === 0) return null;
  return h(
    "table",
    { class: "figures" },
    h("caption", {}, caption),
    h("tbody", {}, ...rows.map(([name, value]) => h("tr", {}, h("td", {}, name), h("td", { class: "number" }, value)))),
  );
}

function preparationTable(run: RunData, cell: number): HTMLElement | null {
  const of = (path: string) => numberOf(run.cells, path, cell);
  const work: [string, string][] = [
    ["Taps", "work.taps_mean"],
    ["Taps, 95th percentile", "work.taps_p95"],
    ["Texels read", "work.texels_mean"],
    ["Steps", "work.steps_mean"],
    ["Steps, 95th percentile", "work.steps_p95"],
  ];
  return rowsTable("Preparation and work per pixel", [
    ["Preparation", of("prepare.ms") === null ? "–" : `${significant(of("prepare.ms"))} ms`],
    ["Memory of prepared maps", bytesText(of("prepare.bytes"))],
    ...work.map(([name, path]): [string, string] => [name, significant(of(path))]),
    ["Covered pixels", (of("work.covered_pixels") ?? 0).toLocaleString("en")],
  ]);
}

function statisticsTables(run: RunData, cell: number): (HTMLElement | null)[] {
  const rows = (prefix: string): [string, string][] =>
    Object.keys(run.cells.numbers)
      .filter((path) => path.startsWith(prefix) && numberOf(run.cells, path, cell) !== null)
      .map((path) => [path.slice(prefix.length).replaceAll("_", " "), numberOf(run.cells, path, cell)!.toLocaleString("en")]);
  return [rowsTable("Pipeline statistics of one draw", rows("pipeline.")), rowsTable("The driver on its compiled stages", rows("executable."))];
}
