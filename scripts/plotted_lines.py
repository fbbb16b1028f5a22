"""Which cells make a line or a panel of plot.py, and their names: those of the report's page (report_page/src/series.ts and
data.ts) and of cells' ids."""

import pandas

from plotted_cells import PARAMETERS, VIEW_ANGLE
from plotted_figures import PlotError

MOST_PANELS = 6
# Axes whose values speak for themselves.
BARE_AXES = ("heightmap", "base", "projection", "boundary", "height_format")


def short(name):
    return name.split(".", 1)[1]


def text_of(value):
    return str(int(value)) if isinstance(value, float) and value.is_integer() else str(value)


def axis_value_text(axis, value):
    """"60°", "rock", "height scale 0.1"."""
    text = text_of(value)
    if axis == "view_angle":
        return f"{text}°"
    return text.split("/")[-1] if axis in BARE_AXES else f"{axis.replace('_', ' ')} {text}"


def varying(cells, prefix, besides=()):
    """Columns with the prefix that have several values; that some cells have none (the distance of parallel rays) follows from
    other axes and is no value."""
    return [name for name in cells.columns
            if name.startswith(prefix) and name not in besides and cells[name].nunique() > 1]


def panels_of(cells, besides=()):
    """(title, cells) of each view, told by the axes that differ."""
    axes = varying(cells, "axes.", besides)
    if not axes:
        return [(only_view(cells, besides), cells)]
    by = axes[0] if len(axes) == 1 else axes
    groups = [(key if isinstance(key, tuple) else (key,), group) for key, group in cells.groupby(by, dropna=False)]
    if len(groups) > MOST_PANELS:
        values = "; ".join(f"{short(name)}: {', '.join(map(text_of, sorted(cells[name].dropna().unique())))}" for name in axes)
        raise PlotError(f"{len(groups)} views are left, and {MOST_PANELS} panels are the most; choose with --filter ({values})")
    panels = []
    for key, group in groups:
        texts = [axis_value_text(short(name), value) for name, value in zip(axes, key) if not pandas.isna(value)]
        panels.append((" · ".join(texts), group))
    return panels


def only_view(cells, besides):
    """Of cells of one view: what their ids say of it, and what nobody guesses."""
    named = {word.split("=")[0] for word in cells["cell"].iloc[0].split(" | ")[-1].split(" ")} | {"heightmap", short(VIEW_ANGLE)}
    first = cells.iloc[0]
    return " · ".join(axis_value_text(short(name), first[name]) for name in cells.columns
                      if name.startswith("axes.") and short(name) in named and name not in besides and not pandas.isna(first[name]))


def running_parameters(cells):
    """Of one technique's cells, the numeric parameters that a line runs along: the one with most values and those that follow
    from it."""
    numeric = [name for name in varying(cells, PARAMETERS) if pandas.api.types.is_numeric_dtype(cells[name].dropna()) and
               not pandas.api.types.is_bool_dtype(cells[name].dropna())]
    if not numeric:
        return set()
    main = max(numeric, key=lambda name: cells[name].nunique())
    follows = [name for name in numeric if (cells.groupby(main)[name].nunique(dropna=False) == 1).all()]
    return {short(name) for name in {main, *follows}}


def with_lines(cells, each_setting):
    """The cells with the column "line", whose it is: technique and parameters as cells' ids write them (defaults left out),
    with `each_setting` all of them, else without those that the line runs along."""
    def line_of(technique, setting):
        words = setting.split(" ")
        return " ".join(words[:1] + [word for word in words[1:] if word.split("=")[0] not in along[technique]])

    along = {technique: set() if each_setting else running_parameters(group)
             for technique, group in cells.groupby("technique")}
    settings = cells["cell"].str.split(" | ", regex=False).str[0]
    return cells.assign(line=[line_of(*each) for each in zip(cells["technique"], settings)])
