#!/usr/bin/python3
"""Figures for papers from runs' folders and exported runs (reliefbench export RUN --format csv).

    plot.py pareto results/quick -o front.pdf --error uv --cost ms
    plot.py steps  cells.csv -o steps.svg --error uv --filter view_angle=60
    plot.py angle  cells.csv -o angle.png --cost ns --filter heightmap=rock

pareto: error against cost; the line is the Pareto front: nothing is both cheaper and better. steps: error against steps
per pixel. angle: cost against view angle. One panel for each view that the filters leave. Bars are the 95 % intervals of
times. The format is the file's extension: pdf, svg or png. Colours and markers are those of the report's page; labels,
units and which way a figure is better come from the run's own run.json, else from figures.json beside this script.
Needs Debian's python3-matplotlib and python3-pandas.
"""

import argparse
import dataclasses
import re
import sys
import textwrap
from pathlib import Path

# Which the first line names, and for which Debian's packages are.
DEBIANS_PYTHON = Path("/usr/bin/python3")

try:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    import numpy
    import pandas
except ModuleNotFoundError as missing:
    install = "apt install python3-matplotlib python3-pandas"
    sys.exit(f"plot.py: {sys.executable} has no module {missing.name}. " + (
        f"On Debian: {install}" if Path(sys.executable).resolve() == DEBIANS_PYTHON.resolve() else
        f"Debian's packages are for {DEBIANS_PYTHON}: run scripts/plot.py itself or {DEBIANS_PYTHON} scripts/plot.py "
        f"(where they are missing: {install})"))

from plotted_axes import number
from plotted_cells import (HIT_LIMIT, VIEW_ANGLE, counted, interval_of, positive, quantity, read_cells, with_direction,
                           with_numbers)
from plotted_figures import SHORT_NAMES, STEPS, USUAL_COST, USUAL_ERROR, PlotError, declared_figures
from plotted_filters import apply_filters
from plotted_lines import panels_of, with_lines
from plotted_marks import LINES, style_of

MOST_LINES = 22
PANEL_INCHES = (3.3, 2.8)
# In a line above a panel.
TITLE_LETTERS = 48
# Of the legend: its lines and margins, each letter, each entry, and what lies above and below it: titles and the axis.
LEGEND_INCHES = 0.6
LETTER_INCHES = 0.055
ENTRY_INCHES = 0.152
BESIDE_LEGEND_INCHES = 0.8
# Values of a swept axis that all get their number.
MOST_NAMED_VALUES = 10
# Linear axes serve values within this factor of each other.
LOG_AXIS_FACTOR = 8
# How far beyond the others lies what has no place on an axis: a factor below the least, a part of their span.
ZERO_FACTOR = 4
INFINITE_ROOM = 0.12
FORMATS = (".pdf", ".svg", ".png")


def styles_of(cells):
    """Line → how it is drawn: colour and marker are the technique's; dashes and the markers' filling tell the lines of one apart."""
    styles = {}
    for technique, group in cells.groupby("technique", sort=True):
        lines = sorted(group["line"].unique(), key=natural)
        if len(lines) > len(LINES):
            raise PlotError(f"{len(lines)} lines of {technique} are too many to tell apart ({lines[0]}, {lines[1]}, ...); "
                            f"choose {len(LINES)} with --filter, such as max_steps=8,32")
        styles.update({line: style_of(group["mark"].iloc[0], at) for at, line in enumerate(lines)})
    if len(styles) > MOST_LINES:
        raise PlotError(f"{len(styles)} lines are too many to tell apart; choose with --filter, such as technique=pom,qdm")
    return styles


def natural(text):
    """Sorts numbers in a text by their size."""
    return [(float(part), "") if part.replace(".", "", 1).isdigit() else (0, part) for part in re.split(r"([\d.]+)", text)]


def bars_of(cells, column, placed):
    """Lengths of the bars below and above; None where the column has no intervals."""
    interval = interval_of(cells, column)
    if interval is None:
        return None
    return [(placed[cells.index] - interval[0]).clip(lower=0).fillna(0), (interval[1] - placed[cells.index]).clip(lower=0).fillna(0)]


def draw_panel(axes, cells, styles, x, y):
    """`x` and `y`: the column, and where each cell is drawn, by its index."""
    for line, part in cells.groupby("line", sort=True):
        part = part.loc[x[1][part.index].sort_values().index]
        style = styles[line]
        axes.plot(x[1][part.index], y[1][part.index], alpha=0.5, **{**style, "marker": None})
        bars = [bars_of(part, *each) for each in (x, y)]
        if any(bar is not None for bar in bars):
            axes.errorbar(x[1][part.index], y[1][part.index], xerr=bars[0], yerr=bars[1], fmt="none", ecolor=style["color"],
                          elinewidth=0.7, capsize=1.6, capthick=0.7)
        counts = counted(part)
        for some, hollow in ((part[counts], {}), (part[~counts], {"fillstyle": "none"})):
            axes.plot(x[1][some.index], y[1][some.index], **{**style, "linestyle": "none", **hollow})


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


def legend_of(cells, styles, quantities, front):
    handles = [plt.Line2D([], [], label=label, **styles[label]) for label in sorted(styles, key=natural)]
    if front:
        handles.append(plt.Line2D([], [], color="#000000", linewidth=0.8, linestyle=(0, (4, 2)), label="Pareto front"))
    if any(interval_of(cells, each.column) is not None for each in quantities):
        handles.append(plt.Line2D([], [], color="#555555", marker="|", markersize=6, linewidth=0.7, label="95 % interval of the time"))
    if not counted(cells).all():
        handles.append(plt.Line2D([], [], color="#555555", marker="o", markerfacecolor="none", markersize=4.5, linestyle="none",
                                  label=f"> {100 * HIT_LIMIT:g} % of hits wrong"))
    return handles


