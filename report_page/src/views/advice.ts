// What should I use? For a budget or a limit on the error, per view angle: what wins, in words.

import { type Advice, advise, type Goal } from "../advice.ts";
import type { App, View } from "../app.ts";
import { leadingNumber, sortedValues, textOf, valueText, viewOf } from "../data.ts";
import { settingElement } from "../describe.ts";
import { choose, fill, h, segments } from "../dom.ts";
import { costMetrics, errorMetrics, type Metric, metricById, metricText, metricTitle } from "../metrics.ts";
import { counted, median, significant } from "../numbers.ts";
import { type SettingPoint, type SettingPoints, settingPoints } from "../settings.ts";

interface Group {
  title: string;
  points: SettingPoints;
}

const angleAxis = "view_angle";

/** Settings by view angle, each by its worst view there: a promise must hold in all of them. */
function groupsOf(app: App, cost: Metric, error: Metric): Group[] {
  const { cells } = app.run();
  const column = cells.axes[angleAxis];
  const angles = column ? sortedValues(column).map(valueText) : [];
  return angles
    .map((angle) => ({ angle, members: app.measured().filter((cell) => textOf(column, cell) === angle) }))
    .filter(({ members }) => members.length > 0)
    .map(({ angle, members }) => ({
      title: leadingNumber(Number(angle)) === 0 ? "Head-on (0°)" : `At ${angle}°`,
      points: settingPoints(cells, members, cost, error, "worst"),
    }));
}

/** Two significant digits, so that a goal that nobody chose reads well. */
function rounded(value: number): number {
  return value === 0 ? 0 : Number(value.toPrecision(2));
}

function defaultGoal(values: number[]): number {
  return rounded(median(values.filter((value) => value > 0)) ?? 1);
}

export function adviceView(app: App): View {
  const { cells } = app.run();
  const errors = errorMetrics(cells);
  const costs = costMetrics(cells);
  const options = (metrics: Metric[]) => metrics.map((metric) => ({ value: metric.id, label: metricTitle(metric) }));
  const goal = segments(
    "Goal",
    [
      { value: "budget", label: "I have a budget" },
      { value: "limit", label: "The error may be at most" },
    ],
    (value) => app.update({ goal: value as "budget" | "limit" }),
  );
  const amount = h("input", {
    attrs: { type: "number", min: 0, step: "any", "aria-label": "How much" },
    on: {
      input: () => {
        const value = amount.value === "" ? null : Number(amount.value);
        const usable = value !== null && Number.isFinite(value) && value >= 0 ? value : null;
        app.update(app.state.goal === "budget" ? { budget: usable } : { limit: usable });
      },
    },
  });
  const unit = h("span", { class: "unit" });
  const cost = choose("Cost", options(costs), "", (value) => app.update({ cost: value, budget: null }));
  const error = choose("Error", options(errors), "", (value) => app.update({ error: value, limit: null }));
  const answers = h("div", { class: "answers" });
  const element = h(
    "section",
    { class: "view-advice" },
    h(
      "div",
      { class: "controls" },
      goal.element,
      h("label", { class: "amount" }, amount, unit),
      cost.element,
      error.element,
    ),
    answers,
    h(
      "p",
      { class: "note" },
      "A setting counts by its worst view of those shown at that angle, and only where it was measured in all of them. Settings with missed and false hits above 0.5 % of the footprint are no advice: discarding hard pixels wins nothing.",
    ),
  );

  return {
    name: "advice",
    title: "What should I use?",
    element,
    refresh() {
      const costMetric = metricById(costs, app.state.cost);
      const errorMetric = metricById(errors, app.state.error);
      goal.set(app.state.goal);
      if (costMetric === null || errorMetric === null) {
        fill(answers, h("p", {}, "No cell of this run was measured, so that there is no advice."));
        return;
      }
      cost.select.value = costMetric.id;
      error.select.value = errorMetric.id;
      const groups = groupsOf(app, costMetric, errorMetric);
      const points = groups.flatMap((group) => group.points.points);
      const target = goalOf(app, points);
      const wanted = target.kind === "budget" ? target.cost : target.error;
      if (document.activeElement !== amount) amount.value = String(wanted);
      unit.textContent = (target.kind === "budget" ? costMetric : errorMetric).unit;
      fill(answers, ...groups.map((group) => answerElement(app, group, target, costMetric, errorMetric)));
    },
  };
}

