#!/usr/bin/python3
"""Figures for papers from exported runs (reliefbench export RUN --format csv, or reliefbench run ... --format csv).

    plot.py pareto cells.csv -o front.pdf --error uv --cost ms
    plot.py steps  cells.csv -o steps.svg --error uv --filter view_angle=60
    plot.py angle  cells.csv -o angle.png --cost ns --filter heightmap=rock

pareto: error against cost; the line is the Pareto front: nothing is both cheaper and better. steps: error against steps
per pixel. angle: cost against view angle. One panel for each view that the filters leave. The format is the file's
extension: pdf, svg or png. Needs Debian's python3-matplotlib and python3-pandas.
"""

import argparse
import re
import sys
from pathlib import Path

try:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    import matplotlib.ticker
    import pandas
except ModuleNotFoundError as missing:
    sys.exit(f"plot.py: there is no Python module {missing.name}; on Debian: apt install python3-matplotlib python3-pandas")

# Short names on the command line: column and what its axis says. Any other numeric column can be named in full.
ERRORS = {
    "uv": ("error.uv_texels.p99", "UV error, 99th percentile (texels)"),
    "uv_mean": ("error.uv_texels.mean", "UV error, mean (texels)"),
    "depth": ("error.depth.p99", "depth error, 99th percentile (patch sides)"),
    "normal": ("error.normal_deg.p99", "normal error, 99th percentile (degrees)"),
    "missed": ("error.missed", "missed hits (fraction of footprint)"),
    "flip": ("image.flip", "FLIP"),
    "motion": ("motion.texels.mean", "change of UV error per frame, mean (texels)"),
    "motion_flip": ("motion.flip.mean", "change per frame, mean FLIP"),
}
COSTS = {
    "ms": ("time.draw.median_ms", "GPU time of a draw (ms)"),
    "ns": ("time.ns_per_pixel", "GPU time per covered pixel (ns)"),
    "taps": ("work.taps_mean", "taps per pixel"),
    "steps": ("work.steps_mean", "steps per pixel"),
    "prepare": ("prepare.ms", "preparation of maps (ms)"),
}
STEPS = COSTS["steps"]
VIEW_ANGLE = ("axes.view_angle", "view angle (degrees from the normal)")

# Okabe and Ito 2008: told apart by colour-blind eyes; the yellow is left out, which white paper swallows.
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00", "#000000"]
MARKERS = ["o", "s", "^", "D", "v", "P", "X", "<", ">", "*", "h"]

# Missed and false hits above this fraction of the footprint: the errors of such a cell do not count.
HIT_LIMIT = 0.005
MOST_PANELS = 6
PANEL_INCHES = (3.3, 2.8)
LEGEND_INCHES = 1.7
# Linear axes serve values within this factor of each other.
LOG_AXIS_FACTOR = 8
FORMATS = (".pdf", ".svg", ".png")


class PlotError(Exception):
    """What is wrong with the input, and what to do."""


def read_cells(files):
    frames = []
    for file in files:
        try:
            frames.append(pandas.read_csv(file))
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
    return measured


def find_column(cells, name):
    for column in (name, f"axes.{name}", f"params.{name}"):
        if column in cells.columns:
            return column
    raise PlotError(f"--filter: there is no axis or parameter '{name}'; there are " + ", ".join(setting_names(cells)))


def setting_names(cells):
    return ["technique"] + [name.split(".", 1)[1] for name in cells.columns if name.startswith(("axes.", "params."))]


def equals(values, text):
    """Numbers as numbers: 60 is 60.0."""
    try:
        return pandas.to_numeric(values, errors="coerce") == float(text)
    except ValueError:
        return values.astype(str).str.lower() == text.lower()


def apply_filters(cells, filters):
    for expression in filters:
        match = re.fullmatch(r"([\w.]+)(<=|>=|=|<|>)(.+)", expression)
        if not match:
            raise PlotError(f"--filter: expected NAME=V1,V2 or NAME>=V, found '{expression}'")
        name, relation, text = match.groups()
        values = cells[find_column(cells, name)]
        if relation == "=":
            chosen = pandas.concat([equals(values, each) for each in text.split(",")], axis=1).any(axis=1)
        else:
            try:
                limit = float(text)
            except ValueError:
                raise PlotError(f"--filter: expected a number after '{relation}', found '{text}'") from None
            numbers = pandas.to_numeric(values, errors="coerce")
            chosen = {"<": numbers < limit, "<=": numbers <= limit, ">": numbers > limit, ">=": numbers >= limit}[relation]
        if not chosen.any():
            there = ", ".join(sorted(values.dropna().astype(str).unique())[:12])
            raise PlotError(f"--filter {expression}: no cell is left; {name} is one of {there}")
        cells = cells[chosen]
    return cells


