import assert from "node:assert/strict";
import { test } from "node:test";

import { advise, adviceGroups, candidates, type Limit, type Question, tellsBetter } from "../src/advice.ts";
import { costMetrics, errorMetrics, metricById } from "../src/metrics.ts";
import { settingPoints } from "../src/settings.ts";
import { cellsOf, figures, measured, type SampleCell } from "./cells.ts";

/** With an interval of ±1 %. */
function timed(technique: string, steps: number, angle: number, ms: number, uv: number, missed = 0): SampleCell {
  const cell = measured(technique, steps, angle, ms, uv, missed);
  const numbers = { "time.draw.ci95_ms.low": 0.99 * ms, "time.draw.ci95_ms.high": 1.01 * ms, "image.flip": uv / 100 };
  return { ...cell, numbers: { ...cell.numbers, ...numbers } };
}

const cells = cellsOf([
  timed("pom", 8, 60, 1, 4),
  timed("pom", 32, 60, 4, 1),
  timed("qdm", 1, 60, 3, 2),
  timed("liar", 1, 60, 0.5, 0, 0.006),
  timed("pom", 8, 75, 2, 9),
  timed("pom", 32, 75, 6, 3),
  timed("qdm", 1, 75, 3, 8),
  timed("liar", 1, 75, 0.5, 0),
  timed("steep", 8, 75, 0.1, 0.1),
]);
const cost = metricById(costMetrics(figures, cells), "time.draw.median_ms")!;
const error = metricById(errorMetrics(figures, cells), "error.uv_texels.p99")!;
const flip = metricById(errorMetrics(figures, cells), "image.flip")!;
const all = [...cells.id.keys()];

const budget = (bound: number): Limit => ({ metric: cost, bound });
const uv = (bound: number): Limit => ({ metric: error, bound });

function answer(of: typeof cells, ...limits: Limit[]) {
  const question: Question = { cost, error, limits };
  const advice = advise(candidates(of, [...of.id.keys()], question).all, question);
  const names = (points: { setting: string }[]) => points.map(({ setting }) => setting.replace("max_steps=", ""));
  return {
    winner: advice.winner?.setting.replace("max_steps=", "") ?? null,
    runnerUp: advice.runnerUp?.setting.replace("max_steps=", "") ?? null,
    nearest: advice.nearest?.setting.replace("max_steps=", "") ?? null,
    asGood: names(advice.asGood),
    beyond: names(advice.beyond),
    refused: advice.refused,
  };
}

test("why a setting is advised: how many keep to the limits, the least error, and how many cannot be told from it", () => {
  const near = cellsOf([
    timed("pom", 8, 60, 1, 0.167),
    timed("qdm", 1, 60, 3, 0.0455),
    timed("qdm", 2, 60, 2, 0.1),
    timed("flat", 1, 60, 0.1, 9),
    timed("slow", 1, 60, 9, 0),
  ]);
  const question: Question = { cost, error: flip, limits: [budget(5)] };
  const { winner, least, kept, asExact } = advise(
    candidates(near, [...near.id.keys()], question).all,
    question,
  );
  assert.deepEqual(
    [winner?.setting, least?.setting, kept, asExact],
    ["pom max_steps=8", "qdm max_steps=1", 4, 3],
  );
});

