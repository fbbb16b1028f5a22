import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { test } from "node:test";

import list from "../../scripts/figures.json";
import names from "../../scripts/short_names.json";
import * as defaults from "../src/defaults.ts";
import { grouped, passFigure } from "../src/figures.ts";
import { costMetrics, errorMetrics } from "../src/metrics.ts";
import type { Cells, Figure } from "../src/data.ts";
import { cellsOf } from "./cells.ts";

const figures = list.map((figure) => ({ ...figure, tolerance: { absolute: 0, relative: 0 } })) as Figure[];
/** The tests lie beside the sources' folder, bundled or not. */
const source = fileURLToPath(new URL("../src/", import.meta.url));

/** A cell that has every figure of a list. */
function withAll(all: readonly Figure[]): Cells {
  return cellsOf([{ id: "any | view", numbers: Object.fromEntries(all.map(({ path }) => [path, 1])) }]);
}

function offered(all: readonly Figure[]): string[] {
  const cells = withAll(all);
  return [...costMetrics(all, cells), ...errorMetrics(all, cells)].map(({ id }) => id);
}

test("every figure of reliefbench's list with a direction is on offer, once, as a cost or as an error", () => {
  const wanted = figures.filter(({ better }) => better !== "neither").map(({ path }) => path);
  assert.ok(wanted.length > 50);
  assert.deepEqual(offered(figures).sort(), [...wanted, defaults.wrongHits].sort());
  for (const path of ["error.shadow.mean", "work.shadow_taps_mean", "motion.flip.p95", "prepare.bytes"])
    assert.ok(wanted.includes(path), path);
});

test("a figure that the page has never heard of is on offer with its label, unit and direction", () => {
  const tolerance = { absolute: 0, relative: 0 };
  const later: Figure[] = [
    ...figures,
    {
      path: "error.outline.p95",
      label: "Outline error, p95",
      unit: "pixels",
      better: "lower",
      needs: ["truth"],
      tolerance,
    },
    { path: "memory.peak_bytes", label: "Peak memory", unit: "bytes", better: "lower", needs: [], tolerance },
    { path: "temporal.stability", label: "Stability", unit: "", better: "higher", needs: [], tolerance },
  ];
  const cells = withAll(later);
  const error = errorMetrics(later, cells).find(({ id }) => id === "error.outline.p95")!;
  assert.deepEqual([error.label, error.unit, error.better], ["Outline error, p95", "pixels", "lower"]);
  assert.ok(errorMetrics(later, cells).some(({ id }) => id === "temporal.stability"));
  assert.equal(costMetrics(later, cells).at(-1)!.label, "Peak memory");
});

test("lists to choose from have headings, and no figure is lost among them", () => {
  const paths = figures.map(({ path }) => path);
  const groups = grouped(paths, (path) => path);
  assert.deepEqual(groups.flatMap((group) => group.figures).sort(), [...paths].sort());
  const titles = groups.map(({ title }) => title);
  assert.equal(new Set(titles).size, titles.length);
  for (const title of ["error · uv texels", "error · shadow", "image", "image · footprint", "motion · flip", "work"])
    assert.ok(titles.includes(title), title);
  assert.deepEqual(
    grouped(["a.b.c", "a.d", "e.f.g", "e.f.h"], (path) => path),
    [
      { title: "a", figures: ["a.b.c", "a.d"] },
      { title: "e · f", figures: ["e.f.g", "e.f.h"] },
    ],
  );
  assert.deepEqual(passFigure("time.level_1.ci95_ms.low"), { pass: "level_1", figure: "ci95_ms.low" });
  assert.equal(passFigure("time.ns_per_pixel"), null);
});

test("what the page chooses is in reliefbench's list", () => {
  const paths = new Set(figures.map(({ path }) => path));
  const { spentGroups, wrongHits, usualMap, stopWord, drawPass, ...chosen } = defaults;
  for (const path of Object.values(chosen).flatMap((value) => (typeof value === "string" ? [value] : valuesOf(value))))
    assert.ok(paths.has(path), path);
  for (const group of spentGroups)
    assert.ok(
      figures.some(({ path }) => path.startsWith(`${group}.`)),
      group,
    );
  assert.ok(figures.some(({ path }) => path.startsWith(`time.${drawPass}.`)));
  assert.ok(![wrongHits, usualMap, stopWord].some((name) => paths.has(name)));
  assert.equal(new Set(Object.keys(names).map((name) => name.toLowerCase())).size, Object.keys(names).length);
});

function valuesOf(value: object): string[] {
  return Object.values(value).flatMap((each: unknown) =>
    typeof each === "string" ? [each] : valuesOf(each as object),
  );
}

/** Code without its comments. */
function code(text: string): string {
  return text.replace(/\/\*[^]*?\*\//g, "").replace(/(^|\s)\/\/.*$/gm, "$1");
}

test("paths of figures stand in defaults.ts alone, and labels nowhere", () => {
  const files = readdirSync(source, { recursive: true, encoding: "utf8" }).filter((name) => name.endsWith(".ts"));
  assert.ok(files.length > 30, "found next to nothing to check");
  const groups = [...new Set(figures.map(({ path }) => path.split(".")[0]!))];
  const path = new RegExp(`["'\`/^](${groups.join("|")})\\\\?\\.`);
  for (const name of files) {
    const text = code(readFileSync(join(source, name), "utf8"));
    // Of one word a label may be what it is in English.
    for (const { label } of figures.filter((figure) => figure.label.includes(" ")))
      assert.ok(!text.includes(label), `${name} has the label “${label}”`);
    if (name === "defaults.ts") continue;
    for (const figure of figures) assert.ok(!text.includes(figure.path), `${name} names ${figure.path}`);
    const found = path.exec(text);
    assert.equal(found?.[0], undefined, `${name} names figures`);
  }
});
