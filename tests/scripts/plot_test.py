#!/usr/bin/python3
"""scripts/plot.py on a run made, exported and read back: plot_test.py RELIEFBENCH"""

import contextlib
import importlib.util
import io
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

PLOT = Path(__file__).resolve().parents[2] / "scripts" / "plot.py"

CONFIGURATION = {
    "techniques": ["flat", "steep", "pom"],
    "axes": {"heightmap": "bricks", "heightmap_size": 32, "projection": "parallel", "view_angle": [30, 60],
             "resolution": 32, "sample_count": [4, 16]},
    "sampling": {"rule": "fixed", "rounds": 1, "samples_per_visit": 1, "warm_up": 0, "minimum_pass_ms": 0},
}


def load_plot():
    specification = importlib.util.spec_from_file_location("plot", PLOT)
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


class Plot(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.script = load_plot()
        cls.folder = tempfile.TemporaryDirectory()
        cls.path = Path(cls.folder.name)
        (cls.path / "plot.json").write_text(json.dumps(CONFIGURATION))
        with open(cls.path / "cells.csv", "w") as csv:
            subprocess.run([RELIEFBENCH, "run", "plot.json", "-o", "run", "--format", "csv"], cwd=cls.path, stdout=csv,
                           stderr=subprocess.PIPE, check=True)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def plot(self, *arguments):
        """Exit code and standard error. In this process: importing matplotlib takes a second."""
        errors = io.StringIO()
        before = os.getcwd()
        os.chdir(self.path)
        try:
            with mock.patch("sys.argv", [str(PLOT), *arguments]), contextlib.redirect_stderr(errors):
                code = self.script.main()
        finally:
            os.chdir(before)
            self.script.plt.close("all")
        return code, errors.getvalue()

    def svg(self, *arguments):
        self.assertEqual(self.plot(*arguments, "-o", "figure.svg"), (0, ""))
        return (self.path / "figure.svg").read_text()

    def shows(self, text, words):
        self.assertTrue(f">{words}</text>" in text, words)

    def refused(self, words, *arguments):
        code, errors = self.plot(*arguments, "-o", "refused.svg")
        self.assertEqual(code, 2, errors)
        for word in words:
            self.assertIn(word, errors)
        self.assertFalse((self.path / "refused.svg").exists())

    def test_the_front_has_its_labels_a_panel_for_each_view_and_every_technique(self):
        text = self.svg("pareto", "cells.csv", "--title", "Made up")
        for words in ("GPU time of a draw (ms)", "UV error, 99th percentile (texels)", "view_angle 30", "view_angle 60",
                      "flat", "steep", "pom", "Pareto front", "Made up"):
            self.shows(text, words)

    def test_error_and_cost_can_be_chosen(self):
        text = self.svg("pareto", "cells.csv", "--error", "flip", "--cost", "taps", "--filter", "view_angle=60",
                        "--filter", "technique=steep,pom")
        for words in ("FLIP", "taps per pixel"):
            self.shows(text, words)
        self.assertFalse("view_angle" in text)
        self.shows(self.svg("pareto", "cells.csv", "--error", "error.depth.rms"), "error.depth.rms")

    def test_error_against_steps(self):
        text = self.svg("steps", "cells.csv", "--filter", "technique=steep,pom", "--filter", "view_angle>=60")
        for words in ("steps per pixel", "UV error, 99th percentile (texels)", "steep"):
            self.shows(text, words)
        self.assertFalse(">flat<" in text)

    def test_time_against_view_angle_has_a_line_for_each_setting(self):
        text = self.svg("angle", "cells.csv", "--cost", "ns")
        for words in ("view angle (degrees from the normal)", "GPU time per covered pixel (ns)"):
            self.shows(text, words)
        # At their defaults parameters are left out, and min_steps follows max_steps.
        self.assertEqual(len(set(re.findall(r">(steep [^<]*max_steps=4[^<]*)<", text))), 1)
        self.assertEqual(len(set(re.findall(r">(pom [^<]*)<", text))), 2)

    def test_what_a_logarithmic_axis_has_no_place_for_is_told(self):
        code, errors = self.plot("steps", "cells.csv", "-o", "steps.svg")
        self.assertEqual(code, 0)
        self.assertIn("left out for work.steps_mean = 0, which a logarithmic axis lacks: 2 of 10 cells", errors)

    def test_each_format_is_written(self):
        for name, start in (("front.pdf", b"%PDF"), ("front.png", b"\x89PNG"), ("front.svg", b"<?xml")):
            self.assertEqual(self.plot("pareto", "cells.csv", "-o", name), (0, ""))
            data = (self.path / name).read_bytes()
            self.assertTrue(data.startswith(start))
            self.assertGreater(len(data), 5000)

    def test_the_same_file_comes_out_every_time(self):
        self.assertEqual(self.svg("pareto", "cells.csv"), self.svg("pareto", "cells.csv"))

    def test_bad_input_ends_with_a_message(self):
        self.refused(["none.csv", "No such file"], "pareto", "none.csv")
        self.refused(["no column 'cell'", "reliefbench export --format csv"], "pareto", "plot.json")
        self.refused(["'time.speed'", "short names: ms"], "pareto", "cells.csv", "--cost", "time.speed")
        self.refused(['"motion"'], "pareto", "cells.csv", "--error", "motion")
        self.refused(["no cell is left", "30"], "pareto", "cells.csv", "--filter", "view_angle=45")
        self.refused(["no axis or parameter 'angle'", "view_angle"], "pareto", "cells.csv", "--filter", "angle=45")
        self.refused(["NAME=V1,V2"], "pareto", "cells.csv", "--filter", "view_angle")
        self.refused(["expected a number"], "pareto", "cells.csv", "--filter", "view_angle>steep")
        self.refused(["one view angle"], "angle", "cells.csv", "--filter", "view_angle=60")

    def test_the_script_ends_with_a_message_and_a_code(self):
        outcome = subprocess.run([PLOT, "pareto", "cells.csv", "-o", "front.gif"], cwd=self.path, capture_output=True,
                                 text=True)
        self.assertEqual((outcome.returncode, outcome.stdout), (2, ""))
        self.assertEqual(outcome.stderr, "plot.py: --output front.gif: expected a file that ends in .pdf, .svg, .png\n")


if __name__ == "__main__":
    RELIEFBENCH = Path(sys.argv.pop(1)).resolve()
    unittest.main()
