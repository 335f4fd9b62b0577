#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""explain, stability, chart and report as a user runs them."""
import json
import os
import random
import re
import signal
import subprocess
import sys
import time
import unittest

sys.dont_write_bytecode = True
from program import PROGRAM, PUBLIC, SCENES, Program, png_pixels


class Explain(Program):
    REASONS = {"clipped", "zero_area", "culled", "no_sample", "outside_box", "outside_edge",
               "tie_lost", "behind", "covers"}

    def explain(self, *args):
        return json.loads(self.succeed("explain", *args, "--json").stdout)

    def check(self, told):
        self.assertEqual(set(told["counts"]), self.REASONS)
        self.assertEqual(sum(told["counts"].values()), told["triangles"])
        self.assertEqual([a["triangle"] for a in told["accounts"]], list(range(told["triangles"])))
        winners = [a["triangle"] for a in told["accounts"] if a["reason"] == "covers"]
        self.assertEqual(winners, [] if told["winner"] is None else [told["winner"]])

    def test_colour_is_the_pictures_at_random_pixels(self):
        rng = random.Random(81)
        for scene in ("teapot.obj", "cube.gltf", "knot.stl", "torus.ply"):
            for size in ((96, 64), (250, 180)):
                for samples in (1, 4):
                    options = (SCENES / scene, "--size", "%dx%d" % size, "--samples", samples)
                    png = self.out / "p.png"
                    self.succeed("render", *options, "--out", png)
                    rows = png_pixels(png)
                    for _ in range(4):
                        x, y = rng.randrange(size[0]), rng.randrange(size[1])
                        sample = rng.randrange(samples)
                        told = self.explain(options[0], x, y, *options[1:], "--sample", sample)
                        self.check(told)
                        self.assertEqual(told["pixel_color"], list(rows[y][3 * x:3 * x + 3]),
                                         f"{scene} {size} {samples} ({x}, {y})")

    def test_close_camera_clips_and_culling_culls(self):
        told = self.explain(SCENES / "teapot.obj", 50, 40, "--size", "100x80", "--eye", "0,1,2",
                            "--target", "0,1,0", "--cull", "front")
        self.check(told)
        self.assertGreater(told["counts"]["clipped"], 0)
        self.assertGreater(told["counts"]["culled"], 0)

    def test_depth_test_decides_between_equal_depths(self):
        case = self.out / "two.tcov"
        case.write_text("TCOV 1 1\ncase 0 t 8 8 2 0 0 0\n0 0 2048 0 0 2048\n0 0 2048 0 0 2048\n")
        first = self.explain(case, 1, 1)
        self.assertEqual((first["winner"], first["accounts"][1]["pieces"][0]["behind"]), (0, 0))
        last = self.explain(case, 1, 1, "--depth-test", "less_equal")
        self.assertEqual((last["winner"], last["accounts"][0]["pieces"][0]["behind"]), (1, 1))

    def test_a_sample_on_a_shared_edge_has_one_owner(self):
        case = self.out / "quad.tcov"
        case.write_text("TCOV 1 1\ncase 0 t 8 8 2 0 0 0\n0 0 2048 0 0 2048\n"
                        "2048 0 2048 2048 0 2048\n")
        told = self.explain(case, 2, 5)
        self.assertEqual((told["counts"]["covers"], told["counts"]["tie_lost"]), (1, 1))
        self.assertEqual(told["accounts"][0]["pieces"][0]["decided_by_edges"], [1])
        edge = told["accounts"][0]["pieces"][0]["edges"][1]
        self.assertEqual((edge["raw"], edge["biased"], edge["kind"]), (0, -1, "other"))
        text = self.succeed("explain", case, 2, 5).stdout
        self.assertIn("tie lost on edge 1", text)
        self.assertIn("tie won on edge 2", text)

    def test_text_names_all_when_asked(self):
        near = self.succeed("explain", SCENES / "cube.gltf", 320, 240).stdout
        every = self.succeed("explain", SCENES / "cube.gltf", 320, 240, "--all").stdout
        self.assertEqual(every.count("\ntriangle "), 12 + 1)
        self.assertLess(near.count("\ntriangle "), 12)

    def test_bad_pixels_and_samples(self):
        teapot = SCENES / "teapot.obj"
        for x, y in (("640", "0"), ("0", "480"), ("-1", "0"), ("0", "-1"), ("a", "0"), ("1.5", "0"),
                     ("99999999999", "0")):
            self.refuse("HS080", "explain", teapot, x, y)
        self.refuse("HS081", "explain", teapot, 1, 1, "--sample", 1)
        self.refuse("HS081", "explain", teapot, 1, 1, "--samples", 4, "--sample", -1)
        self.refuse("HS001", "explain", PUBLIC, 1, 1, says="--case")
        self.refuse("HS001", "explain", teapot, 1)
        self.refuse("HS010", "explain", self.out / "none.obj", 1, 1)


