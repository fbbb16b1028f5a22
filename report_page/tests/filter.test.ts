import assert from "node:assert/strict";
import { test } from "node:test";

import { filteredCells, measuredCells, reasonGroups } from "../src/filter.ts";
import { sortRows } from "../src/table.ts";
import { cellsOf, measured } from "./cells.ts";

const cells = cellsOf([
  measured("pom", 8, 0, 1, 1),
  measured("pom", 8, 60, 1, 1),
  measured("qdm", 8, 60, 1, 1),
  { id: "mine | view_angle=60", axes: { view_angle: 60 }, status: "failed", reason: "no" },
  { id: "mine | view_angle=0", axes: { view_angle: 0 }, status: "failed", reason: "no" },
  { id: "other | view_angle=0", status: "skipped", reason: "not here" },
]);

test("techniques and axes narrow together; an empty list shows all", () => {
  assert.deepEqual(filteredCells(cells, { filters: {}, techniques: [] }), [0, 1, 2, 3, 4, 5]);
  assert.deepEqual(filteredCells(cells, { filters: { view_angle: ["60"] }, techniques: ["pom", "mine"] }), [1, 3]);
  assert.deepEqual(filteredCells(cells, { filters: { view_angle: [] }, techniques: ["qdm"] }), [2]);
});

test("an axis that the run does not have filters nothing, and a cell without the axis does not pass one that it has", () => {
  assert.deepEqual(filteredCells(cells, { filters: { fog: ["1"], toString: ["1"] }, techniques: ["qdm"] }), [2]);
  assert.deepEqual(filteredCells(cells, { filters: { view_angle: ["0"] }, techniques: [] }), [0, 4]);
});

test("cells that were not measured are told by reason", () => {
  assert.deepEqual(measuredCells(cells, [0, 3, 5]), [0]);
  assert.deepEqual(
    reasonGroups(cells).map(({ status, reason, cells: members }) => [status, reason, members.length]),
    [
      ["failed", "no", 2],
      ["skipped", "not here", 1],
    ],
  );
});

test("rows sort either way, equal ones keep their order, undefined ones come last", () => {
  const rows = [
    { name: "a", key: 2 },
    { name: "b", key: null },
    { name: "c", key: 1 },
    { name: "d", key: 2 },
  ];
  const columns = [{ id: "key", title: "", number: true, key: (row: (typeof rows)[0]) => row.key, content: () => "" }];
  const sorted = (sort: string) =>
    sortRows(rows, columns, sort)
      .map(({ name }) => name)
      .join("");
  assert.equal(sorted("key"), "cadb");
  assert.equal(sorted("-key"), "adcb");
  assert.equal(sorted("unknown"), "abcd");
});
