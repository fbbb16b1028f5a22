// What changed between runs, verdict by verdict.

import type { App, View } from "../app.ts";
import { axisStyle, Chart, currentInk, insideZoom, type Option, ticked, tooltipStyle } from "../chart.ts";
import {
  type CellVerdict,
  type ComparisonResult,
  type Json,
  numberOf,
  type QualityVerdict,
  settingOf,
  type Verdict,
  viewLabel,
  viewOf,
} from "../data.ts";
import { drawTime } from "../defaults.ts";
import { factList, settingElement, sign, warning } from "../describe.ts";
import { fill, h } from "../dom.ts";
import { declared, figureTitle } from "../metrics.ts";
import { changeText, counted, extent, significant } from "../numbers.ts";
import { linearTicks, logRange, logTicks, tickText } from "../scales.ts";
import { type Column, identity, sortRows, Table } from "../table.ts";

/** In the order in which they ask for attention. */
const verdicts: Verdict[] = ["slower", "faster", "undecided", "same"];
const qualities: QualityVerdict[] = ["worse", "mixed", "better", "not comparable", "same"];
/** Those with a button of their own. */
const changedQualities: string[] = ["worse", "mixed", "better"];

export function changesView(app: App): View | null {
  const { comparison } = app.data;
  if (comparison === null) return null;
  const content = comparison.result === null ? null : resultElement(app, comparison.result);
  return {
    name: "changes",
    title: "What changed",
    element: h(
      "section",
      { class: "view-changes" },
      h(
        "p",
        { class: "sides" },
        h("span", { class: "muted" }, "From "),
        comparison.base.join(", "),
        h("span", { class: "muted" }, " to "),
        comparison.new.join(", "),
      ),
      comparison.failure === null ? null : warning(`These runs were not compared: ${comparison.failure}`),
      content?.element ?? null,
    ),
    refresh: () => content?.refresh(),
  };
}

function isShown(cell: CellVerdict, wanted: string): boolean {
  return (
    wanted === "" || cell.verdict === wanted || (changedQualities.includes(wanted) && cell.quality.verdict === wanted)
  );
}

function resultElement(app: App, result: ComparisonResult): { element: HTMLElement; refresh(): void } {
  const counts = h("div", { class: "verdicts" });
  const chart = new Chart("New time over base time of every cell", (data) => {
    const cell = (data as { cell?: CellVerdict } | null)?.cell;
    if (cell) app.update({ pin: cell.cell });
  });
  const table = new Table<CellVerdict>({
    label: "Compared cells",
    onSort: (id) => app.update({ sort: app.state.sort === id ? `-${id}` : id }),
    onRow: (row) => app.update({ pin: row.cell }),
    rowClass: (row) => `pinnable${row.cell === app.state.pin ? " pinned" : ""}`,
  });
  const columns = verdictColumns(app);
  return {
    element: h(
      "div",
      {},
      counts,
      factList(result.notices),
      chart.element,
      table.element,
      uncomparedElement(result),
      evidenceElement(result),
    ),
    refresh() {
      const ids = new Set(app.selection().map((cell) => app.run().cells.id[cell]!));
      const inFilter = result.cells.filter((cell) => ids.has(cell.cell));
      fill(counts, ...verdictButtons(app, inFilter));
      const shown = inFilter.filter((cell) => isShown(cell, app.state.verdict));
      const sorted = app.state.sort === "" ? byAttention(shown) : sortRows(shown, columns, app.state.sort);
      chart.show(() => ratioOption(app, shown, result));
      table.show(sorted, columns, app.state.sort);
    },
  };
}

function byAttention(cells: readonly CellVerdict[]): CellVerdict[] {
  const size = (cell: CellVerdict) => Math.abs(Math.log(cell.ratio ?? 1));
  return [...cells].sort((a, b) => verdicts.indexOf(a.verdict) - verdicts.indexOf(b.verdict) || size(b) - size(a));
}

function verdictButtons(app: App, cells: readonly CellVerdict[]): HTMLElement[] {
  const count = (wanted: string) => cells.filter((cell) => isShown(cell, wanted)).length;
  const button = (wanted: string, label: string) =>
    h(
      "button",
      {
        class: `verdict ${wanted}`,
        attrs: { type: "button", "data-verdict": wanted, "aria-pressed": String(app.state.verdict === wanted) },
        on: { click: () => app.update({ verdict: app.state.verdict === wanted ? "" : wanted }) },
      },
      h("b", {}, String(count(wanted))),
      label,
    );
  return [
    button("", "compared"),
    ...verdicts.map((verdict) => button(verdict, verdict)),
    ...changedQualities.map((quality) => button(quality, `${quality} quality`)),
  ];
}

