// Which cells a search finds, and what it says of names and values that there are not.

import { type Cells, leadingNumber, type Json, numberOf, type ValueColumn, valueText } from "./data.ts";
import { type ConditionTerm, parseQuery, type Relation, type Term, type WordTerm } from "./query.ts";
import { suggestion } from "./suggest.ts";

/** A figure under a name of one word, in the unit that the table shows. */
export interface NamedFigure {
  name: string;
  of(cell: number): number | null;
}

export interface SearchNote {
  text: string;
  /** What may have been meant, and the whole search with it. */
  correction: { label: string; query: string } | null;
}

export interface SearchResult {
  found: number[];
  notes: SearchNote[];
}

/** What a condition can be about: values, of which each cell has one or none, or a figure. */
type SearchColumn = { values: ValueColumn } | { figure(cell: number): number | null };

/** Whether a term holds for a cell, and what is wrong with the term: the note's text and the token that may be meant. */
interface Judged {
  holds(cell: number): boolean;
  trouble: { text: string; meant: string | null } | null;
}

const maxListed = 12;
const never = () => false;

function numberFrom(text: string): number | null {
  const value = text.trim() === "" ? NaN : Number(text);
  return Number.isFinite(value) ? value : null;
}

const isSize = (value: Json) => typeof value === "string" && /^\d+x\d+$/.test(value);

/** Numbers as numbers ("60" is 60.0, "256" is "256x256"), files by their whole name or without their folder. */
function valueEquals(value: Json, wanted: string): boolean {
  const text = valueText(value).toLowerCase();
  if (text === wanted || (typeof value === "string" && text.split("/").pop() === wanted)) return true;
  const number = numberFrom(wanted);
  if (number === null) return false;
  return isSize(value) ? text === `${number}x${number}` : value === number;
}

/** A word is a part of a value's text; a number is the whole value, or a side of a size. */
function valueHas(value: Json, word: string): boolean {
  if (typeof value === "string" && !isSize(value)) return value.toLowerCase().includes(word);
  const number = numberFrom(word);
  if (number !== null) return isSize(value) ? valueText(value).split("x").includes(word) : value === number;
  return valueText(value).toLowerCase() === word;
}

function compares(value: number, relation: Relation, bound: number): boolean {
  switch (relation) {
    case "=":
      return value === bound;
    case "<":
      return value < bound;
    case "<=":
      return value <= bound;
    case ">":
      return value > bound;
    case ">=":
      return value >= bound;
  }
}

/** By cell: whether its value is among those of the column that pass. */
function holdsFor(column: ValueColumn, passes: (value: Json) => boolean): (cell: number) => boolean {
  const passing = column.values.map(passes);
  return (cell) => passing[column.index[cell] ?? -1] ?? false;
}

/** What words are searched in: technique, status, reason, every axis and every parameter, at its default or not. */
function searchedColumns(cells: Cells): ValueColumn[] {
  return [cells.words, cells.axes, cells.parameters].flatMap((columns) => Object.values(columns));
}

/** By name, in lower case. Of equal names the first is meant: an axis, a parameter, a figure's short name, a field. */
function namedColumns(cells: Cells, figures: readonly NamedFigure[]): Map<string, SearchColumn> {
  const named = new Map<string, SearchColumn>();
  const add = (name: string, column: SearchColumn) => {
    if (!named.has(name.toLowerCase())) named.set(name.toLowerCase(), column);
  };
  const groups = [
    ["axes", cells.axes],
    ["parameters", cells.parameters],
    ["", cells.words],
  ] as const;
  for (const [group, columns] of groups) {
    for (const [name, column] of Object.entries(columns)) {
      add(name, { values: column });
      // As the columns of an exported table are called.
      if (group !== "") add(`${group}.${name}`, { values: column });
    }
  }
  for (const { name, of } of figures) add(name, { figure: of });
  for (const path of Object.keys(cells.numbers)) add(path, { figure: (cell) => numberOf(cells, path, cell) });
  return named;
}

function listed(texts: readonly string[]): string {
  const shown = texts.slice(0, maxListed).join(", ");
  return texts.length > maxListed ? `${shown} and ${texts.length - maxListed} more` : shown;
}

const sign = (term: Term) => (term.without ? "-" : "");

