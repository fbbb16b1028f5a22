// How long a browser takes to show a report: node first_paint.mjs RELIEFBENCH [CELLS] [REPETITIONS]. Prints; asserts
// nothing.

import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, statSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { openBrowser } from "./browser.mjs";
import { largeRun, writeRun } from "./runs.mjs";

const [binary, cells = "10000", repetitions = "5"] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), "reliefbench-first-paint-"));
const file = join(folder, "report.html");

writeRun(join(folder, "run"), largeRun(Number(cells)));
const start = performance.now();
execFileSync(binary, ["report", join(folder, "run"), "-o", file]);
console.log(
  `${cells} cells: report written in ${Math.round(performance.now() - start)} ms, ${(statSync(file).size / 1e6).toFixed(2)} MB`,
);

const browser = await openBrowser();
for (let repetition = 0; repetition < Number(repetitions); ++repetition) {
  const page = await browser.context.newPage();
  await page.goto(`file://${file}`);
  await page.waitForSelector(".chart canvas");
  const times = await page.evaluate(
    () =>
      new Promise((resolve) => {
        // The frame after next has the chart in it.
        requestAnimationFrame(() =>
          requestAnimationFrame(() =>
            resolve({
              drawn: performance.now(),
              paint: performance.getEntriesByName("first-contentful-paint")[0]?.startTime ?? NaN,
            }),
          ),
        );
      }),
  );
  const filtered = await page.evaluate(() => {
    const before = performance.now();
    document.querySelector("[data-filter=technique] .chip").click();
    return performance.now() - before;
  });
  console.log(
    `first paint ${Math.round(times.paint)} ms, chart drawn by ${Math.round(times.drawn)} ms; a filter takes ${Math.round(filtered)} ms`,
  );
  await page.close();
}
await browser.close();
rmSync(folder, { recursive: true, force: true });
