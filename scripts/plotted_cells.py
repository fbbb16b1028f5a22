"""What plot.py draws: cells of runs' folders and of exported runs."""

import difflib
import json
from pathlib import Path

import numpy
import pandas

from plotted_figures import OUTSIDE, SHORT_NAMES, WRONG_HITS, PlotError, interval_columns, quantity_of
from plotted_marks import mark_numbers

VIEW_ANGLE = "axes.view_angle"
# What runs and exports of version 0.1.0 call parameters.
OLD_PARAMETERS = "params."
PARAMETERS = "parameters."

# Missed and false hits above this fraction of the footprint: the errors of such a cell do not count.
HIT_LIMIT = 0.005


def with_infinities(cells, figures):
    """What is infinite has no number in files: the ratio of a picture without an error to its noise."""
    for path, figure in figures.items():
        beside = figure.get("infinite_at_zero")
        if path in cells.columns and beside in cells.columns:
            cells = cells.assign(**{path: cells[path].mask(cells[path].isna() & (cells[beside] == 0), numpy.inf)})
    return cells


def flattened(value, path, columns):
    """As `reliefbench export --format csv` names columns: arrays of two are intervals."""
    if isinstance(value, dict):
        for key, member in value.items():
            flattened(member, f"{path}.{key}" if path else key, columns)
    elif isinstance(value, list):
        for at, member in enumerate(value):
            flattened(member, f"{path}.{('low', 'high')[at] if len(value) == 2 else at}", columns)
    else:
        columns[path] = value
    return columns


def read_run(folder):
    """The finished cells of a run's folder; a last line that is cut short is none."""
    file = folder / "cells.jsonl"
    try:
        lines = file.read_text().splitlines(keepends=True)
    except OSError as error:
        raise PlotError(f"{file}: {error.strerror}; the run has no finished cell") from error
    cells = []
    for number, line in enumerate(lines, 1):
        if line.endswith("\n"):
            try:
                cells.append(flattened(json.loads(line), "", {}))
            except ValueError as error:
                raise PlotError(f"{file}:{number}: this is no JSON ({error})") from None
    return pandas.DataFrame(cells)


def read_export(file):
    try:
        return pandas.read_csv(file, float_precision="round_trip")
    except OSError as error:
        raise PlotError(f"{file}: {error.strerror}") from error
    except (pandas.errors.ParserError, pandas.errors.EmptyDataError, UnicodeDecodeError) as error:
        raise PlotError(f"{file}: this is no CSV file ({error}); name a run's folder, or make a CSV file of it with reliefbench "
                        "export --format csv") from error


def read_cells(files, figures):
    """Of runs' folders and exported runs."""
    frames = []
    for file in files:
        frame = read_run(Path(file)) if Path(file).is_dir() else read_export(file)
        for column in ("cell", "technique", "status"):
            if column not in frame.columns:
                raise PlotError(f"{file}: there is no column '{column}'; name a run's folder, or make the file with reliefbench "
                                "export --format csv")
        frames.append(frame.rename(columns=lambda name: PARAMETERS + name.removeprefix(OLD_PARAMETERS)
                                   if name.startswith(OLD_PARAMETERS) else name))
    cells = pandas.concat(frames, ignore_index=True)
    measured = cells[cells["status"] == "ok"]
    if measured.empty:
        raise PlotError(f"{', '.join(files)}: no cell was measured ({len(cells)} failed or were skipped)")
    # Among all techniques, so that neither a filter nor a failure changes one's mark.
    return with_infinities(measured.assign(mark=measured["technique"].map(mark_numbers(cells["technique"]))), figures)


def has_numbers(cells, column):
    return column in cells.columns and pandas.api.types.is_numeric_dtype(cells[column]) and cells[column].notna().any()


def quantity(cells, name, figures, option, notes):
    """What to draw, checked: a short name, the path of a figure, or another numeric column. Of several figures that a short
    name has it is the first with numbers."""
    columns = SHORT_NAMES.get(name, [name])
    column = next((each for each in columns if has_numbers(cells, each)), columns[-1])
    if column not in cells.columns and column not in figures:
        near = difflib.get_close_matches(name, [*SHORT_NAMES, *figures, *cells.columns], 1)
        hint = f" (did you mean '{near[0]}'?)" if near else ""
        raise PlotError(f"{option} {name}: there is no figure and no column '{column}'{hint}; short names: " + ", ".join(SHORT_NAMES))
    if not has_numbers(cells, column):
        needs = figures.get(column, {}).get("needs", [])
        raise PlotError(f"{option} {name}: the cells have no numbers of '{column}'" +
                        (f"; it needs {', '.join(needs)}, which the configuration has to ask for" if needs else ""))
    counts_outside = any(figure.get("stand_in") == column for figure in figures.values())
    if counts_outside and OUTSIDE in cells.columns and (cells[OUTSIDE] > 0).any():
        instead = f"; {columns[0]} would not, which these runs do not have" if len(columns) > 1 else ""
        notes.append(f"{column} counts relief outside the footprint, which no per-pixel technique can draw{instead}")
    return quantity_of(column, figures)


def with_direction(chosen, option):
    if chosen.better == "neither":
        raise PlotError(f"{option} {chosen.column}: neither low nor high values of it are better, so that there is no front; "
                        "choose another figure")
    return chosen


def interval_of(cells, column):
    """Lows and highs of the 95 % interval of a pass' median time, or of the draw's over pixels; None for other columns."""
    found = interval_columns(column)
    if found is None or any(end not in cells.columns for end in found[1]):
        return None
    scale = cells[column] / cells[found[0]]
    return [cells[end] * scale for end in found[1]]


def counted(cells):
    """Of which the errors count: hard pixels are not discarded."""
    hits = sum(cells.get(column, 0) for column in WRONG_HITS)
    return ~(hits > HIT_LIMIT) if hasattr(hits, "gt") else pandas.Series(True, index=cells.index)


def with_numbers(cells, columns, notes):
    """Cells with a number in each of the columns."""
    for column in columns:
        kept = cells[cells[column].notna()]
        if len(kept) < len(cells):
            notes.append(f"left out without {column}: {len(cells) - len(kept)} of {len(cells)} cells")
        cells = kept
    if cells.empty:
        raise PlotError(f"no cell is left with numbers in {' and '.join(columns)}")
    return cells


def positive(cells, column, notes):
    kept = cells[cells[column] > 0]
    if len(kept) < len(cells):
        notes.append(f"left out for {column} = 0, which a logarithmic axis lacks: {len(cells) - len(kept)} of {len(cells)} cells")
    if kept.empty:
        raise PlotError(f"no cell is left with numbers above 0 in {column}")
    return kept
