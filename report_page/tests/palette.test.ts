import assert from "node:assert/strict";
import { test } from "node:test";

import { fnv1a, lineLook, markNumbers, markOf } from "../src/palette.ts";
import expected from "./marks_of_names.json";

test("the hash is FNV-1a of the bytes of UTF-8", () => {
  // Of the authors' own list of test vectors.
  assert.equal(fnv1a("", 0x811c9dc5), 0x811c9dc5);
  assert.equal(fnv1a("foobar", 0x811c9dc5), 0xbf9cf968);
  assert.equal(fnv1a("é", 0x811c9dc5), fnv1a("é", 0x811c9dc5));
});

test("25 lines of one technique differ in dashes or filling, the first five in both", () => {
  const looks = Array.from({ length: 25 }, (_, at) => lineLook(at));
  assert.equal(new Set(looks.map((look) => JSON.stringify(look))).size, 25);
  assert.deepEqual(
    looks.slice(0, 5).map(({ filled }) => filled),
    ["full", "left", "right", "bottom", "top"],
  );
  assert.equal(new Set(looks.slice(0, 5).map(({ dash }) => String(dash))).size, 5);
});

test("names have the marks that the figures of scripts/plot.py give them", () => {
  for (const { names, numbers } of expected)
    assert.deepEqual(
      Object.fromEntries(markNumbers(names)),
      Object.fromEntries(names.map((name, at) => [name, numbers[at]])),
    );
});

test("a name keeps its mark whatever stands beside it, in whichever order", () => {
  const alone = (name: string) => markNumbers([name]).get(name);
  const names = ["flat", "steep", "pom", "qdm", "mine"];
  const together = markNumbers(names);
  assert.deepEqual(together, new Map([...markNumbers([...names].reverse())].sort()));
  for (const name of names) assert.equal(together.get(name), alone(name), name);
});

test("no two of many names have colour and shape in common", () => {
  const names = Array.from({ length: 56 }, (_, at) => `technique_${at}`);
  const seen = new Set([...markNumbers(names).values()].map((number) => JSON.stringify(markOf(number, "light"))));
  assert.equal(seen.size, 56);
  assert.equal(markNumbers([...names, "one more"]).size, 57);
});
