// Time and error over an axis, over a parameter or over steps: which cells make a line.

import {
  type Cells,
  type Figure,
  leadingNumber,
  numberOf,
  settingOf,
  techniqueOf,
  textOf,
  type ValueColumn,
} from "./data.ts";
import { steps as stepsFigure } from "./defaults.ts";
import { declared, figureTitle, type Metric } from "./metrics.ts";
import { arithmeticMean, extent, geometricMean } from "./numbers.ts";

/** What stands on the horizontal axis. */
export interface Abscissa {
  id: string;
  label: string;
  of(cells: Cells, cell: number): number | null;
  /** Logarithmic where values span more than a decade and none is 0 or less. */
  scale: "log" | "linear";
}

export interface LinePoint {
  x: number;
  cost: number | null;
  error: number | null;
  cells: number[];
}

export interface Line {
  name: string;
  technique: string;
  /** Counts the lines of the technique from 0, in the order of their names. */
  ofTechnique: number;
  points: LinePoint[];
}

const steps = "steps";

function numericColumn(column: ValueColumn): boolean {
  const numbers = column.values.filter((value) => leadingNumber(value) !== null);
  return numbers.length > 1 && numbers.length === column.values.length;
}

function scaleOf(values: number[]): "log" | "linear" {
  const [least, greatest] = extent(values);
  return least > 0 && greatest / least > 10 ? "log" : "linear";
}

function columnAbscissa(id: string, label: string, column: ValueColumn): Abscissa {
  return {
    id,
    label,
    of: (_, cell) => {
      const at = column.index[cell] ?? -1;
      return at < 0 ? null : leadingNumber(column.values[at]);
    },
    scale: scaleOf(column.values.map((value) => leadingNumber(value)!)),
  };
}

const units: Record<string, string> = {
  view_angle: "degrees",
  azimuth: "degrees",
  fov: "degrees",
  curvature: "1/patch side",
  heightmap_size: "texels",
  resolution: "pixels",
};

export function sweptTitle(axis: string): string {
  const name = axis.replaceAll("_", " ");
  const unit = Object.hasOwn(units, axis) ? units[axis] : undefined;
  return unit === undefined ? name : `${name} (${unit})`;
}

/** Steps first, then axes, then parameters that more than one value was measured of. */
export function abscissas(figures: readonly Figure[], cells: Cells): Abscissa[] {
  const all: Abscissa[] = [];
  if ((cells.numbers[stepsFigure] ?? []).some((value) => value !== null && value > 0)) {
    all.push({
      id: steps,
      label: figureTitle(declared(figures, stepsFigure)),
      of: (of, cell) => {
        const value = numberOf(of, stepsFigure, cell);
        return value !== null && value > 0 ? value : null;
      },
      scale: "log",
    });
  }
  for (const [axis, column] of Object.entries(cells.axes)) {
    if (numericColumn(column)) all.push(columnAbscissa(`axis.${axis}`, sweptTitle(axis), column));
  }
  for (const [parameter, column] of Object.entries(cells.parameters)) {
    if (numericColumn(column)) all.push(columnAbscissa(`param.${parameter}`, parameter, column));
  }
  return all;
}

/**
 * Of each technique, the numeric parameters that a line over steps runs along: the one with most values in `selection`,
 * and those that follow from it.
 */
export function runningParameters(cells: Cells, selection: readonly number[]): Map<string, Set<string>> {
  const byTechnique = new Map<string, number[]>();
  for (const cell of selection) {
    const technique = techniqueOf(cells, cell);
    byTechnique.set(technique, [...(byTechnique.get(technique) ?? []), cell]);
  }
  const running = new Map<string, Set<string>>();
  for (const [technique, members] of byTechnique) {
    const values = new Map<string, Set<number>>();
    for (const [parameter, column] of Object.entries(cells.parameters)) {
      const used = new Set(members.map((cell) => column.index[cell] ?? -1).filter((at) => at >= 0));
      const numeric = [...used].every((at) => typeof column.values[at] === "number");
      if (numeric && used.size > 1) values.set(parameter, used);
    }
    const main = [...values].sort((a, b) => b[1].size - a[1].size)[0]?.[0];
    const set = new Set<string>();
    if (main !== undefined) {
      for (const parameter of values.keys()) {
        if (parameter === main || followsFrom(cells, members, main, parameter)) set.add(parameter);
      }
    }
    running.set(technique, set);
  }
  return running;
}

