import assert from "node:assert/strict";
import { test } from "node:test";

import { figureScale, linearTicks, logRange, logTicks, tickText } from "../src/scales.ts";
import { bytesText, changeText, geometricMean, median, significant } from "../src/numbers.ts";
import { addBase, fromPalette, legendPosition, valueOfColour } from "../src/pictures.ts";

test("figures have significant digits, and what is undefined is a dash", () => {
  assert.equal(significant(1234.5), "1235");
  assert.equal(significant(12.345), "12.3");
  assert.equal(significant(0.001234), "0.00123");
  assert.equal(significant(0.00001234), "1.23e−5");
  assert.equal(significant(-0.5), "−0.500");
  assert.equal(significant(0), "0");
  for (const undefinedValue of [null, undefined, NaN, Infinity]) assert.equal(significant(undefinedValue), "–");
});

test("ratios read as changes, bytes with their unit", () => {
  assert.equal(changeText(1.0721), "+7.2 %");
  assert.equal(changeText(0.935), "−6.5 %");
  assert.equal(changeText(8), "+700 %");
  assert.equal(changeText(0.9999), "0 %");
  assert.equal(changeText(null), "–");
  assert.equal(bytesText(87381), "85.3 KiB");
  assert.equal(bytesText(0), "0 B");
  assert.equal(bytesText(null), "–");
});

test("means and medians", () => {
  assert.equal(median([3, 1, 2]), 2);
  assert.equal(median([4, 1, 2, 3]), 2.5);
  assert.equal(median([]), null);
  assert.ok(Math.abs(geometricMean([1, 100]) - 10) < 1e-9);
  assert.equal(geometricMean([0, 2]), 1, "arithmetic where there is a zero");
});

test("a logarithmic axis spans the values and has a place for zeros", () => {
  const range = logRange([0.01, 10]);
  assert.ok(range.min < 0.01 && range.min > 0.005 && range.max > 10 && !range.hasZero);
  const withZero = logRange([0, 0.01, 10]);
  assert.equal(withZero.min, withZero.zero);
  assert.ok(withZero.zero < 0.01);
  assert.ok(logRange([]).min < logRange([]).max);
  assert.ok(logRange([0]).min > 0);
});

test("what is better the higher it is has a linear axis with a place for infinite values", () => {
  const scale = figureScale([20, 40, Infinity], "higher");
  assert.equal(scale.type, "value");
  assert.ok(scale.min < 20 && scale.min > 10);
  assert.ok(scale.place(Infinity) === scale.max && scale.max > 40);
  assert.equal(scale.text(scale.max), "∞");
  assert.equal(scale.text(30), "30");
  assert.equal(scale.ticks(scale.min, scale.max).at(-1), scale.max, "infinity has its tick");
  assert.ok(scale.ticks(20, 40).every((tick) => tick <= 40));
  const zeros = figureScale([0, 1], "lower");
  assert.deepEqual([zeros.type, zeros.text(zeros.place(0))], ["log", "0"]);
  assert.equal(zeros.ticks(zeros.min, zeros.max)[0], zeros.place(0));
  const single = figureScale([0], "higher");
  assert.ok(single.min < single.max);
});

test("numbers at axes are written out, and as powers of ten only where that is shorter", () => {
  assert.deepEqual([0.03, 1024, 16384, 0.00001, -0.5, 0].map((value) => tickText(value)), [
    "0.03",
    "1024",
    "16384",
    "0.00001",
    "−0.5",
    "0",
  ]);
  const decades = [1e-7, 0.0001, 0.5, 1];
  assert.deepEqual(
    decades.map((value) => tickText(value, decades)),
    ["10⁻⁷", "10⁻⁴", "5·10⁻¹", "10⁰"],
    "all of an axis have one form",
  );
  assert.deepEqual([1e-7, 3e-8, 1e7, 2.5e8].map((value) => tickText(value)), ["10⁻⁷", "3·10⁻⁸", "10⁷", "2.5·10⁸"]);
});

test("every axis has at least two round numbers, and not too many", () => {
  assert.deepEqual(logTicks(0.008, 1.3), [0.01, 0.03, 0.1, 0.3, 1]);
  assert.deepEqual(logTicks(0.4, 50), [1, 3, 10, 30]);
  assert.deepEqual(logTicks(0.9, 2.4), [1, 1.25, 1.5, 1.75, 2, 2.25]);
  assert.deepEqual(linearTicks(0, 75), [0, 20, 40, 60]);
  for (const min of [1e-9, 0.0137, 0.99, 1, 730]) {
    for (const factor of [1.0001, 1.02, 1.44, 1.9, 3, 12, 1e3, 1e7, 1e13]) {
      for (const ticks of [logTicks, linearTicks]) {
        const found = ticks(min, min * factor);
        assert.ok(found.length >= 2 && found.length <= 10, `${min} × ${factor}: ${found}`);
        const nearly = 1e-8 * (factor - 1) * min;
        assert.ok(found.every((tick) => tick >= min - nearly && tick <= min * factor + nearly));
        assert.equal(new Set(found.map((tick) => tickText(tick, found))).size, found.length, `${min} × ${factor}: ${found}`);
      }
    }
  }
});

test("pictures unpack from a palette, with one byte or two, and from a difference", () => {
  const palette = new Uint8Array(3 * 300).map((_, at) => at % 251);
  assert.deepEqual([...fromPalette(Uint8Array.of(1, 0), palette, 2)], [3, 4, 5, 0, 1, 2]);
  const wide = fromPalette(Uint8Array.of(1, 0, 1, 0), palette, 2);
  assert.deepEqual([...wide], [...palette.subarray(3 * 257, 3 * 258), 0, 1, 2]);
  assert.deepEqual([...addBase(Uint8Array.of(1, 255), Uint8Array.of(2, 3))], [3, 2]);
});

test("a map's colour is read back as the value that it stands for, and no other colour is", () => {
  const colours = Uint8Array.of(0, 0, 0, 100, 0, 0, 200, 100, 0);
  const legend = {
    title: "",
    unit: "texels",
    dark: 0.01,
    light: 1,
    logarithmic: true,
    colours: "",
    marks: [],
    others: [],
  };
  assert.equal(valueOfColour([100, 1, 0], legend, colours), 0.1);
  assert.equal(valueOfColour([200, 100, 0], legend, colours), 1);
  assert.equal(valueOfColour([26, 89, 255], legend, colours), null);
  assert.equal(valueOfColour([100, 0, 0], { ...legend, dark: 1, light: 0, logarithmic: false }, colours), 0.5);
  assert.ok(Math.abs(legendPosition(legend, 0.1) - 0.5) < 1e-12);
  assert.equal(legendPosition({ ...legend, dark: 1, light: 0, logarithmic: false }, 0.25), 0.75);
});
