// Timing of the pinned cell, or of the best: samples over rounds pass by pass, preparation, pipeline statistics.

import type { App, View } from "../app.ts";
import { axisStyle, Chart, currentInk, intervalLine, type Option, ticked, tooltipStyle } from "../chart.ts";
import { numberOf, type RunData, textOf } from "../data.ts";
import { drawInterval, drawPass, drawTime, spentGroups, stopWord } from "../defaults.ts";
import { outlierWarning } from "../describe.ts";
import { fill, h } from "../dom.ts";
import { groupOf, passFigure, passPath } from "../figures.ts";
import { declared, figureTitle, metricText, shownFigure, shownUnit } from "../metrics.ts";
import { counted, extent, significant } from "../numbers.ts";
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
  return passes.sort(
    (a, b) => Number(b.name === drawPass) - Number(a.name === drawPass) || a.name.localeCompare(b.name),
  );
}

export function timingView(app: App): View {
  const content = h("div", { class: "timing" });
  return {
    name: "timing",
    title: "Timing",
    element: h("section", { class: "view-timing" }, content),
    refresh() {
      const { cell, why } = shownCell(app, (each) => numberOf(app.run().cells, drawTime, each) !== null);
      if (cell < 0) {
        fill(content, why);
        return;
      }
      fill(
        content,
        why,
        passTable(app, cell),
        outlierWarning(app.run().cells, cell),
        ...roundsElements(app, cell),
        h("div", { class: "columns" }, spentTable(app, cell), ...statisticsTables(app.run(), cell)),
      );
    },
  };
}

/** "Time, MAD (ms)": of any pass, as the draw's figures are called less the draw. */
function passTitle(app: App, figure: string): string {
  const { label, unit } = declared(app.data.figures, passPath(drawPass, figure));
  const ofAny = label.replace(/^draw /i, "").replace(/ of the draw$/i, "");
  return figureTitle({ label: ofAny.slice(0, 1).toUpperCase() + ofAny.slice(1), unit });
}

/** A digit more than elsewhere: passes of one cell are compared. */
function passText(unit: string, value: number | null): string {
  return unit === "" ? (value ?? "–").toLocaleString("en") : significant(value, 4);
}

function passTable(app: App, cell: number): HTMLElement {
  const run = app.run();
  const passes = new Set<string>();
  const figures = new Set<string>();
  // In the order of the list, then what it does not declare.
  const paths = [...app.data.figures.map(({ path }) => path), ...Object.keys(run.cells.numbers)];
  for (const path of paths) {
    const found = passFigure(path);
    if (found === null || numberOf(run.cells, path, cell) === null) continue;
    passes.add(found.pass);
    figures.add(found.figure);
  }
  if (passes.size === 0) return h("p", { class: "empty" }, "There are no times of this cell: it was not measured.");
  const stop = textOf(run.cells.words[stopWord], cell);
  const table = h(
    "table",
    { class: "figures" },
    h("caption", {}, "Passes", stop === null ? null : h("span", { class: "muted" }, ` (sampling stopped: ${stop})`)),
    h(
      "thead",
      {},
      h(
        "tr",
        {},
        h("th", {}, "Pass"),
        ...[...figures].map((figure) => h("th", { class: "number" }, passTitle(app, figure))),
      ),
    ),
    h(
      "tbody",
      {},
      ...[...passes].map((pass) =>
        h(
          "tr",
          {},
          h("td", {}, pass),
          ...[...figures].map((figure) =>
            h(
              "td",
              { class: "number" },
              passText(
                declared(app.data.figures, passPath(drawPass, figure)).unit,
                numberOf(run.cells, passPath(pass, figure), cell),
              ),
            ),
          ),
        ),
      ),
    ),
  );
  return h("div", { class: "scroll-x", attrs: { tabindex: 0, role: "region", "aria-label": "Passes" } }, table);
}

/** Quartiles of fewer samples say no more than the samples. */
const minForBox = 5;

/** What is drawn of groups with so many samples. */
function drawnText(groups: readonly Group[]): string {
  const boxed = groups.filter((group) => group.samples >= minForBox).length;
  const box = "Boxes: quartiles; whiskers: least and greatest";
  const line = "Dots: the median; lines: least to greatest";
  if (boxed === groups.length) return `${box}.`;
  return boxed === 0 ? `${line}.` : `${box}. Of fewer than ${minForBox} samples: ${line.toLowerCase()}.`;
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
  const few = groups.map((group) => group.samples < minForBox);
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
  const of = (path: string) => numberOf(app.run().cells, passPath(pass.name, passFigure(path)!.figure), cell);
  const levels = [drawTime, ...drawInterval].flatMap((path) => of(path) ?? []);
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
  option.series.push(...level(of(drawTime), {}), ...drawInterval.flatMap((path) => level(of(path), bound)));
  return option;
}

function groupTooltip(title: string, group: Group): HTMLElement {
  const names = ["least", "lower quartile", "median", "upper quartile", "greatest"];
  const shown = names.flatMap((name, at) => (group.samples < minForBox && at % 2 === 1 ? [] : [{ name, at }]));
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

function spentTable(app: App, cell: number): HTMLElement | null {
  const { cells } = app.run();
  const rows = app.data.figures
    .filter(({ path }) => spentGroups.includes(groupOf(path)))
    .flatMap((figure): [string, string][] => {
      const value = shownFigure(cells, figure)(cell);
      return value === null ? [] : [[figure.label, metricText({ unit: shownUnit(figure.unit) }, value)]];
    });
  return rowsTable("Preparation and work", rows);
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
