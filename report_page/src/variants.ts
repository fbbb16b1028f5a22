// Cells that differ in nothing but how the picture is made of the same hits: filters of the material, samples, frames.

import { axisValueText, numberOf, type RunData, settingOf, textOf } from "./data.ts";
import { hitErrors } from "./defaults.ts";

export interface Variant {
  cell: number;
  /** By the axes in which the variants differ: "material filter mip · frames 16". */
  label: string;
}

/**
 * The cell among its variants, in the order of the run: those of the same setting with the same hits, whose pictures are
 * beside the same picture of the truth. Empty where the cell has no such pictures.
 */
export function variantsOf(run: RunData, cell: number): Variant[] {
  const { cells, pictures } = run;
  const truth = pictures.truth[cell] ?? -1;
  if (truth < 0 || (pictures.technique[cell] ?? -1) < 0) return [];
  const setting = settingOf(cells.id[cell]!);
  const members = cells.id.flatMap((id, other) =>
    settingOf(id) === setting &&
    pictures.truth[other] === truth &&
    (pictures.technique[other] ?? -1) >= 0 &&
    hitErrors.every((path) => numberOf(cells, path, other) === numberOf(cells, path, cell))
      ? [other]
      : [],
  );
  // What only some of them have, and all of these alike, follows from another axis.
  const axes = Object.keys(cells.axes).filter(
    (axis) => new Set(members.flatMap((member) => textOf(cells.axes[axis], member) ?? [])).size > 1,
  );
  return members.map((member) => ({
    cell: member,
    label: axes
      .flatMap((axis) => {
        const text = textOf(cells.axes[axis], member);
        return text === null ? [] : [axisValueText(axis, text)];
      })
      .join(" · "),
  }));
}
