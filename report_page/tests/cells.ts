// Cells for tests of functions that read them.

import type { Cells, Figure, Json, ValueColumn } from "../src/data.ts";

export interface SampleCell {
  id: string;
  axes?: Record<string, Json>;
  parameters?: Record<string, Json>;
  status?: string;
  reason?: string;
  numbers?: Record<string, number>;
}

function column(values: (Json | undefined)[]): ValueColumn {
  const distinct: Json[] = [];
  const index = values.map((value) => {
    if (value === undefined) return -1;
    if (!distinct.includes(value)) distinct.push(value);
    return distinct.indexOf(value);
  });
  return { values: distinct, index };
}

function columns(rows: Record<string, Json>[]): Record<string, ValueColumn> {
  const names = new Set(rows.flatMap((row) => Object.keys(row)));
  return Object.fromEntries([...names].map((name) => [name, column(rows.map((row) => row[name]))]));
}

/** As harness/report/page_cells.cpp makes them. */
export function cellsOf(rows: SampleCell[]): Cells {
  const paths = new Set(rows.flatMap((row) => Object.keys(row.numbers ?? {})));
  return {
    count: rows.length,
    id: rows.map((row) => row.id),
    words: {
      technique: column(rows.map((row) => row.id.split(" ")[0])),
      status: column(rows.map((row) => row.status ?? "ok")),
      reason: column(rows.map((row) => row.reason)),
      reason_group: column(rows.map((row) => row.reason)),
    },
    axes: columns(rows.map((row) => row.axes ?? {})),
    parameters: columns(rows.map((row) => row.parameters ?? {})),
    numbers: Object.fromEntries([...paths].map((path) => [path, rows.map((row) => row.numbers?.[path] ?? null)])),
  };
}

function figure(path: string, label: string, unit: string, better: Figure["better"] = "lower"): Figure {
  const tolerance =
    unit === "texels"
      ? { absolute: 0.05, relative: 0.05 }
      : /flip/.test(path)
        ? { absolute: 0.002, relative: 0.02 }
        : { absolute: 0.005, relative: 0.05 };
  const needs = /^(error|image|motion)\./.test(path) ? ["truth"] : [];
  const ratio = path.endsWith(".psnr") ? { infinite_at_zero: path.replace("psnr", "rmse") } : {};
  return { path, label, unit, better, tolerance, needs, ...ratio };
}

/** Some of those that the page's data list. */
export const figures: Figure[] = [
  figure("time.draw.median_ms", "Draw time", "ms"),
  figure("time.draw.mad_ms", "Draw time, MAD", "ms", "neither"),
  figure("time.ns_per_pixel", "Draw time per covered pixel", "ns"),
  figure("prepare.bytes", "Memory of maps", "bytes"),
  figure("work.taps_mean", "Taps per pixel", ""),
  figure("work.steps_mean", "Steps per pixel", ""),
  figure("work.unconverged", "Unconverged searches", "fraction of covered pixels"),
  figure("work.shadow_taps_mean", "Shadow taps per pixel", ""),
  figure("error.uv_texels.mean", "UV error, mean", "texels"),
  figure("error.uv_texels.p99", "UV error, p99", "texels"),
  figure("error.depth.mean", "Depth error, signed mean", "patch sides", "neither"),
  figure("error.missed", "Missed hits", "fraction of footprint"),
  figure("error.false_hits", "False hits", "fraction of footprint"),
  figure("error.coverage_iou", "Intersection over union of the coverage", "", "higher"),
  figure("error.shadow.mean", "Shadow error, mean", "visibility"),
  figure("image.flip", "FLIP", ""),
  figure("image.psnr", "PSNR", "dB", "higher"),
  figure("image.ssim", "SSIM", "", "higher"),
  figure("image.rmse", "RMSE of the picture", ""),
];

/** A measured cell of pom, say, at a view angle. */
export function measured(
  technique: string,
  steps: number,
  angle: number,
  ms: number,
  uv: number,
  missed = 0,
): SampleCell {
  return {
    id: `${technique} max_steps=${steps} | view_angle=${angle}`,
    axes: { view_angle: angle },
    parameters: { max_steps: steps },
    numbers: {
      "time.draw.median_ms": ms,
      "error.uv_texels.p99": uv,
      "error.missed": missed,
      "error.false_hits": 0,
      "work.steps_mean": steps / 2,
    },
  };
}
