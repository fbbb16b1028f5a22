// The language of the table's search: words, and conditions on columns ("rock -perspective view_angle=60 uv<0.5").

export type Relation = "=" | "<" | "<=" | ">" | ">=";

/** A part of a search, in lower case. `without`: what it holds for is left out. */
export type Term = { token: string; without: boolean } & (
  | { kind: "word"; word: string }
  /** Of "=" any of the values may hold. There are none while the condition is being typed. */
  | { kind: "condition"; name: string; relation: Relation; values: string[] }
);

export type ConditionTerm = Extract<Term, { kind: "condition" }>;
export type WordTerm = Extract<Term, { kind: "word" }>;

const operator = "<=|>=|!=|=|<|>";
const aroundOperator = new RegExp(`\\s*(${operator})\\s*`, "g");
const firstOperator = new RegExp(`^([^<>=!]+)(${operator})(.*)$`);

/** Other ways to write an operator, and spaces around one. Text in quotes stays as it is. */
function normalised(text: string): string {
  const unquoted = (part: string) =>
    part
      .replaceAll("−", "-")
      .replaceAll("≤", "<=")
      .replaceAll("≥", ">=")
      .replaceAll("≠", "!=")
      .replaceAll("==", "=")
      .replace(aroundOperator, "$1");
  return text
    .split('"')
    .map((part, at) => (at % 2 === 0 ? unquoted(part) : part))
    .join('"');
}

const withoutQuotes = (text: string) => text.replaceAll('"', "");

/** `isColumn` tells whether a name before a colon is one: "status:failed" is a condition, "trace.glsl:3" a word. */
export function parseQuery(text: string, isColumn: (name: string) => boolean): Term[] {
  const terms: Term[] = [];
  for (const token of normalised(text)
    .toLowerCase()
    .match(/(?:"[^"]*"?|[^\s"])+/g) ?? []) {
    const minus = token.length > 1 && token.startsWith("-");
    const body = minus ? token.slice(1) : token;
    const colon = /^([\w.]+):(.*)$/.exec(body);
    const parts = firstOperator.exec(body);
    if (body.startsWith('"') || (parts === null && !(colon !== null && isColumn(colon[1]!)))) {
      const word = withoutQuotes(body);
      // A bar stands between the two parts of a cell's id, which may be pasted.
      if (word !== "" && word !== "|") terms.push({ kind: "word", token, without: minus, word });
      continue;
    }
    const [name, relation, value] = parts === null ? [colon![1]!, "=", colon![2]!] : [parts[1]!, parts[2]!, parts[3]!];
    const not = relation === "!=";
    terms.push({
      kind: "condition",
      token,
      without: minus !== not,
      name,
      relation: not ? "=" : (relation as Relation),
      values: value
        .split(",")
        .map(withoutQuotes)
        .filter((each) => each !== ""),
    });
  }
  return terms;
}
