// A table of many rows, of which only those in sight are elements.

import { fill, h } from "./dom.ts";

export interface Column<Row> {
  id: string;
  title: string;
  unit?: string;
  /** What the column is, in full. */
  help?: string;
  number: boolean;
  /** What rows are sorted by; null comes last either way. */
  key(row: Row): number | string | null;
  content(row: Row): Node | string;
}

/** The column that says whose row it is; it stays in sight when the others are scrolled. */
export function identity<Row>(of: {
  /** In full: what rows are sorted by and what hovering tells. */
  id(row: Row): string;
  content(row: Row): Node;
  /** In a second line. */
  below(row: Row): (Node | string | null)[];
}): Column<Row> {
  return {
    id: "cell",
    title: "Cell",
    number: false,
    key: of.id,
    content: (row) =>
      h(
        "div",
        { class: "identity", title: of.id(row) },
        h("div", {}, of.content(row)),
        h("div", { class: "muted small" }, ...of.below(row)),
      ),
  };
}

export interface TableOptions<Row> {
  label: string;
  onSort(column: string): void;
  onRow(row: Row): void;
  rowClass(row: Row): string;
  /** What stands in the place of figures in a row that has none of them. */
  instead?(row: Row): string | null;
}

function compare(a: number | string | null, b: number | string | null): number {
  if (a === null || b === null) return a === b ? 0 : a === null ? 1 : -1;
  if (typeof a === "number" && typeof b === "number") return a - b;
  return String(a).localeCompare(String(b), "en", { numeric: true });
}

/** `sort` is a column's id, descending with a leading "-". Equal rows keep their order; undefined ones come last. */
export function sortRows<Row>(rows: readonly Row[], columns: readonly Column<Row>[], sort: string): Row[] {
  const descending = sort.startsWith("-");
  const column = columns.find(({ id }) => id === (descending ? sort.slice(1) : sort));
  if (column === undefined) return [...rows];
  const keyed = rows.map((row, at) => ({ row, at, key: column.key(row) }));
  keyed.sort((a, b) => {
    if (a.key === null || b.key === null) return compare(a.key, b.key) || a.at - b.at;
    return (descending ? -1 : 1) * compare(a.key, b.key) || a.at - b.at;
  });
  return keyed.map(({ row }) => row);
}

function cellElement<Row>(column: Column<Row>, row: Row): HTMLElement {
  const content = column.content(row);
  return h("td", { class: column.number ? "number" : "", title: typeof content === "string" ? content : "" }, content);
}

export class Table<Row> {
  readonly element: HTMLElement;
  private readonly head = h("thead");
  private readonly body = h("tbody");
  private readonly options: TableOptions<Row>;
  private rows: readonly Row[] = [];
  private columns: readonly Column<Row>[] = [];
  /** Pixels; of rows that were never drawn none is known. */
  private heights: (number | undefined)[] = [];
  private usualHeight = 30;
  /** At which the heights were measured. */
  private width = 0;
  private first = -1;
  private last = -1;

  constructor(options: TableOptions<Row>) {
    this.options = options;
    this.element = h(
      "div",
      { class: "table-scroll", attrs: { tabindex: 0, role: "region", "aria-label": options.label } },
      h("table", { class: "rows" }, this.head, this.body),
    );
    this.element.addEventListener("scroll", () => this.draw(false), { passive: true });
    new ResizeObserver(() => {
      const otherWidth = this.width !== this.element.clientWidth;
      if (otherWidth) this.heights = [];
      this.draw(otherWidth);
    }).observe(this.element);
  }