function judgeWord(term: WordTerm, cells: Cells, columns: Map<string, SearchColumn>): Judged {
  const searched = searchedColumns(cells);
  const tests = searched.map((column) => holdsFor(column, (value) => valueHas(value, term.word)));
  const holds = (cell: number) => tests.some((test) => test(cell));
  const known = searched.some((column) => column.values.some((value) => valueHas(value, term.word)));
  if (known) return { holds, trouble: null };
  const asColumn = columns.get(term.word);
  if (asColumn !== undefined) {
    const example =
      "values" in asColumn ? `${term.word}=${valueText(asColumn.values.values[0] ?? "")}` : `${term.word}<1`;
    return {
      holds,
      trouble: { text: `“${term.word}” is a column and no value: compare it, as in ${example}.`, meant: null },
    };
  }
  const values = searched.flatMap((column) => column.values.filter((value) => typeof value === "string") as string[]);
  const meant = suggestion(
    term.word,
    values.filter((value) => !value.includes(" ")),
  );
  return { holds, trouble: { text: `No cell of this run has “${term.word}”.`, meant: meant && sign(term) + meant } };
}

function unknownColumn(term: ConditionTerm, columns: Map<string, SearchColumn>): Judged {
  const meant = suggestion(term.name, columns.keys());
  const others = meant === null ? ` There are ${listed([...columns.keys()])}.` : "";
  const rest = term.token.slice((term.token.startsWith("-") ? 1 : 0) + term.name.length);
  return {
    holds: never,
    trouble: {
      text: `There is no column “${term.name}” in this run.${others}`,
      meant: meant && (term.token.startsWith("-") ? "-" : "") + meant + rest,
    },
  };
}

function judgeEquality(term: ConditionTerm, column: ValueColumn): Judged {
  const holds = holdsFor(column, (value) => term.values.some((wanted) => valueEquals(value, wanted)));
  const missing = term.values.find((wanted) => !column.values.some((value) => valueEquals(value, wanted)));
  if (missing === undefined) return { holds, trouble: null };
  const texts = column.values.map(valueText);
  const meant = suggestion(
    missing,
    texts.filter((text) => !text.includes(" ")),
  );
  return {
    holds,
    trouble: {
      text: `No cell of this run has ${term.name}=${missing}. There are ${listed(texts)}.`,
      meant: meant && term.token.replace(missing, meant),
    },
  };
}

function judgeCondition(term: ConditionTerm, columns: Map<string, SearchColumn>): Judged {
  const column = columns.get(term.name);
  if (column === undefined) return unknownColumn(term, columns);
  if (term.values.length === 0) {
    // It is being typed.
    return { holds: () => !term.without, trouble: { text: `${term.token} what? A value is missing.`, meant: null } };
  }
  if ("values" in column && term.relation === "=") return judgeEquality(term, column.values);
  const bounds = term.values.map(numberFrom);
  const [bound] = bounds;
  if (bounds.includes(null) || (term.relation !== "=" && bounds.length > 1)) {
    return { holds: never, trouble: { text: `${term.token}: expected a number after ${term.relation}.`, meant: null } };
  }
  if ("values" in column) {
    const numbers = column.values.values.map(leadingNumber);
    if (numbers.every((number) => number === null)) {
      const text = `${term.name} is no number: ask for ${term.name}= one of ${listed(column.values.values.map(valueText))}.`;
      return { holds: never, trouble: { text, meant: null } };
    }
    const test = (value: Json) => {
      const number = leadingNumber(value);
      return number !== null && compares(number, term.relation, bound!);
    };
    return { holds: holdsFor(column.values, test), trouble: null };
  }
  const holds = (cell: number) => {
    const value = column.figure(cell);
    return value !== null && bounds.some((each) => compares(value, term.relation, each!));
  };
  return { holds, trouble: null };
}

/**
 * The cells of `selection` that the search finds, in their order. A condition on what this run has no column of finds
 * nothing, excluded it takes nothing away, and both times it is reported.
 */
export function searchCells(
  cells: Cells,
  selection: readonly number[],
  text: string,
  figures: readonly NamedFigure[],
): SearchResult {
  const columns = namedColumns(cells, figures);
  const terms = parseQuery(text, (name) => columns.has(name));
  const judged = terms.map((term) =>
    term.kind === "word" ? judgeWord(term, cells, columns) : judgeCondition(term, columns),
  );
  const found = selection.filter((cell) => terms.every((term, at) => judged[at]!.holds(cell) !== term.without));
  const notes = judged.flatMap(({ trouble }, at) => {
    if (trouble === null) return [];
    const { text: message, meant } = trouble;
    const query = terms.map((term, place) => (place === at && meant !== null ? meant : term.token)).join(" ");
    return [{ text: message, correction: meant === null ? null : { label: meant, query } }];
  });
  return { found, notes };
}
