// How the page is laid out for the width of its window, in a real browser: node layout_in_chromium.mjs RELIEFBENCH.

import assert from "node:assert/strict";
import { test } from "node:test";

import { inSight, open, page, report, testsOfPage, write } from "./page_under_test.mjs";
import { measured, smallRun, unmeasured } from "./runs.mjs";

const pom = "pom max_steps=32 | heightmap=rock view_angle=60";
const failed = unmeasured({ technique: "mine", status: "failed", reason: "trace.glsl:3: 'this' : Reserved word." });
const views = ["cost", "advice", "axes", "pictures", "timing", "changes", "cells", "run"];

testsOfPage(() => {
  const picture = (x, y) => [x * 4, y * 4, 7];
  const pictures = { [pom]: { technique: picture, truth: picture, uv_error: () => [0, 0, 3] } };
  write("run", [failed, ...smallRun()], { pictures });
  write("later", smallRun({ slowdown: 2 }));
  const angles = [0, 45, 60, 75].flatMap((view_angle) =>
    [8, 32, 128].map((max_steps) => {
      const params = { max_steps, min_steps: max_steps / 4 };
      return measured({ technique: "pom", params, axes: { view_angle }, ms: 0.123, uv: 0.000123 });
    }),
  );
  write("angles", angles);
  write("again", angles);
  write("mixed", [
    ...Array.from({ length: 60 }, (_, at) => at).flatMap((tiling) => [
      measured({ technique: "flat", axes: { tiling }, ms: 0.1, uv: 1 }),
      measured({ technique: "pom", params: { max_steps: 128, min_steps: 32 }, axes: { tiling }, ms: 1, uv: 0.1 }),
    ]),
  ]);
  report("run", "run");
  report("later", "run", "later");
  report("angles", "angles", "again");
  report("mixed", "mixed");
});

/** What of the words in the first column of a table is cut off, covered, or broken over two lines. */
async function spoiltWords() {
  return page.$$eval(".rows tbody td:first-child", (cells) =>
    cells.flatMap((cell) => {
      const frame = cell.getBoundingClientRect();
      const texts = document.createTreeWalker(cell, NodeFilter.SHOW_TEXT);
      const spoilt = [];
      while (texts.nextNode()) {
        for (const { 0: word, index } of texts.currentNode.data.matchAll(/\S+/g)) {
          const range = document.createRange();
          range.setStart(texts.currentNode, index);
          range.setEnd(texts.currentNode, index + word.length);
          const boxes = [...range.getClientRects()];
          const outside = ({ left, right, top, bottom }) =>
            left < frame.left || right > frame.right || top < frame.top || bottom > frame.bottom;
          if (boxes.length !== 1 || outside(boxes[0])) spoilt.push(word);
        }
      }
      return spoilt;
    }),
  );
}

test("whose row it is can be read in full beside the first figures, on a phone too", async () => {
  for (const width of [1280, 390]) {
    await page.setViewportSize({ width, height: 900 });
    for (const [view, ...figures] of [
      ["cells", "time.draw.median_ms", "error.uv_texels.p99"],
      ["changes", "verdict", "ratio"],
    ]) {
      await open("angles", `view=${view}`);
      assert.match(await page.textContent(".rows tbody"), /max_steps=128 min_steps=32/);
      assert.deepEqual(await spoiltWords(), [], `${view} at ${width}`);
      const wanted = figures.map((id) => `[data-column='${id}']`);
      assert.deepEqual(await inSight(wanted), wanted, `${view} at ${width}`);
    }
  }
  await page.setViewportSize({ width: 1280, height: 900 });
});

test("a table of rows of different heights has rows wherever it is scrolled to, and reaches its ends", async () => {
  await page.setViewportSize({ width: 390, height: 1200 });
  await open("mixed", "view=cells");
  const at = (share) =>
    page.evaluate(async (part) => {
      const scroll = document.querySelector(".table-scroll");
      scroll.scrollIntoView({ block: "end" });
      scroll.scrollTop = part * scroll.scrollHeight;
      const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
      for (let count = 0; count < 3; ++count) await frame();
      const { left, top, bottom } = scroll.getBoundingClientRect();
      const row = (y) => document.elementFromPoint(left + 20, y)?.closest("tbody tr:not(.spacer)")?.textContent ?? null;
      const below = scroll.querySelector("th").getBoundingClientRect().bottom;
      return [below + 10, (top + bottom) / 2, bottom - 10].map(row);
    }, share);
  for (const share of [0, 0.3, 0.8, 0.5, 1, 0]) {
    const rows = await at(share);
    assert.ok(!rows.includes(null), `${share}: ${rows}`);
    if (share === 1) assert.match(rows[2], /tiling 59/);
    if (share === 0) assert.match(rows[0], /^flat/);
  }
  await open("mixed", `view=cells&pin=${encodeURIComponent("pom max_steps=128 min_steps=32 | tiling=40")}`);
  const inFrame = await page.evaluate(() => {
    const [row, frame] = [".rows .pinned", ".table-scroll"].map((each) =>
      document.querySelector(each)?.getBoundingClientRect(),
    );
    return row !== undefined && row.top >= frame.top && row.bottom <= frame.bottom;
  });
  assert.ok(inFrame, "the pinned row is in sight");
  await page.setViewportSize({ width: 1280, height: 900 });
});

