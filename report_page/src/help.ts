import { h } from "./dom.ts";

const keys: [string, string][] = [
  ["1 … 9", "the views, in the order of their tabs"],
  ["j  k", "pin the next, the previous cell"],
  ["Space", "Pictures: flip between truth and technique"],
  ["← → ↑ ↓", "Pictures: move the magnifier by a pixel (with Shift: ten)"],
  ["m", "Pictures: side by side, slider, flip, variants"],
  ["/", "search the cells"],
  ["x", "show everything again"],
  ["r", "the next run"],
  ["t", "light or dark"],
  ["Esc", "unpin, leave a field, close this"],
];

export function helpDialog(): HTMLDialogElement {
  const dialog: HTMLDialogElement = h(
    "dialog",
    { attrs: { "aria-label": "Keys" } },
    h("h2", {}, "Keys"),
    h("dl", { class: "keys" }, ...keys.flatMap(([key, what]) => [h("dt", {}, h("kbd", {}, key)), h("dd", {}, what)])),
    h(
      "p",
      { class: "muted" },
      "The address holds what you see: copy it to share this view of the file. In charts, scroll to zoom, drag to move, ",
      "double-click to see everything again.",
    ),
    h("form", { attrs: { method: "dialog" } }, h("button", { class: "primary" }, "Close")),
  );
  return dialog;
}
