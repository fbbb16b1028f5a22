// What should I use? Within a budget and limits on errors, per kind of view: what to use, in words.

import {
  type Advice,
  advise,
  budgetOf,
  adviceGroups,
  type Candidate,
  candidates,
  errorsAreLimited,
  excess,
  type Limit,
  type Question,
} from "../advice.ts";
import type { App, View } from "../app.ts";
import { axisValueText, leadingNumber, numberOf, textOf, viewOf } from "../data.ts";
import { coveredPixels, outsidePixels, timePerPixel, usualCost, usualError, usualQuality } from "../defaults.ts";
import { settingElement, warning } from "../describe.ts";
import { choose, fill, h } from "../dom.ts";
import { groupedChoices } from "../figures.ts";
import { costMetrics, declared, errorMetrics, type Metric, metricById, metricText, metricTitle } from "../metrics.ts";
import { counted, extent, median, significant } from "../numbers.ts";
import {
  comparedWords,
  costWords,
  errorWords,
  inSentence,
  labelled,
  lessText,
  timesText,
  toleranceWords,
} from "./advice_words.ts";
import { truthNote } from "../truth.ts";
import { LimitFields } from "./limits.ts";

const maxGroups = 24;
const maxNamed = 3;

interface Group {
  title: string;
  all: Candidate[];
  incomplete: number;
  views: number;
}

const sentence = (text: string) => text.slice(0, 1).toUpperCase() + text.slice(1);

function groupTitle(axes: string[], values: (string | null)[]): string {
  const texts = axes.flatMap((axis, at) => {
    const value = values[at]!;
    if (value === null) return [];
    if (axis !== "view_angle") return [axisValueText(axis, value)];
    return [leadingNumber(Number(value)) === 0 ? "head-on (0°)" : `at ${value}°`];
  });
  const title = texts.join(", ") || "in all views";
  return sentence(title);
}

function groupsOf(app: App, question: Question): Group[] {
  const { cells } = app.run();
  const { axes, groups } = adviceGroups(cells, app.measured());
  // Where the camera was swept, its angle is what people look for first.
  const ordered = [...axes].sort((a, b) => Number(b === "view_angle") - Number(a === "view_angle"));
  return groups.map((group) => ({
    title: groupTitle(
      ordered,
      ordered.map((axis) => group.values[axes.indexOf(axis)]!),
    ),
    ...candidates(cells, group.cells, question),
    views: new Set(group.cells.map((cell) => viewOf(cells.id[cell]!))).size,
  }));
}

/** Two significant digits, so that a budget that nobody chose reads well. */
function usualBudget(groups: Group[]): number {
  const costs = groups.flatMap(({ all }) => all.map(({ cost }) => cost)).filter((cost) => cost > 0);
  return Number((median(costs) ?? 1).toPrecision(2));
}