test("charts of a window that was made narrower or wider are those of one that was opened so", async () => {
  const drawn = () => page.$$eval("main .chart canvas", (canvases) => canvases.map((canvas) => canvas.toDataURL()));
  for (const fragment of ["", "view=axes", "view=timing"]) {
    for (const [from, to] of [
      [1280, 390],
      [500, 390],
      [390, 1280],
    ]) {
      await page.setViewportSize({ width: to, height: 900 });
      await open("run", fragment);
      await page.waitForSelector(".chart canvas");
      let expected = [];
      for (let before = null; JSON.stringify(expected) !== before; await page.waitForTimeout(200)) {
        before = JSON.stringify(expected);
        expected = await drawn();
      }
      await page.setViewportSize({ width: from, height: 900 });
      await open("run", fragment);
      await page.waitForSelector(".chart canvas");
      await page.setViewportSize({ width: to, height: 900 });
      assert.ok(expected.length > 0 && expected.every((image) => image.length > 1000), fragment);
      // A busy machine draws late: what is asked is what comes out, not when.
      const isSame = async () => (await drawn()).every((image, at) => image === expected[at]);
      for (let tries = 0; tries < 50 && !(await isSame()); ++tries) await page.waitForTimeout(100);
      assert.ok(await isSame(), `${fragment}: ${from} to ${to}`);
    }
  }
  await page.setViewportSize({ width: 1280, height: 900 });
});

test("on a phone nothing is beside the screen, and the chart is near the top", async () => {
  await page.setViewportSize({ width: 390, height: 844 });
  for (const view of views) {
    await open("later", `view=${view}`);
    const beside = await page.evaluate(() => {
      const scrolls = (element) =>
        element !== null && (/auto|scroll/.test(getComputedStyle(element).overflowX) || scrolls(element.parentElement));
      return [...document.querySelectorAll("body *")]
        .filter((element) => element.getBoundingClientRect().right > innerWidth + 1 && !scrolls(element.parentElement))
        .map((element) => `${element.tagName}.${element.className}`);
    });
    assert.deepEqual(beside, [], view);
    const tabs = await page.$$eval("nav button", (all) =>
      all.map((tab) => tab.getBoundingClientRect()).map(({ left, right }) => left >= 0 && right <= innerWidth),
    );
    assert.ok(tabs.length === views.length && tabs.every(Boolean), "all tabs are in sight");
  }
  await open("run", "view=cells");
  await page.click(".picker summary");
  const list = await page.locator(".picker-list").boundingBox();
  assert.ok(list.x >= 0 && list.x + list.width <= 390, `the list of columns lies at ${list.x}`);
  await open("run");
  const chart = await page.locator(".chart").first().boundingBox();
  assert.ok(chart.y < 844, `the chart begins at ${chart.y}`);
  assert.ok(!(await page.isVisible("[data-filter=view_angle]")), "filters by axes are folded");
  await page.click(".axis-filters summary");
  await page.click("[data-filter=view_angle] [data-value='60']");
  assert.ok(await page.isVisible("[data-filter=view_angle]"), "and stay as they were put");
  await page.setViewportSize({ width: 1280, height: 900 });
});

test("a finger on a chart or a picture moves the page", async () => {
  await page.setViewportSize({ width: 390, height: 844 });
  const client = await page.context().newCDPSession(page);
  await client.send("Emulation.setTouchEmulationEnabled", { enabled: true, maxTouchPoints: 2 });
  for (const [fragment, selector] of [
    ["", ".chart"],
    ["view=pictures", ".picture-frame"],
  ]) {
    await open("run", fragment);
    await page.waitForSelector(`${selector} canvas`);
    await page.locator(selector).first().scrollIntoViewIfNeeded();
    const before = await page.evaluate(() => scrollY);
    const box = await page.locator(selector).first().boundingBox();
    const [x, y] = [box.x + box.width / 2, Math.min(box.y + box.height / 2, 700)];
    const touch = (type, ...touchPoints) => client.send("Input.dispatchTouchEvent", { type, touchPoints });
    await touch("touchStart", { x, y });
    for (let moved = 10; moved <= 200; moved += 10) await touch("touchMove", { x, y: y - moved });
    await touch("touchEnd");
    await page.waitForTimeout(100);
    assert.ok((await page.evaluate(() => scrollY)) > before + 100, selector);
  }
  await client.send("Emulation.setTouchEmulationEnabled", { enabled: false });
  await page.setViewportSize({ width: 1280, height: 900 });
});
