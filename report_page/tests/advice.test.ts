import assert from "node:assert/strict";
import { test } from "node:test";

import { advise } from "../src/advice.ts";
import { costMetrics, errorMetrics, metricById, metricText } from "../src/metrics.ts";
import { settingPoints } from "../src/settings.ts";
import { cellsOf, measured } from "./cells.ts";

const cells = cellsOf([
  measured("pom", 8, 60, 1, 4),
  measured("pom", 32, 60, 4, 1),
  measured("qdm", 1, 60, 3, 2),
  measured("liar", 1, 60, 0.5, 0, 0.006),
  measured("pom", 8, 75, 2, 9),
  measured("pom", 32, 75, 6, 3),
  measured("qdm", 1, 75, 3, 8),
  measured("liar", 1, 75, 0.5, 0),
  measured("steep", 8, 75, 0.1, 0.1),
]);
const cost = metricById(costMetrics(cells), "time.draw.median_ms")!;
const error = metricById(errorMetrics(cells), "error.uv_texels.p99")!;
const all = cells.id.map((_, at) => at);
const worst = settingPoints(cells, all, cost, error, "worst");

test("a setting is the worst, or the mean, of its views; one that lacks a view cannot be set against the others", () => {
  assert.deepEqual(
    worst.points.map(({ setting, cost: ms, error: uv, counts }) => [setting, ms, uv, counts]),
    [
      ["pom max_steps=8", 2, 9, true],
      ["pom max_steps=32", 6, 3, true],
      ["qdm max_steps=1", 3, 8, true],
      ["liar max_steps=1", 0.5, 0, false],
    ],
  );
  assert.equal(worst.incomplete, 1);
  const mean = settingPoints(cells, all, cost, error, "mean").points[0]!;
  assert.ok(Math.abs(mean.cost - Math.sqrt(2)) < 1e-12, "geometric");
  assert.equal(mean.error, 6.5);
});

test("within a budget the least error wins, and the runner-up is another technique", () => {
  const advice = advise(worst.points, { kind: "budget", cost: 6 });
  assert.equal(advice.winner?.setting, "pom max_steps=32");
  assert.equal(advice.runnerUp?.setting, "qdm max_steps=1");
  assert.equal(advise(worst.points, { kind: "budget", cost: 3 }).winner?.setting, "qdm max_steps=1");
});

test("below a limit on the error the least cost wins", () => {
  assert.equal(advise(worst.points, { kind: "limit", error: 8.5 }).winner?.setting, "qdm max_steps=1");
  assert.equal(advise(worst.points, { kind: "limit", error: 9 }).winner?.setting, "pom max_steps=8");
});

test("where nothing keeps to the goal, what comes nearest is told; discarding hard pixels wins nothing", () => {
  const cheap = advise(worst.points, { kind: "budget", cost: 1 });
  assert.equal(cheap.winner, null);
  assert.equal(cheap.nearest?.setting, "pom max_steps=8");
  assert.equal(advise(worst.points, { kind: "limit", error: 1 }).nearest?.setting, "pom max_steps=32");
  assert.deepEqual(advise([], { kind: "budget", cost: 1 }), { winner: null, runnerUp: null, nearest: null });
});

test("metrics are those that a cell has, and read as figures with units", () => {
  assert.deepEqual(
    costMetrics(cells).map(({ id }) => id),
    ["time.draw.median_ms", "work.steps_mean"],
  );
  assert.deepEqual(errorMetrics(cellsOf([{ id: "a | b" }])), []);
  assert.equal(metricText(cost, 0.0321), "0.0321 ms");
  assert.equal(metricText(cost, null), "–");
});