def quantity(cells, name, short_names, option):
    """Column and label, checked."""
    column, label = short_names.get(name, (name, name))
    if column not in cells.columns:
        raise PlotError(f"{option} {name}: there is no column '{column}'; short names: " + ", ".join(short_names))
    if not pandas.api.types.is_numeric_dtype(cells[column]) or cells[column].isna().all():
        raise PlotError(f"{option} {name}: the column '{column}' has no numbers" +
                        ('; the configuration has to ask for it with "motion"' if column.startswith("motion.") else ""))
    return column, label


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
    for label, cells in series.items():
        cells = cells.sort_values(x)
        style = styles[label]
        axes.plot(cells[x], cells[y], alpha=0.5, **{**style, "marker": None})
        counts = counted(cells)
        for part, face in ((cells[counts], style["color"]), (cells[~counts], "none")):
            axes.plot(part[x], part[y], linestyle="none", markerfacecolor=face, **{**style, "linewidth": 0})


def counted(cells):
    """Of which the errors count: hard pixels are not discarded."""
    hits = cells.get("error.missed", 0) + cells.get("error.false_hits", 0)
    return ~(hits > HIT_LIMIT) if hasattr(hits, "gt") else pandas.Series(True, index=cells.index)


def draw_front(axes, cells, cost, error):
    front = []
    best = float("inf")
    for _, cell in cells[counted(cells)].sort_values([cost, error]).iterrows():
        if cell[error] < best:
            best = cell[error]
            front.append((cell[cost], best))
    if front:
        axes.step(*zip(*front), where="post", color="#000000", linewidth=0.8, linestyle=(0, (4, 2)), zorder=0,
                  label="Pareto front")


def positive(cells, columns, notes):
    for column in columns:
        kept = cells[cells[column] > 0]
        if len(kept) < len(cells):
            notes.append(f"left out for {column} = 0, which a logarithmic axis lacks: {len(cells) - len(kept)} of {len(cells)} cells")
        cells = kept
    if cells.empty:
        raise PlotError(f"no cell is left with numbers above 0 in {' and '.join(columns)}")
    return cells


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
    (x_column, x_label), (y_column, y_label) = x, y
    panels = panels_of(cells, besides)
    labels = sorted({label for _, group in panels for label in series_of(group, each_setting)})
    if len(labels) > 2 * len(MARKERS):
        raise PlotError(f"{len(labels)} lines are too many to tell apart; choose with --filter, such as technique=pom,qdm")
    styles = {label: style_of(index) for index, label in enumerate(labels)}
    columns = min(3, len(panels))
    rows = -(-len(panels) // columns)
    figure, grid = plt.subplots(rows, columns, squeeze=False, sharex=True, sharey=True, layout="constrained",
                                figsize=(PANEL_INCHES[0] * columns + LEGEND_INCHES, PANEL_INCHES[1] * rows + (0.3 if title else 0)))
    for axes, (name, group) in zip(grid.flat, panels):
        draw_panel(axes, series_of(group, each_setting), styles, x_column, y_column)
        if front:
            draw_front(axes, group, x_column, y_column)
        axes.set_title(name, fontsize=8)
        axes.grid(True, which="major", linewidth=0.3, color="#cccccc")
        if log_x:
            make_logarithmic(axes.xaxis, axes.set_xscale, cells[x_column])
        if log_y:
            make_logarithmic(axes.yaxis, axes.set_yscale, cells[y_column])
    for axes in list(grid.flat)[len(panels):]:
        axes.set_visible(False)
    figure.supxlabel(x_label, fontsize=9)
    figure.supylabel(y_label, fontsize=9)
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


def plot_pareto(cells, options, notes):
    cost = quantity(cells, options.cost, COSTS, "--cost")
    error = quantity(cells, options.error, ERRORS, "--error")
    cells = positive(cells, [cost[0], error[0]], notes)
    return make_figure(cells, cost, error, options.title, True, True, front=True)


def plot_steps(cells, options, notes):
    steps = quantity(cells, "steps", COSTS, "steps")
    error = quantity(cells, options.error, ERRORS, "--error")
    cells = positive(cells, [steps[0], error[0]], notes)
    return make_figure(cells, steps, error, options.title, True, True)


def plot_angle(cells, options, notes):
    cost = quantity(cells, options.cost, COSTS, "--cost")
    quantity(cells, VIEW_ANGLE[0], {}, "angle")
    cells = cells[cells[cost[0]].notna()]
    if cells[VIEW_ANGLE[0]].nunique() < 2:
        raise PlotError("angle: all cells have one view angle; export a run whose axis view_angle has several")
    log = wants_log(cells[cost[0]])
    return make_figure(cells, VIEW_ANGLE, cost, options.title, False, log, each_setting=True, besides=[VIEW_ANGLE[0]])


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
