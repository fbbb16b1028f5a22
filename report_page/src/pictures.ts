// Unpacks the page's pictures: harness/report/page_pictures.hpp says how they are packed.

import type { MapLegend, PackedPicture } from "./data.ts";

export interface Picture {
  width: number;
  height: number;
  /** RGB, interleaved. */
  rgb: Uint8Array;
}

export function bytesOfBase64(text: string): Uint8Array {
  return Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
}

async function inflate(bytes: Uint8Array): Promise<Uint8Array> {
  const stream = new Blob([bytes as BlobPart]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

export function fromPalette(indices: Uint8Array, palette: Uint8Array, pixels: number): Uint8Array {
  const rgb = new Uint8Array(3 * pixels);
  const wide = indices.length > pixels;
  for (let pixel = 0; pixel < pixels; ++pixel) {
    const at = 3 * (indices[pixel]! + (wide ? 256 * indices[pixels + pixel]! : 0));
    rgb.set(palette.subarray(at, at + 3), 3 * pixel);
  }
  return rgb;
}

export function addBase(difference: Uint8Array, base: Uint8Array): Uint8Array {
  return difference.map((value, at) => (value + base[at]!) & 255);
}

/** Those last looked at stay unpacked. */
export class Pictures {
  private readonly packed: readonly PackedPicture[];
  private readonly unpacked = new Map<number, Promise<Picture>>();

  constructor(packed: readonly PackedPicture[]) {
    this.packed = packed;
  }

  /** `at` is a position in the page's pictures. */
  get(at: number): Promise<Picture> {
    const most = 48;
    const known = this.unpacked.get(at);
    const picture = known ?? this.unpack(at);
    this.unpacked.delete(at);
    this.unpacked.set(at, picture);
    if (this.unpacked.size > most) this.unpacked.delete(this.unpacked.keys().next().value!);
    return picture;
  }

  private async unpack(at: number): Promise<Picture> {
    const { width, height, packing, base, palette, data } = this.packed[at]!;
    const bytes = await inflate(bytesOfBase64(data));
    if (packing === "palette")
      return { width, height, rgb: fromPalette(bytes, bytesOfBase64(palette ?? ""), width * height) };
    if (packing === "difference") return { width, height, rgb: addBase(bytes, (await this.get(base!)).rgb) };
    return { width, height, rgb: bytes };
  }
}

/** How far a colour may lie from the scale's, summed squares of its channels, and still be one of them. */
const nearEnough = 30;

/** The value that a colour of a map stands for; null where it is none of the scale's: a missed hit, say. */
export function valueOfColour(colour: readonly number[], legend: MapLegend, colours: Uint8Array): number | null {
  let best = -1;
  let least = nearEnough;
  const last = colours.length / 3 - 1;
  for (let at = 0; at <= last; ++at) {
    const distance = colour.reduce((sum, value, channel) => sum + (value - colours[3 * at + channel]!) ** 2, 0);
    if (distance < least) [best, least] = [at, distance];
  }
  if (best < 0) return null;
  const along = best / last;
  return legend.logarithmic
    ? legend.dark * (legend.light / legend.dark) ** along
    : legend.dark + along * (legend.light - legend.dark);
}

/** Where along the legend's colours a value of its scale lies: 0 at the dark end, 1 at the light one. */
export function legendPosition({ dark, light, logarithmic }: MapLegend, value: number): number {
  return logarithmic ? Math.log(value / dark) / Math.log(light / dark) : (value - dark) / (light - dark);
}

/** Draws the picture into a canvas of its size. */
export function draw(picture: Picture, canvas: HTMLCanvasElement): void {
  canvas.width = picture.width;
  canvas.height = picture.height;
  const pixels = new ImageData(picture.width, picture.height);
  for (let pixel = 0; pixel < picture.width * picture.height; ++pixel) {
    pixels.data.set(picture.rgb.subarray(3 * pixel, 3 * pixel + 3), 4 * pixel);
    pixels.data[4 * pixel + 3] = 255;
  }
  canvas.getContext("2d")!.putImageData(pixels, 0, 0);
}