function goalOf(app: App, points: SettingPoint[]): Goal {
  return app.state.goal === "budget"
    ? { kind: "budget", cost: app.state.budget ?? defaultGoal(points.map((point) => point.cost)) }
    : { kind: "limit", error: app.state.limit ?? defaultGoal(points.map((point) => point.error)) };
}

function goalWords(goal: Goal, cost: Metric, error: Metric): string {
  return goal.kind === "budget"
    ? `within ${metricText(cost, goal.cost)}`
    : `with an error of at most ${metricText(error, goal.error)}`;
}

function answerElement(app: App, group: Group, goal: Goal, cost: Metric, error: Metric): HTMLElement {
  const advice = advise(group.points.points, goal);
  const views = new Set(
    group.points.points.flatMap((point) => point.cells.map((cell) => viewOf(app.run().cells.id[cell]!))),
  );
  return h(
    "article",
    { class: "answer" },
    h("h3", {}, group.title, h("span", { class: "muted" }, `, ${goalWords(goal, cost, error)}`)),
    ...answerWords(app, advice, goal, cost, error),
    views.size > 1 ? h("p", { class: "muted small" }, `Worst of ${views.size} views.`) : null,
    group.points.incomplete > 0
      ? h(
          "p",
          { class: "muted small" },
          `${counted(group.points.incomplete, "setting")} left out: not measured in all of these views.`,
        )
      : null,
  );
}

function pinnable(app: App, point: SettingPoint): HTMLElement {
  return h(
    "button",
    {
      class: "link",
      title: "Pin it",
      attrs: { type: "button" },
      on: { click: () => app.update({ pin: app.run().cells.id[point.cells[0]!]! }) },
    },
    settingElement(app, point.setting, point.technique),
  );
}

function answerWords(app: App, advice: Advice, goal: Goal, cost: Metric, error: Metric): HTMLElement[] {
  const { winner, runnerUp, nearest } = advice;
  if (winner === null) {
    if (nearest === null) return [h("p", {}, "Nothing here finds enough of its hits to be advised.")];
    const reach =
      goal.kind === "budget"
        ? `the cheapest takes ${metricText(cost, nearest.cost)}`
        : `the best reaches ${metricText(error, nearest.error)}`;
    return [h("p", {}, "Nothing does that; ", reach, ": ", pinnable(app, nearest), ".")];
  }
  const words = [
    h(
      "p",
      { class: "winner" },
      "Use ",
      pinnable(app, winner),
      `: ${errorWords(error, winner.error)}, ${costWords(cost, winner.cost)}.`,
    ),
  ];
  if (runnerUp !== null) {
    words.push(
      h(
        "p",
        { class: "runner-up" },
        "Of the other techniques, the best is ",
        pinnable(app, runnerUp),
        `: ${comparedWords(goal, winner, runnerUp, cost, error)}.`,
      ),
    );
  } else {
    words.push(h("p", { class: "runner-up" }, "No other technique does it."));
  }
  return words;
}

/** "99 % of its pixels lie within 0.031 texels" */
function errorWords(error: Metric, value: number): string {
  const percentile = /\.p(\d+)$/.exec(error.id);
  if (percentile) {
    const bound = value === 0 ? "have no error" : `are within ${metricText(error, value)}`;
    return `${percentile[1]} % of its pixels ${bound}`;
  }
  return `${error.label} ${metricText(error, value)}`;
}

function costWords(cost: Metric, value: number): string {
  if (cost.id === "time.draw.median_ms") return `in ${metricText(cost, value)}`;
  return `at ${metricText(cost, value)}${cost.unit === "" ? ` ${cost.label.toLowerCase()}` : ""}`;
}

/** " (2.7 times the error)" */
function timesText(value: number, from: number, what: string): string {
  if (value <= 0 || from <= 0) return "";
  const times = value / from;
  return times < 1.05 ? ` (nearly the same ${what})` : ` (${significant(times, 2)} times the ${what})`;
}

function comparedWords(goal: Goal, winner: SettingPoint, other: SettingPoint, cost: Metric, error: Metric): string {
  if (goal.kind === "budget") {
    return `${metricText(error, other.error)}${timesText(other.error, winner.error, "error")} ${costWords(cost, other.cost)}`;
  }
  return `${metricText(cost, other.cost)}${timesText(other.cost, winner.cost, "cost")}, ${errorWords(error, other.error)}`;
}
