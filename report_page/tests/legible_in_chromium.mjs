// What can be read from the page, in a real browser: node legible_in_chromium.mjs RELIEFBENCH.

import assert from "node:assert/strict";
import { test } from "node:test";

import { findMark, inSight, open, page, report, testsOfPage, texts, write } from "./page_under_test.mjs";
import { measured, smallRun, unmeasured } from "./runs.mjs";

const pom = "pom max_steps=32 | heightmap=rock view_angle=60";
const failed = unmeasured({ technique: "mine", status: "failed", reason: "trace.glsl:3: 'this' : Reserved word." });
const skipped = unmeasured({ technique: "tessellation", status: "skipped", reason: "the device has no tessellation" });
const views = ["cost", "advice", "axes", "pictures", "timing", "changes", "cells", "run"];

testsOfPage(() => {
  const picture = (x, y) => [x * 4, y * 4, 7];
  const pictures = { [pom]: { technique: picture, truth: picture, uv_error: () => [0, 0, 3] } };
  // What was not measured comes first, as techniques without a view do.
  write("run", [failed, skipped, ...smallRun()], { pictures });
  write("later", smallRun({ slowdown: 2 }), { samples: 6 });
  write("skipped", [skipped, ...smallRun()]);
  write("near", [
    measured({ technique: "pom", ms: 1, uv: 1, spread: 0.4, outliers: 4 }),
    measured({ technique: "qdm", ms: 1.01, uv: 1.05 }),
  ]);
  const angles = [0, 45, 60, 75].flatMap((view_angle) =>
    [8, 32, 128].map((max_steps) => {
      const params = { max_steps, min_steps: max_steps / 4 };
      return measured({ technique: "pom", params, axes: { view_angle }, ms: 0.123, uv: 0.000123 });
    }),
  );
  write("beside", angles);
  report("beside", "beside");
  write("leaves", [
    measured({ technique: "pom", ms: 1, uv: 0.1 }),
    ...["exact", "linear"].flatMap((leaf) =>
      [8, 32].map((max_steps) =>
        measured({ technique: "qdm", params: { leaf, max_steps }, ms: max_steps / 10, uv: 1, steps: max_steps }),
      ),
    ),
  ]);
  report("leaves", "leaves");
  report("run", "run");
  report("later", "run", "later");
  report("skipped", "skipped");
  report("near", "near");
});

/** The numbers that canvases drew since `open`, in order, with where they stand. */
async function drawnNumbers() {
  return page.evaluate(() => window.drawn.filter(({ text }) => /^[−\d.·⁻⁰¹²³⁴⁵⁶⁷⁸⁹e+-]+$/.test(text)));
}

/** Opens a page whose canvases tell what they write. */
async function openTelling(name, fragment) {
  await page.addInitScript(() => {
    window.drawn = [];
    const write = CanvasRenderingContext2D.prototype.fillText;
    CanvasRenderingContext2D.prototype.fillText = function (text, x, y, ...more) {
      const { x: left, y: top } = this.getTransform().transformPoint({ x, y });
      window.drawn.push({ text, left: Math.round(left), top: Math.round(top) });
      return write.call(this, text, x, y, ...more);
    };
  });
  await open(name, fragment);
  await page.waitForFunction(() => window.drawn.length > 0);
}

/** The horizontal axis has its numbers on the lowest line. */
function byAxis(numbers) {
  const lowest = Math.max(...numbers.map(({ top }) => top));
  const isLowest = ({ top }) => Math.abs(top - lowest) < 3;
  const distinct = (some) => [...new Set(some.map(({ text }) => text))];
  return [distinct(numbers.filter(isLowest)), distinct(numbers.filter((number) => !isLowest(number)))];
}

test("every axis has two numbers or more, written out, also where all values are near and after zooming", async () => {
  await openTelling("near");
  for (const numbers of byAxis(await drawnNumbers())) {
    assert.ok(numbers.length >= 2, String(numbers));
    for (const number of numbers) assert.match(number, /^\d+(\.\d+)?$/);
  }
  await page.evaluate(() => (window.drawn = []));
  const box = await page.locator("main .chart").boundingBox();
  await page.mouse.move(box.x + 0.7 * box.width, box.y + 0.4 * box.height);
  await page.mouse.wheel(0, -600);
  await page.waitForFunction(() => window.drawn.length > 4);
  await page.waitForTimeout(200);
  const last = (await drawnNumbers()).slice(-16);
  for (const numbers of byAxis(last)) assert.ok(numbers.length >= 2, String(numbers));
});

