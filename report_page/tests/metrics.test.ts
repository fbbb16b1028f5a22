import assert from "node:assert/strict";
import { test } from "node:test";

import { axisTitle, costMetrics, errorMetrics, metricById, metricText, worstOf } from "../src/metrics.ts";
import { settingPoints } from "../src/settings.ts";
import { cellsOf, figures, measured, type SampleCell } from "./cells.ts";

function picture(steps: number, ms: number, numbers: Record<string, number>): SampleCell {
  const cell = measured("pom", steps, 60, ms, 1);
  return { ...cell, numbers: { ...cell.numbers, ...numbers } };
}

const cells = cellsOf([
  picture(8, 1, { "image.psnr": 20, "image.rmse": 0.1, "image.ssim": 0.8, "error.coverage_iou": 0.9 }),
  picture(16, 2, { "image.psnr": 30, "image.rmse": 0.03, "error.shadow.mean": 0.2, "work.shadow_taps_mean": 9 }),
  picture(32, 3, { "image.rmse": 0, "error.depth.mean": -0.1, "work.unconverged": 0.25 }),
]);
const errors = errorMetrics(figures, cells);
const costs = costMetrics(figures, cells);
const ids = (metrics: { id: string }[]) => metrics.map(({ id }) => id);

test("every figure with a direction that some cell has is on offer, as a cost or as an error", () => {
  assert.deepEqual(ids(costs), ["time.draw.median_ms", "work.steps_mean", "work.shadow_taps_mean"]);
  assert.deepEqual(ids(errors), [
    "work.unconverged",
    "error.uv_texels.p99",
    "error.missed",
    "error.false_hits",
    "error.wrong_hits",
    "error.coverage_iou",
    "error.shadow.mean",
    "image.psnr",
    "image.ssim",
    "image.rmse",
  ]);
});

test("label, unit and direction are those of the list; fractions are shown in per cent", () => {
  const psnr = metricById(errors, "image.psnr")!;
  assert.equal(axisTitle(psnr, "\n"), "PSNR (dB)\nhigher is better");
  assert.equal(axisTitle(psnr), "PSNR (dB), higher is better");
  assert.equal(axisTitle(metricById(costs, "time.draw.median_ms")!), "Draw time (ms), lower is better");
  const unconverged = metricById(errors, "work.unconverged")!;
  assert.equal(metricText(unconverged, unconverged.of(cells, 2)), "25.0 % of covered pixels");
});

test("a picture without an error has the best PSNR, and the worst view is the one with the least", () => {
  const psnr = metricById(errors, "image.psnr")!;
  assert.equal(psnr.of(cells, 2), Infinity);
  assert.equal(metricText(psnr, psnr.of(cells, 2)), "∞ dB");
  assert.equal(worstOf(psnr.better, [30, Infinity, 20]), 20);
  const time = metricById(costs, "time.draw.median_ms")!;
  const twoViews = cellsOf([
    { ...picture(8, 1, { "image.psnr": 20 }), id: "pom | view_angle=0" },
    { ...picture(8, 2, { "image.psnr": 40 }), id: "pom | view_angle=60" },
  ]);
  const [point] = settingPoints(twoViews, [0, 1], time, psnr, "worst").points;
  assert.deepEqual([point!.cost, point!.error], [2, 20]);
});

test("of several ids the first that there is is taken", () => {
  assert.equal(metricById(errors, "", "image.footprint.flip", "image.rmse")!.id, "image.rmse");
  assert.equal(metricById(errors, "constructor")!.id, "work.unconverged");
  assert.equal(metricById([], "image.flip"), null);
});
