"""Tables of documents that are written from runs: scripts/write_curved_tables, write_filtering_tables, write_engine_tables."""

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
END = "<!-- end of the tables -->"
NONE = "–"


def at(cell, path):
    """The number at a path of the line, None where it has none."""
    for key in path.split("."):
        cell = cell.get(key) if isinstance(cell, dict) else None
    return cell


def digits(value, count):
    return NONE if value is None else f"{value:.{count}g}" if 0 < abs(value) < 1000 else f"{value:.0f}"


def setting_of(cell):
    """Technique and parameters."""
    return cell["cell"].split(" | ")[0]


def table(title, columns, rows):
    """The lines of a table: the titles of its columns, and (setting, texts) of each row."""
    lines = [f"| {title} | {' | '.join(columns)} |", f"|---|{'---:|' * len(columns)}"]
    return [*lines, *(f"| {setting} | {' | '.join(texts)} |" for setting, texts in rows)]


def read_cells(run):
    """Those that are ok."""
    lines = (run / "cells.jsonl").read_text(encoding="utf-8").splitlines()
    cells = [cell for cell in map(json.loads, lines) if cell["status"] == "ok"]
    if not cells:
        sys.exit(f"{Path(sys.argv[0]).name}: {run} has no cell that is ok")
    return cells


def made_of(run, configuration):
    record = json.loads((run / "run.json").read_text(encoding="utf-8"))
    device = record.get("device", {}).get("name", "unknown")
    return f"Device: {device}. Configuration: [configs/{configuration.name}](../configs/{configuration.name})."


def program():
    """$RELIEFBENCH, or else build/release/reliefbench."""
    return os.environ.get("RELIEFBENCH", str(ROOT / "build/release/reliefbench"))


def run_configuration(configuration, run):
    subprocess.run([program(), "run", str(configuration), "-o", str(run)], check=True)


def write_between(page, begin, lines):
    """In place of what stands between two comments of the page."""
    before, rest = page.read_text(encoding="utf-8").split(begin, 1)
    text = "\n".join([begin, "", *lines, END])
    page.write_text(before + text + rest.split(END, 1)[1], encoding="utf-8")


def main(usage, write, runs, make):
    """`write` takes the folders of so many runs: those on the command line, or those that `make` makes in a folder."""
    if sys.argv[1:] in (["-h"], ["--help"]) or len(sys.argv) - 1 not in (0, runs):
        sys.exit(usage.strip())
    if len(sys.argv) > 1:
        return write(*map(Path, sys.argv[1:]))
    with tempfile.TemporaryDirectory() as scratch:
        write(*make(Path(scratch)))