def make_figure(cells, x, y, options, log_x, log_y, each_setting=False, besides=(), front=False):
    swept = sorted(cells[x.column].unique()) if x.column in besides else []
    swept = swept if len(swept) <= MOST_NAMED_VALUES else []
    cells = with_lines(cells, each_setting)
    panels = panels_of(cells, besides)
    styles = styles_of(cells)
    handles = legend_of(cells, styles, (x, y), front)
    columns = min(3, len(panels))
    rows = -(-len(panels) // columns)
    width = PANEL_INCHES[0] * columns + LEGEND_INCHES + LETTER_INCHES * max(len(handle.get_label()) for handle in handles)
    height = max(PANEL_INCHES[1] * rows, ENTRY_INCHES * len(handles) + BESIDE_LEGEND_INCHES) + (0.3 if options.title else 0)
    figure, grid = plt.subplots(rows, columns, squeeze=False, sharex=True, sharey=True, layout="constrained",
                                figsize=(width, height))
    (placed_x, edge_x), (placed_y, edge_y) = placed_on(cells[x.column], log_x), placed_on(cells[y.column], log_y)
    for axes, (name, group) in zip(grid.flat, panels):
        axes.set_xscale("log" if log_x else "linear")
        axes.set_yscale("log" if log_y else "linear")
        draw_panel(axes, group, styles, (x.column, placed_x), (y.column, placed_y))
        if front:
            draw_front(axes, group, x, y, (placed_x, placed_y))
        axes.set_title(textwrap.fill(name, TITLE_LETTERS), fontsize=8)
        axes.grid(True, which="major", linewidth=0.3, color="#cccccc")
    for axes in list(grid.flat)[:len(panels)]:
        number(axes.xaxis, log_x, swept)
        number(axes.yaxis, log_y)
        # Panels share their scales, but each can be cut out and read.
        axes.tick_params(labelbottom=True, labelleft=True)
    for axes in list(grid.flat)[len(panels):]:
        axes.set_visible(False)
    figure.supxlabel(x.axis(", ") + edge_x, fontsize=9)
    figure.supylabel(y.axis("\n") + edge_y, fontsize=9)
    if options.title:
        figure.suptitle(options.title, fontsize=10)
    grid[0][-1].legend(handles=handles, loc="upper left", bbox_to_anchor=(1.02, 1.0), fontsize=7, frameon=False,
                       handlelength=3)
    return figure


def is_logarithmic(chosen):
    """What is better the lower it is shrinks by factors; the others near a bound (SSIM, coverage) or are decibels."""
    return chosen.better != "higher"


def plot_pareto(cells, figures, options, notes):
    cost = with_direction(quantity(cells, options.cost, figures, "--cost", notes), "--cost")
    error = with_direction(quantity(cells, options.error, figures, "--error", notes), "--error")
    cells = with_numbers(cells, [cost.column, error.column], notes)
    return make_figure(cells, cost, error, options, is_logarithmic(cost), is_logarithmic(error), front=True)


def plot_steps(cells, figures, options, notes):
    steps = quantity(cells, STEPS, figures, "steps", notes)
    error = quantity(cells, options.error, figures, "--error", notes)
    cells = positive(with_numbers(cells, [steps.column, error.column], notes), steps.column, notes)
    log = is_logarithmic(error) and (cells[error.column] >= 0).all()
    return make_figure(cells, steps, error, options, True, log)


def plot_angle(cells, figures, options, notes):
    cost = quantity(cells, options.cost, figures, "--cost", notes)
    angle = quantity(cells, VIEW_ANGLE, figures, "angle", notes)
    cells = with_numbers(cells, [cost.column], notes)
    if cells[VIEW_ANGLE].nunique() < 2:
        raise PlotError("angle: all cells have one view angle; export a run whose axis view_angle has several")
    angle = dataclasses.replace(angle, label="view angle (degrees)")
    return make_figure(cells, angle, cost, options, False, wants_log(cells[cost.column]), each_setting=True,
                       besides=[VIEW_ANGLE])


FIGURES = {"pareto": plot_pareto, "steps": plot_steps, "angle": plot_angle}


def parse_arguments():
    parser = argparse.ArgumentParser(prog="plot.py", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("figure", choices=FIGURES)
    parser.add_argument("files", nargs="+", metavar="RUN", help="runs' folders, and exported runs (CSV); their cells are taken together")
    parser.add_argument("-o", "--output", required=True, metavar="FILE", help="a .pdf, .svg or .png")
    names = ", ".join(SHORT_NAMES) + "; or the path of any figure"
    parser.add_argument("--error", default=USUAL_ERROR, metavar="NAME", help=f"{names} (default: {USUAL_ERROR})")
    parser.add_argument("--cost", default=USUAL_COST, metavar="NAME", help=f"as --error (default: {USUAL_COST})")
    parser.add_argument("--filter", action="append", default=[], metavar="EXPR",
                        help="keep cells with technique=pom,qdm, view_angle>=60, view_angle=[0:80:20], max_steps!=8 or any axis or "
                             "parameter, as reliefbench run --filter does (may be repeated)")
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
        figures = declared_figures(options.files)
        cells = apply_filters(read_cells(options.files, figures), options.filter)
        figure = FIGURES[options.figure](cells, figures, options, notes)
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
