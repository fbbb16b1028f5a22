// Which cell is shown where none is pinned.

import { tellsBetter } from "./advice.ts";
import { type Cells, viewOf } from "./data.ts";
import { advantage, hitsWithinLimit, type Metric } from "./metrics.ts";
import { median } from "./numbers.ts";

export interface Best {
  cell: number;
  /** How many views it was chosen from. */
  views: number;
}

/**
 * The best cell of the hardest view, that with the worst median error: easy views tell nothing apart. It is the cheapest of
 * those whose error cannot be told from the least. Cells that miss too many hits come into question only where all do. Null
 * where no cell of `among` has both figures.
 */
export function bestCell(cells: Cells, among: readonly number[], cost: Metric, error: Metric): Best | null {
  const errorOf = (cell: number) => error.of(cells, cell)!;
  const costOf = (cell: number) => cost.of(cells, cell)!;
  const byView = new Map<string, number[]>();
  for (const cell of among) {
    if (error.of(cells, cell) === null || cost.of(cells, cell) === null) continue;
    const view = viewOf(cells.id[cell]!);
    byView.set(view, [...(byView.get(view) ?? []), cell]);
  }
  const views = [...byView.values()].map((members) => ({ members, typical: median(members.map(errorOf))! }));
  const hardest = [...views].sort((a, b) => advantage(error.better, a.typical, b.typical))[0];
  if (hardest === undefined) return null;
  const good = hardest.members.filter((cell) => hitsWithinLimit(cells, cell));
  const members = good.length > 0 ? good : hardest.members;
  const least = [...members].sort((a, b) => advantage(error.better, errorOf(b), errorOf(a)))[0]!;
  const asGood = members.filter((cell) => !tellsBetter(error, errorOf(least), errorOf(cell)));
  return { cell: asGood.sort((a, b) => costOf(a) - costOf(b))[0]!, views: views.length };
}
