// Elements from data. Text always becomes text: results files are not trusted, and nothing here reads markup.

type Child = Node | string | number | null | undefined | false;

interface Props {
  class?: string;
  title?: string;
  attrs?: Record<string, string | number | boolean | undefined>;
  on?: Partial<{ [K in keyof HTMLElementEventMap]: (event: HTMLElementEventMap[K]) => void }>;
}

export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  props: Props = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  if (props.class) element.className = props.class;
  if (props.title) element.title = props.title;
  for (const [name, value] of Object.entries(props.attrs ?? {})) {
    if (value === undefined || value === false) continue;
    element.setAttribute(name, value === true ? "" : String(value));
  }
  for (const [name, listener] of Object.entries(props.on ?? {})) {
    element.addEventListener(name, listener as EventListener);
  }
  append(element, children);
  return element;
}

function append(parent: Node, children: Child[]): void {
  for (const child of children) {
    if (child === null || child === undefined || child === false) continue;
    parent.appendChild(typeof child === "object" ? child : document.createTextNode(String(child)));
  }
}

export function fill(parent: Element, ...children: Child[]): void {
  parent.replaceChildren();
  append(parent, children);
}

export interface Choice {
  value: string;
  label: string;
}

/** Choices under a heading. */
export interface ChoiceGroup {
  title: string;
  choices: Choice[];
}

/** Elements for a list to choose from. */
export function optionElements(choices: readonly (Choice | ChoiceGroup)[]): HTMLElement[] {
  return choices.map((choice) =>
    "choices" in choice
      ? h("optgroup", { attrs: { label: choice.title } }, ...optionElements(choice.choices))
      : h("option", { attrs: { value: choice.value } }, choice.label),
  );
}

export interface Select {
  element: HTMLElement;
  select: HTMLSelectElement;
}

/** A labelled list to choose from. */
export function choose(
  label: string,
  choices: readonly (Choice | ChoiceGroup)[],
  value: string,
  onChange: (value: string) => void,
): Select {
  const select = h("select", { on: { change: () => onChange(select.value) } }, ...optionElements(choices));
  select.value = value;
  return { element: h("label", { class: "field" }, h("span", {}, label), select), select };
}

/** Buttons of which one is pressed. */
export function segments(
  label: string,
  choices: Choice[],
  onChange: (value: string) => void,
): { element: HTMLElement; set(value: string): void } {
  const buttons = choices.map((choice) =>
    h(
      "button",
      { attrs: { type: "button", "data-value": choice.value }, on: { click: () => onChange(choice.value) } },
      choice.label,
    ),
  );
  return {
    element: h("div", { class: "segments", attrs: { role: "group", "aria-label": label } }, ...buttons),
    set(value) {
      for (const button of buttons) button.setAttribute("aria-pressed", String(button.dataset["value"] === value));
    },
  };
}
