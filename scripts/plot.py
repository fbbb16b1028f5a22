#!/usr/bin/python3
"""Figures for papers from exported runs (reliefbench export RUN --format csv, or reliefbench run ... --format csv).

    plot.py pareto cells.csv -o front.pdf --error uv --cost ms
    plot.py steps  cells.csv -o steps.svg --error uv --filter view_angle=60
    plot.py angle  cells.csv -o angle.png --cost ns --filter heightmap=rock

pareto: error against cost; the line is the Pareto front: nothing is both cheaper and better. steps: error against steps
per pixel. angle: cost against view angle. One panel for each view that the filters leave. The format is the file's
extension: pdf, svg or png. Labels, units and which way a figure is better come from figures.json beside this script.
Needs Debian's python3-matplotlib and python3-pandas.
"""

import argparse
import dataclasses
import sys
from pathlib import Path

try:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    import matplotlib.ticker
    import numpy
    import pandas
except ModuleNotFoundError as missing:
    sys.exit(f"plot.py: there is no Python module {missing.name}; on Debian: apt install python3-matplotlib python3-pandas")

from plotted_cells import (COSTS, ERRORS, HIT_LIMIT, VIEW_ANGLE, PlotError, apply_filters, counted, positive, quantity,
                           read_cells, with_direction, with_numbers)

# Okabe and Ito 2008: told apart by colour-blind eyes; the yellow is left out, which white paper swallows.
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00", "#000000"]
MARKERS = ["o", "s", "^", "D", "v", "P", "X", "<", ">", "*", "h"]

MOST_PANELS = 6
PANEL_INCHES = (3.3, 2.8)
LEGEND_INCHES = 1.7
# Linear axes serve values within this factor of each other.
LOG_AXIS_FACTOR = 8
# How far beyond the others lies what has no place on an axis: a factor below the least, a part of their span.
ZERO_FACTOR = 4
INFINITE_ROOM = 0.12
FORMATS = (".pdf", ".svg", ".png")


def varying(cells, prefix, besides=()):
    """Columns with the prefix that have several values; that some cells have none (the distance of parallel rays) follows from
    another column."""
    return [name for name in cells.columns if name.startswith(prefix) and name not in besides and cells[name].nunique() > 1]


def short(column):
    return column.split(".", 1)[1]


def text_of(value):
    return f"{value:g}" if isinstance(value, float) else str(value)


def grouped(cells, columns):
    """(values of the columns, cells) of each combination there is."""
    if not columns:
        return [((), cells)]
    by = columns[0] if len(columns) == 1 else columns
    return [(key if isinstance(key, tuple) else (key,), group) for key, group in cells.groupby(by, dropna=False, sort=True)]


def panels_of(cells, besides=()):
    axes = varying(cells, "axes.", besides)
    groups = grouped(cells, axes)
    if len(groups) > MOST_PANELS:
        values = "; ".join(f"{short(name)}: {', '.join(map(text_of, sorted(cells[name].dropna().unique())))}" for name in axes)
        raise PlotError(f"{len(groups)} views are left, and {MOST_PANELS} panels are the most; choose with --filter ({values})")
    panels = []
    for key, group in groups:
        shown = [f"{short(name)} {text_of(value)}" for name, value in zip(axes, key) if not pandas.isna(value)]
        panels.append((", ".join(shown), group))
    return panels


def series_of(cells, each_setting):
    """Label → cells. With `each_setting` one line for each technique and parameters, as cells' ids write them (defaults left
    out); else one for each technique and choice (a parameter that is no number), along which numbers vary."""
    if each_setting:
        settings = cells["cell"].str.split(" | ", regex=False).str[0]
        return {label: part for label, part in cells.groupby(settings, sort=True)}
    series = {}
    for technique, group in cells.groupby("technique", sort=True):
        names = [name for name in varying(group, "params.") if not pandas.api.types.is_numeric_dtype(group[name].dropna())]
        for key, part in grouped(group, names):
            settings = [f"{short(name)}={text_of(value)}" for name, value in zip(names, key)]
            series[" ".join([technique] + settings)] = part
    return series


def style_of(index):
    return {"color": COLOURS[index % len(COLOURS)], "marker": MARKERS[index % len(MARKERS)], "markersize": 4.5,
            "markeredgewidth": 0.8, "linewidth": 0.9}


