// Timing of the pinned cell, or of the best: samples over rounds pass by pass, preparation, pipeline statistics.

import type { App, View } from "../app.ts";
import { axisStyle, Chart, currentInk, intervalLine, type Option, ticked, tooltipStyle } from "../chart.ts";
import { numberOf, type RunData, textOf } from "../data.ts";
import { outlierWarning } from "../describe.ts";
import { fill, h } from "../dom.ts";
import { bytesText, counted, extent, significant } from "../numbers.ts";
import { linearTicks, tickText } from "../scales.ts";
import { shownCell } from "./shown_cell.ts";

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
      const { cell, why } = shownCell(app, (each) => numberOf(app.run().cells, "time.draw.median_ms", each) !== null);
      if (cell < 0) {
        fill(content, why);
        return;
      }
      fill(
        content,
        why,
        passTable(app.run(), cell),
        outlierWarning(app.run().cells, cell),
        ...roundsElements(app, cell),
        h("div", { class: "columns" }, preparationTable(app.run(), cell), ...statisticsTables(app.run(), cell)),
      );
    },
  };
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
      .filter(
        (pass): pass is string => pass !== undefined && numberOf(run.cells, `time.${pass}.median_ms`, cell) !== null,
      ),
  );
  if (passes.size === 0) return h("p", { class: "empty" }, "There are no times of this cell: it was not measured.");
  const stop = textOf(run.cells.words["time.stop"], cell);
  const table = h(
    "table",
    { class: "figures" },
    h("caption", {}, "Passes", stop === null ? null : h("span", { class: "muted" }, ` (sampling stopped: ${stop})`)),
    h(
      "thead",
      {},
      h("tr", {}, h("th", {}, "Pass"), ...figures.map(([, title]) => h("th", { class: "number" }, title))),
    ),
    h(
      "tbody",
      {},
      ...[...passes].map((pass) =>
        h(
          "tr",
          {},
          h("td", {}, pass),
          ...figures.map(([key]) =>
            h("td", { class: "number" }, figureText(key, numberOf(run.cells, `time.${pass}.${key}`, cell))),
          ),
        ),
      ),
    ),
  );
  return h("div", { class: "scroll-x", attrs: { tabindex: 0, role: "region", "aria-label": "Passes" } }, table);
}

/** Quartiles of fewer samples say no more than the samples. */
const fewestForBox = 5;

/** What is drawn of groups with so many samples. */
function drawnText(groups: readonly Group[]): string {
  const boxed = groups.filter((group) => group.samples >= fewestForBox).length;
  const box = "Boxes: quartiles; whiskers: least and greatest";
  const line = "Dots: the median; lines: least to greatest";
  if (boxed === groups.length) return `${box}.`;
  return boxed === 0 ? `${line}.` : `${box}. Of fewer than ${fewestForBox} samples: ${line.toLowerCase()}.`;
}

/** A chart over rounds for each pass that was sampled in rounds, and one for all that were before them. */
function roundsElements(app: App, cell: number): HTMLElement[] {
  const passes = passesOf(app.run(), cell);
  const before = passes.filter((pass) => pass.groups.length === 1);
  const elements = passes
    .filter((pass) => pass.groups.length > 1)
    .map((pass) =>
      figure(
        pass.name,
        `${sampledText(pass)}. ${drawnText(pass.groups)} Across: the median and its 95 % interval.`,
        roundsOption(app, pass, cell),
      ),
    );
  if (before.length > 0) {
    elements.push(
      figure(
        "Before the rounds",
        `${before.map((pass) => `${pass.name}: ${counted(pass.groups[0]!.samples, "sample")}`).join(", ")}. ${drawnText(before.map((pass) => pass.groups[0]!))}`,
        beforeOption(before),
      ),
    );
  }
  return elements;
}

function sampledText(pass: Pass): string {
  const samples = pass.groups.reduce((sum, group) => sum + group.samples, 0);
  const together = pass.groups[1]!.firstRound - pass.groups[0]!.firstRound > 1;
  return `${counted(samples, "sample")} in ${together ? `${pass.groups.length} groups of rounds` : counted(pass.groups.length, "round")}`;
}

function figure(title: string, words: string, option: Option): HTMLElement {
  const chart = new Chart(`Samples: ${title}`);
  chart.show(() => option);
  return h(
    "figure",
    {},
    h("figcaption", {}, h("b", {}, title), h("span", { class: "muted" }, ` ${words}`)),
    chart.element,
  );
}