export function adviceView(app: App): View {
  const { cells } = app.run();
  const errors = errorMetrics(app.data.figures, cells);
  const costs = costMetrics(app.data.figures, cells);
  const cost = choose("Cost", groupedChoices(costs, metricTitle), "", (value) =>
    app.update({ cost: value, budget: null }),
  );
  const error = choose("Better by", groupedChoices(errors, metricTitle), "", (value) => app.update({ error: value }));
  const fields = new LimitFields(app, [...errors, ...costs]);
  const caution = h("div", { class: "caution" });
  const answers = h("div", { class: "answers" });
  const more = h("p", { class: "note" });
  const against = h("p", { class: "note" });
  const element = h(
    "section",
    { class: "view-advice" },
    h("div", { class: "controls" }, error.element, cost.element),
    fields.element,
    caution,
    answers,
    more,
    against,
    h(
      "p",
      { class: "note" },
      h(
        "span",
        {},
        "There is one answer for each camera, resolution and other axis of the view, and a setting counts by its worst height map and azimuth there, only where it was measured in all of them. Settings with missed and false hits above 0.5 % of the footprint are no advice: discarding hard pixels wins nothing.",
      ),
      h(
        "span",
        {},
        "With a budget alone the best within it is advised, or the cheapest of those that are as good; with a limit on an error the cheapest that keeps to all limits. Times are as good as equal where their 95 % intervals overlap; errors where they differ by no more than verdicts of quality ask for.",
      ),
    ),
  );

  return {
    name: "advice",
    title: "What should I use?",
    element,
    refresh() {
      const costMetric = metricById(costs, app.state.cost, ...usualCost);
      const errorMetric = metricById(errors, app.state.error, ...usualQualityOf(app));
      caution.hidden = true;
      if (costMetric === null || errorMetric === null) {
        fill(answers, h("p", {}, "No cell of this run was measured, so that there is no advice."));
        return;
      }
      cost.select.value = costMetric.id;
      error.select.value = errorMetric.id;
      const limits: Limit[] = [...errors, ...costs]
        .filter(({ id }) => id !== costMetric.id && Object.hasOwn(app.state.limits, id))
        .map((metric) => ({ metric, bound: app.state.limits[metric.id]! }));
      const ask = (all: Limit[]): Question => ({ cost: costMetric, error: errorMetric, limits: all });
      const budget = app.state.budget ?? (limits.length > 0 ? null : usualBudget(groupsOf(app, ask([]))));
      const question = ask(budget === null ? limits : [{ metric: costMetric, bound: budget }, ...limits]);
      const groups = groupsOf(app, question);
      fields.refresh(question, budget, usualError);
      const words = cautionWords(app, errorMetric, [...errors, ...costs]);
      caution.hidden = words.length === 0;
      fill(caution, warning(words.join(" ")));
      fill(against, truthNote(app.run(), errorMetric));
      fill(answers, ...groups.slice(0, maxGroups).map((group) => answerElement(app, group, question)));
      fill(
        more,
        groups.length > maxGroups
          ? `Showing ${maxGroups} of ${counted(groups.length, "answer")}: filter to see the others.`
          : null,
      );
    },
  };
}

/**
 * Over the footprint, unless some picture has no figures there: what is ranked is alike in all. Runs of version 0.1.0 have
 * none.
 */
function usualQualityOf(app: App): string[] {
  const { cells } = app.run();
  const [overFootprint, whole] = usualQuality;
  const lacks = app
    .measured()
    .some((cell) => numberOf(cells, whole!, cell) !== null && numberOf(cells, overFootprint!, cell) === null);
  return lacks ? usualQuality.slice(1) : usualQuality;
}

/** What has to be said of the question: limits that this run cannot keep, and an error that counts what nobody asked for. */
function cautionWords(app: App, error: Metric, known: readonly Metric[]): string[] {
  const { cells } = app.run();
  const unknown = Object.keys(app.state.limits).filter((path) => !known.some(({ id }) => id === path));
  const words = unknown.map((path) => `No measured cell of this run has ${path}: the limit on it is left out.`);
  const overFootprint = app.data.figures.find((figure) => figure.stand_in === error.id);
  if (overFootprint !== undefined && app.measured().some((cell) => numberOf(cells, outsidePixels, cell))) {
    words.push(`${error.label}: relief outside the footprint counts, too, which no per-pixel technique can draw.`);
    words.push(
      known.some(({ id }) => id === overFootprint.path)
        ? "The figures over the footprint leave it out."
        : "This run is of a version that had no figures over the footprint.",
    );
  }
  return words;
}

function limitWords({ metric, bound }: Limit): string {
  return `${inSentence(metric.label)} at ${metric.better === "lower" ? "most" : "least"} ${metricText(metric, bound)}`;
}

function questionWords(question: Question): string {
  const { cost, limits } = question;
  const budget = budgetOf(question);
  const others = limits.filter((limit) => limit !== budget).map(limitWords);
  const within = budget ? [`within ${metricText(cost, budget.bound)}`] : [];
  return [...within, ...(others.length > 0 ? [`with ${others.join(" and ")}`] : [])].join(" ");
}