function verdictColour(app: App, verdict: Verdict): string {
  const light: Record<Verdict, string> = {
    slower: "#c85200",
    faster: "#0072b2",
    undecided: "#8a8f98",
    same: "#b9bdc4",
  };
  const dark: Record<Verdict, string> = { slower: "#f2854a", faster: "#4ea6e6", undecided: "#8b93a0", same: "#565d68" };
  return (app.theme === "dark" ? dark : light)[verdict];
}

const verdictSymbols: Record<Verdict, string> = {
  slower: "triangle",
  faster: "path://M5 9.3L0.2 0.8H9.8Z",
  undecided: "diamond",
  same: "circle",
};

/** Ratio over the base's time: whether it is the long draws that moved. */
function ratioOption(app: App, cells: readonly CellVerdict[], result: ComparisonResult): Option {
  const ink = currentInk();
  const of = app.run().cells;
  const index = new Map(of.id.map((id, at) => [id, at]));
  const threshold = result.threshold ?? 0;
  const level = (value: number) => ({ yAxis: value, lineStyle: { color: ink.muted, type: "dashed", width: 1 } });
  const data = (verdict: Verdict) =>
    cells
      .filter((cell) => cell.verdict === verdict && cell.ratio !== null)
      .map((cell) => ({
        value: [numberOf(of, drawTime, index.get(cell.cell) ?? -1) ?? 0, cell.ratio!],
        cell,
      }))
      .filter(({ value }) => value[0]! > 0);
  const shown = verdicts.flatMap(data).map(({ value }) => value as [number, number]);
  const x = logRange(shown.map(([ms]) => ms));
  const reach = Math.exp(
    1.15 * extent([2 * Math.log1p(threshold), ...shown.map(([, ratio]) => Math.abs(Math.log(ratio)))])[1],
  );
  // Small changes read best on a linear scale; doubling and halving lie as far from 1.
  const isSmall = reach < 2;
  const y = { ...axisStyle(ink, "Change of time"), nameGap: ink.size * 4.4, type: isSmall ? "value" : "log" };
  return {
    grid: { left: ink.size * 6, right: ink.size * 2, top: ink.size * 1.5, bottom: ink.size * 4 },
    xAxis: ticked(
      {
        ...axisStyle(ink, figureTitle(declared(app.data.figures, drawTime))),
        type: "log",
        min: x.min,
        max: x.max,
        nameGap: ink.size * 2.2,
      },
      logTicks,
      tickText,
    ),
    yAxis: ticked(
      { ...y, min: isSmall ? 2 - reach : 1 / reach, max: reach },
      isSmall ? linearTicks : powersOfTwo,
      (value) => changeText(value),
    ),
    dataZoom: insideZoom(0),
    tooltip: {
      ...tooltipStyle(ink),
      formatter: (parameters: { data?: { cell?: CellVerdict } }) =>
        parameters.data?.cell ? verdictTooltip(app, parameters.data.cell) : "",
    },
    series: [...verdicts].reverse().map((verdict) => ({
      type: "scatter",
      data: data(verdict),
      symbol: verdictSymbols[verdict],
      symbolSize: ink.size * 0.8,
      itemStyle: { color: verdictColour(app, verdict), borderColor: ink.panel, borderWidth: 1 },
      markLine: {
        silent: true,
        symbol: "none",
        label: { show: false },
        data: [level(1 + threshold), level(1 / (1 + threshold))],
      },
    })),
  };
}

/** Doublings and halvings. */
function powersOfTwo(from: number, to: number): number[] {
  const [least, greatest] = [Math.ceil(Math.log2(from)), Math.floor(Math.log2(to))];
  if (greatest - least < 1) return logTicks(from, to);
  return Array.from({ length: greatest - least + 1 }, (_, at) => 2 ** (least + at));
}

function techniqueIn(id: string): string {
  return settingOf(id).split(" ")[0] ?? "";
}

function intervalText(cell: CellVerdict): string {
  const [low, high] = cell.ci95;
  return low === null || high === null ? "–" : `${changeText(low)} to ${changeText(high)}`;
}

function verdictTooltip(app: App, cell: CellVerdict): HTMLElement {
  return h(
    "div",
    { class: "tip" },
    settingElement(app, settingOf(cell.cell), techniqueIn(cell.cell)),
    h("div", { class: "muted" }, viewOf(cell.cell)),
    h(
      "dl",
      {},
      h("dt", {}, cell.verdict),
      h("dd", {}, changeText(cell.ratio)),
      h("dt", {}, "95 % interval"),
      h("dd", {}, intervalText(cell)),
    ),
    h("div", { class: "wrap" }, cell.reason),
  );
}

