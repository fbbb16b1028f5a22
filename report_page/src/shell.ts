// The page around the views: header, tabs, filters, the pinned cell, keys, and the state in the URL's fragment.

import type { App, View } from "./app.ts";
import { cellIndex, type PageData, type RunData, techniques } from "./data.ts";
import { cellSummary } from "./describe.ts";
import { fill, h } from "./dom.ts";
import { filteredCells, measuredCells } from "./filter.ts";
import { headerElement } from "./header.ts";
import { helpDialog } from "./help.ts";
import { markNumbers, type Theme } from "./palette.ts";
import { sidebar } from "./sidebar.ts";
import { type State, stateFromFragment, stateToFragment } from "./state.ts";
import { adviceView } from "./views/advice.ts";
import { axesView } from "./views/axes.ts";
import { cellsView } from "./views/cells.ts";
import { changesView } from "./views/changes.ts";
import { costView } from "./views/cost.ts";
import { enginesView } from "./views/engines.ts";
import { picturesView } from "./views/pictures.ts";
import { runView } from "./views/run.ts";
import { timingView } from "./views/timing.ts";

// A run of engines' presets was made for what the first says.
const makers = [enginesView, costView, adviceView, axesView, picturesView, timingView, changesView, cellsView, runView];

interface Shell {
  app: App;
  views: View[];
  shown(): View;
  step(by: number): void;
  toggleTheme(): void;
}

function systemTheme(): Theme {
  return matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
}

/** As page.css has it: filters stand above the views and not beside them. */
const narrow = matchMedia("(max-width: 800px)");

export function startShell(data: PageData, body: HTMLElement): void {
  let state: State = stateFromFragment(location.hash);
  let theme: Theme = systemTheme();
  let views: View[] = [];
  let selection: number[] = [];
  let measured: number[] = [];
  // Of all runs, so that switching between them changes no mark.
  const marks = markNumbers(data.runs.flatMap((each) => techniques(each.cells)));

  let filtersOpen = !narrow.matches;

  const run = (): RunData => data.runs[state.run] ?? data.runs[0]!;
  const app: App = {
    data,
    get state() {
      return state;
    },
    get theme() {
      return theme;
    },
    run,
    selection: () => selection,
    measured: () => measured,
    pinned: () => cellIndex(run().cells, state.pin),
    mark: (technique) => marks.get(technique) ?? 0,
    update(change) {
      const before = state;
      state = { ...state, ...change };
      const fragment = stateToFragment(state);
      history.replaceState(null, "", fragment === "" ? location.pathname + location.search : `#${fragment}`);
      if (state.run !== before.run) build();
      else refresh();
    },
  };

  const header = h("header");
  const aside = h("aside", { attrs: { "aria-label": "Filters" } });
  const tabs = h("nav", { attrs: { "aria-label": "Views" } });
  const pinBar = h("div", { class: "pin-bar" });
  const main = h("main", { attrs: { id: "main" } });
  const help = helpDialog();
  body.replaceChildren(
    header,
    h("div", { class: "frame" }, aside, h("div", { class: "content" }, tabs, pinBar, main)),
    help,
  );

  const shown = () => views.find((view) => view.name === state.view) ?? views[0]!;
  const shell: Shell = {
    app,
    get views() {
      return views;
    },
    shown,
    step(by) {
      const cells = measured.length > 0 ? measured : selection;
      if (cells.length === 0) return;
      const at = cells.indexOf(app.pinned());
      const next = at < 0 ? (by > 0 ? 0 : cells.length - 1) : (at + by + cells.length) % cells.length;
      app.update({ pin: run().cells.id[cells[next]!]! });
    },
    toggleTheme() {
      setTheme(theme === "dark" ? "light" : "dark");
    },
  };

  function setTheme(next: Theme): void {
    theme = next;
    document.documentElement.dataset["theme"] = theme;
    build();
  }

  function build(): void {
    views = makers.map((make) => make(app)).filter((view): view is View => view !== null);
    fill(
      header,
      headerElement(
        app,
        () => shell.toggleTheme(),
        () => help.showModal(),
      ),
    );
    fill(
      tabs,
      ...views.map((view, at) =>
        h(
          "button",
          {
            title: `Key ${at + 1}`,
            attrs: { type: "button", "data-view": view.name },
            on: { click: () => app.update({ view: view.name }) },
          },
          view.title,
        ),
      ),
    );
    refresh();
  }

  function refresh(): void {
    const { cells } = run();
    selection = filteredCells(cells, state);
    measured = measuredCells(cells, selection);
    const view = shown();
    const focused = focusedSelector();
    for (const tab of tabs.querySelectorAll("button")) {
      if (tab.dataset["view"] === view.name) tab.setAttribute("aria-current", "page");
      else tab.removeAttribute("aria-current");
    }
    fill(
      aside,
      sidebar(app, filtersOpen, (open) => (filtersOpen = open)),
    );
    fill(pinBar, pinElement(app, shell));
    if (main.firstElementChild !== view.element) main.replaceChildren(view.element);
    view.refresh();
    if (focused !== null && document.activeElement === body) document.querySelector<HTMLElement>(focused)?.focus();
    document.title = `${view.title} – ${run().name} – reliefbench`;
  }

  document.documentElement.dataset["theme"] = theme;
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => setTheme(systemTheme()));
  narrow.addEventListener("change", () => {
    filtersOpen = !narrow.matches;
    refresh();
  });
  addEventListener("hashchange", () => app.update(stateFromFragment(location.hash)));
  addEventListener("keydown", (event) => onKey(event, shell, help));
  build();
}

