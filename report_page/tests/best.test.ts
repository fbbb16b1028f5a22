import assert from "node:assert/strict";
import { test } from "node:test";

import { bestCell } from "../src/best.ts";
import { costMetrics, errorMetrics, intervalOf, manyOutliers, metricById } from "../src/metrics.ts";
import { cellsOf, figures, measured, type SampleCell } from "./cells.ts";

const having = (cell: SampleCell, numbers: Record<string, number>): SampleCell => ({
  ...cell,
  numbers: { ...cell.numbers, ...numbers },
});

const cells = cellsOf([
  measured("flat", 1, 0, 0.1, 0.001),
  measured("pom", 8, 0, 1, 0.001),
  measured("flat", 1, 60, 0.1, 0.01, 0.02),
  measured("pom", 8, 60, 1, 2),
  measured("pom", 32, 60, 4, 0.51),
  measured("qdm", 8, 60, 3, 0.5),
  measured("qdm", 32, 60, 5, 0.49),
]);
const cost = metricById(costMetrics(figures, cells), "time.draw.median_ms")!;
const error = metricById(errorMetrics(figures, cells), "error.uv_texels.p99")!;
const all = cells.id.map((_, at) => at);

test("the best cell is of the view with the largest median error, and the cheapest that cannot be told from the least", () => {
  assert.deepEqual(bestCell(cells, all, cost, error), { cell: 5, views: 2 });
});

test("a cell that misses too many hits is the best only where all do", () => {
  assert.equal(bestCell(cells, [2, 3], cost, error)!.cell, 3);
  assert.equal(bestCell(cells, [2], cost, error)!.cell, 2);
});

test("within one view nothing is harder, and without figures there is no best cell", () => {
  assert.deepEqual(bestCell(cells, [0, 1], cost, error), { cell: 0, views: 1 });
  assert.equal(bestCell(cells, [], cost, error), null);
  const unmeasured = cellsOf([{ id: "mine | view_angle=0", status: "failed" }]);
  assert.equal(bestCell(unmeasured, [0], cost, error), null);
});

test("of figures that are better the higher, the hardest view has the lowest", () => {
  const psnr = (cell: SampleCell, value: number) => having(cell, { "image.psnr": value });
  const pictures = cellsOf([
    psnr(measured("pom", 8, 0, 1, 0), 50),
    psnr(measured("pom", 8, 60, 1, 0), 20),
    psnr(measured("qdm", 8, 60, 2, 0), 30),
  ]);
  const metric = metricById(errorMetrics(figures, pictures), "image.psnr")!;
  assert.equal(bestCell(pictures, [0, 1, 2], cost, metric)!.cell, 2);
});

test("the interval of a time over pixels is as wide as the draw's; other figures have none", () => {
  const sampled = cellsOf([
    having(measured("pom", 8, 0, 2, 1), {
      "time.draw.ci95_ms.low": 1,
      "time.draw.ci95_ms.high": 3,
      "time.ns_per_pixel": 200,
      "work.taps_mean": 7,
    }),
    measured("pom", 32, 0, 2, 1),
  ]);
  const metrics = costMetrics(figures, sampled);
  const interval = (id: string, cell: number) => intervalOf(metricById(metrics, id)!, sampled, cell);
  assert.deepEqual(interval("time.draw.median_ms", 0), [1, 3]);
  assert.deepEqual(interval("time.ns_per_pixel", 0), [100, 300]);
  assert.equal(interval("work.taps_mean", 0), null);
  assert.equal(interval("time.draw.median_ms", 1), null);
});

test("outliers are too many above a tenth of the samples", () => {
  const sampled = (outliers: number) =>
    cellsOf([having(measured("pom", 8, 0, 1, 1), { "time.draw.n": 20, "time.draw.outliers": outliers })]);
  assert.equal(manyOutliers(sampled(2), 0), null);
  assert.deepEqual(manyOutliers(sampled(3), 0), { outliers: 3, samples: 20 });
  assert.equal(manyOutliers(cellsOf([measured("pom", 8, 0, 1, 1)]), 0), null, "of a run that did not count them");
});
