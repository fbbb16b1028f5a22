import assert from "node:assert/strict";
import { test } from "node:test";

import type { Json } from "../src/data.ts";
import { searchCells } from "../src/search.ts";
import { suggestion } from "../src/suggest.ts";
import { cellsOf, type SampleCell } from "./cells.ts";

const defaults: Record<string, Json> = {
  heightmap: "bricks",
  heightmap_size: "256x256",
  view_angle: 0,
  projection: "perspective",
  height_scale: 0.05,
  self_shadow: "off",
};

/** Ids leave out what is at its default, axes and parameters are in full. */
function cell(technique: string, axes: Record<string, Json>, params: Record<string, Json>, uv?: number): SampleCell {
  const text = (values: Record<string, Json>) => Object.entries(values).map(([name, value]) => `${name}=${value}`);
  const shown: Record<string, Json> = technique === "pom" ? { max_steps: 32, refine: "linear" } : {};
  return {
    id: `${[technique, ...text(params)].join(" ")} | ${text(axes).join(" ")}`,
    axes: { ...defaults, ...axes },
    parameters: { ...shown, ...params },
    ...(uv === undefined ? {} : { numbers: { "error.uv_texels.p99": uv, "error.missed": uv / 1000 } }),
  };
}

const cells = cellsOf([
  cell("pom", {}, {}, 1),
  cell("pom", { projection: "parallel" }, { max_steps: 8 }, 4),
  cell("pom", { projection: "parallel", view_angle: 60 }, {}, 0.25),
  cell("cone_step", { heightmap: "maps/Gray Rocks 02.png", view_angle: 60, height_scale: 0.1 }, {}, 0),
  {
    ...cell("robust_cone", { heightmap_size: "512x256" }, {}),
    status: "failed",
    reason: "trace.glsl:3: no such thing",
  },
]);
const all = [...cells.id.keys()];
const uv = (at: number) => cells.numbers["error.uv_texels.p99"]![at] ?? null;
const search = (text: string) => searchCells(cells, all, text, [{ name: "uv", of: uv }]);
const found = (text: string) => {
  const result = search(text);
  assert.deepEqual(result.notes, [], text);
  return result.found;
};

test("axes and parameters at their defaults are found and left out like others", () => {
  assert.deepEqual(found("perspective"), [0, 3, 4]);
  assert.deepEqual(found("-perspective"), [1, 2]);
  assert.deepEqual(found("view_angle=0"), [0, 1, 4]);
  assert.deepEqual(found("-view_angle=0"), [2, 3]);
  assert.deepEqual(found("max_steps=32"), [0, 2]);
  assert.deepEqual(found("-max_steps=32"), [1, 3, 4]);
  assert.deepEqual(found("linear -perspective"), [1, 2]);
  assert.deepEqual(found("self_shadow=off uv<0.5"), [2, 3]);
});

test("names of axes are no values: a word that is in none of them finds nothing by them", () => {
  const { found: none, notes } = search("self_shadow");
  assert.deepEqual(none, []);
  assert.match(notes[0]!.text, /“self_shadow” is a column and no value.*self_shadow=off/);
});

test("numbers are compared as numbers, and sizes by their sides", () => {
  assert.deepEqual(found("view_angle=60.0"), [2, 3]);
  assert.deepEqual(found("height_scale=1e-1"), [3]);
  assert.deepEqual(found("view_angle>0 height_scale<0.1"), [2]);
  assert.deepEqual(found("view_angle = 0,60 max_steps >= 9"), [0, 2]);
  assert.deepEqual(found("heightmap_size=256"), [0, 1, 2, 3]);
  assert.deepEqual(found("heightmap_size=512x256"), [4]);
  assert.deepEqual(found("heightmap_size>256"), [4]);
  assert.deepEqual(found("60"), [2, 3], "a number as a word is a whole value");
  assert.deepEqual(found("-60 8"), [1]);
  assert.deepEqual(found("max_steps≤8"), [1]);
  assert.deepEqual(found("max_steps!=8"), [0, 2, 3, 4]);
});

