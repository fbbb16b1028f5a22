import assert from "node:assert/strict";
import { test } from "node:test";

import { besideById, besideIds } from "../src/beside.ts";
import type { Json } from "../src/data.ts";
import { cellsOf, type SampleCell } from "./cells.ts";

function cell(technique: string, axes: Record<string, Json>, params: Record<string, Json>, uv: number): SampleCell {
  return {
    id: `${technique} ${JSON.stringify(params)} | ${JSON.stringify(axes)}`,
    axes,
    parameters: params,
    numbers: { "error.uv_texels.mean": uv, "error.uv_texels.max": uv, "error.missed": 0, "error.false_hits": 0 },
  };
}

const shadowed = (technique: string, view_angle: number, uv: number) => [
  cell(technique, { view_angle, self_shadow: "off" }, { steps: 8 }, uv),
  ...[8, 32].map((shadow_max_steps) =>
    cell(technique, { view_angle, self_shadow: "hard", shadow_max_steps, hard_shadow_bias: 0.1 }, { steps: 8 }, uv),
  ),
  cell(technique, { view_angle, self_shadow: "soft" }, { steps: 8 }, uv),
];
const cells = cellsOf([
  ...shadowed("pom", 0, 1),
  ...shadowed("pom", 60, 2),
  ...shadowed("qdm", 60, 3),
  cell("flat", { view_angle: 60, self_shadow: "off" }, {}, 9),
]);
const all = [...cells.id.keys()];

test("cells that differ in the chosen axis alone stand in one row, whatever follows from its values", () => {
  const beside = besideById(cells, all, "axis.self_shadow")!;
  assert.deepEqual(beside.columns, ["off", "hard shadow_max_steps=8", "hard shadow_max_steps=32", "soft"]);
  assert.deepEqual(
    beside.rows.map((row) => row.cells),
    [
      [0, 1, 2, 3],
      [4, 5, 6, 7],
      [8, 9, 10, 11],
    ],
  );
  assert.ok(beside.sameHits);
  assert.deepEqual(beside.names, new Set(["self_shadow", "shadow_max_steps", "hard_shadow_bias"]));
});

test("a value that was left out has no cell, and a row with one cell alone is none", () => {
  const without = all.filter((at) => at !== 3 && at < 9);
  const beside = besideById(cells, without, "axis.self_shadow")!;
  assert.deepEqual(
    beside.rows.map((row) => row.cells),
    [
      [0, 1, 2, -1],
      [4, 5, 6, 7],
    ],
  );
});

test("an axis that moves the hits is told from one that does not, and stands behind it", () => {
  assert.deepEqual(besideIds(cells, all), ["axis.self_shadow", "axis.shadow_max_steps", "axis.view_angle"]);
  const angles = besideById(cells, all, "axis.view_angle")!;
  assert.deepEqual(angles.columns, ["0", "60"]);
  assert.ok(!angles.sameHits);
});

test("words of a parameter stand beside each other, too; one value has nothing beside it", () => {
  const leaves = cellsOf([
    cell("qdm", { view_angle: 0 }, { leaf: "linear", max_steps: 8 }, 1),
    cell("qdm", { view_angle: 0 }, { leaf: "exact", max_steps: 8 }, 0),
    cell("pom", { view_angle: 0 }, { max_steps: 8 }, 2),
  ]);
  const leaf = besideById(leaves, [0, 1, 2], "param.leaf")!;
  assert.deepEqual([leaf.columns, leaf.rows.map((row) => row.cells)], [["linear", "exact"], [[0, 1]]]);
  assert.ok(!leaf.sameHits, "the technique's own hits move");
  assert.equal(besideById(leaves, [0, 2], "param.leaf"), null);
  assert.equal(besideById(leaves, [0, 1, 2], "axis.nothing"), null);
});
