// The page in a real browser: node in_chromium.mjs RELIEFBENCH. Reports are made of generated runs.

import assert from "node:assert/strict";
import { test } from "node:test";

import { findMark, fragment, open, page, report, testsOfPage, texts, write } from "./page_under_test.mjs";
import { largeRun, measured, shadowRun, smallRun, unmeasured } from "./runs.mjs";

const pom = "pom max_steps=32 | heightmap=rock view_angle=60";
const hostile = `<img src=x onerror="document.title='broken'"> </script><script>document.title='broken'</script>`;

const shownCount = async () => (await page.textContent(".shown")).match(/^[\d,]+/)[0];

const filteredCell = (filter) => {
  const cell = measured({ technique: "pom", axes: { heightmap: "rock", material_filter: filter }, ms: 1, uv: 1 });
  return { ...cell, image: { ...cell.image, footprint: { ...cell.image } } };
};
const filteredPicture = (at) => ({
  technique: (x) => [x * 4, 50 * at, 7],
  truth: (x) => [x * 4, 0, 9],
  uv_error: () => [0, 0, 3],
});

testsOfPage(() => {
  const pictures = {
    [pom]: {
      technique: (x, y) => [x * 4, y * 4, 7],
      truth: (x, y) => [x * 4, y * 4 + 1, 9],
      // Black is the scale's dark end, and green is no value's colour.
      uv_error: (x) => (x < 11 ? [0, 0, 3] : [26, 204, 51]),
    },
  };
  write("small", smallRun(), { name: "small", pictures });
  const slower = smallRun({ slowdown: 8 }).slice(1);
  const { error } = slower.find(({ cell }) => cell === pom);
  error.uv_texels.p99 /= 10;
  error.missed = 0.03;
  write("slower", [...slower, unmeasured({ technique: "new", status: "failed", reason: "no" })]);
  write(
    "troubled",
    [
      ...smallRun(),
      unmeasured({
        technique: hostile,
        axes: { heightmap: hostile },
        status: "failed",
        reason: `trace.glsl:3: ${hostile}`,
      }),
      unmeasured({ technique: "tessellation", status: "skipped", reason: "the device has no tessellation" }),
    ],
    { name: hostile },
  );
  write("empty", []);
  write("shadows", shadowRun());
  write(
    "even",
    ["a", "b"].map((technique, at) => measured({ technique, ms: 1 + at / 100, uv: 1 })),
  );
  write("near", [
    measured({ technique: "flat", ms: 0.1, uv: 20 }),
    measured({ technique: "pom", ms: 1, uv: 0.167 }),
    measured({ technique: "qdm", ms: 3, uv: 0.0455 }),
  ]);
  write("filtered", ["lod0", "mip", "anisotropic"].map(filteredCell), {
    truth: { kind: "exact", samples: 64 },
    pictures: Object.fromEntries(["lod0", "mip", "anisotropic"].map((filter, at) => [filteredCell(filter).cell, filteredPicture(at)])),
  });
  write("large", largeRun(10_000), { rounds: 3 });
  const preset = (cell) => ({ ...cell, cell: cell.cell.replace(" |", " preset=engine |"), preset: "engine" });
  write(
    "engines",
    [
      preset(measured({ technique: "pom", ms: 2, uv: 4, missed: 0.02 })),
      measured({ technique: "qdm", ms: 1.5, uv: 0.1, missed: 0.006 }),
    ],
    {
      more: {
        presets: {
          pom: {
            engine: {
              title: hostile,
              source: "engine, a.glsl at 1a",
              parameters: { max_steps: 32 },
              not_expressed: "Its fade.",
            },
          },
        },
      },
    },
  );
  report("engines", "engines");
  report("small", "small");
  report("changes", "small", "slower");
  report("troubled", "troubled");
  report("empty", "empty");
  report("shadows", "shadows");
  report("filtered", "filtered");
  report("even", "even");
  report("near", "near");
  report("large", "large");
});

test("a run opens with its chart, its techniques and what it was measured on", async () => {
  await open("small");
  assert.match(await page.textContent("header"), /small.*test device.*20 cells measured/);
  assert.deepEqual(await texts("[data-filter=technique] .chip-name"), ["flat", "pom", "qdm"]);
  assert.match(await page.title(), /^Quality against cost/);
  await page.waitForSelector(".chart canvas");
});