function followsFrom(cells: Cells, members: readonly number[], main: string, parameter: string): boolean {
  const implied = new Map<number, number>();
  return members.every((cell) => {
    const from = cells.parameters[main]!.index[cell] ?? -1;
    const to = cells.parameters[parameter]!.index[cell] ?? -1;
    const known = implied.get(from);
    if (known === undefined) implied.set(from, to);
    return known === undefined || known === to;
  });
}

/** Technique and parameters without those of these names: what stays the same along a line. */
export function lineName(cells: Cells, cell: number, along: ReadonlySet<string>): string {
  const words = settingOf(cells.id[cell]!).split(" ");
  return words.filter((word, at) => at === 0 || !along.has(word.slice(0, word.indexOf("=")))).join(" ");
}

function mean(values: (number | null)[], of: (defined: number[]) => number): number | null {
  const defined = values.filter((value): value is number => value !== null);
  return defined.length === 0 ? null : of(defined);
}

/**
 * Lines over `x`. Cells of equal x on one line are one point: geometric mean of the cost, arithmetic of the error. Over
 * steps, which differ from view to view, a point is a setting, at the mean of its steps.
 */
export function lines(cells: Cells, selection: readonly number[], x: Abscissa, cost: Metric, error: Metric): Line[] {
  const running = runningParameters(cells, selection);
  const groups = new Map<string, { technique: string; at: Map<string, number[]> }>();
  for (const cell of selection) {
    const value = x.of(cells, cell);
    if (value === null) continue;
    const technique = techniqueOf(cells, cell);
    const along =
      x.id === steps
        ? running.get(technique)!
        : new Set(x.id.startsWith("param.") ? [x.id.slice("param.".length), ...running.get(technique)!] : []);
    const name = lineName(cells, cell, along);
    const group = groups.get(name) ?? { technique, at: new Map<string, number[]>() };
    groups.set(name, group);
    const key = x.id === steps ? settingOf(cells.id[cell]!) : String(value);
    group.at.set(key, [...(group.at.get(key) ?? []), cell]);
  }
  const names = [...groups.keys()].sort((a, b) => a.localeCompare(b, "en", { numeric: true }));
  const siblings = (technique: string) => names.filter((name) => groups.get(name)!.technique === technique);
  return [...groups].map(([name, { technique, at }]) => ({
    name,
    technique,
    ofTechnique: siblings(technique).indexOf(name),
    points: [...at.values()]
      .map((members) => ({
        x: mean(
          members.map((cell) => x.of(cells, cell)),
          geometricMean,
        )!,
        cost: mean(
          members.map((cell) => cost.of(cells, cell)),
          geometricMean,
        ),
        error: mean(
          members.map((cell) => error.of(cells, cell)),
          arithmeticMean,
        ),
        cells: members,
      }))
      .sort((a, b) => a.x - b.x),
  }));
}

/** Whether the points of some line rest on different values of other axes, so that a slope may be theirs. */
export function mixesViews(cells: Cells, all: readonly Line[], x: Abscissa): boolean {
  const axes = Object.keys(cells.axes).filter((axis) => x.id !== `axis.${axis}`);
  const behind = (members: number[]) =>
    axes.map((axis) => [...new Set(members.map((cell) => textOf(cells.axes[axis], cell)))].sort().join(",")).join("|");
  return all.some((line) => new Set(line.points.map((point) => behind(point.cells))).size > 1);
}
