// What the pictures of a run are compared with.

import { deep, type RunData } from "./data.ts";
import { usualError, usualQuality } from "./defaults.ts";
import { groupOf } from "./figures.ts";
import type { Metric } from "./metrics.ts";

/** With how many samples for each pixel the truth's picture was made. */
export function truthSamples(run: RunData): number {
  const samples = deep(run.record, "configuration", "truth", "samples");
  return typeof samples === "number" ? samples : 1;
}

/**
 * The error that fronts and the best cell go by: where the truth is filtered as a player sees it, what is seen decides; else
 * the hits, for a truth of one sample counts what filters do to a picture as errors.
 */
export function usualErrorsOf(run: RunData): readonly string[] {
  return truthSamples(run) > 1 ? usualQuality : usualError;
}

/** "Pictures are compared with a truth of 64 samples a pixel."; null of errors of anything else. */
export function truthNote(run: RunData, metric: Pick<Metric, "id">): string | null {
  if (groupOf(metric.id) !== groupOf(usualQuality[0]!)) return null;
  const samples = truthSamples(run);
  return `Pictures are compared with a truth of ${samples === 1 ? "one sample" : `${samples} samples`} a pixel.`;
}