test("lines of one technique are told apart by dashes and filling, and a legend says which is which", async () => {
  await page.addInitScript(() => {
    window.dashes = [];
    const set = CanvasRenderingContext2D.prototype.setLineDash;
    CanvasRenderingContext2D.prototype.setLineDash = function (dashes) {
      window.dashes.push([...dashes]);
      return set.call(this, dashes);
    };
  });
  await open("leaves", "view=axes&x=steps");
  await page.waitForSelector(".chart canvas");
  assert.deepEqual(await texts(".lines li"), ["qdm leaf=exact", "qdm leaf=linear"]);
  const looks = await page.$$eval(".lines svg.line-mark", (all) => all.map((svg) => svg.innerHTML));
  assert.equal(new Set(looks).size, 2);
  const drawn = await page.evaluate(() => window.dashes.map(String));
  assert.ok(drawn.includes("8,3.2"), `the second is dashed: ${[...new Set(drawn)]}`);
  await open("leaves", "view=axes&x=steps&techniques=pom");
  assert.deepEqual(await texts(".lines li"), [], "a technique's only line needs none");
});

test("a swept axis has its own values below it", async () => {
  await openTelling("run", "view=axes&x=param.max_steps");
  assert.deepEqual(byAxis(await drawnNumbers())[0], ["8", "32", "128"]);
});

test("tables at 1280 pixels show what a row is of and how good it is without scrolling", async () => {
  await page.setViewportSize({ width: 1280, height: 900 });
  const columns = (...ids) => ids.map((id) => `[data-column='${id}']`);
  await open("run", "view=cells");
  const quality = columns(
    "cell",
    "time.draw.median_ms",
    "error.uv_texels.p99",
    "image.flip",
    "error.missed",
    "error.false_hits",
  );
  assert.deepEqual(await inSight(quality), quality);
  const row = ".rows tbody tr:has-text('max_steps=32')";
  assert.match(await page.textContent(`${row} >> nth=0 >> td >> nth=0`), /^pommax_steps=32rock · 0°$/);
  await open("later", "view=changes");
  const verdict = columns("cell", "verdict", "ratio", "quality");
  assert.deepEqual(await inSight(verdict), verdict);
  assert.match(await page.textContent(".rows tbody tr >> nth=0 >> td >> nth=0"), /rock · 0°|bricks · /);
});

test("four values beside each other have their costs and errors in sight at 1280 pixels", async () => {
  await open("beside", "view=axes&x=axis.view_angle");
  const { right, frame } = await page.$eval(".beside-scroll", (scroll) => ({
    right: scroll.querySelector("tbody td:last-child").getBoundingClientRect().right,
    frame: scroll.getBoundingClientRect().right,
  }));
  assert.equal(await page.locator(".value-head").count(), 4);
  assert.ok(right <= frame + 0.5, `${right} beyond ${frame}`);
});

test("a row without figures has its reason in their place", async () => {
  await open("run", "view=cells");
  assert.match(
    await page.textContent(".rows tbody tr >> nth=0"),
    /^minefailed.*trace\.glsl:3: 'this' : Reserved word\.$/,
  );
  const box = await page.locator(".rows .instead").first().boundingBox();
  assert.ok(box.x + 200 < 1280, "it can be read without scrolling");
});

test("pictures and timing show the best cell of the hardest view while nothing is pinned, and say so", async () => {
  await open("run", "view=timing");
  assert.equal(await page.getAttribute("[data-best]", "data-best"), "qdm leaf=exact | heightmap=rock view_angle=60");
  assert.match(
    await page.textContent(".best"),
    /Best.*qdm.*0\.500 ms.*Nothing is pinned.*hardest view \(largest median of UV error, p99\) of 4.*cheapest.*cannot be told/,
  );
  await page.waitForSelector(".timing .chart canvas");
  await open("run", "view=timing&axis.view_angle=0&axis.heightmap=rock");
  // There all errors are within what can be told apart.
  assert.equal(await page.getAttribute("[data-best]", "data-best"), "pom max_steps=8 | heightmap=rock view_angle=0");
  await open("run", "view=pictures");
  await page.waitForSelector("canvas[data-picture=map]");
  assert.equal(await page.getAttribute("[data-best]", "data-best"), pom, "of those that have pictures");
  await page.click(".best button");
  assert.equal(await page.getAttribute(".pin", "data-pin"), pom);
  assert.equal(await page.locator(".best").count(), 0);
});

test("a pinned cell that failed shows what became of it and why, in every view", async () => {
  for (const view of views.filter((each) => each !== "changes")) {
    await open("run", `view=${view}&pin=${encodeURIComponent(failed.cell)}`);
    assert.match(await page.textContent(".pin"), /minefailed|mine.*failed.*trace\.glsl:3: 'this' : Reserved word\./);
  }
  await open("run", `view=timing&pin=${encodeURIComponent(failed.cell)}`);
  assert.match(await page.textContent(".timing"), /^There are no times of this cell: it was not measured\.$/);
});

test("the list of columns does not print one line over another", async () => {
  await open("run", "view=cells");
  await page.click(".picker summary");
  const boxes = await page.$$eval(".picker-list :is(input[type=search], button, legend, label)", (items) =>
    items.map((item) => item.getBoundingClientRect()).map(({ top, bottom }) => ({ top, bottom })),
  );
  assert.ok(boxes.length > 20);
  for (let at = 1; at < boxes.length; ++at) assert.ok(boxes[at].top >= boxes[at - 1].bottom, `line ${at}`);
  for (const { top, bottom } of boxes) assert.ok(bottom - top > 15, "its text is not beside its box");
});

