// The pictures of the pinned cell, or of the best: truth, technique and error map side by side, with a slider, a flip and a
// magnifier.

import type { App, View } from "../app.ts";
import type { MapLegend } from "../data.ts";
import { usualMap } from "../defaults.ts";
import { fact, shownMetrics, warning } from "../describe.ts";
import { choose, fill, h, segments } from "../dom.ts";
import { draw, type Picture, Pictures } from "../pictures.ts";
import { metricText } from "../metrics.ts";
import { type PictureMode, pictureModes } from "../state.ts";
import { type Variant, variantsOf } from "../variants.ts";
import { lensPart, type Pixel } from "./lens.ts";
import { legendElement } from "./map_legend.ts";
import { shownCell } from "./shown_cell.ts";

interface Shown {
  truth: Picture | null;
  technique: Picture | null;
  map: Picture | null;
  legend: MapLegend | null;
  /** In the mode that shows them; else empty. */
  variants: { title: string; picture: Picture | null }[];
}

export function picturesView(app: App): View {
  const pictures = new Pictures(app.data.pictures);
  const mode = segments(
    "How to compare",
    [
      { value: "side", label: "Side by side" },
      { value: "slider", label: "Slider" },
      { value: "flip", label: "Flip" },
      { value: "variants", label: "Variants" },
    ],
    (value) => app.update({ mode: value as PictureMode }),
  );
  const names = mapNames(app);
  const map = choose(
    "Map",
    names.map((name) => ({ value: name, label: mapTitle(app, name) })),
    "",
    (value) => app.update({ map: value }),
  );
  const stage = h("div", { class: "stage" });
  const lens = h("div", { class: "lens", attrs: { "aria-live": "off" } });
  const empty = h("div", {});
  const controls = h("div", { class: "controls" }, mode.element, names.length > 1 ? map.element : null);
  const element = h("section", { class: "view-pictures" }, empty, controls, stage, lens);

  let shown: Shown = { truth: null, technique: null, map: null, legend: null, variants: [] };
  let showsTruth = false;
  let divider = 0.5;
  let pixel: Pixel | null = null;
  let drawn = "";

  const refreshLens = () => fill(lens, ...lensElements(shown, pixel, mapTitle(app, mapName(app)), legendOf(app)));
  const point = (next: Pixel | null) => {
    pixel = next;
    refreshLens();
    for (const cross of stage.querySelectorAll<HTMLElement>(".cross"))
      placeCross(cross, shown.technique ?? shown.truth, pixel);
  };
  const flip = () => {
    showsTruth = !showsTruth;
    showFlip(stage, showsTruth);
  };

  const redraw = () => {
    stage.dataset["mode"] = app.state.mode;
    if (app.state.mode === "side") fill(stage, ...sideBySide(shown, mapTitle(app, mapName(app)), point));
    else if (app.state.mode === "variants") fill(stage, ...besideVariants(shown, point));
    else if (app.state.mode === "slider") {
      fill(
        stage,
        slider(shown, divider, (to) => (divider = to), point),
        mapPane(shown, mapTitle(app, mapName(app)), point),
      );
    } else {
      fill(stage, flipPane(shown, point, flip), mapPane(shown, mapTitle(app, mapName(app)), point));
      showFlip(stage, showsTruth);
    }
    point(pixel);
  };

  async function load(wanted: Wanted): Promise<void> {
    const key = JSON.stringify([wanted, app.state.mode, mapName(app)]);
    if (key === drawn) return;
    drawn = key;
    const get = (at: number): Promise<Picture> | null => (at < 0 ? null : pictures.get(at));
    const [truth, technique, error] = await Promise.all([wanted.truth, wanted.technique, wanted.map].map(get));
    const variants = await Promise.all(
      wanted.variants.map(async ({ title, at }) => ({ title, picture: (await get(at)) ?? null })),
    );
    if (key !== drawn) return;
    shown = { truth: truth ?? null, technique: technique ?? null, map: error ?? null, legend: legendOf(app), variants };
    pixel ??= middle(shown.technique ?? shown.truth);
    redraw();
  }

  return {
    name: "pictures",
    title: "Pictures",
    element,
    refresh() {
      mode.set(app.state.mode);
      map.select.value = mapName(app);
      map.element.hidden = app.state.mode === "variants";
      const { wanted, why } = shownPictures(app);
      fill(empty, why);
      for (const part of [controls, stage, lens]) part.hidden = wanted === null;
      if (wanted === null) {
        drawn = "";
        return;
      }
      load(wanted).catch((problem: unknown) =>
        fill(empty, warning(`The pictures cannot be unpacked: ${String(problem)}`)),
      );
    },
    key(event) {
      if (event.key === " " && (app.state.mode === "side" || app.state.mode === "flip")) {
        if (app.state.mode !== "flip") app.update({ mode: "flip" });
        else flip();
        return true;
      }
      if (event.key === "m") {
        app.update({ mode: pictureModes[(pictureModes.indexOf(app.state.mode) + 1) % pictureModes.length]! });
        return true;
      }
      const size = shown.technique ?? shown.truth;
      const step = event.shiftKey ? 10 : 1;
      const moves: Record<string, [number, number]> = {
        ArrowLeft: [-1, 0],
        ArrowRight: [1, 0],
        ArrowUp: [0, -1],
        ArrowDown: [0, 1],
      };
      const move = moves[event.key];
      if (move === undefined || size === null || stage.hidden) return false;
      const from = pixel ?? middle(size)!;
      point({ x: clamp(from.x + step * move[0], size.width), y: clamp(from.y + step * move[1], size.height) });
      return true;
    },
  };
}