test("figures are compared by the table's titles and by their paths; what has no value is within no bound", () => {
  assert.deepEqual(found("uv<=1"), [0, 2, 3]);
  assert.deepEqual(found("UV=0"), [3]);
  assert.deepEqual(found("error.uv_texels.p99>1"), [1]);
  assert.deepEqual(found("error.missed<0.001"), [2, 3], "in the unit of cells.jsonl");
  assert.deepEqual(found("uv>-1"), [0, 1, 2, 3]);
  assert.deepEqual(found("-uv>=0"), [4]);
});

test("techniques and height maps are found by a part as words, and whole as values", () => {
  assert.deepEqual(found("CONE"), [3, 4]);
  assert.deepEqual(found("technique=cone_step"), [3]);
  assert.deepEqual(found("technique=pom,robust_cone -bricks"), []);
  assert.deepEqual(found("heightmap=bricks pom"), [0, 1, 2]);
  assert.deepEqual(found("rocks"), [3]);
  assert.deepEqual(found('heightmap="gray rocks 02.png"'), [3], "without its folder");
  assert.deepEqual(found('"gray rocks" axes.heightmap="maps/Gray Rocks 02.png"'), [3]);
});

test("status and reason are searched, and a pasted id finds its cell", () => {
  assert.deepEqual(found("status:failed"), [4]);
  assert.deepEqual(found("-status=failed pom"), [0, 1, 2]);
  assert.deepEqual(found("trace.glsl:3"), [4]);
  assert.deepEqual(found("pom max_steps=8 | projection=parallel"), [1]);
  assert.deepEqual(found(""), all);
});

test("a column that there is not is told, with the one that may be meant", () => {
  const { found: none, notes } = search("pom view_angel=60");
  assert.deepEqual(none, []);
  assert.equal(notes[0]!.text, "There is no column “view_angel” in this run.");
  assert.deepEqual(notes[0]!.correction, { label: "view_angle=60", query: "pom view_angle=60" });
  assert.equal(search("steps<9").notes[0]!.correction!.query, "max_steps<9", "a part of a name will do");
  const far = search("nothing<9").notes[0]!;
  assert.match(far.text, /no column “nothing” in this run. There are heightmap, /);
  assert.equal(far.correction, null);
});

test("a value that no cell has is told, with those that there are", () => {
  const { found: none, notes } = search("heightmap=brick pom");
  assert.deepEqual(none, []);
  assert.match(notes[0]!.text, /No cell of this run has heightmap=brick. There are bricks, maps/);
  assert.equal(notes[0]!.correction!.query, "heightmap=bricks pom");
  const word = search("-perspektive");
  assert.deepEqual(word.found, all);
  assert.equal(word.notes[0]!.text, "No cell of this run has “perspektive”.");
  assert.equal(word.notes[0]!.correction!.query, "-perspective");
});

test("what cannot be compared is told", () => {
  assert.match(search("heightmap<rock").notes[0]!.text, /expected a number after </);
  assert.match(search("projection<3").notes[0]!.text, /projection is no number.*perspective, parallel/);
  assert.match(search("uv<abc").notes[0]!.text, /uv<abc: expected a number/);
  const typing = search("pom uv<");
  assert.deepEqual(typing.found, [0, 1, 2], "a condition that is being typed hides nothing");
  assert.match(typing.notes[0]!.text, /A value is missing/);
});

test("names are suggested by edit distance, swaps of neighbours included, else by a part", () => {
  assert.equal(suggestion("heihgtmap", ["heightmap", "heightmap_size"]), "heightmap");
  assert.equal(suggestion("angle", ["azimuth", "view_angle"]), "view_angle");
  assert.equal(suggestion("xyz", ["heightmap"]), null);
  assert.equal(suggestion("a", []), null);
});
