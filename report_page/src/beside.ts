// Values of an axis or a parameter beside each other: cells that differ in nothing else.

import { type Cells, leadingNumber, numberOf, techniqueOf, type ValueColumn, valueText } from "./data.ts";
import { hitErrors } from "./defaults.ts";

/** One cell per column, -1 where there is none. */
export interface BesideRow {
  technique: string;
  cells: number[];
}

export interface Beside {
  /** "axis.<name>" or "param.<name>" */
  id: string;
  /** Axes and parameters in which a row's cells may differ. */
  names: Set<string>;
  /** Values, each with what it brings along that others have no use for ("hard shadow_max_steps=16"). */
  columns: string[];
  rows: BesideRow[];
  /** Whether the hits of each row's cells have the same errors: then the axis changes what is drawn on them only. */
  sameHits: boolean;
}

const maxColumns = 8;

interface Named {
  id: string;
  name: string;
  column: ValueColumn;
}

function namedColumns(cells: Cells): Named[] {
  const axes = Object.entries(cells.axes).map(([name, column]) => ({ id: `axis.${name}`, name, column }));
  const parameters = Object.entries(cells.parameters).map(([name, column]) => ({ id: `param.${name}`, name, column }));
  return [...axes, ...parameters];
}

const at = (column: ValueColumn, cell: number) => column.index[cell] ?? -1;

/**
 * What a technique's cells have at some values of `chosen` and at others do not: a bias of hard shadows, say. What one
 * technique has and another lacks follows from no value.
 */
function dependents(cells: Cells, chosen: Named, others: readonly Named[], selection: readonly number[]): Named[] {
  return others.filter(({ column }) => {
    const values = new Map<string, boolean>();
    for (const cell of selection) {
      const key = `${techniqueOf(cells, cell)} ${at(chosen.column, cell)}`;
      values.set(key, (values.get(key) ?? false) || at(column, cell) >= 0);
    }
    const byTechnique = new Map<string, Set<boolean>>();
    for (const [key, has] of values) {
      const technique = key.slice(0, key.lastIndexOf(" "));
      byTechnique.set(technique, (byTechnique.get(technique) ?? new Set()).add(has));
    }
    return [...byTechnique.values()].some((has) => has.size > 1);
  });
}

/** Numbers by size; of words the default first, which ids leave out, then in the order in which cells have them. */
function valueOrder(cells: Cells, { name, column }: Named, selection: readonly number[]): (value: number) => number {
  const numbers = column.values.map(leadingNumber);
  if (!numbers.includes(null)) return (value) => numbers[value]!;
  const byDefault = selection.find((cell) => !` ${cells.id[cell]} `.includes(` ${name}=`));
  const first = byDefault === undefined ? -1 : at(column, byDefault);
  return (value) => (value === first ? -1 : value);
}

function hitsAreSame(cells: Cells, rows: readonly BesideRow[]): boolean {
  return rows.every((row) =>
    hitErrors.every((path) => {
      const values = row.cells.filter((cell) => cell >= 0).map((cell) => numberOf(cells, path, cell));
      return new Set(values).size <= 1;
    }),
  );
}

/** A cell's value, with those that follow from it where they differ ("hard shadow_max_steps=16"). */
function columnLabels(
  chosen: Named,
  following: readonly Named[],
  selection: readonly number[],
): (cell: number) => string {
  const alike = new Map<number, number[]>();
  for (const cell of selection) {
    const value = at(chosen.column, cell);
    alike.set(value, [...(alike.get(value) ?? []), cell]);
  }
  const varied = new Map<number, Named[]>();
  for (const [value, members] of alike) {
    varied.set(
      value,
      following.filter(({ column }) => new Set(members.map((cell) => at(column, cell))).size > 1),
    );
  }
  return (cell) => {
    const value = at(chosen.column, cell);
    const texts = varied
      .get(value)!
      .filter(({ column }) => at(column, cell) >= 0)
      .map(({ name, column }) => `${name}=${valueText(column.values[at(column, cell)]!)}`);
    return [valueText(chosen.column.values[value]!), ...texts].join(" ");
  };
}

/** Null where the axis or parameter has one value only, too many, or no two cells that differ in nothing else. */
function besideOf(cells: Cells, selection: readonly number[], chosen: Named, all: readonly Named[]): Beside | null {
  const members = selection.filter((cell) => at(chosen.column, cell) >= 0);
  const used = new Set(members.map((cell) => at(chosen.column, cell)));
  if (used.size < 2 || used.size > maxColumns) return null;
  const others = all.filter((named) => named !== chosen);
  const following = dependents(cells, chosen, others, members);
  const fixed = others.filter((named) => !following.includes(named));
  const key = (cell: number, named: readonly Named[]) =>
    [techniqueOf(cells, cell), ...named.map(({ column }) => at(column, cell))].join(" ");

  const groups = new Map<string, number[]>();
  for (const cell of members) {
    const rowKey = key(cell, fixed);
    groups.set(rowKey, [...(groups.get(rowKey) ?? []), cell]);
  }
  const comparable = [...groups.values()].filter((row) => row.length > 1);
  const compared = comparable.flat();
  const label = columnLabels(chosen, following, compared);
  const order = valueOrder(cells, chosen, members);
  const columns = [
    ...new Set([...compared].sort((a, b) => order(at(chosen.column, a)) - order(at(chosen.column, b))).map(label)),
  ];
  if (columns.length < 2 || columns.length > maxColumns) return null;
  const rows = comparable.map((row) => ({
    technique: techniqueOf(cells, row[0]!),
    cells: columns.map((text) => row.find((cell) => label(cell) === text) ?? -1),
  }));
  return {
    id: chosen.id,
    names: new Set([chosen.name, ...following.map(({ name }) => name)]),
    columns,
    rows,
    sameHits: chosen.id.startsWith("axis.") && hitsAreSame(cells, rows),
  };
}

/** Of the axis or parameter with this id; null where its values cannot stand beside each other. */
export function besideById(cells: Cells, selection: readonly number[], id: string): Beside | null {
  const all = namedColumns(cells);
  const chosen = all.find((named) => named.id === id);
  return chosen === undefined ? null : besideOf(cells, selection, chosen, all);
}

/** Axes and parameters whose values can stand beside each other; those that change no hit come first. */
export function besideIds(cells: Cells, selection: readonly number[]): string[] {
  const all = namedColumns(cells);
  const found = all.flatMap((chosen) => besideOf(cells, selection, chosen, all) ?? []);
  return [...found.filter(({ sameHits }) => sameHits), ...found.filter(({ sameHits }) => !sameHits)].map(
    ({ id }) => id,
  );
}