def draw_panel(axes, series, styles, x, y):
    """`x` and `y`: where each cell is drawn, by its index."""
    for label, cells in series.items():
        cells = cells.loc[x[cells.index].sort_values().index]
        style = styles[label]
        axes.plot(x[cells.index], y[cells.index], alpha=0.5, **{**style, "marker": None})
        counts = counted(cells)
        for part, face in ((cells[counts], style["color"]), (cells[~counts], "none")):
            axes.plot(x[part.index], y[part.index], linestyle="none", markerfacecolor=face, **{**style, "linewidth": 0})


def front_of(cells, cost, error):
    """Cells that nothing is both cheaper and better than, by cost; those whose errors do not count are left out."""
    worth = {"lower": 1, "higher": -1}
    ranked = cells[counted(cells)]
    keys = pandas.DataFrame({"cost": ranked[cost.column] * worth[cost.better],
                             "error": ranked[error.column] * worth[error.better]}).sort_values(["cost", "error"])
    best = keys["error"].cummin().shift()
    return ranked.loc[keys.index[best.isna() | (keys["error"] < best)]]


def draw_front(axes, cells, cost, error, placed):
    front = front_of(cells, cost, error)
    if not front.empty:
        axes.step(placed[0][front.index], placed[1][front.index], where="post", color="#000000", linewidth=0.8,
                  linestyle=(0, (4, 2)), zorder=0, label="Pareto front")


def placed_on(values, log):
    """Where values are drawn, and what to say on the axis: zeros and infinite values lie beyond all others."""
    if log:
        least = values[values > 0].min()
        edge = least / ZERO_FACTOR if least > 0 else 1
        return values.where(values > 0, edge), ("; 0 on the edge" if (values <= 0).any() else "")
    finite = values[numpy.isfinite(values)]
    top = finite.max() + INFINITE_ROOM * ((finite.max() - finite.min()) or 1) if len(finite) else 1
    return values.where(numpy.isfinite(values), top), ("; \N{INFINITY} on the edge" if len(finite) < len(values) else "")


def wants_log(values):
    return values.min() > 0 and values.max() > LOG_AXIS_FACTOR * values.min()


def make_logarithmic(axis, set_scale, values):
    set_scale("log")
    if values.max() < 100 * values.min():
        # Powers of ten alone would leave such an axis with one number or none.
        axis.set_major_locator(matplotlib.ticker.LogLocator(subs=(1, 2, 5)))
        axis.set_major_formatter(matplotlib.ticker.FuncFormatter(lambda value, _: f"{value:g}"))
        axis.set_minor_formatter(matplotlib.ticker.NullFormatter())


