import assert from "node:assert/strict";
import { test } from "node:test";

import { paretoFront } from "../src/pareto.ts";

const costs = (points: { cost: number; error: number }[], better: "lower" | "higher" = "lower") =>
  paretoFront(points, better).map((at) => points[at]!.cost);

test("the front keeps what nothing beats in both, by ascending cost", () => {
  const points = [
    { cost: 4, error: 1 },
    { cost: 1, error: 8 },
    { cost: 3, error: 9 },
    { cost: 2, error: 4 },
    { cost: 5, error: 1 },
  ];
  assert.deepEqual(costs(points), [1, 2, 4]);
});

test("equal points are on the front together, and a point as good for more is not", () => {
  const points = [
    { cost: 1, error: 2 },
    { cost: 1, error: 2 },
    { cost: 1, error: 3 },
    { cost: 2, error: 2 },
  ];
  assert.deepEqual(paretoFront(points, "lower"), [0, 1]);
});

test("no points have no front; an error of 0 ends it", () => {
  assert.deepEqual(paretoFront([], "lower"), []);
  assert.deepEqual(
    costs([
      { cost: 1, error: 0 },
      { cost: 2, error: 0 },
      { cost: 0.5, error: 1 },
    ]),
    [0.5, 1],
  );
});

test("what is better the higher it is leads the front with its highest, an infinite one last", () => {
  const psnr = [
    { cost: 1, error: 20 },
    { cost: 2, error: 18 },
    { cost: 3, error: 30 },
    { cost: 4, error: Infinity },
    { cost: 5, error: Infinity },
    { cost: 3, error: 25 },
  ];
  assert.deepEqual(costs(psnr, "higher"), [1, 3, 4]);
});

test("the front of many points is that of comparing each with each", () => {
  let seed = 7;
  const random = () => (seed = (seed * 16807) % 2147483647) / 2147483647;
  const points = Array.from({ length: 400 }, () => ({
    cost: Math.round(20 * random()),
    error: Math.round(20 * random()),
  }));
  const beaten = (a: number) =>
    points.some(
      (other) =>
        other.cost <= points[a]!.cost &&
        other.error <= points[a]!.error &&
        (other.cost < points[a]!.cost || other.error < points[a]!.error),
    );
  const expected = points.map((_, at) => at).filter((at) => !beaten(at));
  assert.deepEqual(
    paretoFront(points, "lower").sort((a, b) => a - b),
    expected,
  );
});
