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
    sys.path.insert(0, str(PLOT.parent))
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
        (cls.path / "images").mkdir()
        with open(cls.path / "cells.csv", "w") as csv:
            subprocess.run([RELIEFBENCH, "run", "plot.json", "-o", "run", "--format", "csv"], cwd=cls.path, stdout=csv,
                           stderr=subprocess.PIPE, check=True)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    @staticmethod
    def declared():
        return sys.modules["plotted_figures"].declared_figures([])

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
        for words in ("Draw time (ms), lower is better", "UV error, p99 (texels)", "lower is better", "30°", "60°", "flat", "steep", "pom", "Pareto front", "Made up"):
            self.shows(text, words)

    def test_error_and_cost_can_be_chosen(self):
        text = self.svg("pareto", "cells.csv", "--error", "flip", "--cost", "taps", "--filter", "view_angle=60",
                        "--filter", "technique=steep,pom")
        self.shows(text, "Taps per pixel, lower is better")
        self.assertIn(">FLIP", text)
        self.assertRegex(text, r">bricks · [^<]*60°[^<]*<")
        self.assertFalse("30°" in text)
        self.shows(self.svg("pareto", "cells.csv", "--error", "error.depth.rms"), "Depth error, RMS (patch sides)")

    def front(self, cost, error, cells):
        """Names of the cells on the front."""
        script = self.script
        figures = script.pandas.DataFrame(cells, columns=["cell", "time.draw.median_ms", error])
        quantities = [script.quantity(figures, name, self.declared(), "", []) for name in (cost, error)]
        return list(script.front_of(figures, *quantities)["cell"])

    def test_a_front_goes_through_the_best_points_whichever_way_a_figure_is_better(self):
        cells = [("a", 1, 0.2), ("b", 2, 0.5), ("c", 3, 0.4), ("d", 4, 0.9), ("e", 4, 0.95)]
        for error, expected in (("image.ssim", "abe"), ("image.psnr", "abe"), ("error.coverage_iou", "abe"),
                                ("image.flip", "a"), ("error.uv_texels.p99", "a")):
            self.assertEqual("".join(self.front("time.draw.median_ms", error, cells)), expected, error)

    def test_a_figure_without_a_direction_has_no_front(self):
        self.refused(["--error error.depth.mean", "neither low nor high values", "no front"], "pareto", "cells.csv", "--error",
                     "error.depth.mean")
        self.refused(["--cost work.covered_pixels", "no front"], "pareto", "cells.csv", "--cost", "work.covered_pixels")
        self.refused(["no front"], "pareto", "cells.csv", "--cost", "parameters.max_steps")
        self.shows(self.svg("angle", "cells.csv", "--cost", "error.depth.mean"), "Depth error, signed mean (patch sides)")

    def test_a_picture_without_an_error_has_the_best_psnr_and_zeros_are_on_the_front(self):
        header = "cell,technique,status,axes.view_angle,time.draw.median_ms,error.uv_texels.p99,image.psnr,image.rmse"
        rows = ["a | v,a,ok,0,1,2,20,0.1", "b | v,b,ok,0,2,0,,0", "c | v,c,ok,0,3,1,30,0.03", "d | v,d,ok,0,4,1,,"]
        (self.path / "perfect.csv").write_text("\n".join([header, *rows]) + "\n")
        cells = self.script.read_cells([str(self.path / "perfect.csv")], self.declared())
        for name in ("image.psnr", "uv"):
            error = self.script.quantity(cells, name, self.declared(), "", [])
            cost = self.script.quantity(cells, "ms", self.declared(), "", [])
            with_both = self.script.with_numbers(cells, [error.column], [])
            self.assertEqual(list(self.script.front_of(with_both, cost, error)["technique"]), ["a", "b"], name)
        code, notes = self.plot("pareto", "perfect.csv", "-o", "figure.svg", "--error", "psnr")
        self.assertEqual((code, notes), (0, "plot.py: note: left out without image.psnr: 1 of 4 cells\n"))
        self.shows((self.path / "figure.svg").read_text(), "higher is better; \N{INFINITY} on the edge")
        self.shows(self.svg("pareto", "perfect.csv"), "lower is better; 0 on the edge")

    def test_whole_pictures_are_taken_where_there_are_none_over_the_footprint_and_that_is_told(self):
        header = "cell,technique,status,time.draw.median_ms,image.flip,error.outside_quad.pixels"
        (self.path / "old.csv").write_text(f"{header}\na | v,a,ok,1,0.5,9\nb | v,b,ok,2,0.25,0\n")
        code, notes = self.plot("pareto", "old.csv", "-o", "figure.svg", "--error", "flip")
        self.assertEqual(code, 0)
        self.assertIn("image.flip counts relief outside the footprint", notes)
        self.assertIn("image.footprint.flip would not, which these runs do not have", notes)
        (self.path / "new.csv").write_text(f"{header},image.footprint.flip\na | v,a,ok,1,0.5,9,0.1\nb | v,b,ok,2,0.5,9,0.05\n")
        self.shows(self.svg("pareto", "new.csv", "--error", "flip"), "lower is better")

    def test_every_short_name_is_a_declared_figure(self):
        declared = self.declared()
        page = (PLOT.parent / "README.md").read_text()
        for name, columns in self.script.SHORT_NAMES.items():
            self.assertIn(f"`{name}`", page)
            for column in columns:
                self.assertIn(column, declared, name)
                self.assertNotEqual(declared[column]["better"], "neither", name)

    def test_error_against_steps(self):
        text = self.svg("steps", "cells.csv", "--filter", "technique=steep,pom", "--filter", "view_angle>=60")
        for words in ("Steps per pixel, lower is better", "UV error, p99 (texels)", "steep"):
            self.shows(text, words)
        self.assertFalse(">flat<" in text)

    def test_time_against_view_angle_has_a_line_for_each_setting(self):
        text = self.svg("angle", "cells.csv", "--cost", "ns")
        for words in ("view angle (degrees)", "Draw time per covered pixel (ns)"):
            self.shows(text, words)
        # At their defaults parameters are left out, and min_steps follows max_steps.
        self.assertEqual(len(set(re.findall(r">(steep [^<]*max_steps=4[^<]*)<", text))), 1)
        self.assertEqual(len(set(re.findall(r">(pom [^<]*)<", text))), 2)

    def figure(self, *arguments):
        """Its panels' axes, drawn."""
        kept = []
        with mock.patch.object(self.script.plt, "close"), mock.patch.object(
                self.script, "make_figure", side_effect=lambda *a, made=self.script.make_figure, **k: kept.append(made(*a, **k)) or kept[0]):
            self.svg(*arguments)
        return [axes for axes in kept[0].axes if axes.get_visible()]

    def test_every_panel_has_numbers_at_both_axes_and_none_is_a_power_of_ten_that_reads_better_written_out(self):
        for arguments in (["pareto", "cells.csv"], ["steps", "cells.csv", "--filter", "technique=steep,pom"]):
            panels = self.figure(*arguments)
            self.assertEqual(len(panels), 2)
            for axes in panels:
                for axis in (axes.xaxis, axes.yaxis):
                    low, high = sorted(axis.get_view_interval())
                    shown = [tick.label1 for tick in axis.get_major_ticks() if low <= tick.get_loc() <= high]
                    self.assertGreaterEqual(len(shown), 2)
                    for label in shown:
                        self.assertTrue(label.get_visible())
                        self.assertRegex(label.get_text(), r"^(−?\d+(\.\d+)?|([\d.]+·)?10⁻?[⁰¹²³⁴⁵⁶⁷⁸⁹]+)$")

    def test_numbers_at_axes_are_those_of_the_report(self):
        axes = sys.modules["plotted_axes"]
        self.assertEqual(axes.tick_texts([0.03, 1024, 16384, 0.00001, -0.5, 0]),
                         ["0.03", "1024", "16384", "0.00001", "−0.5", "0"])
        self.assertEqual(axes.tick_texts([1e-7, 3e-8, 1e7, 0.0001, 0.5, 0]),
                         ["10⁻⁷", "3·10⁻⁸", "10⁷", "10⁻⁴", "5·10⁻¹", "0"])
        for low in (1e-9, 0.0137, 0.99, 1, 730):
            for factor in (1.0001, 1.02, 1.44, 1.9, 3, 12, 1e3, 1e7, 1e13):
                for ticks in (axes.log_ticks(low, low * factor), axes.linear_ticks(low, low * factor)):
                    self.assertTrue(2 <= len(ticks) <= 10, f"{low} times {factor}: {ticks}")

    def test_all_numbers_of_an_axis_have_one_form(self):
        header = "cell,technique,status,time.draw.median_ms,error.uv_texels.p99"
        rows = [f"{name} | ,{name},ok,{1 + at},{10.0 ** -at}" for at, name in enumerate("abcdefgh")]
        (self.path / "decades.csv").write_text("\n".join([header, *rows]) + "\n")
        axis = self.figure("pareto", "decades.csv")[0].yaxis
        low, high = sorted(axis.get_view_interval())
        texts = [tick.label1.get_text() for tick in axis.get_major_ticks() if low <= tick.get_loc() <= high]
        self.assertEqual(texts, ["10⁻⁷", "10⁻⁶", "10⁻⁵", "10⁻⁴", "10⁻³", "10⁻²", "10⁻¹", "10⁰"])

    def test_a_single_panel_says_which_view_it_is_of(self):
        panels = self.figure("pareto", "cells.csv", "--filter", "view_angle=60")
        self.assertEqual(len(panels), 1)
        for words in ("bricks", "60°"):
            self.assertIn(words, panels[0].get_title().split(" · "))
        self.assertLess(max(map(len, panels[0].get_title().splitlines())), 49)
        over_angles = self.figure("angle", "cells.csv")[0].get_title().split(" · ")
        self.assertIn("bricks", over_angles)
        self.assertFalse(any("°" in words for words in over_angles), over_angles)

    def test_filters_have_the_grammar_of_reliefbench(self):
        header = "cell,technique,status,time.draw.median_ms,error.uv_texels.p99,axes.heightmap,axes.view_angle,parameters.exact"
        rows = ['a,a,ok,1,1,"a,b.png",30,true', 'b,b,ok,1,1,"[x,y].png",45,false', "c,c,ok,1,1,007,60,", "d,d,ok,1,1,7,0.3,"]
        (self.path / "filtered.csv").write_text("\n".join([header, *rows]) + "\n")
        cells = self.script.read_cells([str(self.path / "filtered.csv")], self.declared())

        def kept(*filters):
            return "".join(self.script.apply_filters(cells, filters)["technique"])
        for expected, *filters in (
                ("a", 'heightmap="a,b.png"'), ("ac", 'heightmap="a,b.png",007'), ("b", 'heightmap=["[x,y].png"]'),
                ("ab", 'heightmap=["a,b.png","[x,y].png"]'), ("d", "heightmap=7"), ("c", "heightmap=007"),
                ("ab", "view_angle=[30:50:15]"), ("abd", "view_angle=[0.1:0.4:0.1],30,45"), ("bc", "view_angle=[45,60.0]"),
                ("bcd", "technique!=a"), ("cd", "technique!=a,b"), ("c", "view_angle>=45", "technique!=b"), ("a", "exact=true"),
                ("b", "exact=false"), ("ad", "view_angle<45"), ("abcd", "view_angle=0.3,3e1,45,60")):
            self.assertEqual(kept(*filters), expected, filters)
        for words, text in (("lacks its closing quote", 'heightmap="a,b.png'), ("lacks its closing bracket", "view_angle=[30,45"),
                            ("a value is missing", "view_angle=30,,45"), ("expected a comma behind [x,y]", "heightmap=[x,y].png"),
                            ("[start:stop:step]", "view_angle=[0:9]"), ("steps away", "view_angle=[9:0:1]"),
                            ("expected one number", "view_angle<30,45"), ("expected one number", "view_angle<steep"),
                            ("expected name=value", "=3")):
            with self.assertRaises(sys.modules["plotted_figures"].PlotError) as raised:
                kept(text)
            self.assertIn(words, str(raised.exception))

    def test_reliefbench_keeps_the_same_cells_by_the_same_filters(self):
        for text in ("view_angle=[30:50:15]", "technique!=pom,flat", 'technique="pom",steep', 'technique=["pom","flat"]',
                     "max_steps!=4",
                     "heightmap=[\"bricks\"]"):
            listed = subprocess.run([RELIEFBENCH, "run", "plot.json", "--dry-run", "--filter", text], cwd=self.path,
                                    capture_output=True, text=True)
            cells = self.script.read_cells([str(self.path / "cells.csv")], self.declared())
            try:
                kept = set(self.script.apply_filters(cells, [text])["cell"])
            except sys.modules["plotted_figures"].PlotError:
                kept = None
            self.assertEqual((text, kept is not None), (text, listed.returncode == 0), listed.stderr)
            if kept is not None:
                self.assertEqual({cell for cell in cells["cell"] if cell in listed.stdout}, kept, text)

    def test_the_limit_of_hits_is_written_as_in_the_report(self):
        header = "cell,technique,status,time.draw.median_ms,error.uv_texels.p99,error.missed"
        (self.path / "missed.csv").write_text(f"{header}\na | ,a,ok,1,1,0.1\nb | ,b,ok,2,1,0\n")
        text = self.svg("pareto", "missed.csv")
        self.assertIn("0.5 % of hits wrong", text)

    def test_times_have_their_95_percent_interval_as_bars(self):
        header = "cell,technique,status,time.draw.median_ms,time.draw.ci95_ms.low,time.draw.ci95_ms.high,time.ns_per_pixel," \
                 "error.uv_texels.p99,axes.view_angle"
        rows = ["a | v,a,ok,2,1,3,200,1,0", "a | w,a,ok,4,4,8,400,1,30"]
        (self.path / "bars.csv").write_text("\n".join([header, *rows]) + "\n")

        def ends(axes, direction):
            return sorted(segment[:, direction].tolist() for bars in axes.containers for each in bars.lines[2]
                          for segment in each.get_segments())
        panels = self.figure("pareto", "bars.csv")
        self.assertEqual([ends(axes, 0) for axes in panels], [[[1, 3]], [[4, 8]]])
        self.assertEqual([ends(axes, 1) for axes in self.figure("angle", "bars.csv", "--cost", "ns")], [[[100, 300], [400, 800]]])
        self.shows(self.svg("pareto", "bars.csv"), "95 % interval of the time")
        self.assertFalse("95 %" in self.svg("pareto", "bars.csv", "--cost", "error.uv_texels.p99"))

    def test_a_technique_has_the_colour_and_marker_of_the_report_in_every_figure(self):
        marks = sys.modules["plotted_marks"]
        for case in json.loads((PLOT.parents[1] / "report_page/tests/marks_of_names.json").read_text()):
            self.assertEqual(marks.mark_numbers(case["names"]), dict(zip(case["names"], case["numbers"])))
        shipped = [folder.name for folder in (PLOT.parents[1] / "techniques").iterdir() if folder.is_dir()]
        together = marks.mark_numbers(shipped)
        self.assertEqual(len(shipped), len(set(together.values())))
        self.assertEqual(together, {name: marks.mark_numbers([name])[name] for name in shipped}, "no two meet")

        def styles(*filters):
            lines = self.figure("pareto", "cells.csv", "--filter", "view_angle=60", *filters)[0].get_legend().get_lines()
            return {line.get_label(): (line.get_color(), line.get_marker()) for line in lines}
        everything, alone = styles(), styles("--filter", "technique=pom")
        self.assertEqual(everything["pom"], alone["pom"])
        self.assertNotEqual(everything["pom"], everything["steep"])

    def test_lines_of_one_technique_differ_in_dashes_and_filling(self):
        lines = self.figure("angle", "cells.csv")[0].get_legend().get_lines()
        of_pom = [line for line in lines if line.get_label().startswith("pom")]
        self.assertEqual(len({(line.get_color(), line.get_marker()) for line in of_pom}), 1)
        self.assertEqual(len({line.get_linestyle() for line in of_pom}), 2)
        self.assertEqual(len({line.get_fillstyle() for line in of_pom}), 2)

    def test_lines_and_panels_are_named_as_in_ids_and_in_the_report(self):
        header = "cell,technique,status,time.draw.median_ms,error.uv_texels.p99,axes.heightmap,axes.height_scale," \
                 "parameters.leaf,parameters.max_steps,parameters.min_steps"
        view = "heightmap=a/rock.png height_scale=0.1"
        rows = [f"qdm | {view},qdm,ok,1,1,a/rock.png,0.1,exact,50,8",
                f"qdm max_steps=16 min_steps=2 | {view},qdm,ok,2,1,a/rock.png,0.1,exact,16,2",
                f"qdm leaf=linear | {view},qdm,ok,3,1,a/rock.png,0.1,linear,50,8",
                "flat | heightmap=b height_scale=0.05,flat,ok,3,1,b,0.05,,,"]
        (self.path / "names.csv").write_text("\n".join([header, *rows]) + "\n")
        panels = self.figure("pareto", "names.csv")
        self.assertEqual([axes.get_title() for axes in panels], ["rock.png · height scale 0.1", "b · height scale 0.05"])
        self.assertEqual([line.get_label() for line in panels[-1].get_legend().get_lines()],
                         ["flat", "qdm", "qdm leaf=linear", "Pareto front"])

    def test_what_a_logarithmic_axis_has_no_place_for_is_told(self):
        code, errors = self.plot("steps", "cells.csv", "-o", "steps.svg")
        self.assertEqual(code, 0)
        self.assertIn("left out for work.steps_mean = 0, which a logarithmic axis lacks: 2 of 10 cells", errors)

    def test_a_legend_of_many_techniques_lies_within_the_figure(self):
        header = "cell,technique,status,time.draw.median_ms,error.uv_texels.p99,error.missed"
        rows = [f"technique_{at:02} | ,technique_{at:02},ok,{1 + at},{30 - at},{at % 2}" for at in range(20)]
        (self.path / "many.csv").write_text("\n".join([header, *rows]) + "\n")
        axes = self.figure("pareto", "many.csv")[0]
        axes.figure.canvas.draw()
        legend, whole = axes.get_legend().get_window_extent(), axes.figure.bbox
        self.assertGreaterEqual(legend.y0, whole.y0)
        self.assertLessEqual(legend.x1, whole.x1)

    def test_each_format_is_written(self):
        for name, start in (("front.pdf", b"%PDF"), ("front.png", b"\x89PNG"), ("front.svg", b"<?xml")):
            self.assertEqual(self.plot("pareto", "cells.csv", "-o", name), (0, ""))
            data = (self.path / name).read_bytes()
            self.assertTrue(data.startswith(start))
            self.assertGreater(len(data), 5000)

    def test_the_same_file_comes_out_every_time(self):
        self.assertEqual(self.svg("pareto", "cells.csv"), self.svg("pareto", "cells.csv"))

    def test_a_runs_folder_is_drawn_as_its_export_is(self):
        for arguments in (["pareto"], ["steps", "--filter", "technique=steep,pom"], ["angle", "--cost", "ns"]):
            self.assertEqual(self.svg(*arguments, "run"), self.svg(*arguments, "cells.csv"), arguments)
        lines = (self.path / "run/cells.jsonl").read_text()
        (self.path / "cut").mkdir()
        (self.path / "cut/run.json").write_text((self.path / "run/run.json").read_text())
        (self.path / "cut/cells.jsonl").write_text(lines + '{"cell": "half a li')
        self.assertEqual(self.svg("pareto", "cut"), self.svg("pareto", "run"))
        (self.path / "cut/cells.jsonl").write_text("no JSON\n" + lines)
        self.refused(["cut/cells.jsonl:1", "no JSON"], "pareto", "cut")

    def test_labels_units_and_directions_are_those_that_the_run_declares(self):
        record = json.loads((self.path / "run/run.json").read_text())
        cells = [json.loads(line) for line in (self.path / "run/cells.jsonl").read_text().splitlines()]
        for at, cell in enumerate(cells):
            cell["outline"] = {"p95": 1 + at}
        record["figures"] = [{"path": "outline.p95", "label": "Outline agreement", "unit": "pixels", "better": "higher", "needs": []},
                             {"path": "time.draw.median_ms", "label": "Time of the draw", "unit": "s", "better": "lower"},
                             {"path": "outline.later", "label": "Later", "unit": "", "better": "lower", "needs": ["truth", "motion"]}]
        (self.path / "later").mkdir()
        (self.path / "later/run.json").write_text(json.dumps(record))
        (self.path / "later/cells.jsonl").write_text("".join(json.dumps(cell) + "\n" for cell in cells))
        text = self.svg("pareto", "later", "--error", "outline.p95")
        self.shows(text, "Outline agreement (pixels)")
        self.shows(text, "higher is better")
        self.shows(text, "Time of the draw (s), lower is better")
        self.shows(self.svg("pareto", "later", "--error", "error.depth.rms"), "Depth error, RMS (patch sides)")
        self.refused(["did you mean 'outline.p95'?"], "pareto", "later", "--error", "outline.p59")
        self.refused(["no numbers of 'outline.later'", "needs truth, motion"], "pareto", "later", "--error", "outline.later")
        (self.path / "later/run.json").write_text(json.dumps({**record, "figures": [{"path": "outline.p95"}]}))
        self.refused(["later/run.json: this is no list of figures"], "pareto", "later")

    def test_runs_and_exports_of_version_0_1_0_are_drawn_beside_those_of_this_one(self):
        old = PLOT.parents[1] / "tests/fixtures/version_0_1_0/all"
        self.assertIn('"params"', (old / "cells.jsonl").read_text())
        text = self.svg("pareto", str(old), "--filter", "max_steps>=16")
        self.shows(text, "UV error, p99 (texels)")
        text = self.svg("pareto", str(old), "run", "--filter", "technique=pom", "--filter", "heightmap=bricks")
        self.shows(text, "pom")
        header = "cell,technique,status,time.draw.median_ms,error.uv_texels.p99"
        (self.path / "old_parameters.csv").write_text(f"{header},params.max_steps\npom | ,pom,ok,1,1,8\n")
        (self.path / "new_parameters.csv").write_text(f"{header},parameters.max_steps\npom | ,pom,ok,2,1,16\n")
        cells = self.script.read_cells([str(self.path / f"{name}_parameters.csv") for name in ("old", "new")], self.declared())
        self.assertEqual(list(cells["parameters.max_steps"]), [8, 16])
        self.assertNotIn("params.max_steps", cells.columns)

    def test_a_figure_is_named_in_one_place(self):
        paths = self.declared()
        scripts = sorted(PLOT.parent.glob("*.py"))
        self.assertGreater(len(scripts), 5)
        for script in scripts:
            text = script.read_text()
            named = [path for path in paths if path in text or paths[path]["label"] in text and " " in paths[path]["label"]]
            if script.name != "plotted_figures.py":
                self.assertEqual(named, [], script.name)

    def test_bad_input_ends_with_a_message(self):
        self.refused(["none.csv", "No such file"], "pareto", "none.csv")
        self.refused(["images is no run's folder", "run.json"], "pareto", "images")
        self.refused(["no column 'cell'", "reliefbench export --format csv"], "pareto", "plot.json")
        self.refused(["'time.speed'", "short names: ms"], "pareto", "cells.csv", "--cost", "time.speed")
        self.refused(["did you mean 'error.depth.max'?"], "pareto", "cells.csv", "--error", "error.depht.max")
        self.refused(["no numbers of 'motion.texels.mean'"], "pareto", "cells.csv", "--error", "motion")
        self.refused(["did you mean 'error.shadow.mean'?"], "pareto", "run", "--error", "error.shadow.maen")
        self.refused(["no cell is left", "30"], "pareto", "cells.csv", "--filter", "view_angle=45")
        self.refused(["no axis or parameter 'angle'", "view_angle"], "pareto", "cells.csv", "--filter", "angle=45")
        self.refused(["name=value,value"], "pareto", "cells.csv", "--filter", "view_angle")
        self.refused(["expected one number"], "pareto", "cells.csv", "--filter", "view_angle>steep")
        self.refused(["one view angle"], "angle", "cells.csv", "--filter", "view_angle=60")

    def test_a_python_without_the_modules_is_told_apart_from_a_machine_without_them(self):
        def told(executable):
            code = (f"import runpy, sys; sys.modules['matplotlib'] = None; sys.executable = {executable!r}; "
                    f"runpy.run_path({str(PLOT)!r}, run_name='__main__')")
            return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True).stderr
        install = "apt install python3-matplotlib python3-pandas"
        self.assertEqual(told("/usr/bin/python3"), f"plot.py: /usr/bin/python3 has no module matplotlib. On Debian: {install}\n")
        self.assertEqual(told("/opt/other/python3"),
                         "plot.py: /opt/other/python3 has no module matplotlib. Debian's packages are for /usr/bin/python3: run "
                         f"scripts/plot.py itself or /usr/bin/python3 scripts/plot.py (where they are missing: {install})\n")

    def test_the_script_ends_with_a_message_and_a_code(self):
        outcome = subprocess.run([PLOT, "pareto", "cells.csv", "-o", "front.gif"], cwd=self.path, capture_output=True,
                                 text=True)
        self.assertEqual((outcome.returncode, outcome.stdout), (2, ""))
        self.assertEqual(outcome.stderr, "plot.py: --output front.gif: expected a file that ends in .pdf, .svg, .png\n")


if __name__ == "__main__":
    RELIEFBENCH = Path(sys.argv.pop(1)).resolve()
    unittest.main()
