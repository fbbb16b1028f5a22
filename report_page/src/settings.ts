import { type Cells, settingOf, techniqueOf, viewOf } from "./data.ts";
import { hitsWithinLimit, type Metric, worstOf } from "./metrics.ts";
import { arithmeticMean, geometricMean } from "./numbers.ts";

/** A technique with parameters, over several views. */
export interface SettingPoint {
  setting: string;
  technique: string;
  cost: number;
  error: number;
  /** Missed and false hits are few enough in each view. */
  counts: boolean;
  cells: number[];
}

/** How the cells of a setting become one: mean (geometric for the cost, arithmetic for the error), or the worst. */
export type Together = "mean" | "worst";

export interface SettingPoints {
  points: SettingPoint[];
  views: number;
  /** Settings that were not measured in every view, and so cannot be set against the others. */
  incomplete: number;
}

/**
 * One point per setting over the views of `selection`. Settings that lack a view, or there one of the figures (those of
 * `needed` too), are left out, and counted.
 */
export function settingPoints(
  cells: Cells,
  selection: readonly number[],
  cost: Metric,
  error: Metric,
  together: Together,
  needed: readonly Metric[] = [],
): SettingPoints {
  const views = new Set<string>();
  const bySetting = new Map<string, number[]>();
  for (const cell of selection) {
    const id = cells.id[cell]!;
    views.add(viewOf(id));
    const setting = settingOf(id);
    if ([cost, error, ...needed].some((metric) => metric.of(cells, cell) === null)) {
      if (!bySetting.has(setting)) bySetting.set(setting, []);
      continue;
    }
    const members = bySetting.get(setting);
    if (members) members.push(cell);
    else bySetting.set(setting, [cell]);
  }
  const points: SettingPoint[] = [];
  let incomplete = 0;
  for (const [setting, members] of bySetting) {
    if (members.length !== views.size) {
      ++incomplete;
      continue;
    }
    const costs = members.map((cell) => cost.of(cells, cell)!);
    const errors = members.map((cell) => error.of(cells, cell)!);
    const mean = together === "mean";
    points.push({
      setting,
      technique: techniqueOf(cells, members[0]!),
      cost: mean ? geometricMean(costs) : worstOf(cost.better, costs),
      error: mean ? arithmeticMean(errors) : worstOf(error.better, errors),
      counts: members.every((cell) => hitsWithinLimit(cells, cell)),
      cells: members,
    });
  }
  return { points, views: views.size, incomplete };
}
