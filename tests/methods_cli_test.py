#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""halfspace methods, and render --method, as a user runs them."""
import json
import sys
import unittest

sys.dont_write_bytecode = True
from program import PUBLIC, SCENES, TESTS, Program

TEAPOT = SCENES / "teapot.obj"


class Methods(Program):
    def draw(self, *args):
        """The picture's bytes and the CRC of its hit counts."""
        png, stats = self.out / "p.png", self.out / "p.json"
        self.succeed("render", *args, "--out", png, "--stats", stats)
        return png.read_bytes(), json.loads(stats.read_text())["coverage_crc32"]

    def methods(self):
        return json.loads(self.succeed("methods", "--json").stdout)

    def test_lists_eighteen_rows_with_every_field(self):
        listed = self.methods()
        self.assertEqual({m["row"] for m in listed}, set(range(1, 19)))
        for m in listed:
            for key in ("name", "title", "input", "rule", "precision", "complexity", "use",
                        "source"):
                self.assertTrue(m[key], f"{m['name']}: {key}")
            self.assertIn(f"`{m['name']}`", (TESTS.parent / m["page"]).read_text())
        text = self.succeed("methods").stdout
        for m in listed:
            self.assertIn(m["name"] + " ", text)

    def test_every_method_draws_the_teapot_and_every_row_a_case(self):
        drawn, rows = set(), set()
        for m in self.methods():
            scenes = [(TEAPOT, "--size", "96x72")]
            if m["row"] not in rows:
                scenes.append((PUBLIC, "--case", "0"))
            rows.add(m["row"])
            for scene in scenes:
                png, crc = self.draw(*scene, "--method", m["name"])
                self.assertEqual(png[:8], b"\x89PNG\r\n\x1a\n", m["name"])
                drawn.add((scene, crc))
        # Exact and inexact methods differ, but a blank picture would be one CRC for all.
        self.assertGreater(len(drawn), 4)

    def test_pipeline_as_a_method_is_the_pipeline(self):
        scene = (TEAPOT, "--size", "160x120")
        right = self.draw(*scene)
        self.assertEqual(self.draw(*scene, "--method", "halfspace_s8"), right)
        # The exact methods count the same hits, whatever they are made of.
        for name in ("edge_fixed_s8", "walk_exact", "tiled_16", "table_exact", "warnock",
                     "parity_exact", "shade_perspective", "project_glm"):
            self.assertEqual(self.draw(*scene, "--method", name)[1], right[1], name)

    def test_refuses_what_a_method_cannot_do(self):
        out = self.out / "x.png"
        for code, args in (("HS070", ("--method", "nonsense")),
                           ("HS071", ("--method", "line_dda", "--shade", "depth")),
                           ("HS071", ("--method", "shade_affine", "--shade", "tiles")),
                           ("HS001", ("--method", "line_dda", "--level", "bit"))):
            self.refuse(code, "render", TEAPOT, "--out", out, *args)


if __name__ == "__main__":
    unittest.main()