function clamp(value: number, size: number): number {
  return Math.max(0, Math.min(size - 1, value));
}

function middle(picture: Picture | null): Pixel | null {
  return picture === null ? null : { x: picture.width >> 1, y: picture.height >> 1 };
}

/** The error that most people look at goes first. */
function mapNames(app: App): string[] {
  return Object.keys(app.run().pictures.maps).sort((a, b) => Number(b === usualMap) - Number(a === usualMap));
}

function mapName(app: App): string {
  const { maps } = app.run().pictures;
  return Object.hasOwn(maps, app.state.map) ? app.state.map : (mapNames(app)[0] ?? "");
}

function legendOf(app: App): MapLegend | null {
  const { legends } = app.run().pictures;
  return Object.hasOwn(legends, mapName(app)) ? (legends[mapName(app)] ?? null) : null;
}

function mapTitle(app: App, name: string): string {
  const { legends } = app.run().pictures;
  if (Object.hasOwn(legends, name)) return legends[name]!.title;
  return name === "" ? "Error map" : name[0]!.toUpperCase() + name.slice(1).replaceAll("_", " ");
}

/** Positions in the page's pictures, -1 for none. */
interface Wanted {
  truth: number;
  technique: number;
  map: number;
  variants: { title: string; at: number }[];
}

const noVariants =
  "No other cell with pictures differs from this one only in how its picture is made of the same hits: in filters of the material, samples or frames.";
/** More panes than this are no comparison. */
const maxVariants = 12;

function variantTitle(app: App, { cell, label }: Variant): string {
  const { error } = shownMetrics(app);
  const value = error?.of(app.run().cells, cell) ?? null;
  const name = label === "" ? "Technique" : label;
  return error === null || value === null ? name : `${name}: ${error.label} ${metricText(error, value)}`;
}

function wantedPictures(app: App, cell: number): Wanted {
  const { pictures } = app.run();
  const variants = app.state.mode === "variants" ? variantsOf(app.run(), cell).slice(0, maxVariants) : [];
  return {
    variants: variants.map((variant) => ({ title: variantTitle(app, variant), at: pictures.technique[variant.cell]! })),
    truth: pictures.truth[cell] ?? -1,
    technique: pictures.technique[cell] ?? -1,
    map: pictures.maps[mapName(app)]?.[cell] ?? -1,
  };
}

/** What is there of which cell, and what has to be said: why this cell, or why there is nothing. */
function shownPictures(app: App): { wanted: Wanted | null; why: HTMLElement | null } {
  const { pictures } = app.run();
  const { cell, why } = shownCell(app, (each) => (pictures.technique[each] ?? -1) >= 0);
  const any = pictures.technique.some((at) => at >= 0);
  const wanted = wantedPictures(app, cell);
  if (cell >= 0 && (wanted.truth >= 0 || wanted.technique >= 0)) {
    const alone = app.state.mode === "variants" && wanted.variants.length < 2;
    return { wanted, why: alone ? h("div", {}, why, fact(noVariants)) : why };
  }
  if (cell < 0 && any) return { wanted: null, why };
  const text = !any
    ? 'This run kept no pictures. Set "images": true in its configuration, run it and make the report again.'
    : pictures.left_out > 0
      ? `The pictures of ${pictures.left_out} cells did not fit into this file, this cell's among them. reliefbench report --picture-megabytes makes room.`
      : "There are no pictures of this cell: it was not measured.";
  return { wanted: null, why: h("p", { class: "empty" }, text) };
}

function onPointer(element: HTMLElement, picture: Picture | null, point: (pixel: Pixel) => void): void {
  if (picture === null) return;
  element.addEventListener("pointermove", (event) => {
    const box = element.getBoundingClientRect();
    point({
      x: clamp(Math.floor(((event.clientX - box.left) / box.width) * picture.width), picture.width),
      y: clamp(Math.floor(((event.clientY - box.top) / box.height) * picture.height), picture.height),
    });
  });
}

function canvasOf(picture: Picture | null, name: string): HTMLElement {
  if (picture === null) return h("div", { class: "missing" }, "not in this file");
  const canvas = h("canvas", { class: "picture", attrs: { "data-picture": name, role: "img", "aria-label": name } });
  draw(picture, canvas);
  return canvas;
}

/** So that a whole picture can be seen at once, however wide the window. */
function limitHeight(frame: HTMLElement, picture: Picture | null): void {
  if (picture !== null) frame.style.maxWidth = `calc(72vh * ${picture.width / picture.height})`;
}

