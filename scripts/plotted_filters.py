"""--filter of plot.py: name=value,value or one of != < <= > >=, in the grammar of `reliefbench run --filter`
(harness/sweep/filter.cpp and override.cpp)."""

import json
import math
import re

import pandas

from plotted_cells import PARAMETERS
from plotted_figures import PlotError

# Names and paths, which are no numbers though they may look like one.
WORDS = ("technique", "heightmap", "albedo")
MOST_VALUES = 100000
NUMBER = r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?"
CLOSING = {'"': "quote", "[": "bracket", "{": "brace"}


def is_number(text):
    return re.fullmatch(NUMBER, text) is not None


def values_in_range(text, argument):
    """Of [start:stop:step], the stop included when met."""
    parts = text[1:-1].split(":")
    if len(parts) != 3 or not all(map(is_number, parts)) or float(parts[2]) == 0:
        raise PlotError(f"{argument}: '{text}' is no range; write [start:stop:step], for example [0:80:20]")
    start, stop, step = map(float, parts)
    # A hair beyond, so that a stop that rounding just misses is met.
    steps = math.floor((stop - start) / step + 1e-9)
    if not 0 <= steps < MOST_VALUES:
        raise PlotError(f"{argument}: the range '{text}' steps away from its stop or has more than {MOST_VALUES} values")
    return [float(f"{start + at * step:.12g}") for at in range(steps + 1)]


def end_of_json(text, begin, argument):
    """Behind the string, array or object of JSON that begins at `begin`."""
    depth, in_string, escaped = 0, False, False
    for at in range(begin, len(text)):
        letter = text[at]
        if escaped:
            escaped = False
        elif in_string and letter == "\\":
            escaped = True
        elif letter == '"':
            in_string = not in_string
        elif not in_string and letter in "[{":
            depth += 1
        elif not in_string and letter in "]}":
            depth -= 1
        if not in_string and depth == 0 and not escaped:
            return at + 1
    raise PlotError(f"{argument}: '{text[begin:]}' lacks its closing {CLOSING[text[begin]]}")


def end_of_word(text, begin):
    """A plain value ends at a comma; those in brackets do not count."""
    depth = 0
    for at in range(begin, len(text)):
        if text[at] == "," and depth == 0:
            return at
        depth = depth + 1 if text[at] == "[" else max(0, depth - 1) if text[at] == "]" else depth
    return len(text)


def values_of_json(part, argument):
    if part[0] == "[" and (part == "[]" or (":" in part and '"' not in part and "{" not in part)):
        return values_in_range(part, argument)
    try:
        value = json.loads(part)
    except json.JSONDecodeError as error:
        raise PlotError(f"{argument}: {part} is no JSON ({error.msg})") from None
    return value if isinstance(value, list) else [value]


def values_in(name, text, argument):
    """Numbers, booleans and texts, separated by commas: words, ranges and JSON."""
    values, begin = [], 0
    while begin <= len(text):
        is_json = begin < len(text) and text[begin] in CLOSING
        end = end_of_json(text, begin, argument) if is_json else end_of_word(text, begin)
        part = text[begin:end]
        if not part:
            raise PlotError(f"{argument}: a value is missing between commas")
        if end < len(text) and text[end] != ",":
            raise PlotError(f"{argument}: expected a comma behind {part}, found '{text[end:]}'; a value that begins so is "
                            'quoted as JSON is: ["..."]')
        if is_json:
            values += values_of_json(part, argument)
        elif name not in WORDS and is_number(part):
            values.append(float(part))
        else:
            values.append(part)
        begin = end + 1
    return values


def find_column(cells, name):
    for column in (name, f"axes.{name}", PARAMETERS + name):
        if column in cells.columns:
            return column
    raise PlotError(f"--filter: there is no axis or parameter '{name}'; there are " + ", ".join(setting_names(cells)))


def setting_names(cells):
    return ["technique"] + [name.split(".", 1)[1] for name in cells.columns if name.startswith(("axes.", PARAMETERS))]


def equals(column, value):
    """Numbers as numbers: 60 is 60.0. In CSV true and false are words, and objects are JSON."""
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        return pandas.to_numeric(column, errors="coerce") == value
    text = value if isinstance(value, str) else json.dumps(value, separators=(",", ":"))
    return column.astype(str).str.lower() == text.lower()


def is_any_of(column, values):
    return pandas.concat([equals(column, value) for value in values], axis=1).any(axis=1)


def apply_filters(cells, filters):
    """The cells that pass all of them."""
    for expression in filters:
        argument = f"--filter {expression}"
        match = re.fullmatch(r"([^!<>=]+)(!=|<=|>=|=|<|>)(.+)", expression, re.DOTALL)
        if not match:
            raise PlotError(f"{argument}: expected name=value,value or one of != < <= > >= instead of =")
        name, relation, text = match.groups()
        column = cells[find_column(cells, name)]
        values = values_in(name, text, argument)
        if relation in ("=", "!="):
            chosen = is_any_of(column, values) == (relation == "=")
        else:
            if len(values) != 1 or not isinstance(values[0], (int, float)):
                raise PlotError(f"{argument}: expected one number after '{relation}', found '{text}'")
            numbers, limit = pandas.to_numeric(column, errors="coerce"), values[0]
            chosen = {"<": numbers < limit, "<=": numbers <= limit, ">": numbers > limit, ">=": numbers >= limit}[relation]
        if not chosen.any():
            there = ", ".join(sorted(column.dropna().astype(str).unique())[:12])
            raise PlotError(f"{argument}: no cell is left; {name} is one of {there}")
        cells = cells[chosen]
    return cells