test("a setting is the worst, or the mean, of its views; one that lacks a view cannot be set against the others", () => {
  const worst = settingPoints(cells, all, cost, error, "worst");
  assert.deepEqual(
    worst.points.map(({ setting, cost: ms, error: texels, counts }) => [setting, ms, texels, counts]),
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
  assert.deepEqual(answer(cells, budget(6)), {
    winner: "pom 32",
    runnerUp: "qdm 1",
    nearest: null,
    asGood: [],
    beyond: [],
    refused: 1,
  });
  assert.equal(answer(cells, budget(3)).winner, "qdm 1");
});

test("below a limit on the error the least cost wins, and all of several limits must be kept", () => {
  assert.equal(answer(cells, uv(8.5)).winner, "qdm 1");
  assert.equal(answer(cells, uv(9)).winner, "pom 8");
  assert.equal(answer(cells, uv(8.5), budget(4)).winner, "qdm 1", "the cheapest, not the best of the budget");
  assert.equal(answer(cells, uv(9), { metric: flip, bound: 0.05 }).winner, "pom 32");
  assert.equal(answer(cells, uv(5), budget(4)).winner, null);
});

test("beyond the budget stand the next better steps, each told to be better than the one before", () => {
  const steps = cellsOf([
    timed("pom", 16, 75, 190, 10.4),
    timed("pom", 17, 75, 230, 10.39),
    timed("dear", 1, 75, 250, 12),
    timed("qdm", 4, 75, 276, 0.095),
    timed("qdm", 8, 75, 300, 0.09),
    timed("liar", 8, 75, 310, 0, 0.01),
    timed("exact", 1, 75, 400, 0),
  ]);
  const advice = answer(steps, budget(200));
  assert.equal(advice.winner, "pom 16");
  assert.deepEqual(advice.beyond, ["qdm 4", "exact 1"]);
  assert.deepEqual(answer(steps, budget(500)).beyond, []);
  assert.deepEqual(
    answer(steps, budget(100)).beyond,
    ["qdm 4", "exact 1"],
    "from the nearest, where nothing is within",
  );
  const both = answer(steps, budget(200), uv(0.5));
  assert.deepEqual([both.winner, both.nearest], [null, "qdm 4"]);
  assert.deepEqual(both.beyond, ["exact 1"], "from the nearest, which keeps to the other limit");
  const strict = answer(steps, budget(189), uv(9.9));
  assert.equal(strict.nearest, "pom 16");
  assert.deepEqual(strict.beyond, ["qdm 4", "exact 1"], "the cheapest that keeps to the other limit first");
});

test("settings that cannot be told apart are named, and of those with the least error the cheapest is advised", () => {
  const close = cellsOf([
    timed("a", 1, 75, 2, 1),
    timed("b", 1, 75, 2.01, 1.04),
    timed("c", 1, 75, 2.5, 0.97),
    timed("d", 1, 75, 2.02, 1.2),
  ]);
  assert.deepEqual(answer(close, budget(3)), {
    winner: "a 1",
    runnerUp: "c 1",
    nearest: null,
    asGood: ["b 1"],
    beyond: [],
    refused: 0,
  });
  assert.deepEqual(answer(close, uv(2)).asGood, ["b 1", "d 1"], "by their times alone, where the error is limited");
});

test("errors can be told apart by more than both tolerances, and in the direction of the figure", () => {
  assert.ok(tellsBetter(error, 1, 1.06));
  assert.ok(!tellsBetter(error, 1.06, 1));
  assert.ok(!tellsBetter(error, 0.01, 0.05), "within 0.05 texels");
  assert.ok(!tellsBetter(error, 10, 10.4), "within 5 %");
  assert.ok(tellsBetter(flip, 0.09, 0.093));
  assert.ok(!tellsBetter(flip, 0.001, 0.0029));
  const psnr = { ...flip, id: "image.psnr", better: "higher" as const };
  assert.ok(tellsBetter(psnr, Infinity, 60) && tellsBetter(psnr, 40, 30));
  assert.ok(!tellsBetter(psnr, 30, 40) && !tellsBetter(psnr, Infinity, Infinity));
});

test("where nothing keeps to the limits, what comes nearest is told; discarding hard pixels wins nothing", () => {
  const cheap = answer(cells, budget(1));
  assert.deepEqual([cheap.winner, cheap.nearest, cheap.refused], [null, "pom 8", 1]);
  assert.equal(answer(cells, uv(1)).nearest, "pom 32");
  // 2 times the time, or 1.13 times the time and 1.6 times the error.
  assert.equal(answer(cells, budget(2.66), uv(5)).nearest, "qdm 1");
  assert.deepEqual(answer(cellsOf([]), budget(1)).nearest, null);
});

test("there is an answer for each view that the asker chooses, over height maps and azimuths, in the order of values", () => {
  const views = cellsOf(
    [0.1, 0.025, 0.05].flatMap((height_scale) =>
      ["rock", "bricks"].flatMap((heightmap) =>
        [-90, -67].map((azimuth) => ({
          id: `pom | ${heightmap} ${height_scale} ${azimuth}`,
          axes: { heightmap, height_scale, azimuth, tiling: 1 },
        })),
      ),
    ),
  );
  const { axes, groups } = adviceGroups(views, [...views.id.keys()]);
  assert.deepEqual(axes, ["height_scale"]);
  assert.deepEqual(
    groups.map((group) => [group.values, group.cells.length]),
    [
      [["0.025"], 4],
      [["0.05"], 4],
      [["0.1"], 4],
    ],
  );
});