function placeCross(cross: HTMLElement, picture: Picture | null, pixel: Pixel | null): void {
  cross.hidden = picture === null || pixel === null;
  if (picture === null || pixel === null) return;
  cross.style.left = `${(100 * (pixel.x + 0.5)) / picture.width}%`;
  cross.style.top = `${(100 * (pixel.y + 0.5)) / picture.height}%`;
}

function paneOf(name: string, title: string, picture: Picture | null, point: (pixel: Pixel) => void): HTMLElement {
  const frame = h("div", { class: "picture-frame" }, canvasOf(picture, name), h("span", { class: "cross" }));
  limitHeight(frame, picture);
  onPointer(frame, picture, point);
  return h("figure", { class: "pane" }, h("figcaption", {}, title), frame);
}

function mapPane(shown: Shown, title: string, point: (pixel: Pixel) => void): HTMLElement {
  const pane = paneOf("map", title, shown.map, point);
  if (shown.legend !== null) pane.append(legendElement(shown.legend));
  return pane;
}

function sideBySide(shown: Shown, map: string, point: (pixel: Pixel) => void): HTMLElement[] {
  return [
    paneOf("truth", "Ground truth", shown.truth, point),
    paneOf("technique", "Technique", shown.technique, point),
    mapPane(shown, map, point),
  ];
}

function besideVariants(shown: Shown, point: (pixel: Pixel) => void): HTMLElement[] {
  return [
    paneOf("truth", "Ground truth", shown.truth, point),
    ...shown.variants.map(({ title, picture }, at) => paneOf(`variant ${at}`, title, picture, point)),
  ];
}

function slider(shown: Shown, start: number, onMove: (to: number) => void, point: (pixel: Pixel) => void): HTMLElement {
  const over = h("div", { class: "over" }, canvasOf(shown.technique, "technique"));
  const range = h("input", {
    class: "divider",
    attrs: {
      type: "range",
      min: 0,
      max: 1,
      step: 0.001,
      value: start,
      "aria-label": "Where truth ends and technique begins",
    },
    on: { input: () => place(Number(range.value)) },
  });
  const frame = h(
    "div",
    { class: "picture-frame" },
    canvasOf(shown.truth, "truth"),
    over,
    h("span", { class: "cross" }),
  );
  const place = (to: number) => {
    frame.style.setProperty("--divider", `${100 * to}%`);
    onMove(to);
  };
  frame.addEventListener("pointerdown", (event) => frame.setPointerCapture(event.pointerId));
  const follow = (event: PointerEvent) => {
    if (event.buttons === 0) return;
    const box = frame.getBoundingClientRect();
    const to = Math.max(0, Math.min(1, (event.clientX - box.left) / box.width));
    range.value = String(to);
    place(to);
  };
  frame.addEventListener("pointermove", follow);
  frame.addEventListener("pointerdown", follow);
  limitHeight(frame, shown.technique ?? shown.truth);
  onPointer(frame, shown.technique ?? shown.truth, point);
  place(start);
  return h("figure", { class: "pane" }, h("figcaption", {}, "Ground truth left, technique right"), frame, range);
}

function flipPane(shown: Shown, point: (pixel: Pixel) => void, flip: () => void): HTMLElement {
  const frame = h(
    "div",
    { class: "picture-frame", title: "Click or press space", on: { click: flip } },
    canvasOf(shown.technique, "technique"),
    h("div", { class: "over whole" }, canvasOf(shown.truth, "truth")),
    h("span", { class: "cross" }),
  );
  limitHeight(frame, shown.technique ?? shown.truth);
  onPointer(frame, shown.technique ?? shown.truth, point);
  return h("figure", { class: "pane flip" }, h("figcaption", {}), frame);
}

function showFlip(stage: HTMLElement, truth: boolean): void {
  const pane = stage.querySelector<HTMLElement>(".flip");
  if (pane === null) return;
  pane.dataset["shows"] = truth ? "truth" : "technique";
  fill(
    pane.querySelector("figcaption")!,
    truth ? "Ground truth" : "Technique",
    h("span", { class: "muted" }, "  space flips"),
  );
}

function lensElements(shown: Shown, pixel: Pixel | null, map: string, legend: MapLegend | null): HTMLElement[] {
  if (pixel === null) return [];
  const others: [string, Picture | null][] =
    shown.variants.length > 0
      ? shown.variants.map(({ title, picture }) => [title, picture])
      : [
          ["Technique", shown.technique],
          [map, shown.map],
        ];
  const parts: [string, Picture | null][] = [["Ground truth", shown.truth], ...others];
  return [
    h(
      "p",
      { class: "lens-title" },
      "Magnifier",
      h("span", { class: "muted" }, ` pixel ${pixel.x}, ${pixel.y}; red, green and blue, sRGB, 0 to 255`),
    ),
    ...parts.map(([title, picture]) => lensPart(title, picture, pixel, picture === shown.map ? legend : null)),
  ];
}
