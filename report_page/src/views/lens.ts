// A magnified part of a picture, with the values of the pixel in its middle.

import type { MapLegend } from "../data.ts";
import { h } from "../dom.ts";
import type { Picture } from "../pictures.ts";
import { legendValueText } from "./map_legend.ts";

export interface Pixel {
  x: number;
  y: number;
}

/** Pixels on a side of the magnifier. */
const lensPixels = 15;
const lensScale = 10;

function colourAt(picture: Picture, { x, y }: Pixel): [number, number, number] | null {
  if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) return null;
  const at = 3 * (y * picture.width + x);
  return [picture.rgb[at]!, picture.rgb[at + 1]!, picture.rgb[at + 2]!];
}

export function lensPart(title: string, picture: Picture | null, pixel: Pixel, legend: MapLegend | null): HTMLElement {
  const canvas = h("canvas", {
    attrs: { width: lensPixels * lensScale, height: lensPixels * lensScale, "aria-hidden": true },
  });
  const pen = canvas.getContext("2d")!;
  const reach = lensPixels >> 1;
  for (let dy = -reach; dy <= reach; ++dy) {
    for (let dx = -reach; dx <= reach; ++dx) {
      const colour = picture === null ? null : colourAt(picture, { x: pixel.x + dx, y: pixel.y + dy });
      if (colour === null) continue;
      pen.fillStyle = `rgb(${colour.join(" ")})`;
      pen.fillRect((dx + reach) * lensScale, (dy + reach) * lensScale, lensScale, lensScale);
    }
  }
  pen.strokeStyle = "white";
  pen.strokeRect(reach * lensScale - 0.5, reach * lensScale - 0.5, lensScale + 1, lensScale + 1);
  pen.strokeStyle = "black";
  pen.strokeRect(reach * lensScale - 1.5, reach * lensScale - 1.5, lensScale + 3, lensScale + 3);
  const colour = picture === null ? null : colourAt(picture, pixel);
  return h(
    "figure",
    { class: "lens-part" },
    canvas,
    h(
      "figcaption",
      {},
      h("b", {}, title),
      h("span", { class: "pixel-value" }, colour === null ? "–" : colour.join("  ")),
      legend === null || colour === null ? null : h("span", { class: "map-value" }, legendValueText(colour, legend)),
    ),
  );
}
