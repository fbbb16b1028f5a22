// A browser with reports of generated runs, for tests in it. The first argument is the path of reliefbench.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, afterEach, before } from "node:test";

import { openBrowser } from "./browser.mjs";
import { writeRun } from "./runs.mjs";

const binary = process.argv[2];
const folder = mkdtempSync(join(tmpdir(), "reliefbench-report-"));

let browser;
let problems = [];
export let page;

export function write(name, cells, options) {
  writeRun(join(folder, name), cells, options);
}

export function report(name, ...runs) {
  execFileSync(binary, ["report", ...runs.map((run) => join(folder, run)), "-o", join(folder, `${name}.html`)], {
    // No noise of this machine's may sway the comparison.
    env: { ...process.env, RELIEFBENCH_STATE_DIR: folder },
  });
}

export async function open(name, fragment = "") {
  // From elsewhere, so that another fragment is another load.
  await page.goto("about:blank");
  await page.goto(`file://${join(folder, `${name}.html`)}${fragment === "" ? "" : `#${fragment}`}`);
  await page.waitForSelector("main section");
}

export const fragment = async () => new URLSearchParams((await page.evaluate(() => location.hash)).slice(1));
export const texts = (selector) => page.$$eval(selector, (elements) => elements.map((element) => element.textContent));

/** Before all tests of a file `makeReports` is called and a page opened; none may have errors or ask the network. */
export function testsOfPage(makeReports) {
  before(async () => {
    makeReports();
    browser = await openBrowser();
    page = await browser.context.newPage();
    page.on("pageerror", (error) => problems.push(error.message));
    page.on("console", (message) => {
      if (message.type() === "error" || message.type() === "warning") problems.push(message.text());
    });
    page.on("request", (request) => {
      if (!/^(file|data|blob|about):/.test(request.url())) problems.push(`asked the network for ${request.url()}`);
    });
  });
  after(async () => {
    await browser?.close();
    rmSync(folder, { recursive: true, force: true });
  });
  afterEach(() => {
    const found = problems;
    problems = [];
    assert.deepEqual(found, []);
  });
}

/** The first blot of a technique's colour in the first chart. */
export async function findMark(colour) {
  const at = await page.evaluate((wanted) => {
    const canvas = document.querySelector("main .chart canvas");
    const { width, height } = canvas;
    const copy = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
    copy.drawImage(canvas, 0, 0);
    const { data } = copy.getImageData(0, 0, width, height);
    const is = (x, y) => wanted.every((value, channel) => Math.abs(data[4 * (y * width + x) + channel] - value) < 24);
    for (let y = 3; y < height - 3; ++y) {
      for (let x = 3; x < width - 3; ++x) {
        if ([-1, 0, 1].every((dy) => [-1, 0, 1].every((dx) => is(x + dx, y + dy)))) {
          const box = canvas.getBoundingClientRect();
          return { x: box.left + (x * box.width) / width, y: box.top + (y * box.height) / height };
        }
      }
    }
    return null;
  }, colour);
  assert.notEqual(at, null, "no mark of this colour in the chart");
  return at;
}

/** Which of the elements are whole within the frame of the table. */
export async function inSight(selectors) {
  return page.evaluate((wanted) => {
    const frame = document.querySelector(".table-scroll").getBoundingClientRect();
    return wanted.filter((selector) => {
      const box = document.querySelector(selector).getBoundingClientRect();
      return box.left >= frame.left && box.right <= frame.right + 0.5 && box.width > 0;
    });
  }, selectors);
}
