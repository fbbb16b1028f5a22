// The fields of advice's limits: a budget, and any figure at most or at least so much.

import type { Question } from "../advice.ts";
import type { App } from "../app.ts";
import { fill, h, optionElements } from "../dom.ts";
import { groupedChoices } from "../figures.ts";
import { type Metric, metricTitle } from "../metrics.ts";

function numberIn(input: HTMLInputElement): number | null {
  const value = input.value === "" ? NaN : Number(input.value);
  return Number.isFinite(value) && value >= 0 ? value : null;
}

interface Field {
  element: HTMLElement;
  input: HTMLInputElement;
}

function limitField(label: string, unit: string, onInput: (value: number | null) => void): Field {
  const input: HTMLInputElement = h("input", {
    attrs: { type: "number", min: 0, step: "any", placeholder: "any" },
    on: { input: () => onInput(numberIn(input)) },
  });
  const element = h("label", { class: "amount" }, h("span", {}, label), input, h("span", { class: "unit" }, unit));
  return { element, input };
}

export class LimitFields {
  readonly element = h("div", { class: "limits" });
  private readonly app: App;
  private readonly metrics: readonly Metric[];
  private readonly fields = new Map<string, Field>();
  /** Figures that a field was asked for. */
  private readonly opened = new Set<string>();
  private shown: string[] = [];
  private costId = "";

  constructor(app: App, metrics: readonly Metric[]) {
    this.app = app;
    this.metrics = metrics;
  }

  /** Fields for the budget, the error that ranks, those of `usual`, those with a limit and those asked for. */
  refresh(question: Question, budget: number | null, usual: readonly string[]): void {
    const { cost, error } = question;
    if (cost.id !== this.costId) {
      // The fields of the old and of the new budget change their meaning.
      for (const id of [this.costId, cost.id]) this.fields.delete(id);
      this.costId = cost.id;
      this.shown = [];
    }
    const wanted = new Set([error.id, ...usual, ...Object.keys(this.app.state.limits), ...this.opened]);
    wanted.delete(cost.id);
    const ids = [cost.id, ...this.metrics.map(({ id }) => id).filter((id) => wanted.has(id))];
    if (ids.join("\n") !== this.shown.join("\n")) {
      this.shown = ids;
      fill(this.element, h("span", { class: "limits-title" }, "Limits"));
      for (const id of ids) this.element.append(this.fieldOf(id).element);
      this.element.append(this.adder(new Set(ids)));
    }
    for (const id of ids) {
      const { input } = this.fieldOf(id);
      const value = id === cost.id ? budget : (this.app.state.limits[id] ?? null);
      if (document.activeElement !== input) input.value = value === null ? "" : String(value);
    }
  }

  private fieldOf(id: string): Field {
    const known = this.fields.get(id);
    if (known) return known;
    const metric = this.metrics.find((each) => each.id === id)!;
    const isBudget = id === this.costId;
    const label = isBudget ? "Budget" : `${metric.label} at ${metric.better === "lower" ? "most" : "least"}`;
    const field = limitField(label, metric.unit, (value) => {
      if (isBudget) this.app.update({ budget: value });
      else this.setLimit(id, value);
    });
    field.element.dataset["limit"] = id;
    this.fields.set(id, field);
    return field;
  }

  private setLimit(id: string, value: number | null): void {
    const { [id]: _, ...limits } = this.app.state.limits;
    this.app.update({ limits: value === null ? limits : { ...limits, [id]: value } });
  }

  /** A list to choose another figure from. */
  private adder(there: ReadonlySet<string>): HTMLElement {
    const select: HTMLSelectElement = h(
      "select",
      {
        attrs: { "aria-label": "Limit another figure" },
        on: {
          change: () => {
            const id = select.value;
            this.opened.add(id);
            this.app.update({});
            this.fields.get(id)?.input.focus();
          },
        },
      },
      h("option", { attrs: { value: "" } }, "+ another limit"),
      ...optionElements(
        groupedChoices(
          this.metrics.filter(({ id }) => !there.has(id)),
          metricTitle,
        ),
      ),
    );
    return select;
  }
}