function boxOption(
  names: string[],
  axisName: string,
  groups: Group[],
  titles: string[],
  levels: number[] = [],
): Option & { series: object[] } {
  const ink = currentInk();
  const [least, greatest] = extent([...groups.flatMap((group) => group.ms), ...levels]);
  const room = 0.08 * (greatest - least) || 0.08 * greatest || 1;
  const few = groups.map((group) => group.samples < fewestForBox);
  return {
    grid: { left: ink.size * 5, right: ink.size * 2, top: ink.size, bottom: ink.size * 3.6 },
    xAxis: [
      { ...axisStyle(ink, axisName), type: "category", data: names, nameGap: ink.size * 2, splitLine: { show: false } },
      { type: "value", min: -0.5, max: names.length - 0.5, show: false },
    ],
    yAxis: ticked(
      { ...axisStyle(ink, "ms"), type: "value", min: least - room, max: greatest + room, nameGap: ink.size * 3.6 },
      linearTicks,
      tickText,
    ),
    tooltip: {
      ...tooltipStyle(ink),
      formatter: ({ dataIndex }: { dataIndex: number }) => groupTooltip(titles[dataIndex]!, groups[dataIndex]!),
    },
    series: [
      {
        type: "boxplot",
        data: groups.map((group, at) => (few[at] ? group.ms.map(() => NaN) : group.ms)),
        itemStyle: { color: ink.panel, borderColor: ink.text, borderWidth: 1.2 },
        boxWidth: [4, 26],
      },
      intervalLine(
        groups.flatMap(({ ms }, at) =>
          few[at]
            ? [
                [at, ms[0]!],
                [at, ms[4]!],
                [null, null],
              ]
            : [],
        ),
        ink.text,
      ),
      {
        type: "scatter",
        data: groups.map((group, at) => [at, few[at] ? group.ms[2]! : NaN]),
        symbolSize: ink.size * 0.6,
        itemStyle: { color: ink.text, opacity: 1 },
      },
    ],
  };
}

function beforeOption(passes: Pass[]): Option {
  const names = passes.map((pass) => pass.name);
  return boxOption(
    names,
    "",
    passes.map((pass) => pass.groups[0]!),
    names,
  );
}

function roundsOption(app: App, pass: Pass, cell: number): Option {
  const ink = currentInk();
  const of = (key: string) => numberOf(app.run().cells, `time.${pass.name}.${key}`, cell);
  const levels = ["median_ms", "ci95_ms.low", "ci95_ms.high"].flatMap((key) => of(key) ?? []);
  const rounds = pass.groups.map((group) => String(group.firstRound));
  const option = boxOption(
    rounds,
    "round",
    pass.groups,
    rounds.map((round) => `Round ${round}`),
    levels,
  );
  const level = (value: number | null, style: object) =>
    value === null
      ? []
      : [
          {
            type: "line",
            data: [
              [-0.5, value],
              [rounds.length - 0.5, value],
            ],
            xAxisIndex: 1,
            symbol: "none",
            silent: true,
            lineStyle: { color: ink.accent, width: 1.2, ...style },
            z: 1,
          },
        ];
  const bound = { type: "dashed", opacity: 0.7 };
  option.series.push(
    ...level(of("median_ms"), {}),
    ...level(of("ci95_ms.low"), bound),
    ...level(of("ci95_ms.high"), bound),
  );
  return option;
}

function groupTooltip(title: string, group: Group): HTMLElement {
  const names = ["least", "lower quartile", "median", "upper quartile", "greatest"];
  const shown = names.flatMap((name, at) => (group.samples < fewestForBox && at % 2 === 1 ? [] : [{ name, at }]));
  return h(
    "div",
    { class: "tip" },
    h("b", {}, title),
    h("div", { class: "muted" }, counted(group.samples, "sample")),
    h(
      "dl",
      {},
      ...shown.flatMap(({ name, at }) => [h("dt", {}, name), h("dd", {}, `${significant(group.ms[at], 4)} ms`)]),
    ),
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
  if (of("prepare.ms") === null && of("work.covered_pixels") === null) return null;
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
      .map((path) => [
        path.slice(prefix.length).replaceAll("_", " "),
        numberOf(run.cells, path, cell)!.toLocaleString("en"),
      ]);
  return [
    rowsTable("Pipeline statistics of one draw", rows("pipeline.")),
    rowsTable("The driver on its compiled stages", rows("executable.")),
  ];
}
