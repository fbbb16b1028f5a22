"""What plot.py knows of figures: what runs declare of them, and the few that it chooses by name. Nowhere else in these
scripts a figure is named."""

import dataclasses
import json
import re
from pathlib import Path

# Written by `reliefbench list figures --format json`: for exported runs, and for those of versions that wrote no list.
FIGURES_FILE = Path(__file__).resolve().with_name("figures.json")
# Short names on the command line and what they stand for; of several figures the first that has numbers. The search of the
# report's page knows them, too.
SHORT_NAMES = json.loads(Path(__file__).resolve().with_name("short_names.json").read_text())

# By their short names: what is drawn unless something else is chosen, and what `steps` draws over.
USUAL_ERROR = "uv"
USUAL_COST = "ms"
STEPS = "steps"
# The draw's median, its interval, and the median over pixels, which has the same.
DRAW_TIME = "time.draw.median_ms"
INTERVAL = ("ci95_ms.low", "ci95_ms.high")
TIME_PER_PIXEL = "time.ns_per_pixel"
# Fractions of the footprint that together say whether a cell's errors count.
WRONG_HITS = ("error.missed", "error.false_hits")
# Relief outside the footprint, which errors of whole pictures count and no per-pixel technique can draw.
OUTSIDE = "error.outside_quad.pixels"


class PlotError(Exception):
    """What is wrong with the input, and what to do."""


@dataclasses.dataclass
class Quantity:
    """A column and what is declared of it; `better` is "neither" for columns that are no figures."""
    column: str
    label: str
    better: str

    def axis(self, separator):
        """What stands at an axis."""
        return self.label if self.better == "neither" else f"{self.label}{separator}{self.better} is better"


def listed_figures(file, figures):
    """Path → figure. `figures` is a list as `reliefbench list figures --format json` prints it."""
    def is_figure(entry):
        return isinstance(entry, dict) and all(isinstance(entry.get(key), str) for key in ("path", "label", "unit", "better"))
    if not isinstance(figures, list) or not all(map(is_figure, figures)):
        raise PlotError(f"{file}: this is no list of figures with path, label, unit and better")
    return {figure["path"]: figure for figure in figures}


def read_json(file):
    try:
        return json.loads(file.read_text())
    except OSError as error:
        raise PlotError(f"{file}: {error.strerror}") from error
    except ValueError as error:
        raise PlotError(f"{file}: this is no JSON ({error})") from None


def declared_figures(files):
    """Of this version, and of each run's folder among `files` those of the version that made it: path → what `reliefbench
    list figures --format json` says of it."""
    figures = listed_figures(FIGURES_FILE, read_json(FIGURES_FILE))
    for folder in filter(Path.is_dir, map(Path, files)):
        if not (folder / "run.json").exists():
            raise PlotError(f"{folder} is no run's folder: it has no run.json; name one that reliefbench run made, or a file of "
                            "reliefbench export --format csv")
        record = read_json(folder / "run.json")
        if isinstance(record, dict) and "figures" in record:
            figures.update(listed_figures(folder / "run.json", record["figures"]))
    return figures


def quantity_of(column, figures):
    figure = figures.get(column)
    if figure is None:
        return Quantity(column, column, "neither")
    unit = f" ({figure['unit']})" if figure["unit"] else ""
    return Quantity(column, figure["label"] + unit, figure["better"])


def interval_columns(column):
    """Of a pass' median time, or of the draw's over pixels: the columns of that median and of its 95 % interval's ends; None
    for other columns."""
    group, _, median = DRAW_TIME.split(".")
    of = DRAW_TIME if column == TIME_PER_PIXEL else column
    match = re.fullmatch(rf"({group}\..+)\.{median}", of)
    return match and (of, [f"{match.group(1)}.{end}" for end in INTERVAL])
