#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""explain --method as a user runs it, against the pictures of render --method."""
import json
import random
import sys
import unittest

sys.dont_write_bytecode = True
from program import PUBLIC, SCENES, Program, png_pixels

TEAPOT = SCENES / "teapot.obj"
# A method of each row.
METHODS = ("line_dda", "walk_closed", "edge_float_cross", "hack_incremental_float",
           "fill_draw_ties", "plane_float", "bary_area_float", "offscreen_float",
           "scaled_float_strict", "tiled_8", "table_n8", "micropolygons", "parity_closed",
           "decompose_fan", "shade_affine", "project_fovy", "clip_none", "halfspace_s4")


class ExplainMethod(Program):
    REASONS = ["clipped", "outside", "tie_lost", "false_hit", "double", "missed", "gap", "behind",
               "covers"]
    MISTAKES = {"false_hit", "double", "missed", "gap"}

    def explain(self, *args):
        return json.loads(self.succeed("explain", *args, "--json").stdout)

    def quad(self):
        case = self.out / "quad.tcov"
        case.write_text("TCOV 1 1\ncase 0 t 8 8 2 0 0 0\n0 0 2048 0 0 2048\n"
                        "2048 0 2048 2048 0 2048\n")
        return case

    def check(self, told):
        self.assertEqual(list(told["counts"]), self.REASONS)
        self.assertEqual(sum(told["counts"].values()), told["triangles"])
        accounts = told["accounts"]
        self.assertEqual([a["triangle"] for a in accounts], list(range(told["triangles"])))
        for key in ("hits", "owns"):
            self.assertEqual(sum(a[key] for a in accounts), told[key])
        showing = [a["triangle"] for a in accounts if a["shows"]]
        self.assertEqual(showing, [] if told["winner"] is None else [told["winner"]])
        for a in accounts:
            self.assertEqual(a["mistake"], a["reason"] in self.MISTAKES)
            if not a["mistake"]:
                self.assertEqual(a["hits"], a["owns"], a)

    def test_colour_is_that_of_render_at_random_pixels_for_every_row(self):
        listed = {m["name"]: m for m in json.loads(self.succeed("methods", "--json").stdout)}
        self.assertEqual({listed[name]["row"] for name in METHODS}, set(range(1, 19)))
        rng, shown = random.Random(91), 0
        width, height = 96, 72
        for name in METHODS:
            png = self.out / "p.png"
            scene = (TEAPOT, "--size", f"{width}x{height}", "--method", name)
            self.succeed("render", *scene, "--out", png)
            rows = png_pixels(png)
            for _ in range(5):
                x, y = rng.randrange(25, width - 25), rng.randrange(25, height - 22)
                told = self.explain(scene[0], x, y, *scene[1:])
                self.check(told)
                self.assertEqual(told["pixel_color"], list(rows[y][3 * x:3 * x + 3]),
                                 f"{name} ({x}, {y})")
                self.assertEqual(told["winner"] is not None,
                                 listed[name]["attributes"] and told["hits"] > 0, name)
                shown += told["hits"] > 0
        self.assertGreater(shown, 50, "nearly every pixel was background")

    def test_the_design_as_a_method_has_the_winner_of_explain(self):
        rng, shown = random.Random(92), 0
        for _ in range(12):
            at = (TEAPOT, rng.randrange(25, 70), rng.randrange(25, 50), "--size", "96x72")
            winner = self.explain(*at)["winner"]
            told = self.explain(*at, "--method", "halfspace_s8")
            self.assertEqual(told["winner"], winner, str(at))
            self.assertFalse([a for a in told["accounts"] if a["mistake"]], str(at))
            shown += winner is not None
        self.assertGreater(shown, 5)

    def test_without_a_tie_rule_a_shared_edge_is_a_gap_or_a_double(self):
        case = self.quad()
        for name, counts, line in (
                ("edge_double_strict", (1, 0, 0, 1), "triangle 1: gap"),
                ("edge_float_inclusive", (0, 1, 1, 0), "triangle 0: double"),
                ("edge_fixed_s8", (1, 0, 1, 0), "triangle 1: covers")):
            told = self.explain(case, 2, 5, "--method", name)
            self.check(told)
            self.assertEqual(tuple(told["counts"][reason] for reason in
                                   ("tie_lost", "double", "covers", "gap")), counts, name)
            self.assertEqual(told["accounts"][1]["pieces"][0]["exact"], "tie_won")
            text = self.succeed("explain", case, 2, 5, "--method", name).stdout
            self.assertIn("\n" + line, text)
            self.assertRegex(text, r"edge 2 +left +exact +0 +method +0.* (passes|fails)  tie\n")
        edge = told["accounts"][0]["pieces"][0]["edges"][1]
        self.assertEqual(edge, {"exact": 0, "kind": "other", "raw": 0, "biased": -2.0 ** -18,
                                "passes": False})

    def test_text_has_mistakes_first_and_all_when_asked(self):
        at = (TEAPOT, 270, 200, "--method", "walk_closed")
        near = self.succeed("explain", *at).stdout
        self.assertRegex(near, r"px\^2, inside positive\n\ntriangle \d+: double")
        self.assertIn("\ntriangle 136: covers", near)
        every = self.succeed("explain", *at, "--all").stdout
        self.assertEqual(every.count("\ntriangle "), 992)
        self.assertLess(near.count("\ntriangle "), 10)

    def test_close_camera_clips(self):
        for name in ("walk_closed", "clip_guard_band", "line_exact", "parity_exact"):
            told = self.explain(TEAPOT, 50, 40, "--size", "100x80", "--eye", "0,1,2",
                                "--target", "0,1,0", "--method", name)
            self.check(told)
            self.assertGreater(told["counts"]["clipped"], 0, name)

    def test_bad_options(self):
        at = ("explain", TEAPOT, 1, 1, "--method")
        self.refuse("HS070", *at, "nonsense", says="halfspace methods lists them")
        self.refuse("HS070", "explain", self.out / "none.obj", 1, 1, "--method", "nonsense")
        for other in (("--sample", 0), ("--samples", 4), ("--cull", "back"),
                      ("--depth-test", "less")):
            self.refuse("HS001", *at, "walk_closed", *other, says=other[0])
        self.refuse("HS080", "explain", TEAPOT, 640, 0, "--method", "walk_closed")
        self.refuse("HS080", "explain", TEAPOT, 0, -1, "--method", "walk_closed")
        self.refuse("HS001", "explain", PUBLIC, 1, 1, "--method", "walk_closed", says="--case")
        self.refuse("HS010", "explain", self.out / "n.obj", 1, 1, "--method", "walk_closed")


if __name__ == "__main__":
    unittest.main()