/** How to find the element that has the focus once its surroundings were made anew. */
function focusedSelector(): string | null {
  const element = document.activeElement;
  if (!(element instanceof HTMLElement)) return null;
  const within = (name: string) => {
    const value = element.closest<HTMLElement>(`[${name}]`)?.getAttribute(name);
    return value === null || value === undefined ? "" : `[${name}="${CSS.escape(value)}"]`;
  };
  const [filter, column] = [within("data-filter"), within("data-column")];
  if (filter !== "") return `${filter} ${within("data-value")}`;
  if (column !== "") return `${column} button`;
  return within("data-verdict") || (element.closest(".pin-bar") ? `.pin-bar ${within("aria-label")}` : null);
}

/** The pinned cell with its figures, above every view. */
function pinElement(app: App, shell: Shell): HTMLElement | null {
  const pinned = app.pinned();
  const { cells } = app.run();
  if (pinned < 0) {
    return app.state.pin === ""
      ? null
      : h("p", { class: "muted" }, `This run has no cell “${app.state.pin}”.`, unpinButton(app));
  }
  const id = cells.id[pinned]!;
  return h(
    "div",
    { class: "pin", attrs: { "data-pin": id } },
    h("span", { class: "pin-label" }, "Pinned"),
    ...cellSummary(app, pinned),
    h(
      "span",
      { class: "pin-buttons" },
      h(
        "button",
        {
          title: "Previous cell (k)",
          attrs: { type: "button", "aria-label": "Previous cell" },
          on: { click: () => shell.step(-1) },
        },
        "‹",
      ),
      h(
        "button",
        {
          title: "Next cell (j)",
          attrs: { type: "button", "aria-label": "Next cell" },
          on: { click: () => shell.step(1) },
        },
        "›",
      ),
      unpinButton(app),
    ),
  );
}

function unpinButton(app: App): HTMLElement {
  return h(
    "button",
    {
      title: "Unpin (Esc)",
      attrs: { type: "button", "aria-label": "Unpin" },
      on: { click: () => app.update({ pin: "" }) },
    },
    "×",
  );
}

/** Whether the element takes this key for itself. */
function takesKeys(target: EventTarget | null, key: string): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target instanceof HTMLInputElement) return target.type !== "range" && target.type !== "checkbox";
  if (target instanceof HTMLSelectElement || target instanceof HTMLTextAreaElement) return true;
  return (key === " " || key === "Enter") && target instanceof HTMLButtonElement;
}

function onKey(event: KeyboardEvent, shell: Shell, help: HTMLDialogElement): void {
  if (event.ctrlKey || event.metaKey || event.altKey || help.open) return;
  const { app } = shell;
  // Also on a button of the view that was just clicked: space flips pictures, whatever has the focus.
  if (event.target instanceof HTMLButtonElement && event.key === " " && shell.shown().key?.(event)) {
    event.preventDefault();
    return;
  }
  if (takesKeys(event.target, event.key)) {
    if (event.key === "Escape") (event.target as HTMLElement).blur();
    return;
  }
  const view = shell.views[Number(event.key) - 1];
  const actions: Record<string, () => void> = {
    "?": () => help.showModal(),
    Escape: () => app.update({ pin: "" }),
    j: () => shell.step(1),
    k: () => shell.step(-1),
    r: () => app.update({ run: (app.state.run + 1) % app.data.runs.length }),
    t: () => shell.toggleTheme(),
    x: () => app.update({ filters: {}, techniques: [] }),
    "/": () => {
      app.update({ view: "cells" });
      document.querySelector<HTMLInputElement>("#query")?.focus();
    },
  };
  const action = actions[event.key];
  if (view !== undefined && /^[1-9]$/.test(event.key)) app.update({ view: view.name });
  else if (shell.shown().key?.(event)) event.preventDefault();
  else if (action !== undefined) {
    action();
    event.preventDefault();
  }
}