  show(rows: readonly Row[], columns: readonly Column<Row>[], sort: string): void {
    this.rows = rows;
    this.columns = columns;
    this.heights = [];
    const name = sort.replace(/^-/, "");
    const direction = sort.startsWith("-") ? "descending" : "ascending";
    fill(
      this.head,
      h(
        "tr",
        {},
        ...columns.map((column) =>
          h(
            "th",
            {
              class: column.number ? "number" : "",
              title: column.help ?? "",
              attrs: {
                scope: "col",
                "aria-sort": column.id === name ? direction : undefined,
                "data-column": column.id,
              },
            },
            h(
              "button",
              { attrs: { type: "button" }, on: { click: () => this.options.onSort(column.id) } },
              column.title,
              column.unit ? h("span", { class: "unit" }, column.unit) : null,
              column.id === name ? h("span", { class: "arrow" }, direction === "ascending" ? " ↑" : " ↓") : null,
            ),
          ),
        ),
      ),
    );
    this.draw(true);
  }

  /** Brings a row into sight; again where rows that were drawn for it have other heights than were expected. */
  reveal(at: number): void {
    const maxTries = 3;
    for (let tries = 0; tries < maxTries; ++tries) {
      const [top, bottom] = [this.heightOf(0, at), this.heightOf(0, at + 1)];
      const { scrollTop, clientHeight } = this.element;
      const room = clientHeight - this.head.offsetHeight;
      if (top >= scrollTop && bottom <= scrollTop + room) return;
      this.element.scrollTop = top < scrollTop ? top : bottom - room;
      this.draw(false);
    }
  }

  /** Of the rows from `first` to before `last`. */
  private heightOf(first: number, last: number): number {
    let sum = 0;
    for (let at = first; at < last; ++at) sum += this.heights[at] ?? this.usualHeight;
    return sum;
  }

  /** The row at a height, and what of it lies above that. */
  private rowAt(height: number): { at: number; above: number } {
    let above = Math.max(0, height);
    for (let at = 0; at < this.rows.length; ++at) {
      const own = this.heightOf(at, at + 1);
      if (above < own) return { at, above };
      above -= own;
    }
    return { at: this.rows.length, above: 0 };
  }

  private cellsOf(row: Row): HTMLElement[] {
    const [first, ...others] = this.columns;
    const figures = others.filter((column) => column.number);
    const instead = figures.every((column) => column.key(row) === null) ? (this.options.instead?.(row) ?? null) : null;
    if (first !== undefined && instead !== null && others.length > 0)
      return [
        cellElement(first, row),
        h("td", { class: "instead", title: instead, attrs: { colspan: others.length } }, instead),
      ];
    return this.columns.map((column) => cellElement(column, row));
  }

  private draw(afresh: boolean): void {
    const margin = 10;
    const { scrollTop, clientHeight } = this.element;
    this.width = this.element.clientWidth;
    const top = this.rowAt(scrollTop);
    const first = Math.max(0, top.at - margin);
    const last = Math.min(this.rows.length, this.rowAt(scrollTop + (clientHeight || 800)).at + margin);
    if (!afresh && first === this.first && last === this.last) return;
    [this.first, this.last] = [first, last];
    const spacer = () => h("tr", { class: "spacer", attrs: { "aria-hidden": true } });
    const [before, behind] = [spacer(), spacer()];
    const drawn = this.rows
      .slice(first, last)
      .map((row) =>
        h(
          "tr",
          { class: this.options.rowClass(row), on: { click: () => this.options.onRow(row) } },
          ...this.cellsOf(row),
        ),
      );
    const space = () => {
      before.style.height = `${this.heightOf(0, first)}px`;
      behind.style.height = `${this.heightOf(last, this.rows.length)}px`;
    };
    // Before anything is measured, so that the table is never too short for where it is scrolled to.
    space();
    fill(this.body, first > 0 && before, ...drawn, last < this.rows.length && behind);
    const heights = drawn.map((element) => element.getBoundingClientRect().height);
    // An element that is not shown has no sizes.
    if (heights.some((height) => height > 0)) {
      if (this.heights.length === 0) this.usualHeight = heights.reduce((sum, height) => sum + height) / heights.length;
      heights.forEach((height, at) => (this.heights[first + at] = height));
    }
    space();
    // What is in sight stays where it is, whatever the rows above it turned out to be.
    const kept = this.heightOf(0, top.at) + top.above;
    if (top.at < this.rows.length && Math.abs(kept - this.element.scrollTop) > 1) this.element.scrollTop = kept;
  }
}
