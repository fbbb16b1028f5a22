"""What plot.py draws: cells of exported runs, and the figures that figures.json declares."""

import dataclasses
import difflib
import json
import re
import shlex
from pathlib import Path

import numpy
import pandas

from plotted_marks import mark_numbers

# Written by `reliefbench list figures --format json`.
FIGURES_FILE = Path(__file__).resolve().parent / "figures.json"

# Short names on the command line and what they stand for; of several columns the first that has numbers. Any other numeric
# column can be named in full.
ERRORS = {
    "uv": ["error.uv_texels.p99"],
    "uv_mean": ["error.uv_texels.mean"],
    "depth": ["error.depth.p99"],
    "normal": ["error.normal_deg.p99"],
    "missed": ["error.missed"],
    "flip": ["image.footprint.flip", "image.flip"],
    "ssim": ["image.footprint.ssim", "image.ssim"],
    "psnr": ["image.footprint.psnr", "image.psnr"],
    "coverage": ["error.coverage_iou"],
    "shadow": ["error.shadow.mean"],
    "motion": ["motion.texels.mean"],
    "motion_flip": ["motion.flip.mean"],
}
COSTS = {
    "ms": ["time.draw.median_ms"],
    "ns": ["time.ns_per_pixel"],
    "taps": ["work.taps_mean"],
    "shadow_taps": ["work.shadow_taps_mean"],
    "steps": ["work.steps_mean"],
    "prepare": ["prepare.ms"],
    "memory": ["prepare.bytes"],
}
VIEW_ANGLE = "axes.view_angle"
# Relief beyond the quad, which whole-picture errors count and no per-pixel technique can draw.
OUTSIDE = "error.outside_quad.pixels"

# Missed and false hits above this fraction of the footprint: the errors of such a cell do not count.
HIT_LIMIT = 0.005


class PlotError(Exception):
    """What is wrong with the input, and what to do."""


@dataclasses.dataclass
class Quantity:
    """A column and what figures.json says of it; `better` is "neither" for columns that it does not list."""
    column: str
    label: str
    better: str

    def axis(self, separator):
        """What stands at an axis."""
        return self.label if self.better == "neither" else f"{self.label}{separator}{self.better} is better"


def declared_figures():
    try:
        figures = json.loads(FIGURES_FILE.read_text())
    except OSError as error:
        raise PlotError(f"{FIGURES_FILE}: {error.strerror}; make it with reliefbench list figures --format json") from error
    return {figure["path"]: figure for figure in figures}


def with_best_ratios(cells):
    """A picture without an error has no number for the ratio of itself to its noise: it is the best."""
    for column in [name for name in cells.columns if name.endswith(".psnr")]:
        rmse = cells.get(column.replace(".psnr", ".rmse"))
        if rmse is not None:
            cells = cells.assign(**{column: cells[column].mask(cells[column].isna() & (rmse == 0), numpy.inf)})
    return cells


def read_cells(files):
    frames = []
    for file in files:
        try:
            frames.append(pandas.read_csv(file))
        except IsADirectoryError:
            raise PlotError(f"{file} is a folder; export the run first: reliefbench export {shlex.quote(str(file))} --format csv "
                            "-o cells.csv, and name cells.csv instead") from None
        except OSError as error:
            raise PlotError(f"{file}: {error.strerror}") from error
        except (pandas.errors.ParserError, pandas.errors.EmptyDataError, UnicodeDecodeError) as error:
            raise PlotError(f"{file}: this is no CSV file ({error}); make one with reliefbench export --format csv") from error
        for column in ("cell", "technique", "status"):
            if column not in frames[-1].columns:
                raise PlotError(f"{file}: there is no column '{column}'; make the file with reliefbench export --format csv")
    cells = pandas.concat(frames, ignore_index=True)
    measured = cells[cells["status"] == "ok"]
    if measured.empty:
        raise PlotError(f"{', '.join(files)}: no cell was measured ({len(cells)} failed or were skipped)")
    # Among all techniques, so that neither a filter nor a failure changes one's mark.
    return with_best_ratios(measured.assign(mark=measured["technique"].map(mark_numbers(cells["technique"]))))


def has_numbers(cells, column):
    return column in cells.columns and pandas.api.types.is_numeric_dtype(cells[column]) and cells[column].notna().any()


def quantity(cells, name, short_names, option, notes):
    """What to draw, checked. A short name for several columns is the first with numbers."""
    columns = short_names.get(name, [name])
    column = next((each for each in columns if has_numbers(cells, each)), columns[-1])
    if column not in cells.columns:
        near = difflib.get_close_matches(name, [*short_names, *cells.columns], 1)
        hint = f" (did you mean '{near[0]}'?)" if near else ""
        raise PlotError(f"{option} {name}: there is no column '{column}'{hint}; short names: " + ", ".join(short_names))
    if not has_numbers(cells, column):
        raise PlotError(f"{option} {name}: the column '{column}' has no numbers" +
                        ('; the configuration has to ask for it with "motion"' if column.startswith("motion.") else ""))
    whole_picture = column.startswith("image.") and not column.startswith("image.footprint.")
    if whole_picture and OUTSIDE in cells.columns and (cells[OUTSIDE] > 0).any():
        instead = f"; {columns[0]} would not, which these runs do not have" if len(columns) > 1 else ""
        notes.append(f"{column} counts relief beyond the quad, which no per-pixel technique can draw{instead}")
    figure = declared_figures().get(column)
    if figure is None:
        return Quantity(column, column, "neither")
    unit = f" ({figure['unit']})" if figure["unit"] else ""
    return Quantity(column, figure["label"] + unit, figure["better"])


def with_direction(chosen, option):
    if chosen.better == "neither":
        raise PlotError(f"{option} {chosen.column}: neither low nor high values of it are better (figures.json), so that "
                        "there is no front; choose another figure")
    return chosen


def interval_of(cells, column):
    """Lows and highs of the 95 % interval of a pass' median time, or of the draw's over pixels; None for other columns."""
    pass_name = re.fullmatch(r"time\.(.+)\.median_ms", column)
    of = pass_name.group(1) if pass_name else "draw" if column == "time.ns_per_pixel" else None
    ends = [f"time.{of}.ci95_ms.{end}" for end in ("low", "high")]
    if of is None or any(end not in cells.columns for end in ends):
        return None
    scale = cells[column] / cells[f"time.{of}.median_ms"]
    return [cells[end] * scale for end in ends]


def counted(cells):
    """Of which the errors count: hard pixels are not discarded."""
    hits = cells.get("error.missed", 0) + cells.get("error.false_hits", 0)
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
