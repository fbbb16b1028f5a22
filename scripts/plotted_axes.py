"""Numbers at plot.py's axes: round ones, at least two, written as report_page/src/scales.ts writes them."""

import math

import matplotlib.ticker

# Numbers at an axis: fewer than these and more than those are not to be read from.
FEWEST_TICKS = 4
MOST_TICKS = 9
# What is multiplied by powers of ten, from coarse to fine.
DECADE_STEPS = [(1,), (1, 3), (1, 2, 5), tuple(range(1, 10))]
SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def reads_written_out(value):
    """Where nobody would count the zeros it does not."""
    return value == 0 or 0.99e-6 < abs(value) < 0.99e7


def tick_texts(values):
    """Of one axis, all in one form: 0.03, 1024 or, where one of them does not read written out, 3·10⁻², 10⁻⁷."""
    written_out = all(map(reads_written_out, values))
    return [tick_text(value, written_out) for value in values]


def tick_text(value, written_out):
    size = abs(value)
    if size == 0 or written_out:
        return f"{value:.10f}".rstrip("0").rstrip(".").replace("-", "−")
    exponent = math.floor(math.log10(size) + 1e-9)
    factor = f"{value / 10 ** exponent:.6g}".replace("-", "−")
    return ("" if factor == "1" else factor + "·") + "10" + str(exponent).translate(SUPERSCRIPTS)


def linear_ticks(low, high):
    rough = (high - low) / (FEWEST_TICKS + 2)
    decade = 10 ** math.floor(math.log10(rough))
    step = next(factor * decade for factor in (1, 2, 2.5, 5, 10) if factor * decade >= 0.999 * rough)
    return [at * step for at in range(math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9) + 1)]


def log_ticks(low, high):
    """Both above 0 and not equal."""
    first, last = math.floor(math.log10(low)), math.floor(math.log10(high))
    every = max(1, math.ceil((last - first) / MOST_TICKS))
    start = (math.ceil(first / every) - 1) * every

    def within(steps):
        ticks = (step * 10.0 ** exponent for exponent in range(start, last + 1, every) for step in steps)
        return [tick for tick in ticks if low <= tick <= high]

    if every > 1:
        return within((1,))
    choices = [ticks for ticks in map(within, DECADE_STEPS) if len(ticks) <= MOST_TICKS]
    chosen = next((ticks for ticks in choices if len(ticks) >= FEWEST_TICKS), choices[-1] if choices else [])
    return chosen if len(chosen) >= FEWEST_TICKS else linear_ticks(low, high)


def number(axis, is_logarithmic, values=()):
    """Ticks and their texts for what the axis shows now: at `values`, if any."""
    low, high = sorted(axis.get_view_interval())
    ticks = values or (log_ticks if is_logarithmic else linear_ticks)(low, high)
    axis.set_major_locator(matplotlib.ticker.FixedLocator(ticks))
    axis.set_major_formatter(matplotlib.ticker.FixedFormatter(tick_texts(ticks)))
    axis.set_minor_locator(matplotlib.ticker.NullLocator())
