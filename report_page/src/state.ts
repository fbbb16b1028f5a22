// What the page shows, as plain data. It lives in the URL's fragment, so that a link leads to a view.

export const viewNames = ["engines", "cost", "advice", "axes", "pictures", "timing", "changes", "cells", "run"] as const;
export type ViewName = (typeof viewNames)[number];

export type PointsMode = "cells" | "mean" | "worst";
export const pictureModes = ["side", "slider", "flip", "variants"] as const;
export type PictureMode = (typeof pictureModes)[number];

export interface State {
  /** "": the first that there is. */
  view: ViewName | "";
  /** Which of the runs. */
  run: number;
  /** Paths of figures; "" leaves the choice to the page. */
  cost: string;
  error: string;
  points: PointsMode;
  /** An axis, "view" or "none"; "" leaves the choice to the page. */
  facet: string;
  /** Texts of the axis' values that are shown; an axis that is not here shows all. */
  filters: Record<string, string[]>;
  /** Shown techniques; empty: all. */
  techniques: string[];
  /** A cell's id. */
  pin: string;
  /** Of what advice is for: how much of the cost, in its unit. Null: no budget, or where there are no limits, the page's. */
  budget: number | null;
  /** Other limits, by the paths of figures, in the units that the page shows. */
  limits: Record<string, number>;
  /** Of the charts over an axis: "steps", "axis.<name>" or "param.<name>"; "" leaves the choice to the page. */
  x: string;
  query: string;
  /** A column; descending with a leading "-". */
  sort: string;
  columns: string[];
  mode: PictureMode;
  map: string;
  verdict: string;
}

export const defaultState: Readonly<State> = {
  view: "",
  run: 0,
  cost: "",
  error: "",
  points: "cells",
  facet: "",
  filters: {},
  techniques: [],
  pin: "",
  budget: null,
  limits: {},
  x: "",
  query: "",
  sort: "",
  columns: [],
  mode: "side",
  map: "",
  verdict: "",
};

const textKeys = ["cost", "error", "facet", "pin", "x", "query", "sort", "map", "verdict"] as const;
const listKeys = ["techniques", "columns"] as const;
const filterPrefix = "axis.";
const limitPrefix = "limit.";

/** What differs from the defaults, as a fragment without its "#". */
export function stateToFragment(state: State): string {
  const fragment = new URLSearchParams();
  for (const key of ["view", "points", "mode"] as const) {
    if (state[key] !== defaultState[key]) fragment.set(key, state[key]);
  }
  if (state.run !== defaultState.run) fragment.set("run", String(state.run));
  for (const key of textKeys) {
    if (state[key] !== defaultState[key]) fragment.set(key, state[key]);
  }
  if (state.budget !== null) fragment.set("budget", String(state.budget));
  for (const [path, bound] of Object.entries(state.limits)) fragment.set(limitPrefix + path, String(bound));
  for (const key of listKeys) {
    for (const value of state[key]) fragment.append(key, value);
  }
  for (const [axis, values] of Object.entries(state.filters)) {
    for (const value of values) fragment.append(filterPrefix + axis, value);
  }
  return fragment.toString();
}

function oneOf<T extends string>(value: string | null, choices: readonly T[], fallback: T): T {
  return choices.find((choice) => choice === value) ?? fallback;
}

function positive(text: string | null): number | null {
  const value = text === null || text === "" ? NaN : Number(text);
  return Number.isFinite(value) && value >= 0 ? value : null;
}

/** What a fragment does not say, or says wrongly, stays at its default. */
export function stateFromFragment(text: string): State {
  const fragment = new URLSearchParams(text.replace(/^#/, ""));
  const state: State = { ...defaultState, filters: {}, limits: {}, techniques: [], columns: [] };
  state.view = oneOf(fragment.get("view"), viewNames, defaultState.view);
  state.points = oneOf(fragment.get("points"), ["cells", "mean", "worst"], defaultState.points);
  state.mode = oneOf(fragment.get("mode"), pictureModes, defaultState.mode);
  const run = Number(fragment.get("run") ?? 0);
  state.run = Number.isInteger(run) && run >= 0 ? run : 0;
  for (const key of textKeys) state[key] = fragment.get(key) ?? defaultState[key];
  state.budget = positive(fragment.get("budget"));
  for (const key of listKeys) state[key] = fragment.getAll(key);
  const filters = new Map<string, string[]>();
  const limits = new Map<string, number>();
  for (const [key, value] of fragment) {
    const bound = positive(value);
    if (key.startsWith(filterPrefix)) {
      const axis = key.slice(filterPrefix.length);
      filters.set(axis, [...(filters.get(axis) ?? []), value]);
    } else if (key.startsWith(limitPrefix) && bound !== null) {
      limits.set(key.slice(limitPrefix.length), bound);
    }
  }
  state.filters = Object.fromEntries(filters);
  state.limits = Object.fromEntries(limits);
  return state;
}

/** The list with the value taken in or out; all values of `everything` are the same as none. */
export function toggled(list: readonly string[], value: string, everything: readonly string[]): string[] {
  const shown = list.length === 0 ? everything : list;
  const next = shown.includes(value) ? shown.filter((each) => each !== value) : [...shown, value];
  const ordered = everything.filter((each) => next.includes(each));
  return ordered.length === everything.length ? [] : ordered;
}
