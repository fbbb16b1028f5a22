// The table's filter: words that a row's text must hold, and bounds on its figures ("uv<0.5 ms>=2 pom").

export interface Bound {
  name: string;
  compare: "<" | "<=" | ">" | ">=";
  value: number;
}

export interface Query {
  /** In lower case; all must be there. A word that begins with "-" must not. */
  words: string[];
  without: string[];
  bounds: Bound[];
}

export function parseQuery(text: string): Query {
  const query: Query = { words: [], without: [], bounds: [] };
  for (const token of text.trim().toLowerCase().split(/\s+/)) {
    const bound = /^([^<>=]+)(<=|>=|<|>)(-?[\d.]+(?:e-?\d+)?)$/.exec(token);
    if (bound && Number.isFinite(Number(bound[3]))) {
      query.bounds.push({ name: bound[1]!, compare: bound[2] as Bound["compare"], value: Number(bound[3]) });
    } else if (token.length > 1 && token.startsWith("-")) {
      query.without.push(token.slice(1));
    } else if (token !== "") {
      query.words.push(token);
    }
  }
  return query;
}

function holds(bound: Bound, value: number): boolean {
  switch (bound.compare) {
    case "<":
      return value < bound.value;
    case "<=":
      return value <= bound.value;
    case ">":
      return value > bound.value;
    case ">=":
      return value >= bound.value;
  }
}

/** `figure` gives a row's figure by the name in a bound: undefined where there is no such column, null for no value. */
export function matches(query: Query, rowText: string, figure: (name: string) => number | null | undefined): boolean {
  const text = rowText.toLowerCase();
  return (
    query.words.every((word) => text.includes(word)) &&
    !query.without.some((word) => text.includes(word)) &&
    query.bounds.every((bound) => {
      const value = figure(bound.name);
      return value !== undefined && value !== null && holds(bound, value);
    })
  );
}
