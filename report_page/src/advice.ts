import type { SettingPoint } from "./settings.ts";

export type Goal = { kind: "budget"; cost: number } | { kind: "limit"; error: number };

export interface Advice {
  /** The best that keeps to the goal. */
  winner: SettingPoint | null;
  /** The best of another technique. */
  runnerUp: SettingPoint | null;
  /** Where nothing keeps to the goal: what comes nearest. */
  nearest: SettingPoint | null;
}

/** Negative where `a` is to be preferred. */
function preference(goal: Goal, a: SettingPoint, b: SettingPoint): number {
  const byText = a.setting < b.setting ? -1 : a.setting > b.setting ? 1 : 0;
  return goal.kind === "budget"
    ? a.error - b.error || a.cost - b.cost || byText
    : a.cost - b.cost || a.error - b.error || byText;
}

function keepsTo(goal: Goal, point: SettingPoint): boolean {
  return goal.kind === "budget" ? point.cost <= goal.cost : point.error <= goal.error;
}

/** What to use of `points`. Settings that miss or invent too many hits are no advice. */
export function advise(points: readonly SettingPoint[], goal: Goal): Advice {
  const counted = points.filter((point) => point.counts);
  const kept = counted.filter((point) => keepsTo(goal, point)).sort((a, b) => preference(goal, a, b));
  const winner = kept[0] ?? null;
  if (winner !== null) {
    return { winner, runnerUp: kept.find((point) => point.technique !== winner.technique) ?? null, nearest: null };
  }
  const excess = (point: SettingPoint) => (goal.kind === "budget" ? point.cost : point.error);
  const nearest = [...counted].sort((a, b) => excess(a) - excess(b) || preference(goal, a, b))[0] ?? null;
  return { winner: null, runnerUp: null, nearest };
}
