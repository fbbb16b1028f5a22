import assert from "node:assert/strict";
import { test } from "node:test";

import { costMetrics, errorMetrics, metricById } from "../src/metrics.ts";
import { abscissas, lines, mixesViews, runningParameters } from "../src/series.ts";
import { cellsOf, figures, measured, type SampleCell } from "./cells.ts";

const leaf = (steps: number, kind: string): SampleCell => ({
  ...measured("qdm", steps, 0, steps, 1),
  id: `qdm max_steps=${steps} min_steps=${steps / 4} leaf=${kind} | view_angle=0`,
  parameters: { max_steps: steps, min_steps: steps / 4, leaf: kind },
});

const cells = cellsOf([
  measured("pom", 32, 0, 4, 1),
  measured("pom", 8, 0, 1, 4),
  measured("pom", 8, 60, 4, 8),
  measured("pom", 32, 60, 16, 3),
  leaf(8, "linear"),
  leaf(32, "linear"),
  leaf(8, "exact"),
]);
const cost = metricById(costMetrics(figures, cells), "time.draw.median_ms")!;
const error = metricById(errorMetrics(figures, cells), "error.uv_texels.p99")!;
const all = cells.id.map((_, at) => at);
/** Means of logarithms are not exact. */
const rounded = (value: number | null) => Number(value!.toPrecision(9));
const over = (id: string) => abscissas(figures, cells).find((each) => each.id === id)!;

test("steps, axes and parameters that are numbers can stand below a chart", () => {
  assert.deepEqual(
    abscissas(figures, cells).map(({ id }) => id),
    ["steps", "axis.view_angle", "param.max_steps", "param.min_steps"],
  );
  const sizes = cellsOf([
    { id: "a | b", axes: { heightmap_size: "128x128", heightmap: "rock" } },
    { id: "a | c", axes: { heightmap_size: "2048x2048", heightmap: "bricks" } },
  ]);
  const size = abscissas(figures, sizes)[0]!;
  assert.equal(size.id, "axis.heightmap_size");
  assert.equal(size.of(sizes, 1), 2048);
  assert.equal(size.scale, "log");
});

test("a line over steps runs along the parameter with most values and those that follow from it", () => {
  assert.deepEqual(runningParameters(cells, all).get("qdm"), new Set(["max_steps", "min_steps"]));
  const found = lines(cells, all, over("steps"), cost, error);
  assert.deepEqual(
    found.map(({ name, points }) => [name, points.length]),
    [
      ["pom", 2],
      ["qdm leaf=linear", 2],
      ["qdm leaf=exact", 1],
    ],
  );
  assert.deepEqual(
    found.map(({ ofTechnique }) => ofTechnique),
    [0, 1, 0],
    "counted by name",
  );
  const [first, second] = found[0]!.points;
  assert.deepEqual([first!.x, first!.cost, first!.error].map(rounded), [4, 2, 6], "means over both angles");
  assert.deepEqual([second!.x, second!.cost, second!.error].map(rounded), [16, 8, 2]);
});

test("a line over an axis is a setting", () => {
  const found = lines(cells, all, over("axis.view_angle"), cost, error);
  const pom = found.find(({ name }) => name === "pom max_steps=8")!;
  assert.deepEqual(
    pom.points.map(({ x, cost: ms }) => [x, ms].map(rounded)),
    [
      [0, 1],
      [60, 4],
    ],
  );
  assert.ok(!mixesViews(cells, found, over("axis.view_angle")));
});

test("points that rest on different values of another axis are told of", () => {
  const zipped = cellsOf([
    { ...measured("pom", 8, 0, 1, 1), axes: { view_angle: 0, heightmap: "rock" } },
    { ...measured("pom", 8, 60, 1, 1), axes: { view_angle: 60, heightmap: "bricks" } },
  ]);
  const x = abscissas(figures, zipped).find(({ id }) => id === "axis.view_angle")!;
  assert.ok(mixesViews(zipped, lines(zipped, [0, 1], x, cost, error), x));
});
