// The page's data as `reliefbench report` writes them: harness/report/page.hpp and the headers that it names.

export type Json = null | boolean | number | string | Json[] | { [key: string]: Json };

/** Distinct values and, per cell, which of them it has: -1 for none. */
export interface ValueColumn {
  values: Json[];
  index: number[];
}

export interface Cells {
  count: number;
  /** "<technique and parameters> | <view>" */
  id: string[];
  words: Record<string, ValueColumn>;
  axes: Record<string, ValueColumn>;
  parameters: Record<string, ValueColumn>;
  numbers: Record<string, (number | null)[]>;
}

/** Samples of one pass. `cell` and `groups` have one entry per cell; the others one (`ms`: five) per group of rounds. */
export interface PassSamples {
  pass: string;
  cell: number[];
  groups: number[];
  first_round: number[];
  samples: number[];
  ms: number[];
}

/** What a map's colours mean: RGB, base64, for values from `dark` to `light`; there are none where it has no marks. */
export interface MapLegend {
  title: string;
  unit: string;
  dark: number;
  light: number;
  logarithmic: boolean;
  colours: string;
  /** Values that are named, from dark to light. */
  marks: number[];
  /** Colours that stand for no value, RGB. */
  others: { colour: number[]; text: string }[];
}

/** Positions in PageData.pictures, one per cell, -1 for none. */
export interface CellPictures {
  technique: number[];
  truth: number[];
  maps: Record<string, number[]>;
  legends: Record<string, MapLegend>;
  step: number;
  left_out: number;
}

/** A technique with parameters by its worst view of a kind. */
export interface EngineSetting {
  setting: string;
  technique: string;
  preset?: string;
  ms: number;
  ci95_ms: [number, number];
  ns_per_pixel: number | null;
  /** Missed and false hits, a fraction of the footprint. */
  wrong_hits: number;
  /** By path. */
  figures: Record<string, number | null>;
}

export interface EngineAnswers {
  rank_by: string;
  views: {
    axes: Record<string, Json>;
    views: string[];
    /** By their times. */
    presets?: { preset: EngineSetting; better: EngineSetting | null; cheaper: EngineSetting | null }[];
  }[];
}

export interface RunData {
  name: string;
  record: { [key: string]: Json };
  summary: { [key: string]: Json } | null;
  /** What whoever reads the figures has to know first, in words. */
  cautions: string[];
  /** Of runs with presets (harness/report/engine_answers.hpp). */
  engines: EngineAnswers | null;
  cells: Cells;
  samples: PassSamples[];
  pictures: CellPictures;
}

export interface PackedPicture {
  width: number;
  height: number;
  packing: "rgb" | "difference" | "palette";
  base?: number;
  palette?: string;
  data: string;
}

export type Verdict = "slower" | "faster" | "same" | "undecided";

export type QualityVerdict = "worse" | "mixed" | "better" | "same" | "not comparable";

/** `decides`: part of the verdict. */
export interface QualityChange {
  decides: boolean;
  text: string;
}

export interface CellVerdict {
  cell: string;
  verdict: Verdict;
  ratio: number | null;
  ci95: [number | null, number | null];
  visible: number | null;
  reason: string;
  /** The most important change first. */
  quality: { verdict: QualityVerdict; changes: QualityChange[] };
}

export interface ComparisonResult {
  cells: CellVerdict[];
  uncompared: { cell: string; reason: string; failed_now: boolean }[];
  notices: string[];
  summary: Record<string, number>;
  deciding_figures: { figure: string; tolerance: string }[];
  threshold: number | null;
  unit: string;
  environment: Json;
}

/** The compared cells as the page's file has them: `cell` is a position in the cells of all runs, one after the other. */
export interface VerdictColumns {
  cell: number[];
  verdict: Verdict[];
  ratio: (number | null)[];
  low: (number | null)[];
  high: (number | null)[];
  visible: (number | null)[];
  reason: string[];
  quality: QualityVerdict[];
  changes: [place: number, changes: QualityChange[]][];
}

export interface PageComparison {
  base: string[];
  new: string[];
  failure: string | null;
  result: ComparisonResult | null;
}

/** What a number of a cell is, by its path in cells.jsonl: harness/store/figures.hpp has the list. */
export interface Figure {
  path: string;
  label: string;
  /** Empty for pure numbers. */
  unit: string;
  better: "lower" | "higher" | "neither";
  /** What a change must exceed, in the unit and of the larger value, to be one that can be told. */
  tolerance: Tolerance;
  /** What it is measured of, or depends on: "truth", "motion" ... */
  needs: string[];
  /** Path of the figure beside which 0 makes this one infinite, which has no number in JSON. */
  infinite_at_zero?: string;
  /** Path of the figure that decides where a run is too old to have this one. */
  stand_in?: string;
  /** Of a percentile over the pixels of a picture: per cent of them in which what it is of is at most the figure. */
  percent_of_pixels?: number;
}

export interface Tolerance {
  absolute: number;
  relative: number;
}

export interface PageData {
  tool_version: string;
  figures: Figure[];
  runs: RunData[];
  pictures: PackedPicture[];
  comparison: PageComparison | null;
}

