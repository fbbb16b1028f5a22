// The paths of figures: groups of them, and the passes that times are of.

import { drawTime } from "./defaults.ts";
import type { Choice, ChoiceGroup } from "./dom.ts";

/** "error" of "error.uv_texels.p99" */
export function groupOf(path: string): string {
  return path.slice(0, Math.max(0, path.indexOf(".")));
}

/** "error · uv texels" */
export function groupTitle(group: string): string {
  return group.replaceAll(".", " · ").replaceAll("_", " ");
}

/**
 * Figures under headings, both in the order of `figures`: those with the first two parts of their paths in common, where
 * there are several ("error.uv_texels"); the others of a group together.
 */
export function grouped<Figure>(
  figures: readonly Figure[],
  pathOf: (figure: Figure) => string,
): { title: string; figures: Figure[] }[] {
  const subgroup = (path: string) => path.split(".").slice(0, -1).slice(0, 2).join(".");
  const members = new Map<string, number>();
  for (const figure of figures) {
    const name = subgroup(pathOf(figure));
    members.set(name, (members.get(name) ?? 0) + 1);
  }
  const groups = new Map<string, Figure[]>();
  for (const figure of figures) {
    const path = pathOf(figure);
    const name = members.get(subgroup(path))! > 1 ? subgroup(path) : groupOf(path);
    groups.set(name, [...(groups.get(name) ?? []), figure]);
  }
  return [...groups].map(([name, found]) => ({ title: groupTitle(name), figures: found }));
}

/** For a list to choose from. */
export function groupedChoices<Figure extends { id: string }>(
  figures: readonly Figure[],
  choiceOf: (figure: Figure) => string,
): ChoiceGroup[] {
  return grouped(figures, ({ id }) => id).map(({ title, figures: found }) => ({
    title,
    choices: found.map((figure): Choice => ({ value: figure.id, label: choiceOf(figure) })),
  }));
}

/** Both of "time.<pass>.<figure>"; null of other paths. A pass' name has no dots. */
export function passFigure(path: string): { pass: string; figure: string } | null {
  const [group, pass, ...rest] = path.split(".");
  return group !== groupOf(drawTime) || rest.length === 0 ? null : { pass: pass!, figure: rest.join(".") };
}

export function passPath(pass: string, figure: string): string {
  return `${groupOf(drawTime)}.${pass}.${figure}`;
}