test("a technique has the same mark in every report and in every run of one", async () => {
  const marks = async () =>
    Object.fromEntries(
      await page.$$eval("[data-filter=technique] .chip", (chips) =>
        chips.map((chip) => [chip.dataset.value, chip.querySelector(".mark").innerHTML]),
      ),
    );
  await open("shadows");
  const { pom: mark } = await marks();
  assert.match(mark, /#a8328a/);
  await open("changes");
  assert.equal((await marks()).pom, mark);
  await page.keyboard.press("r");
  assert.equal((await marks()).pom, mark);
  await open("small", "techniques=pom");
  assert.equal((await marks()).pom, mark);
  await findMark([0xa8, 0x32, 0x8a]);
});

test("techniques and axes filter; x shows everything again", async () => {
  await open("small");
  await page.click("[data-filter=technique] [data-value=flat]");
  assert.equal(await shownCount(), "16");
  await page.click("[data-filter=view_angle] [data-value='60']", { modifiers: ["Shift"] });
  assert.equal(await shownCount(), "8");
  assert.deepEqual((await fragment()).getAll("techniques"), ["pom", "qdm"]);
  assert.deepEqual((await fragment()).getAll("axis.view_angle"), ["60"]);
  await page.focus("[data-filter=technique] [data-value=qdm]");
  await page.keyboard.press("Enter");
  await page.keyboard.press("Enter");
  assert.equal(await shownCount(), "8", "the focus stays where it was");
  await page.keyboard.press("x");
  assert.equal(await shownCount(), "20");
  assert.equal((await fragment()).toString(), "");
});

test("hovering tells the cell and a click pins it", async () => {
  await open("small", "techniques=qdm&axis.heightmap=rock&axis.view_angle=60");
  await page.waitForSelector(".chart canvas");
  const at = await findMark([0x00, 0x7f, 0x5f]);
  await page.mouse.move(at.x, at.y);
  await page.waitForSelector(".tip");
  assert.match(await page.textContent(".tip"), /qdm.*rock.*60°.*0\.500 ms/);
  await page.mouse.click(at.x, at.y);
  assert.equal((await fragment()).get("pin"), "qdm leaf=exact | heightmap=rock view_angle=60");
  assert.match(await page.textContent(".pin"), /qdm.*leaf=exact.*0\.500 ms/);
});

test("a wheel zooms into a chart and a double click leads back", async () => {
  await open("small", "facet=none");
  await page.waitForSelector(".chart canvas");
  const picture = () => page.evaluate(() => document.querySelector("main .chart canvas").toDataURL());
  const whole = await picture();
  const box = await page.locator("main .chart").boundingBox();
  // Where no point is, so that nothing is pinned.
  await page.mouse.move(box.x + box.width - 60, box.y + 40);
  await page.mouse.wheel(0, -400);
  await page.waitForFunction((before) => document.querySelector("main .chart canvas").toDataURL() !== before, whole);
  await page.mouse.dblclick(box.x + box.width - 60, box.y + 40);
  await page.waitForFunction((before) => document.querySelector("main .chart canvas").toDataURL() === before, whole);
});

test("what to use is said in words for a budget, with what more would buy and what it is the cost of", async () => {
  await open("small", "view=advice&axis.view_angle=60&budget=0.4");
  assert.match(
    await page.textContent(".answer"),
    /At 60°, within 0\.400 ms.*Use pommax_steps=32: FLIP[^0-9]* 0\.00250, in 0\.320 ms/,
  );
  assert.match(
    await page.textContent(".answer"),
    /Relief covers 50 % of the picture; 156 ns per covered pixel.*No other technique does it.*0\.500 ms \(1\.6 times the cost\) buys FLIP[^0-9]* 0: qdm.*1 setting more.*Worst of 2 views/,
  );
  await page.fill("[data-limit='time.draw.median_ms'] input", "0.01");
  assert.match(
    await page.textContent(".answer"),
    /Nothing does that\. Nearest comes pommax_steps=8: draw time 0\.0800 ms and not 0\.0100 ms; FLIP[^0-9]* 0\.0100.*0\.320 ms buys FLIP[^0-9]* 0\.00250/,
  );
});

test("why a setting is advised stands beside it, so that a better one that it cannot be told from is no contradiction", async () => {
  await open("near", "view=advice&budget=5");
  assert.match(
    await page.textContent(".answer"),
    /Use pom: FLIP[^0-9]* 0\.00167.*The least FLIP[^0-9]* within the budget is 0\.000455, of qdm: too near to 0\.00167 to be told apart \(that takes more than 0\.002 and 2 %\); it is the cheapest of the 2 settings of which that is so\./,
  );
  await open("near", "view=advice&budget=5&limit.error.uv_texels.p99=1");
  assert.match(
    await page.textContent(".answer .why"),
    /^It is the cheapest of the 2 settings that keep to the limits\.$/,
  );
  await open("near", "view=advice&budget=2");
  assert.match(await page.textContent(".answer .why"), /^Its FLIP.* is the least within the budget\.$/);
  await open("near", "view=advice&budget=0.5");
  assert.match(await page.textContent(".answer .why"), /^It is the only setting that keeps to the budget\.$/);
});

test("several limits hold at once, of any figure, and the address has them", async () => {
  await open("small", "view=advice&axis.view_angle=60&error=error.uv_texels.p99");
  await page.fill("[data-limit='error.uv_texels.p99'] input", "0.1");
  assert.match(
    await page.textContent(".answer"),
    /with UV error, p99 at most 0\.100 texels.*Use qdm.*have no error.*in 0\.500 ms.*pommax_steps=128: 99 % of its pixels are within 0\.0625 texels, in 1\.28 ms \(2\.6 times the cost\)/,
  );
  await page.selectOption("[aria-label='Limit another figure']", "prepare.bytes");
  await page.fill("[data-limit='prepare.bytes'] input", "0");
  assert.match(await page.textContent(".answer"), /Use pommax_steps=128.*memory of maps 0 B.*No other technique/);
  await page.fill("[data-limit='time.draw.median_ms'] input", "0.9");
  assert.match(
    await page.textContent(".answer"),
    /within 0\.900 ms with UV error.*Nothing does that.*pommax_steps=128: draw time 1\.28 ms and not 0\.900 ms/,
  );
  assert.deepEqual([(await fragment()).get("budget"), (await fragment()).get("limit.prepare.bytes")], ["0.9", "0"]);
});

test("advice says when settings cannot be told apart, and when its error counts relief outside the footprint", async () => {
  await open("shadows", "view=advice&axis.self_shadow=off&budget=5");
  assert.match(
    await page.textContent(".view-advice .caution"),
    /FLIP.*: relief outside the footprint counts.*version that had no figures/,
  );
  assert.match(await page.textContent(".answer"), /Use pom: .*in 1\.00 ms/);
  await open("small", "view=advice&axis.view_angle=0&budget=5&limit.image.flip=0.5&limit.image.footprint.flip=0.1");
  assert.match(
    await page.textContent(".view-advice .caution"),
    /No measured cell of this run has image\.footprint\.flip/,
  );
  await open("small", "view=advice&axis.view_angle=0&budget=0.5&techniques=qdm");
  assert.ok(!(await page.isVisible(".view-advice .caution")));
  await open("even", "view=advice&budget=5");
  assert.match(await page.textContent(".answer"), /Use a: .*Cannot be told apart from it: b \(0\.0100, 1\.01 ms\)\./);
});

test("values of an axis that changes no hit stand beside each other with cost and error", async () => {
  await open("shadows", "view=axes&x=axis.self_shadow");
  assert.deepEqual(await texts(".beside .value-head"), ["off", "hard", "soft"]);
  assert.match(await page.textContent(".beside tbody tr >> nth=1"), /^qdm2\.00–6\.00× 3\.000\.2504\.00× 2\.000\.500$/);
  assert.match(await page.textContent(".beside tfoot"), /Mean of 2 rows–× 3\.000\.250× 2\.000\.500/);
  assert.match(await page.textContent(".beside .note"), /The hits are the same at every value/);
  await page.selectOption(".field select >> nth=1", "work.shadow_taps_mean");
  assert.match(await page.textContent(".beside tbody tr >> nth=0"), /^pom––9\.00–0\.250/);
  await page.click(".beside tbody td.number >> nth=2");
  assert.equal((await fragment()).get("pin"), "pom | self_shadow=hard");
});

test("figures that are better the higher lead a front with their highest, and axes say which way is better", async () => {
  await open("small", "axis.view_angle=60&axis.heightmap=rock&error=image.psnr");
  assert.match(await page.textContent(".note"), /Upper left is better/);
  assert.deepEqual(await texts(".front tbody td:last-child"), ["30.0 dB", "∞ dB"]);
  await open("small", "axis.view_angle=60&axis.heightmap=rock&error=image.ssim");
  assert.deepEqual(await texts(".front tbody td:first-child b"), ["pom", "pom", "qdm"]);
});

test("charts over steps and over the view angle have a line per technique", async () => {
  await open("small", "view=axes");
  assert.equal(await page.locator(".chart-pair canvas").count(), 2);
  await findMark([0xa8, 0x32, 0x8a]);
  await page.selectOption(".field select >> nth=0", "axis.view_angle");
  assert.equal((await fragment()).get("x"), "axis.view_angle");
  await findMark([0xa8, 0x32, 0x8a]);
});

test("pictures of a pinned cell: side by side, flip, slider, and the values of a pixel", async () => {
  await open("small", `view=pictures&pin=${encodeURIComponent(pom)}`);
  await page.waitForSelector("[data-picture=map]");
  assert.deepEqual(await page.$$eval("canvas.picture", (all) => all.map((canvas) => canvas.dataset.picture)), [
    "truth",
    "technique",
    "map",
  ]);
  const box = await page.locator("[data-picture=technique]").boundingBox();
  await page.mouse.move(box.x + (box.width * 10.5) / 64, box.y + (box.height * 20.5) / 64);
  assert.deepEqual(await texts(".pixel-value"), ["40  81  9", "40  80  7", "0  0  3"]);
  assert.deepEqual(await texts(".map-value"), ["at most 0.010 texels"]);
  await page.keyboard.press("ArrowRight");
  assert.deepEqual(await texts(".map-value"), [""]);
  assert.deepEqual(await texts(".pixel-value"), ["44  81  9", "44  80  7", "26  204  51"]);
  await page.keyboard.press(" ");
  await page.waitForSelector(".flip[data-shows=technique]");
  await page.keyboard.press(" ");
  await page.waitForSelector(".flip[data-shows=truth]");
  await page.click("[data-value=side]");
  await page.click("[data-value=flip]");
  await page.keyboard.press(" ");
  await page.waitForSelector(".flip[data-shows=technique]");
  await page.click("[data-value=slider]");
  await page.waitForSelector(".divider");
  const frame = await page.locator(".picture-frame").first().boundingBox();
  await page.mouse.move(frame.x + 0.5 * frame.width, frame.y + 20);
  await page.mouse.down();
  await page.mouse.move(frame.x + 0.25 * frame.width, frame.y + 20);
  await page.mouse.up();
  assert.ok(Math.abs(Number(await page.inputValue(".divider")) - 0.25) < 0.01);
  await page.keyboard.press("j");
  await page.waitForSelector(".empty");
  assert.match(await page.textContent(".empty"), /no pictures of this cell/);
});

test("cells that differ in how the picture is made stand beside their truth, and what it is made of is said", async () => {
  await open("filtered", "view=pictures&mode=variants");
  await page.waitForSelector("[data-picture='variant 2']");
  const captions = await texts(".pane figcaption");
  assert.equal(captions.length, 4);
  assert.equal(captions[0], "Ground truth");
  for (const [at, filter] of ["lod0", "mip", "anisotropic"].entries())
    assert.match(captions[at + 1], new RegExp(`^material filter ${filter}: FLIP, footprint 0\\.\\d+$`));
  const box = await page.locator("[data-picture='variant 1']").boundingBox();
  await page.mouse.move(box.x + (box.width * 10.5) / 64, box.y + (box.height * 20.5) / 64);
  assert.deepEqual(await texts(".pixel-value"), ["40  0  9", "40  0  7", "40  50  7", "40  100  7"]);
  assert.match(await page.textContent(".facts"), /truth of 64 samples a pixel/);
  await open("filtered");
  assert.equal(await page.inputValue(".field select >> nth=0"), "image.footprint.flip");
  assert.match(await page.textContent(".note"), /a truth of 64 samples a pixel/);
  await open("filtered", "view=advice");
  assert.match(await page.textContent(".view-advice"), /a truth of 64 samples a pixel/);
  await open("small", `view=pictures&mode=variants&pin=${encodeURIComponent(pom)}`);
  await page.waitForSelector("[data-picture='variant 0']");
  assert.match(await page.textContent(".view-pictures"), /No other cell with pictures differs/);
});

test("timing of a pinned cell: passes, a chart of its rounds, memory", async () => {
  await open("small", "view=timing&pin=" + encodeURIComponent("qdm leaf=exact | heightmap=rock view_angle=60"));
  await page.waitForSelector(".chart canvas");
  assert.match(
    await page.textContent(".timing"),
    /draw.*18 samples in 9 rounds.*1\.50 ms.*85\.3 KiB.*fragment shader invocations4,096/,
  );
});

test("the table sorts, searches and pins", async () => {
  await open("small", "view=cells");
  await page.click("[data-column='time.draw.median_ms'] button");
  await page.click("[data-column='time.draw.median_ms'] button");
  assert.match(await page.textContent(".rows tbody tr >> nth=0"), /max_steps=128/);
  await page.keyboard.press("/");
  await page.keyboard.type("pom uv<0.3 -bricks");
  assert.equal(await page.textContent("#row-count"), "5 cells");
  await page.click(".rows tbody tr >> nth=0");
  assert.match((await fragment()).get("pin"), /^pom/);
});

test("the search finds what is at its default, and says which column there is not", async () => {
  await open("small", "view=cells");
  const count = async (query) => {
    await page.fill("#query", query);
    return Number((await page.textContent("#row-count")).split(" ")[0]);
  };
  assert.equal(await count("parallel"), 20);
  assert.equal(await count("-parallel"), 0);
  assert.equal(await count("view_angle=0"), 10);
  assert.equal(await count("technique=pom view_angle=0,60 max_steps>8 heightmap=rock"), 4);
  assert.equal(await page.textContent(".search-notes"), "");
  assert.equal(await count("view_angel=60"), 0);
  assert.match(await page.textContent(".search-notes"), /no column “view_angel”.*Did you mean view_angle=60\?/);
  await page.click(".search-notes button");
  assert.equal(await page.inputValue("#query"), "view_angle=60");
  assert.equal(await page.textContent("#row-count"), "10 cells");
});

test("what changed between two runs, verdict by verdict", async () => {
  await open("changes", "view=changes");
  assert.match(await page.textContent(".verdicts"), /19compared12slower/);
  await page.click("[data-verdict=slower]");
  assert.match(await page.textContent(".rows tbody tr >> nth=0"), /slower\+700 %/);
  assert.match(
    await page.textContent(".quality.mixed"),
    /^mixed: worse by 3.0 % of footprint: error.missed\+error.false_hits 0 → 3.00 % of footprint, and 1 more$/,
  );
  await page.click("[data-verdict=mixed]");
  assert.equal(await page.locator(".rows tbody tr").count(), 1);
  assert.match(await page.textContent(".view-changes"), /2 cells not compared.*flat \| heightmap=rock view_angle=0/);
  await page.keyboard.press("r");
  assert.match(await page.textContent("header"), /19 cells measured1 failed/);
});

test("a link leads to the view that it was taken from", async () => {
  await open(
    "small",
    `view=cells&techniques=pom&axis.heightmap=rock&query=uv%3C1&sort=-error.uv_texels.p99&pin=${encodeURIComponent(pom)}`,
  );
  assert.equal(await page.inputValue("#query"), "uv<1");
  assert.equal(await page.textContent("#row-count"), "5 cells");
  assert.equal(await page.getAttribute("[data-column='error.uv_texels.p99']", "aria-sort"), "descending");
  assert.equal(await page.getAttribute(".pin", "data-pin"), pom);
  await page.evaluate(() => (location.hash = "#view=run"));
  await page.waitForSelector(".view-run");
  await open(
    "small",
    "view=nonsense&run=7&budget=x&limit.__proto__=1&pin=gone&axis.nothing=1&facet=__proto__&error=constructor&sort=-valueOf",
  );
  assert.match(await page.textContent(".pin-bar"), /no cell “gone”/);
  await page.waitForSelector(".view-cost .chart canvas");
});

test("any figure of a run can be chosen, under headings, and a word finds it among the columns", async () => {
  await open("shadows", "facet=none");
  const headed = (at) =>
    page.$$eval(`.field:nth-of-type(${at}) optgroup`, (groups) =>
      groups.map((group) => [group.label, group.children.length]),
    );
  assert.deepEqual(Object.fromEntries(await headed(1))["error · shadow"], 3);
  const work = Object.fromEntries(await headed(2))["work"];
  assert.equal(work, 7, "taps, texels, steps and shadow taps, but what is no cost");
  await page.selectOption(".field:nth-of-type(1) select", "error.shadow.mean");
  await page.selectOption(".field:nth-of-type(2) select", "work.shadow_taps_p95");
  assert.match(await page.textContent(".front thead"), /Shadow taps per pixel, p95.*Shadow error, mean \(visibility\)/);
  await page.keyboard.press("6");
  await page.click(".picker summary");
  await page.fill(".picker-list input[type=search]", "missed sh");
  const shown = () =>
    page.$$eval(".picker-list :is(legend, label)", (all) =>
      all.filter((each) => each.checkVisibility()).map((each) => each.textContent),
    );
  assert.deepEqual(await shown(), ["error · shadow", "Missed shadow (% of visibilities compared)"]);
  await page.click(".picker-list label:visible");
  assert.match(await page.textContent(".rows th:nth-last-child(1)"), /Missed shadow/);
  await page.click(".picker-list button");
  assert.equal(await page.locator("[data-column='error.shadow.missed_shadow']").count(), 0);
  assert.equal(await page.isChecked(".picker-list label:visible input"), false);
});

test("keys reach every view, cell, theme and the help", async () => {
  await open("changes");
  const seen = [];
  for (let key = 1; key <= 8; ++key) {
    await page.keyboard.press(String(key));
    seen.push((await page.getAttribute("main section", "class")).replace("view-", ""));
  }
  assert.deepEqual(seen, ["cost", "advice", "axes", "pictures", "timing", "changes", "cells", "run"]);
  await page.keyboard.press("j");
  await page.keyboard.press("j");
  await page.keyboard.press("k");
  assert.match(await page.getAttribute(".pin", "data-pin"), /^flat \|/);
  await page.keyboard.press("Escape");
  assert.equal(await page.locator(".pin").count(), 0);
  const theme = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const light = await theme();
  await page.keyboard.press("t");
  assert.notEqual(await theme(), light);
  await page.keyboard.press("?");
  assert.ok(await page.locator("dialog").isVisible());
  await page.keyboard.press("Escape");
  assert.ok(!(await page.locator("dialog").isVisible()));
});

test("a run of engines' presets opens on what they pay, what they miss, and what is better", async () => {
  await open("engines");
  assert.equal(await page.textContent("nav [aria-current=page]"), "Engines");
  const row = await page.textContent(".engines tbody tr");
  assert.ok(row.includes(hostile), "the title, as text");
  assert.match(row, /2\.00 ms.*⚠ 2\.0 %.*qdm.*0\.00100.*1\.50 ms.*⚠ 0\.60 % missed or false/s);
  assert.ok(!(await page.textContent(".engine-table h3")).includes("worst of"), "there is one view");
  assert.match(await page.textContent(".engine-sources"), /pom: max_steps 32.*engine, a\.glsl at 1a.*Its fade\./s);
  await page.keyboard.press("2");
  assert.equal(await page.textContent("nav [aria-current=page]"), "Quality against cost");
  await open("small");
  assert.deepEqual((await texts("nav button"))[0], "Quality against cost", "a run without presets has no such view");
});

test("failed and skipped cells are there with their reasons, and no text becomes markup", async () => {
  await open("troubled");
  assert.match(await page.textContent("header"), /1 failed1 skipped/);
  assert.match(
    await page.textContent(".view-cost .warning"),
    /2 cells were not measured.*trace\.glsl:3: <img src=x.*no tessellation/,
  );
  for (const view of ["advice", "axes", "pictures", "timing", "run"]) await open("troubled", `view=${view}`);
  await open("troubled", "view=cells");
  await page.click("[data-status=failed]");
  assert.equal(await page.textContent("#row-count"), "1 cell");
  assert.ok((await page.textContent(".rows tbody tr >> nth=0")).includes(`trace.glsl:3: ${hostile}`));
  assert.equal(await page.locator("img, main script").count(), 0);
  assert.ok(!(await page.title()).startsWith("broken"));
});

test("a run without cells says so in every view", async () => {
  for (const view of ["cost", "advice", "axes", "pictures", "timing", "cells", "run"])
    await open("empty", `view=${view}`);
  await open("empty");
  assert.match(await page.textContent(".note"), /No cell of this run was measured/);
});

test("10,000 cells: chart, filter, table", async () => {
  await open("large");
  await page.waitForSelector(".chart canvas");
  assert.equal(await shownCount(), "10,000");
  await page.click("[data-filter=technique] [data-value=technique_03]", { modifiers: ["Shift"] });
  assert.equal(await shownCount(), "500");
  await page.keyboard.press("x");
  await page.keyboard.press("6");
  assert.equal(await page.textContent("#row-count"), "10,000 cells");
  assert.ok((await page.locator(".rows tbody tr").count()) < 120, "rows out of sight are no elements");
  await page.fill("#query", "technique_07 uv<0.1");
  assert.match(await page.textContent("#row-count"), /^[\d,]+ cells$/);
});
