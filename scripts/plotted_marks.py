"""How plot.py tells lines apart: a technique has the colour and the marker that it has in every report."""

import json
from pathlib import Path

# Read by report_page/src/palette.ts too.
MARKS = json.loads((Path(__file__).resolve().parent / "marks.json").read_text())
COLOURS = MARKS["colours"]["light"]
SHAPES = MARKS["shapes"]
# Colours and shapes have no common divisor, so that no two numbers below this have both in common.
MARK_COUNT = len(COLOURS) * len(SHAPES)
# Lines of one technique, which share colour and marker: how each is dashed (in widths of the line) and its markers are filled.
LINES = [((0, tuple(line["dash"])) if line["dash"] else "-", line["filled"]) for line in MARKS["lines"]]


def fnv1a(text, basis):
    """Of the text's UTF-8 bytes, 32 bits."""
    value = basis
    for byte in text.encode():
        value = (value ^ byte) * 16777619 & 0xFFFFFFFF
    return value


def mark_numbers(names):
    """Name → number of its mark: its hash; where two names meet, the later one in the order of code points takes the next
    mark that is free."""
    numbers = {}
    for name in sorted(set(names)):
        number = fnv1a(name, MARKS["basis"]) * MARK_COUNT >> 32
        if len(numbers) < MARK_COUNT:
            taken = set(numbers.values())
            while number in taken:
                number = (number + 1) % MARK_COUNT
        numbers[name] = number
    return numbers


def style_of(number, line):
    """For matplotlib, of the technique whose mark has this number; `line` counts its lines from 0."""
    dashes, filled = LINES[line]
    return {"color": COLOURS[number % len(COLOURS)], "marker": SHAPES[number % len(SHAPES)]["matplotlib"], "markersize": 4.5,
            "markeredgewidth": 0.8, "fillstyle": filled, "markerfacecoloralt": "white", "linewidth": 0.9, "linestyle": dashes}