/** As the file has it. */
export interface PackedPageData extends Omit<PageData, "comparison"> {
  comparison:
    | (Omit<PageComparison, "result"> & {
        result: (Omit<ComparisonResult, "cells"> & { cells: VerdictColumns }) | null;
      })
    | null;
}

export function unpackVerdicts(columns: VerdictColumns, ids: readonly string[]): CellVerdict[] {
  const changes = new Map(columns.changes);
  return columns.cell.map((cell, place) => ({
    cell: ids[cell]!,
    verdict: columns.verdict[place]!,
    ratio: columns.ratio[place]!,
    ci95: [columns.low[place]!, columns.high[place]!],
    visible: columns.visible[place]!,
    reason: columns.reason[place]!,
    quality: { verdict: columns.quality[place]!, changes: changes.get(place) ?? [] },
  }));
}

export function unpackPage(packed: PackedPageData): PageData {
  const { comparison } = packed;
  if (comparison === null || comparison.result === null) return { ...packed, comparison: comparison as null };
  const ids = packed.runs.flatMap((run) => run.cells.id);
  const result = { ...comparison.result, cells: unpackVerdicts(comparison.result.cells, ids) };
  return { ...packed, comparison: { ...comparison, result } };
}

/** A value deep in a record; null where it is not there. */
export function deep(record: Json, ...path: string[]): Json {
  let value: Json = record;
  for (const key of path) {
    if (value === null || typeof value !== "object" || Array.isArray(value)) return null;
    value = Object.hasOwn(value, key) ? (value[key] ?? null) : null;
  }
  return value;
}

export function valueText(value: Json): string {
  if (value === null) return "–";
  return typeof value === "string" ? value : JSON.stringify(value);
}

/** The value's text; null where the cell has none. */
export function textOf(column: ValueColumn | undefined, cell: number): string | null {
  const at = column?.index[cell] ?? -1;
  return at < 0 || !column ? null : valueText(column.values[at] ?? null);
}

/** Names may come from a URL: what every object has is no axis. */
export function axisColumn(cells: Cells, axis: string): ValueColumn | undefined {
  return Object.hasOwn(cells.axes, axis) ? cells.axes[axis] : undefined;
}

export function hasFigure(cells: Cells, path: string): boolean {
  return Object.hasOwn(cells.numbers, path);
}

export function numberOf(cells: Cells, path: string, cell: number): number | null {
  return hasFigure(cells, path) ? (cells.numbers[path]?.[cell] ?? null) : null;
}

export function techniqueOf(cells: Cells, cell: number): string {
  return textOf(cells.words["technique"], cell) ?? "?";
}

export function statusOf(cells: Cells, cell: number): string {
  return textOf(cells.words["status"], cell) ?? "?";
}

export function reasonOf(cells: Cells, cell: number): string {
  return textOf(cells.words["reason"], cell) ?? "";
}

const bar = " | ";

/** Technique and parameters, as the cell's id has them. */
export function settingOf(id: string): string {
  const at = id.indexOf(bar);
  return at < 0 ? id : id.slice(0, at);
}

/** What the setting is drawn on: height map, camera, resolution. */
export function viewOf(id: string): string {
  const at = id.indexOf(bar);
  return at < 0 ? "" : id.slice(at + bar.length);
}

/** Values in the order in which cells first have them. */
export function techniques(cells: Cells): string[] {
  return (cells.words["technique"]?.values ?? []).map(valueText);
}

/** Names of the axes that differ between cells. */
export function variedAxes(cells: Cells): string[] {
  return Object.keys(cells.axes).filter((axis) => (cells.axes[axis]?.values.length ?? 0) > 1);
}

/** An axis' value for people: "60°", "rock", "height scale 0.1". */
export function axisValueText(axis: string, value: string): string {
  if (axis === "view_angle") return `${value}°`;
  if (["heightmap", "base", "projection", "boundary", "height_format"].includes(axis)) return value.split("/").pop() ?? value;
  return `${axis.replaceAll("_", " ")} ${value}`;
}

/** A cell's view by the axes that differ in this run, but for those left out: "rock · 60° · parallel". */
export function viewLabel(cells: Cells, cell: number, without?: ReadonlySet<string>): string {
  const parts = variedAxes(cells).flatMap((axis) => {
    const text = textOf(cells.axes[axis], cell);
    return text === null || without?.has(axis) ? [] : [axisValueText(axis, text)];
  });
  return parts.length > 0 ? parts.join(" · ") : viewOf(cells.id[cell]!) || "the configuration’s only view";
}

/** As a number where the value is one or begins with one ("512x256"); else null. */
export function leadingNumber(value: Json | undefined): number | null {
  if (typeof value === "number") return value;
  if (typeof value !== "string") return null;
  const match = /^(\d+)x\d+$/.exec(value);
  return match ? Number(match[1]) : null;
}

/** Numbers by size, then other values by their text. */
export function sortedValues(column: ValueColumn): Json[] {
  return [...column.values].sort((a, b) => {
    const x = leadingNumber(a);
    const y = leadingNumber(b);
    if (x !== null && y !== null) return x - y;
    return valueText(a).localeCompare(valueText(b), "en");
  });
}

export function cellIndex(cells: Cells, id: string | null): number {
  return id === null ? -1 : cells.id.indexOf(id);
}
