// Runs that no device drew, written as docs/architecture.md describes a run's folder, so that what they say is known.

import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { deflateSync } from "node:zlib";

const record = (name, device, truth, more) => ({
  ...more,
  configuration: { name, truth, images: false, axes: { view_angle: [0, 60] } },
  environment: {
    tool_version: "0.1.0",
    git_revision: "abc",
    git_dirty: false,
    cpu: "test CPU",
    cores: 2,
    os: "test",
    time: "2026-11-22T08:00:00Z",
  },
  device: { name: device, type: "discrete GPU", driver: "test", driver_version: "1" },
  techniques: {},
  height_maps: [],
  command_line: ["reliefbench", "run", name],
});

const defaults = {
  heightmap: "rock",
  heightmap_size: "256x256",
  height_format: "r16",
  view_angle: 0,
  azimuth: -90,
  projection: "parallel",
  distance: null,
  fov: null,
  height_scale: 0.05,
  tiling: 1,
  boundary: "clip",
  resolution: "64x64",
};

function idOf(technique, params, axes) {
  const text = (values) => Object.entries(values).map(([key, value]) => `${key}=${value}`);
  return `${[technique, ...text(params)].join(" ")} | ${text(axes).join(" ")}`;
}

const summary = (p99) => ({ mean: p99 / 4, rms: p99 / 3, p50: p99 / 5, p95: p99 / 2, p99, max: 3 * p99 });

/**
 * A measured cell: `ms` of the draw, which its interval exceeds by `spread` to either side, and `uv`, the 99th percentile
 * of its error.
 */
export function measured({
  technique,
  params = {},
  axes = {},
  ms,
  uv,
  missed = 0,
  steps = 8,
  shadow = null,
  outside = 0,
  spread = 0.02,
  outliers = 0,
}) {
  return {
    cell: idOf(technique, params, axes),
    technique,
    axes: { ...defaults, ...axes },
    params,
    status: "ok",
    reason: null,
    time: {
      draw: {
        median_ms: ms,
        mad_ms: ms / 50,
        ci95_ms: [(1 - spread) * ms, (1 + spread) * ms],
        n: 18,
        repeats: 1,
        rounds: 9,
        outliers,
        lower_quartile_ms: 0.99 * ms,
      },
      ns_per_pixel: ms * 488,
      stop: "precise",
      throttled_rounds: 0,
    },
    prepare: { ms: technique === "qdm" ? 1.5 : 0, bytes: technique === "qdm" ? 87381 : 0 },
    work: {
      taps_mean: steps,
      taps_p95: steps,
      texels_mean: steps,
      steps_mean: steps,
      steps_p95: steps,
      unconverged: 0,
      covered_pixels: 2048,
      ...(shadow === null ? {} : { shadow_taps_mean: shadow.taps, shadow_taps_p95: 2 * shadow.taps }),
    },
    pipeline: { fragment_shader_invocations: 4096 },
    executable: {},
    error: {
      uv_texels: summary(uv),
      depth: summary(uv / 1000),
      normal_deg: summary(uv),
      compared: 4096,
      missed,
      false_hits: 0,
      outside_quad: { pixels: outside, covered: outside > 0 ? 0 : null },
      coverage_iou: 1,
      ...(shadow === null
        ? {}
        : {
            shadow: {
              mean: shadow.error,
              false_shadow: 0,
              missed_shadow: 0,
              compared: 4096,
              truth_standard_error: null,
            },
          }),
    },
    image: { flip: uv / 100, psnr: uv === 0 ? null : 30, ssim: 1 - uv / 1000, rmse: uv / 100 },
  };
}

export function unmeasured({ technique, axes = {}, status, reason }) {
  return {
    cell: idOf(technique, {}, axes),
    technique,
    axes: { ...defaults, ...axes },
    params: {},
    status,
    reason,
    time: { ns_per_pixel: null, stop: null, throttled_rounds: 0 },
    prepare: { ms: null, bytes: null },
    work: null,
    pipeline: {},
    executable: {},
    error: null,
    image: null,
  };
}