test("times have their 95 % interval in charts and in what hovering tells, and outliers are warned of", async () => {
  await open("near");
  await page.waitForSelector(".chart canvas");
  const at = await findMark([0xa8, 0x32, 0x8a]);
  // From 0.6 to 1.4 ms on an axis that is not much longer.
  const reach = await page.evaluate(({ y }) => {
    const canvas = document.querySelector("main .chart canvas");
    const box = canvas.getBoundingClientRect();
    const { width, height } = canvas;
    const copy = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
    copy.drawImage(canvas, 0, 0);
    const top = Math.round(((y - box.top) * height) / box.height);
    let [least, greatest] = [width, 0];
    const { data } = copy.getImageData(0, top - 8, width, 32);
    for (let pixel = 0; pixel < width * 32; ++pixel) {
      const [red, green, blue] = data.subarray(4 * pixel, 4 * pixel + 3);
      const column = pixel % width;
      if (red - green > 40 && blue - green > 30)
        [least, greatest] = [Math.min(least, column), Math.max(greatest, column)];
    }
    return (greatest - least) / width;
  }, at);
  assert.ok(reach > 0.5, `the bar spans ${reach} of the chart`);
  await page.mouse.move(at.x, at.y);
  await page.waitForSelector(".tip");
  assert.match(
    await page.textContent(".tip"),
    /Draw time1\.00 ms95 % interval0\.600 to 1\.40 ms.*4 of 18 samples are outliers/,
  );
  assert.match(await page.textContent(".disturbed .warning"), /outliers in 1 of 2 cells/);
  await open("near", `view=timing&pin=${encodeURIComponent("pom | ")}`);
  assert.match(await page.textContent(".timing .warning"), /4 of 18 samples are outliers/);
  await open("near", `view=timing&pin=${encodeURIComponent("qdm | ")}`);
  assert.equal(await page.locator(".timing .warning").count(), 0);
});

test("quartiles are drawn of five samples or more", async () => {
  await open("run", "view=timing");
  assert.match(await page.textContent(".timing figcaption"), /Dots: the median; lines: least to greatest\./);
  const at = await findMark([0x1c, 0x20, 0x26]);
  await page.mouse.move(at.x, at.y);
  await page.waitForSelector(".tip");
  assert.match(await page.textContent(".tip"), /^Round \d2 samplesleast[^q]*median[^q]*greatest[^q]*$/);
  await open("later", "run=1&view=timing");
  assert.match(await page.textContent(".timing figcaption"), /Boxes: quartiles; whiskers: least and greatest\./);
});

test("facts and warnings look different, and not by colour alone", async () => {
  const look = (selector) =>
    page.$eval(selector, (element) => {
      const { backgroundColor, borderLeftWidth } = getComputedStyle(element);
      return { backgroundColor, borderLeftWidth, sign: element.textContent.includes("⚠") };
    });
  await open("run");
  const warning = await look(".view-cost .warning");
  await open("skipped");
  const fact = await look(".view-cost .fact");
  assert.deepEqual([warning.sign, fact.sign], [true, false]);
  assert.notEqual(warning.backgroundColor, fact.backgroundColor);
  assert.notEqual(warning.borderLeftWidth, fact.borderLeftWidth);
  await open("later", "view=changes");
  assert.match(await page.textContent(".view-changes ul.fact"), /noise between runs/);
  assert.match(await page.textContent(".header > .warning"), /^⚠ all rays run along rows or columns of texels/);
});

test("techniques of which nothing was measured come last in the legend", async () => {
  await open("run");
  assert.deepEqual(await texts("[data-filter=technique] .chip-name"), ["flat", "pom", "qdm", "mine", "tessellation"]);
  assert.deepEqual((await texts("[data-filter=technique] .count")).slice(-2), ["failed", "skipped"]);
});

test("what a map's colours mean is written in the page's own ink, light or dark", async () => {
  await page.emulateMedia({ colorScheme: "light" });
  for (const theme of ["light", "dark"]) {
    await page.emulateMedia({ colorScheme: theme });
    await open("run", "view=pictures");
    await page.waitForSelector(".legend");
    assert.match(await page.textContent(".legend"), /^UV error, texels0\.010\.1110missedfalse hit.*nothing$/);
    const [ink, page_ink, backgrounds] = await page.evaluate(() => {
      const colour = (selector) => getComputedStyle(document.querySelector(selector)).color;
      const backs = [...document.querySelectorAll(".legend, .legend :not(.swatch, canvas)")];
      return [
        colour(".legend-marks span"),
        colour("body"),
        backs.map((each) => getComputedStyle(each).backgroundColor),
      ];
    });
    assert.equal(ink, page_ink, theme);
    assert.deepEqual([...new Set(backgrounds)], ["rgba(0, 0, 0, 0)"], theme);
  }
  await page.emulateMedia({ colorScheme: "light" });
});