function answerElement(app: App, group: Group, question: Question): HTMLElement {
  const advice = advise(group.all, question);
  const small = (text: string | null) => (text === null ? null : h("p", { class: "muted small" }, text));
  return h(
    "article",
    { class: "answer" },
    h("h3", {}, group.title, h("span", { class: "muted" }, `, ${questionWords(question)}`)),
    ...(advice.winner === null
      ? nothingWords(app, group, advice.nearest, question)
      : winnerWords(app, advice, advice.winner, question)),
    beyondElement(app, advice, question),
    small(
      advice.refused > 0
        ? `${counted(advice.refused, "setting")} more would keep to it, but for missed and false hits above 0.5 % of the footprint.`
        : null,
    ),
    small(group.views > 1 ? `Worst of ${group.views} views.` : null),
    small(
      group.incomplete > 0
        ? `${counted(group.incomplete, "setting")} left out: not measured in all of these views.`
        : null,
    ),
  );
}

function pinnable(app: App, point: Candidate): HTMLElement {
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

function nothingWords(app: App, group: Group, nearest: Candidate | null, question: Question): HTMLElement[] {
  if (group.all.length === 0) {
    return [h("p", {}, "No setting has all of these figures in all of these views.")];
  }
  if (nearest === null) return [h("p", {}, "Nothing here finds enough of its hits to be advised.")];
  const missed = question.limits
    .map((limit, at) => ({ limit, value: nearest.limited[at]! }))
    .filter(({ limit, value }) => excess(limit, value) > 1)
    .map(({ limit: { metric, bound }, value }) => `${labelled(metric, value)} and not ${metricText(metric, bound)}`);
  const error = question.limits.some(({ metric }) => metric.id === question.error.id)
    ? []
    : [labelled(question.error, nearest.error)];
  return [
    h("p", {}, "Nothing does that. Nearest comes ", pinnable(app, nearest), `: ${[...missed, ...error].join("; ")}.`),
    shareElement(app, nearest, question),
  ];
}

function winnerWords(app: App, advice: Advice, winner: Candidate, question: Question): HTMLElement[] {
  const { cost, error, limits } = question;
  const others = limits.flatMap(({ metric }, at) =>
    metric.id === cost.id || metric.id === error.id ? [] : [labelled(metric, winner.limited[at]!)],
  );
  const figures = [errorWords(error, winner.error), ...others].join(", ");
  const words = [
    h("p", { class: "winner" }, "Use ", pinnable(app, winner), `: ${figures}, ${costWords(cost, winner.cost)}.`),
    reasonElement(app, advice, winner, question),
    shareElement(app, winner, question),
  ];
  if (advice.asGood.length > 0) words.push(asGoodElement(app, advice.asGood, question));
  const { runnerUp } = advice;
  words.push(
    runnerUp === null
      ? h("p", { class: "runner-up" }, "No other technique does it.")
      : h(
          "p",
          { class: "runner-up" },
          "Of the other techniques, the best is ",
          pinnable(app, runnerUp),
          `: ${comparedWords(winner, runnerUp, question)}.`,
        ),
  );
  return words;
}

/** Why this one: by the rules of docs/report.md, "Advice". */
function reasonElement(app: App, advice: Advice, winner: Candidate, question: Question): HTMLElement {
  const { error } = question;
  const { least, kept, asExact } = advice;
  const all = question.limits.length > 1 ? "the limits" : budgetOf(question) ? "the budget" : "the limit";
  const best = error.better === "lower" ? "least" : "highest";
  const because = (...words: (HTMLElement | string)[]) => h("p", { class: "small why" }, ...words);
  if (kept === 1) return because(`It is the only setting that keeps to ${all}.`);
  if (errorsAreLimited(question)) return because(`It is the cheapest of the ${kept} settings that keep to ${all}.`);
  const figure = inSentence(error.label);
  if (asExact === 1 || least === null) return because(`Its ${figure} is the ${best} within ${all}.`);
  const cheapest = `it is the cheapest of the ${asExact} settings of which that is so`;
  if (least.error === winner.error) {
    return because(`Within ${all} no ${figure} can be told to be better; ${cheapest}.`);
  }
  return because(
    `The ${best} ${figure} within ${all} is ${metricText(error, least.error)}, of `,
    pinnable(app, least),
    `: too near to ${metricText(error, winner.error)} to be told apart (that takes more than ${toleranceWords(error)}); ${cheapest}.`,
  );
}

/** A time is worth what it is of: a full screen of relief, or a distant wall. */
function shareElement(app: App, point: Candidate, { cost }: Question): HTMLElement {
  const { cells } = app.run();
  const shares = point.cells.flatMap((cell) => {
    const covered = numberOf(cells, coveredPixels, cell);
    const size = /^(\d+)x(\d+)$/.exec(textOf(cells.axes["resolution"], cell) ?? "");
    return covered === null || size === null ? [] : [covered / (Number(size[1]) * Number(size[2]))];
  });
  const times = point.cells.flatMap((cell) => numberOf(cells, timePerPixel, cell) ?? []);
  const [least, most] = extent(shares).map((share) => significant(100 * share, 2));
  const parts = [
    ...(shares.length > 0 ? [`relief covers ${least === most ? least : `${least} to ${most}`} % of the picture`] : []),
    ...(times.length > 0 && cost.id !== timePerPixel
      ? [`${metricText(declared(app.data.figures, timePerPixel), extent(times)[1])} per covered pixel`]
      : []),
  ];
  return h("p", { class: "muted small share" }, `${sentence(parts.join("; "))}.`);
}

function listed(elements: HTMLElement[]): (HTMLElement | string)[] {
  return elements.flatMap((element, at) =>
    at === 0 ? [element] : [at === elements.length - 1 ? " and " : ", ", element],
  );
}

function asGoodElement(app: App, asGood: Candidate[], { cost, error }: Question): HTMLElement {
  const named = asGood
    .slice(0, maxNamed)
    .map((point) =>
      h("span", {}, pinnable(app, point), ` (${metricText(error, point.error)}, ${metricText(cost, point.cost)})`),
    );
  const rest = asGood.length - named.length;
  const others = rest > 0 ? [h("span", {}, `${rest} more`)] : [];
  return h("p", { class: "as-good" }, "Cannot be told apart from it: ", ...listed([...named, ...others]), ".");
}

/** What more than the budget would buy. */
function beyondElement(app: App, advice: Advice, question: Question): HTMLElement | null {
  if ((advice.winner ?? advice.nearest) === null || budgetOf(question) === null) return null;
  if (advice.beyond.length === 0) {
    const others = question.limits.length > 1 ? " and keeps to the other limits" : "";
    return h("p", { class: "beyond" }, `Beyond the budget nothing is better${others}.`);
  }
  return h(
    "div",
    { class: "beyond" },
    h("p", {}, "Beyond the budget:"),
    h(
      "ul",
      {},
      ...advice.beyond.map((point) =>
        h("li", {}, `${boughtWords(point, advice.winner, question)}: `, pinnable(app, point)),
      ),
    ),
  );
}

/** "276 ms (1.5 times the cost) buys UV error, p99 0.095 texels (109 times less)"; without a winner no ratios. */
function boughtWords(point: Candidate, winner: Candidate | null, { cost, error }: Question): string {
  const price = metricText(cost, point.cost);
  const bought = labelled(error, point.error);
  if (winner === null) return `${price} buys ${bought}`;
  const less = error.better === "lower" ? lessText(point.error, winner.error) : "";
  return `${price}${timesText(point.cost, winner.cost, "cost")} buys ${bought}${less}`;
}
