import assert from "node:assert/strict";
import { test } from "node:test";

import { defaultState, type State, stateFromFragment, stateToFragment, toggled } from "../src/state.ts";

test("a state comes back from its fragment as it was", () => {
  const state: State = {
    view: "cells",
    run: 1,
    cost: "work.taps_mean",
    error: "image.flip",
    points: "worst",
    facet: "height_scale",
    filters: { heightmap: ["a b.png", "c&d=e#f"], view_angle: ["60"] },
    techniques: ["pom", "qdm"],
    pin: "pom max_steps=16 | heightmap=größe view_angle=60",
    budget: 1.5,
    limits: { "error.uv_texels.p99": 0.5, "image.psnr": 0 },
    x: "axis.view_angle",
    query: "uv<1 -bricks %",
    sort: "-time.draw.median_ms",
    columns: ["time.draw.n"],
    mode: "flip",
    map: "flip",
    verdict: "slower",
  };
  assert.deepEqual(stateFromFragment(`#${stateToFragment(state)}`), state);
});

test("the default state is an empty fragment, and the other way round", () => {
  assert.equal(stateToFragment(defaultState), "");
  assert.deepEqual(stateFromFragment(""), defaultState);
  assert.deepEqual(stateFromFragment("#"), defaultState);
});

test("what a fragment says wrongly stays at its default", () => {
  const state = stateFromFragment(
    "#view=nope&run=-1&budget=cheap&limit.image.flip=-3&limit.__proto__=1&points=&mode=x&axis.__proto__=1&%E0%A4%A",
  );
  assert.equal(state.view, "");
  assert.equal(state.run, 0);
  assert.equal(state.budget, null);
  assert.equal(state.limits["image.flip"], undefined);
  assert.equal(Object.getPrototypeOf(state.limits), Object.prototype);
  assert.equal(Object.getPrototypeOf(state.filters), Object.prototype);
});

test("a chip takes its value in and out, and all values are the same as no filter", () => {
  const all = ["a", "b", "c"];
  assert.deepEqual(toggled([], "b", all), ["a", "c"]);
  assert.deepEqual(toggled(["a", "c"], "b", all), []);
  assert.deepEqual(toggled(["c"], "a", all), ["a", "c"]);
  assert.deepEqual(toggled(["c"], "c", all), [], "the last one out shows everything again");
});
