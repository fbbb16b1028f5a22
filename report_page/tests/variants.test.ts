import assert from "node:assert/strict";
import { test } from "node:test";

import type { Json, RunData } from "../src/data.ts";
import { truthNote, truthSamples, usualErrorsOf } from "../src/truth.ts";
import { variantsOf } from "../src/variants.ts";
import { cellsOf, type SampleCell } from "./cells.ts";

function drawn(id: string, axes: SampleCell["axes"], p99 = 1): SampleCell {
  const numbers = { "error.uv_texels.mean": p99 / 4, "error.uv_texels.max": p99, "error.missed": 0, "error.false_hits": 0 };
  return { id, axes: { view_angle: 60, material_filter: "lod0", frames: 1, ...axes }, numbers };
}

function runOf(rows: SampleCell[], truth: number[], technique: number[], samples?: number): RunData {
  const settings: Record<string, Json> = { kind: "exact" };
  if (samples !== undefined) settings["samples"] = samples;
  return {
    name: "run",
    record: { configuration: { truth: settings } },
    summary: null,
    cautions: [],
    engines: null,
    cells: cellsOf(rows),
    samples: [],
    pictures: { technique, truth, maps: {}, legends: {}, step: 1, left_out: 0 },
  };
}

const rows = [
  drawn("pom | view_angle=60", {}),
  drawn("pom | view_angle=60 material_filter=mip", { material_filter: "mip", mip_bias: 0 }),
  drawn("pom | view_angle=60 frames=16", { frames: 16 }),
  drawn("pom max_steps=64 | view_angle=60", {}),
  drawn("pom | view_angle=75", { view_angle: 75 }, 2),
  drawn("pom | view_angle=60 frames=2", { frames: 2 }),
  // Of another truth, though it looks the same.
  drawn("pom | view_angle=0", { view_angle: 0 }, 0.5),
];

test("variants are the cells of one setting whose pictures stand beside one truth's", () => {
  const run = runOf(rows, [0, 0, 0, 0, 9, 0, 0], [1, 2, 3, 4, 5, -1, 6]);
  const found = [
    { cell: 0, label: "material filter lod0 · frames 1" },
    { cell: 1, label: "material filter mip · frames 1" },
    { cell: 2, label: "material filter lod0 · frames 16" },
  ];
  assert.deepEqual(variantsOf(run, 0), found);
  assert.deepEqual(variantsOf(run, 2), found);
  assert.deepEqual(variantsOf(run, 4), [{ cell: 4, label: "" }]);
  assert.deepEqual(variantsOf(run, 5), [], "without a picture");
});

test("pictures decide where the truth is filtered, hits where it has one sample a pixel", () => {
  const plain = runOf(rows, [], []);
  const filtered = runOf(rows, [], [], 64);
  assert.equal(truthSamples(plain), 1);
  assert.equal(truthSamples(filtered), 64);
  assert.equal(usualErrorsOf(plain)[0], "error.uv_texels.p99");
  assert.equal(usualErrorsOf(filtered)[0], "image.footprint.flip");
  assert.match(truthNote(filtered, { id: "image.footprint.flip" })!, /a truth of 64 samples a pixel/);
  assert.match(truthNote(plain, { id: "image.footprint.flip" })!, /a truth of one sample a pixel/);
  assert.equal(truthNote(filtered, { id: "error.uv_texels.p99" }), null);
});
