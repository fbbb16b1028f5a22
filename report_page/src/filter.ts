import { axisColumn, type Cells, statusOf, techniqueOf, textOf } from "./data.ts";

export interface Filter {
  filters: Record<string, string[]>;
  techniques: string[];
}

/** Cells that the filter of techniques and axes lets through, in their order, whatever became of them. */
export function filteredCells(cells: Cells, filter: Filter): number[] {
  const axes = Object.entries(filter.filters).filter(
    ([axis, values]) => values.length > 0 && axisColumn(cells, axis) !== undefined,
  );
  const selection: number[] = [];
  for (let cell = 0; cell < cells.count; ++cell) {
    if (filter.techniques.length > 0 && !filter.techniques.includes(techniqueOf(cells, cell))) continue;
    const passes = axes.every(([axis, values]) => {
      const text = textOf(cells.axes[axis], cell);
      return text !== null && values.includes(text);
    });
    if (passes) selection.push(cell);
  }
  return selection;
}

export function measuredCells(cells: Cells, selection: readonly number[]): number[] {
  return selection.filter((cell) => statusOf(cells, cell) === "ok");
}

export interface ReasonGroup {
  status: string;
  reason: string;
  cells: number[];
}

/** Failed and skipped cells, reasons that differ by figures alone together, failed ones first. */
export function reasonGroups(cells: Cells): ReasonGroup[] {
  const groups = new Map<string, ReasonGroup>();
  for (let cell = 0; cell < cells.count; ++cell) {
    const status = statusOf(cells, cell);
    if (status === "ok") continue;
    const reason = textOf(cells.words["reason_group"], cell) ?? "no reason given";
    const key = `${status}\n${reason}`;
    const group = groups.get(key);
    if (group) group.cells.push(cell);
    else groups.set(key, { status, reason, cells: [cell] });
  }
  return [...groups.values()].sort((a, b) => a.status.localeCompare(b.status) || b.cells.length - a.cells.length);
}
