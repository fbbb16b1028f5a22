// What to use of a run's settings within limits: the rules are those of docs/report.md, "Advice".

import { type Cells, sortedValues, textOf, valueText, variedAxes } from "./data.ts";
import { advantage, likelyInterval, type Metric, worstOf, wrongHitsMetric } from "./metrics.ts";
import { type SettingPoint, settingPoints } from "./settings.ts";

/** At most so much of what is better the lower it is, at least so much of the others. */
export interface Limit {
  metric: Metric;
  bound: number;
}

export interface Question {
  cost: Metric;
  /** What ranks the settings. */
  error: Metric;
  limits: Limit[];
}

/** A setting by its worst view. */
export interface Candidate extends SettingPoint {
  /** 95 % interval of the cost; of what is counted, not timed, the cost itself. */
  costInterval: [number, number];
  /** In the order of the question's limits. */
  limited: number[];
}

export interface Advice {
  winner: Candidate | null;
  /** How many keep to the limits. */
  kept: number;
  /** Of those the one with the least error, and how many have an error that cannot be told from it. */
  least: Candidate | null;
  asExact: number;
  /** The best of another technique that keeps to the limits. */
  runnerUp: Candidate | null;
  /** Others within the limits that cannot be told apart from the winner by what was asked for. */
  asGood: Candidate[];
  /**
   * With a budget: settings beyond it that keep to the other limits, by ascending cost: the first told to be better than
   * the least error within it (where there is none: than the nearest, if that keeps to them), the others than the one before.
   */
  beyond: Candidate[];
  /** Where nothing keeps to the limits: the one whose largest ratio of a figure to its limit is the least. */
  nearest: Candidate | null;
  /** Settings that keep to all limits, but miss or invent too many hits. */
  refused: number;
}

const maxSteps = 3;
/** What views may differ in and be asked about together: the material, and the side it is seen from. */
const joinedAxes = ["heightmap", "azimuth"];

/** By the axes that the asker chooses, in the order of their values; the key's texts in the order of `axes`. */
export function adviceGroups(
  cells: Cells,
  selection: readonly number[],
): { axes: string[]; groups: { values: (string | null)[]; cells: number[] }[] } {
  const axes = variedAxes(cells).filter((axis) => !joinedAxes.includes(axis));
  const groups = new Map<string, { values: (string | null)[]; cells: number[] }>();
  for (const cell of selection) {
    const values = axes.map((axis) => textOf(cells.axes[axis], cell));
    const key = JSON.stringify(values);
    const group = groups.get(key);
    if (group) group.cells.push(cell);
    else groups.set(key, { values, cells: [cell] });
  }
  const ranks = axes.map((axis) => sortedValues(cells.axes[axis]!).map(valueText));
  const rank = (values: (string | null)[], at: number) => ranks[at]!.indexOf(values[at] ?? "");
  const ordered = [...groups.values()].sort((a, b) =>
    axes.reduce((order, _, at) => order || rank(a.values, at) - rank(b.values, at), 0),
  );
  return { axes, groups: ordered };
}

export function candidates(
  cells: Cells,
  selection: readonly number[],
  question: Question,
): { all: Candidate[]; incomplete: number } {
  const { cost, error, limits } = question;
  const needed = [wrongHitsMetric, ...limits.map(({ metric }) => metric)];
  const { points, incomplete } = settingPoints(cells, selection, cost, error, "worst", needed);
  const worst = (metric: Metric, members: readonly number[]) =>
    worstOf(
      metric.better,
      members.map((cell) => metric.of(cells, cell)!),
    );
  const all = points.map((point) => ({
    ...point,
    costInterval: likelyInterval(
      cost,
      cells,
      point.cells.find((cell) => cost.of(cells, cell) === point.cost)!,
    ) ?? [point.cost, point.cost],
    limited: limits.map(({ metric }) => worst(metric, point.cells)),
  }));
  return { all, incomplete };
}

/** Whether `a` can be told to be better than `b`: by more than both, the relative one of the larger. */
export function tellsBetter(error: Metric, a: number, b: number): boolean {
  if (advantage(error.better, a, b) <= 0) return false;
  const { absolute, relative } = error.tolerance;
  const difference = Math.abs(a - b);
  return (
    difference === Infinity || (difference > absolute && difference > relative * Math.max(Math.abs(a), Math.abs(b)))
  );
}

function sameError(error: Metric, a: Candidate, b: Candidate): boolean {
  return !tellsBetter(error, a.error, b.error) && !tellsBetter(error, b.error, a.error);
}