/** The verdict with the change that weighs most; all of them when hovered over. */
function qualityElement({ verdict, changes }: CellVerdict["quality"]): HTMLElement | string {
  if (changes.length === 0) return verdict;
  const decided = changes.filter((change) => change.decides).length;
  const first = decided > 0 ? `: ${changes[0]!.text}` : "";
  const more = decided > 1 ? `, and ${decided - 1} more` : "";
  return h(
    "span",
    { class: `quality ${verdict}`, title: changes.map((change) => change.text).join("\n") },
    `${verdict}${first}${more}`,
  );
}

function verdictColumns(app: App): Column<CellVerdict>[] {
  const { cells } = app.run();
  const index = new Map(cells.id.map((id, at) => [id, at]));
  return [
    identity({
      id: (row) => row.cell,
      content: (row) => settingElement(app, settingOf(row.cell), techniqueIn(row.cell)),
      below: (row) => {
        const at = index.get(row.cell);
        return [at === undefined ? viewOf(row.cell) : viewLabel(cells, at)];
      },
    }),
    {
      id: "verdict",
      title: "Verdict",
      number: false,
      key: (row) => verdicts.indexOf(row.verdict),
      content: (row) => h("span", { class: `verdict-word ${row.verdict}` }, row.verdict),
    },
    {
      id: "ratio",
      title: "Time",
      help: "New time against base time",
      number: true,
      key: (row) => row.ratio,
      content: (row) => changeText(row.ratio),
    },
    { id: "interval", title: "95 % interval", number: true, key: (row) => row.ci95[0], content: intervalText },
    {
      id: "quality",
      title: "Quality",
      number: false,
      key: (row) => qualities.indexOf(row.quality.verdict),
      content: (row) => qualityElement(row.quality),
    },
    {
      id: "visible",
      title: "Visible",
      help: "The smallest change that this evidence would show in 99 of 100 cases",
      number: true,
      key: (row) => row.visible,
      content: (row) => (row.visible === null ? "–" : `${significant(100 * row.visible, 2)} %`),
    },
    { id: "why", title: "Why", number: false, key: (row) => row.reason, content: (row) => row.reason },
  ];
}

function uncomparedElement(result: ComparisonResult): HTMLElement | null {
  if (result.uncompared.length === 0) return null;
  const most = 200;
  const failed = result.uncompared.some((cell) => cell.failed_now);
  return h(
    "details",
    { class: failed ? "warning" : "fact", attrs: { open: failed } },
    h("summary", {}, failed ? sign() : null, `${counted(result.uncompared.length, "cell")} not compared`),
    h(
      "ul",
      {},
      ...result.uncompared
        .slice(0, most)
        .map((cell) =>
          h(
            "li",
            {},
            cell.failed_now ? h("b", {}, "failed now: ") : null,
            h("code", {}, cell.cell),
            ": ",
            h("span", { class: "reason" }, cell.reason),
          ),
        ),
    ),
    result.uncompared.length > most ? h("p", { class: "muted" }, `and ${result.uncompared.length - most} more`) : null,
  );
}

function evidenceElement(result: ComparisonResult): HTMLElement {
  const rows = (value: Json, path: string): [string, string][] =>
    value !== null && typeof value === "object"
      ? Object.entries(value).flatMap(([key, item]) => rows(item, path === "" ? key : `${path} › ${key}`))
      : [[path.replaceAll("_", " "), value === null ? "unknown" : String(value)]];
  return h(
    "details",
    { class: "evidence" },
    h("summary", {}, "What this rests on"),
    h(
      "p",
      {},
      `A change of time counts from ${significant(100 * (result.threshold ?? 0), 2)} % on. The unit of evidence is the ${result.unit.replace(/s$/, "")}.`,
    ),
    h("p", {}, "Quality is better or worse where one of these changes by more than its tolerance:"),
    h(
      "ul",
      {},
      ...result.deciding_figures.map(({ figure, tolerance }) => h("li", {}, h("code", {}, figure), `: ${tolerance}`)),
    ),
    h(
      "table",
      { class: "figures" },
      h(
        "tbody",
        {},
        ...rows(result.environment, "").map(([key, text]) =>
          h("tr", {}, h("td", {}, key), h("td", { class: "value" }, text)),
        ),
      ),
    ),
  );
}
