import assert from "node:assert/strict";
import { test } from "node:test";

import list from "../../scripts/figures.json";
import { errorMetrics } from "../src/metrics.ts";
import { errorWords, inSentence } from "../src/views/advice_words.ts";
import type { Figure } from "../src/data.ts";
import { cellsOf } from "./cells.ts";

const figures = list.map((figure) => ({ ...figure, tolerance: { absolute: 0, relative: 0 } })) as Figure[];
const cells = cellsOf([{ id: "any | view", numbers: Object.fromEntries(list.map(({ path }) => [path, 1])) }]);

test("an error that is a percentile over pixels is told by how many are within it, any other by its label", () => {
  const errors = errorMetrics(figures, cells);
  const percents = new Set<string>();
  for (const error of errors) {
    const words = errorWords(error, 0.5);
    const [, named] = /, (?:p([0-9.]+)|median)$/.exec(error.label) ?? [];
    // Percentiles of outlines are over their pixels, which are few of all.
    const isOfPixels = error.id.startsWith("error.") && !error.id.startsWith("error.outline");
    const isPercentile = /, (p[0-9.]+|median)$/.test(error.label) && isOfPixels;
    if (isPercentile) {
      const percent = named ?? "50";
      percents.add(percent);
      assert.ok(words.startsWith(`${percent} % of its pixels are within 0.5`), `${error.id}: ${words}`);
      assert.equal(errorWords(error, 0), `${percent} % of its pixels have no error`);
    } else {
      assert.ok(words.startsWith(`${inSentence(error.label)} `), `${error.id}: ${words}`);
    }
  }
  assert.deepEqual([...percents].sort(), ["50", "95", "99", "99.9"]);
  assert.ok(errors.length > 20);
});