def make_figure(cells, x, y, title, log_x, log_y, each_setting=False, besides=(), front=False):
    panels = panels_of(cells, besides)
    labels = sorted({label for _, group in panels for label in series_of(group, each_setting)})
    if len(labels) > 2 * len(MARKERS):
        raise PlotError(f"{len(labels)} lines are too many to tell apart; choose with --filter, such as technique=pom,qdm")
    styles = {label: style_of(index) for index, label in enumerate(labels)}
    columns = min(3, len(panels))
    rows = -(-len(panels) // columns)
    figure, grid = plt.subplots(rows, columns, squeeze=False, sharex=True, sharey=True, layout="constrained",
                                figsize=(PANEL_INCHES[0] * columns + LEGEND_INCHES, PANEL_INCHES[1] * rows + (0.3 if title else 0)))
    (placed_x, edge_x), (placed_y, edge_y) = placed_on(cells[x.column], log_x), placed_on(cells[y.column], log_y)
    for axes, (name, group) in zip(grid.flat, panels):
        draw_panel(axes, series_of(group, each_setting), styles, placed_x, placed_y)
        if front:
            draw_front(axes, group, x, y, (placed_x, placed_y))
        axes.set_title(name, fontsize=8)
        axes.grid(True, which="major", linewidth=0.3, color="#cccccc")
        if log_x:
            make_logarithmic(axes.xaxis, axes.set_xscale, placed_x)
        if log_y:
            make_logarithmic(axes.yaxis, axes.set_yscale, placed_y)
    for axes in list(grid.flat)[len(panels):]:
        axes.set_visible(False)
    figure.supxlabel(x.axis(", ") + edge_x, fontsize=9)
    figure.supylabel(y.axis("\n") + edge_y, fontsize=9)
    if title:
        figure.suptitle(title, fontsize=10)
    handles = [plt.Line2D([], [], label=label, **style) for label, style in styles.items()]
    if front:
        handles.append(plt.Line2D([], [], color="#000000", linewidth=0.8, linestyle=(0, (4, 2)), label="Pareto front"))
    if not counted(cells).all():
        handles.append(plt.Line2D([], [], color="#555555", marker="o", markerfacecolor="none", markersize=4.5, linestyle="none",
                                  label=f"> {HIT_LIMIT:.1%} of hits wrong"))
    grid[0][-1].legend(handles=handles, loc="upper left", bbox_to_anchor=(1.02, 1.0), fontsize=7, frameon=False)
    return figure


def is_logarithmic(chosen):
    """What is better the lower it is shrinks by factors; the others near a bound (SSIM, coverage) or are decibels."""
    return chosen.better != "higher"


def plot_pareto(cells, options, notes):
    cost = with_direction(quantity(cells, options.cost, COSTS, "--cost", notes), "--cost")
    error = with_direction(quantity(cells, options.error, ERRORS, "--error", notes), "--error")
    cells = with_numbers(cells, [cost.column, error.column], notes)
    return make_figure(cells, cost, error, options.title, is_logarithmic(cost), is_logarithmic(error), front=True)


def plot_steps(cells, options, notes):
    steps = quantity(cells, "steps", COSTS, "steps", notes)
    error = quantity(cells, options.error, ERRORS, "--error", notes)
    cells = positive(with_numbers(cells, [steps.column, error.column], notes), steps.column, notes)
    log = is_logarithmic(error) and (cells[error.column] >= 0).all()
    return make_figure(cells, steps, error, options.title, True, log)


def plot_angle(cells, options, notes):
    cost = quantity(cells, options.cost, COSTS, "--cost", notes)
    angle = quantity(cells, VIEW_ANGLE, {}, "angle", notes)
    cells = with_numbers(cells, [cost.column], notes)
    if cells[VIEW_ANGLE].nunique() < 2:
        raise PlotError("angle: all cells have one view angle; export a run whose axis view_angle has several")
    angle = dataclasses.replace(angle, label="view angle (degrees from the normal)")
    return make_figure(cells, angle, cost, options.title, False, wants_log(cells[cost.column]), each_setting=True,
                       besides=[VIEW_ANGLE])


FIGURES = {"pareto": plot_pareto, "steps": plot_steps, "angle": plot_angle}


def parse_arguments():
    parser = argparse.ArgumentParser(prog="plot.py", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("figure", choices=FIGURES)
    parser.add_argument("files", nargs="+", metavar="CSV", help="exported runs; their cells are taken together")
    parser.add_argument("-o", "--output", required=True, metavar="FILE", help="a .pdf, .svg or .png")
    parser.add_argument("--error", default="uv", metavar="NAME", help=", ".join(ERRORS) + ", or a column (default: uv)")
    parser.add_argument("--cost", default="ms", metavar="NAME", help=", ".join(COSTS) + ", or a column (default: ms)")
    parser.add_argument("--filter", action="append", default=[], metavar="EXPR",
                        help="keep cells with technique=pom,qdm, view_angle>=60 or any axis or parameter (may be repeated)")
    parser.add_argument("--title", default="", metavar="TEXT", help="above the figure; default: none, a paper has its caption")
    parser.add_argument("--dpi", type=int, default=200, metavar="N", help="of a .png (default: 200)")
    return parser.parse_args()


def main():
    options = parse_arguments()
    # Text stays text, and the same file comes out every time.
    plt.rcParams.update({"svg.fonttype": "none", "pdf.fonttype": 42, "svg.hashsalt": "reliefbench", "font.size": 8,
                         "axes.linewidth": 0.6, "font.family": "DejaVu Sans"})
    notes = []
    try:
        suffix = Path(options.output).suffix.lower()
        if suffix not in FORMATS:
            raise PlotError(f"--output {options.output}: expected a file that ends in {', '.join(FORMATS)}")
        cells = apply_filters(read_cells(options.files), options.filter)
        figure = FIGURES[options.figure](cells, options, notes)
        metadata = {".svg": {"Date": None}, ".pdf": {"CreationDate": None}}.get(suffix)
        try:
            figure.savefig(options.output, dpi=options.dpi, metadata=metadata)
        except OSError as error:
            raise PlotError(f"cannot write {options.output}: {error.strerror}") from error
    except PlotError as error:
        print(f"plot.py: {error}", file=sys.stderr)
        return 2
    for note in notes:
        print(f"plot.py: note: {note}", file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main())