function sameCost(a: Candidate, b: Candidate): boolean {
  return a.costInterval[0] <= b.costInterval[1] && b.costInterval[0] <= a.costInterval[1];
}

function keeps(limit: Limit, value: number): boolean {
  return advantage(limit.metric.better, value, limit.bound) >= 0;
}

/** How far a value is beyond its limit, as a ratio; at most 1 where it keeps to it. */
export function excess(limit: Limit, value: number): number {
  if (keeps(limit, value)) return 1;
  const ratio = limit.metric.better === "lower" ? value / limit.bound : limit.bound / value;
  return Number.isNaN(ratio) || ratio < 0 ? Infinity : ratio;
}

type Order = (a: Candidate, b: Candidate) => number;

/** With a budget alone the cheapest of those whose error cannot be told from the least; else the cheapest. */
function bestOf(kept: readonly Candidate[], question: Question, byError: Order, byCost: Order): Candidate | null {
  const least = [...kept].sort(byError)[0];
  if (least === undefined) return null;
  const asExact = errorsAreLimited(question)
    ? [...kept]
    : kept.filter((point) => sameError(question.error, point, least));
  return asExact.sort(byCost)[0]!;
}

export const errorsAreLimited = ({ limits }: Question) => limits.some(({ metric }) => metric.role === "error");

/** The limit on the cost. */
export function budgetOf({ cost, limits }: Question): Limit | null {
  return limits.find(({ metric }) => metric.id === cost.id) ?? null;
}

function stepsBeyond(
  counted: readonly Candidate[],
  nearest: Candidate | null,
  question: Question,
  byError: Order,
  byCost: Order,
): Candidate[] {
  const budget = budgetOf(question);
  if (budget === null) return [];
  const keepsOthers = (point: Candidate) =>
    question.limits.every((limit, at) => limit === budget || keeps(limit, point.limited[at]!));
  const keeping = counted.filter(keepsOthers);
  let before = keeping.filter((point) => keeps(budget, point.cost)).sort(byError)[0] ?? null;
  if (nearest !== null && keepsOthers(nearest)) before = nearest;
  const steps: Candidate[] = [];
  for (const point of keeping.filter(({ cost }) => !keeps(budget, cost)).sort(byCost)) {
    if (steps.length === maxSteps) break;
    if (before !== null && !tellsBetter(question.error, point.error, before.error)) continue;
    steps.push(point);
    before = point;
  }
  return steps;
}

/** What to use. Settings that miss or invent too many hits are no advice. */
export function advise(all: readonly Candidate[], question: Question): Advice {
  const { error, limits } = question;
  const byText: Order = (a, b) => (a.setting < b.setting ? -1 : a.setting > b.setting ? 1 : 0);
  const byError: Order = (a, b) => advantage(error.better, b.error, a.error) || a.cost - b.cost || byText(a, b);
  const byCost: Order = (a, b) => a.cost - b.cost || advantage(error.better, b.error, a.error) || byText(a, b);
  const keepsAll = (point: Candidate) => limits.every((limit, at) => keeps(limit, point.limited[at]!));
  const largestExcess = (point: Candidate) =>
    Math.max(0, ...limits.map((limit, at) => excess(limit, point.limited[at]!)));

  const counted = all.filter((point) => point.counts);
  const kept = counted.filter(keepsAll);
  const winner = bestOf(kept, question, byError, byCost);
  const least = [...kept].sort(byError)[0] ?? null;
  const nearest =
    winner === null
      ? ([...counted].sort((a, b) => {
          const [x, y] = [largestExcess(a), largestExcess(b)];
          return (x === y ? 0 : x - y) || byCost(a, b);
        })[0] ?? null)
      : null;
  const isAsGood = (point: Candidate) =>
    winner !== null &&
    point !== winner &&
    sameCost(point, winner) &&
    (errorsAreLimited(question) || sameError(error, point, winner));
  return {
    winner,
    kept: kept.length,
    least,
    asExact: least === null ? 0 : kept.filter((point) => sameError(error, point, least)).length,
    runnerUp: bestOf(
      kept.filter(({ technique }) => technique !== winner?.technique),
      question,
      byError,
      byCost,
    ),
    asGood: kept.filter(isAsGood).sort(byError),
    beyond: stepsBeyond(counted, nearest, question, byError, byCost),
    nearest,
    refused: all.filter((point) => !point.counts && keepsAll(point)).length,
  };
}