class Stability(Program):
    def test_a_cell_says_how_much_is_wrong_and_how(self):
        data = self.out / "s.json"
        self.succeed("stability", "--method", "halfspace_s8", "--method", "walk_closed",
                     "--suite", "scanline", "--out", data)
        told = json.loads(data.read_text())
        right, wrong = told["cells"]
        self.assertEqual((right["method"], right["wrong_ppm"]), ("halfspace_s8", 0))
        self.assertGreater(wrong["wrong_ppm"], 1000)
        case = wrong["cases"][0]
        self.assertEqual(case["wrong"], case["gaps"] + case["doubles"])
        table = self.succeed("stability", "--method", "walk_closed", "--suite", "scanline").stdout
        self.assertIn("walk_closed", table)

    def test_order_dependence_is_marked(self):
        data = self.out / "s.json"
        self.succeed("stability", "--method", "bary_area_float", "--suite", "order", "--out", data)
        self.assertEqual(json.loads(data.read_text())["cells"][0]["marks"], ["order"])

    def test_the_worst_case_is_a_picture(self):
        png = self.out / "w.png"
        said = self.succeed("stability", "--explain", "edge_double_strict/shared_edges",
                            "--picture", png).stdout
        self.assertIn("22 of 64 pixels wrong", said)
        missing = sum(row[i:i + 3] == bytearray((214, 44, 160)) for row in png_pixels(png)
                      for i in range(0, len(row), 3))
        self.assertGreater(missing, 22 * 30)  # 9 x 9 each, less the outlines

    def test_every_suite_is_listed(self):
        listed = self.succeed("stability", "--list").stdout
        for name in ("shared_edges", "slivers", "offsets", "w_to_zero", "perspective"):
            self.assertIn(name, listed)

    def test_bad_options(self):
        png = self.out / "w.png"
        self.refuse("HS082", "stability", "--suite", "none", says="--suite")
        self.refuse("HS082", "stability", "--method", "none", says="--method")
        self.refuse("HS082", "stability", "--explain", "none/slivers", "--picture", png)
        self.refuse("HS082", "stability", "--explain", "line_dda/slivers", "--picture", png,
                    says="takes lines")
        self.refuse("HS001", "stability", "--explain", "walk_closed", "--picture", png)
        self.refuse("HS001", "stability", "--explain", "walk_closed/slivers")
        self.refuse("HS001", "stability", "--picture", png)
        self.refuse("HS030", "stability", "--out", self.out / "no" / "s.json")


class Chart(Program):
    SCENE = (SCENES / "cube.gltf", "--size", "96x72")

    def test_each_chart_is_measured_on_a_scene(self):
        names = [line.split()[0] for line in
                 self.succeed("chart", "--list").stdout.splitlines()]
        self.assertGreaterEqual(len(names), 7)
        for name in set(names) - {"stability", "methods"}:
            data = self.out / f"{name}.json"
            self.succeed("chart", name, "--scene", *self.SCENE, "--out", data)
            self.assertEqual(json.loads(data.read_text())["chart"], name)

    def test_the_ladder_has_the_engine_that_render_uses(self):
        data = self.out / "ladder.json"
        self.succeed("chart", "ladder", "--scene", *self.SCENE, "--out", data)
        rows = json.loads(data.read_text())["levels"]
        self.assertEqual([(r["level"], r["engine"]) for r in rows],
                         [("coverage", "coverage engine"), ("bit", "frame engine"),
                          ("bit", "plain stages"), ("cycle", "cycle engine"), ("rtl", "Verilator")])
        self.assertEqual({r["coverage"] for r in rows}, {"exact"})

    def test_triangles_that_the_geometry_stage_drops_are_not_measured(self):
        close = (SCENES / "teapot.obj", "--size", "100x80", "--eye", "0,1,2", "--target", "0,1,0")
        stats, data = self.out / "s.json", self.out / "c.json"
        self.succeed("render", *close, "--out", self.out / "p.png", "--stats", stats)
        self.succeed("chart", "efficiency", "--scene", *close, "--out", data)
        drawn = json.loads(stats.read_text())
        self.assertLess(drawn["triangles_to_setup"], drawn["triangles"] / 2)
        tile8 = json.loads(data.read_text())["tiles"][1]["total"]
        self.assertEqual((tile8["triangles"], tile8["tiles_tested"]),
                         (drawn["triangles_to_setup"], drawn["tiles_visited"]))

    def test_a_chart_is_drawn_where_matplotlib_is(self):
        svg = self.out / "a.svg"
        arguments = ("chart", "accumulator", "--scene", *self.SCENE, "--out", svg)
        if not CAN_DRAW:
            return self.refuse("HS083", *arguments)
        self.succeed(*arguments)
        self.assertIn("<svg", svg.read_text())
        self.assertEqual([p.name for p in self.out.iterdir()], ["a.svg"])

    def test_bad_options(self):
        out = self.out / "x.json"
        self.refuse("HS084", "chart", "none", "--out", out)
        self.refuse("HS084", "chart", "ladder", "--out", out)
        self.refuse("HS001", "chart", "subpixel", "--out", self.out / "x.txt")
        self.refuse("HS001", "chart", "subpixel")
        self.refuse("HS010", "chart", "subpixel", "--scene", self.out / "n.obj", "--out", out)
        self.refuse("HS041", "chart", "subpixel", "--scene", PUBLIC, "--out", out, says="--case")
        far = self.out / "far.tcov"
        far.write_text("TCOV 1 1\ncase 7 t 8 8 1 0 0 0\n0 0 2048 0 0 99999999\n")
        self.refuse("HS021", "chart", "subpixel", "--scene", far, "--out", out, says="case 7")
        self.refuse("HS083", "chart", "subpixel", "--out", self.out / "x.svg",
                    environment={**os.environ, "HALFSPACE_CHARTS": str(self.out / "no.py")})