/** `pictures` maps a cell's id to `{technique, truth, uv_error}`, functions from x and y to [red, green, blue]. */
export function writeRun(
  folder,
  cells,
  { name = "test", device = "test device", rounds = 9, samples = 2, pictures = {}, truth = { kind: "exact" }, more = {} } = {},
) {
  mkdirSync(folder, { recursive: true });
  const lines = (values) => values.map((value) => `${JSON.stringify(value)}\n`).join("");
  writeFileSync(join(folder, "run.json"), JSON.stringify(record(name, device, truth, more)));
  writeFileSync(join(folder, "cells.jsonl"), lines(cells));
  const visits = [];
  for (const { cell, time } of cells) {
    for (let round = 0; time.draw && round < rounds; ++round) {
      const ms = time.draw.median_ms * (1 + 0.01 * ((round % 3) - 1));
      visits.push({
        cell,
        pass: "draw",
        round,
        order: 0,
        repeats: 1,
        ms: Array.from({ length: samples }, (_, at) => ms * (1 + at / 100)),
      });
    }
  }
  writeFileSync(join(folder, "samples.jsonl"), lines(visits));
  writeFileSync(
    join(folder, "summary.json"),
    JSON.stringify({ cells: { ok: cells.length, skipped: 0, failed: 0 }, total_s: 1 }),
  );
  for (const [cell, { technique, truth, uv_error }] of Object.entries(pictures)) {
    const stem = join(folder, "images", cell.replace(" | ", "@").replaceAll(" ", "+"));
    mkdirSync(join(folder, "images"), { recursive: true });
    writeFileSync(`${stem}.png`, png(64, 64, technique));
    writeFileSync(`${stem}.truth.png`, png(64, 64, truth));
    writeFileSync(`${stem}.uv_error.png`, png(64, 64, uv_error));
  }
}

function crc32(bytes) {
  let crc = ~0;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; ++bit) crc = (crc >>> 1) ^ (crc & 1 ? 0xedb88320 : 0);
  }
  return ~crc >>> 0;
}

/** 8-bit RGB. */
function png(width, height, colour) {
  const chunk = (type, data) => {
    const body = Buffer.concat([Buffer.from(type, "latin1"), data]);
    const frame = Buffer.alloc(8);
    frame.writeUInt32BE(data.length, 0);
    frame.writeUInt32BE(crc32(body), 4);
    return Buffer.concat([frame.subarray(0, 4), body, frame.subarray(4)]);
  };
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set([8, 2, 0, 0, 0], 8);
  const rows = [];
  for (let y = 0; y < height; ++y) {
    rows.push(0);
    for (let x = 0; x < width; ++x) rows.push(...colour(x, y));
  }
  const signature = Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]);
  return Buffer.concat([
    signature,
    chunk("IHDR", header),
    chunk("IDAT", deflateSync(Buffer.from(rows))),
    chunk("IEND", Buffer.alloc(0)),
  ]);
}

/** Two height maps and two angles of three techniques; errors fall as steps double. */
export function smallRun({ slowdown = 1 } = {}) {
  const cells = [];
  for (const heightmap of ["rock", "bricks"]) {
    for (const view_angle of [0, 60]) {
      const axes = { heightmap, view_angle };
      const hard = view_angle === 0 ? 0.01 : 1;
      cells.push(measured({ technique: "flat", axes, ms: 0.1, uv: 20 * hard, missed: 0.02 * hard, steps: 0 }));
      for (const max_steps of [8, 32, 128]) {
        const ms = max_steps / 100;
        cells.push(
          measured({
            technique: "pom",
            params: { max_steps },
            axes,
            ms: ms * slowdown,
            uv: (8 * hard) / max_steps,
            steps: max_steps / 2,
          }),
        );
      }
      cells.push(measured({ technique: "qdm", params: { leaf: "exact" }, axes, ms: 0.5, uv: 0, steps: 40 }));
    }
  }
  return cells;
}

/** Two techniques without and with shadows: what they cost and how wrong they are. */
export function shadowRun() {
  const shadows = { off: null, hard: { taps: 9, error: 0.25 }, soft: { taps: 5, error: 0.5 } };
  const cells = [];
  for (const technique of ["pom", "qdm"]) {
    for (const [self_shadow, shadow] of Object.entries(shadows)) {
      const axes = self_shadow === "off" ? {} : { self_shadow };
      const ms = { off: 1, hard: 3, soft: 2 }[self_shadow] * (technique === "pom" ? 1 : 2);
      const cell = measured({ technique, axes, ms, uv: 1, shadow, outside: 99 });
      cells.push({ ...cell, axes: { ...cell.axes, self_shadow } });
    }
  }
  return cells;
}

/** As many cells as asked for, of 20 techniques over five axes. */
export function largeRun(count) {
  const cells = [];
  for (let at = 0; cells.length < count; ++at) {
    const technique = `technique_${String(at % 20).padStart(2, "0")}`;
    const step = Math.floor(at / 20);
    const max_steps = 2 ** (2 + (step % 8));
    const view = Math.floor(step / 8);
    const axes = {
      heightmap: ["rock", "bricks", "cobbles", "sand"][view % 4],
      view_angle: 15 * (Math.floor(view / 4) % 6),
      height_scale: [0.025, 0.05, 0.1][Math.floor(view / 24) % 3],
      tiling: 1 + Math.floor(view / 72),
    };
    const ms = (0.02 * max_steps * (1 + (at % 20) / 7) * (10 + axes.view_angle)) / 40;
    const uv = (40 * (1 + (at % 7))) / max_steps ** (1 + (at % 3) / 2);
    cells.push(
      measured({ technique, params: { max_steps }, axes, ms, uv, missed: at % 11 === 0 ? 0.02 : 0, steps: max_steps }),
    );
  }
  return cells;
}
