import type { PageData, RunData } from "./data.ts";
import type { Theme } from "./palette.ts";
import type { State, ViewName } from "./state.ts";

/** What views read and how they ask for changes. */
export interface App {
  readonly data: PageData;
  readonly state: Readonly<State>;
  readonly theme: Theme;
  run(): RunData;
  /** Cells that the filter lets through, and those of them that were measured. */
  selection(): readonly number[];
  measured(): readonly number[];
  /** The pinned cell; -1 for none. */
  pinned(): number;
  /** The number of a technique's mark (palette.ts). */
  mark(technique: string): number;
  update(change: Partial<State>): void;
}

/** Made once per run; `refresh` brings it up to date when it is shown and the state has changed. */
export interface View {
  name: ViewName;
  title: string;
  element: HTMLElement;
  refresh(): void;
  /** A key that the page has no use for itself; true when it was taken. */
  key?(event: KeyboardEvent): boolean;
}