CAN_DRAW = subprocess.run(["/usr/bin/python3", "-c", "import matplotlib"],
                          capture_output=True).returncode == 0


class Report(Program):
    def interrupted(self, ready, *args, group=True, environment=None):
        """What the program said, interrupted as soon as ready() holds."""
        run = subprocess.Popen([PROGRAM, *map(str, args)], stderr=subprocess.PIPE, text=True,
                               start_new_session=True, env=environment)
        while run.poll() is None and not ready():
            time.sleep(0.01)
        # Ctrl-C reaches every process of the group, kill only the one.
        (os.killpg if group else os.kill)(run.pid, signal.SIGINT)
        said = run.communicate(timeout=60)[1]
        self.assertEqual(run.returncode, 2, said)
        self.assertEqual(said.splitlines(),
                         ["halfspace: error[HS050]: interrupted; nothing was written"])

    def test_interrupted_leaves_nothing(self):
        folder = self.out / "new" / "report"
        arguments = ("report", SCENES / "teapot.obj", "--size", "160x120", "--out", folder)
        for name in ("picture.png", "hits.png", "tiles.png"):
            self.interrupted(lambda: any(self.out.glob(f"new/*/{name}")), *arguments)
            self.assertEqual(list(self.out.iterdir()), [], f"at {name}")
        # A report that is there stays as it is.
        folder.mkdir(parents=True)
        (folder / "index.html").write_text("the last one")
        self.interrupted(lambda: any(self.out.glob("new/*partial*/hits.png")), *arguments)
        self.assertEqual([p.name for p in folder.parent.iterdir()], ["report"])
        self.assertEqual([p.read_text() for p in folder.iterdir()], ["the last one"])

    @unittest.skipUnless(CAN_DRAW, "needs matplotlib")
    def test_interrupted_chart_is_not_drawn_later(self):
        script = self.out / "charts.py"
        script.write_text("import pathlib, sys, time\n"
                          "pathlib.Path(sys.argv[-1]).write_text('half')\n"
                          "time.sleep(1)\n"
                          "pathlib.Path(sys.argv[-1]).write_text('whole')\n")
        environment = {**os.environ, "HALFSPACE_CHARTS": str(script)}
        folder = self.out / "charts"
        folder.mkdir()
        for group in (True, False):
            self.interrupted(lambda: any(folder.glob("*.svg")), "chart", "accumulator", "--scene",
                             SCENES / "cube.gltf", "--size", "96x72", "--out", folder / "a.svg",
                             group=group, environment=environment)
            time.sleep(1.2)
            self.assertEqual(list(folder.iterdir()), [])

    def test_the_page_needs_only_the_files_beside_it(self):
        folder = self.out / "report"
        self.succeed("report", SCENES / "cube.gltf", "--size", "96x72", "--out", folder)
        page = (folder / "index.html").read_text()
        self.assertNotIn("http", page)
        for name in re.findall(r'src="([^"]+)"', page):
            self.assertTrue((folder / name).is_file(), name)
        for name in ("picture.png", "hits.png", "tiles.png"):
            self.assertIn(name, page)
        for words in ("What accuracy costs here", "Which level and configuration suffice",
                      "Where a weaker method would fail", "Statistics"):
            self.assertIn(words, page)
        # Curves where figures are to be compared, in the look of the page of `fit`.
        self.assertEqual(page.count("<svg"), 7)
        self.succeed("fit", SCENES / "cube.gltf", "--size", "96x72", "--report", self.out / "fit",
                     "--out", self.out / "c.json")
        style = re.search("<style>.*?</style>", page, re.S)[0]
        self.assertIn(style, (self.out / "fit/index.html").read_text())

    def test_bad_options(self):
        self.refuse("HS001", "report", SCENES / "cube.gltf")
        self.refuse("HS010", "report", self.out / "none.obj", "--out", self.out / "r")
        self.refuse("HS001", "report", PUBLIC, "--out", self.out / "r", says="--case")
        (self.out / "file").write_text("")
        self.refuse("HS030", "report", SCENES / "cube.gltf", "--out", self.out / "file")


if __name__ == "__main__":
    unittest.main()
