#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The Python module: arrays of the right shape and kind, holding what the model drew."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest
import zlib

import halfspace
import numpy as np

SCENES = pathlib.Path(os.environ["HALFSPACE_TESTS"]) / "scenes"
SEED = 20261122


def inside(triangle, width, height):
    """Pixels whose centre is strictly inside, in exact integers: 1/512 px."""
    (x0, y0), (x1, y1), (x2, y2) = (2 * np.asarray(triangle, dtype=np.int64)).tolist()
    x = np.arange(width, dtype=np.int64)[None, :] * 512 + 256
    y = np.arange(height, dtype=np.int64)[:, None] * 512 + 256
    edges = [(bx - ax) * (y - ay) - (by - ay) * (x - ax)
             for ax, ay, bx, by in ((x0, y0, x1, y1), (x1, y1, x2, y2), (x2, y2, x0, y0))]
    return np.all([e > 0 for e in edges], axis=0) | np.all([e < 0 for e in edges], axis=0)


class Python(unittest.TestCase):
    def triangles(self, count=200):
        # Odd subpixels: no edge of two odd ends passes a centre often, and ties are left out below.
        return np.random.default_rng(SEED).integers(0, 100 * 256, (count, 3, 2)) | 1

    def test_hits_are_the_pixels_inside(self):
        model = halfspace.Model("full")
        for triangle in self.triangles(50):
            model.begin_frame(100, 80)
            model.push(triangle)
            strictly = inside(triangle, 100, 80)
            hits = model.hits()
            self.assertEqual((hits.shape, hits.dtype), ((80, 100), np.uint8))
            self.assertTrue((hits[strictly] == 1).all(), f"seed {SEED}: {triangle}")
            extra = np.argwhere((hits != 0) & ~strictly)
            self.assertLess(len(extra), 3, "beyond those inside, only centres on an edge")

    def test_depth_is_tested_and_cleared_as_asked(self):
        model = halfspace.Model("full")
        for test, drawn in (("less", True), ("greater", False), ("never", False),
                            ("not_equal", True)):
            model.begin_frame(16, 16, depth_test=test, depth_clear=(1 << 24) - 1,
                              scissor=(4, 0, 8, 16))
            model.push(np.array([[0, 0], [64, 0], [0, 64]]) * 256)
            self.assertEqual(int((model.color()[:, :, 0] != 0).sum()), 128 if drawn else 0, test)
            self.assertTrue((model.depth()[:, :4] == (1 << 24) - 1).all())
        with self.assertRaises(ValueError):
            model.begin_frame(16, 16, scissor=(9, 0, 8, 16))
        with self.assertRaises(ValueError):
            model.begin_frame(16, 16, depth_clear=1 << 24)

    def test_tiles_are_the_hits(self):
        for config in ("tiny", "full", "msaa4"):
            model = halfspace.Model(config)
            grid = model.config["grid"]
            model.begin_frame(101, 83, stall=0.2, seed=4)
            pixels = np.random.default_rng(SEED).uniform(0, 100, (300, 3, 2))
            model.push(pixels)
            tiles = model.pull_tiles()
            self.assertEqual(len(tiles), model.stats()["tiles_covered"])
            lanes = tiles["mask"][:, :, None] >> np.arange(grid * grid, dtype=np.uint64) & 1
            any_sample = lanes.any(axis=1).reshape(-1, grid, grid)
            counted = np.zeros((96, 112), dtype=int)
            for tile, covered in zip(tiles, any_sample):
                counted[tile["y"]:tile["y"] + grid, tile["x"]:tile["x"] + grid] += covered
            np.testing.assert_array_equal(counted[:83, :101], model.hits())
            self.assertTrue((np.diff(tiles["clock"].astype(np.int64)) > 0).all(), "one a clock")
            self.assertTrue((np.diff(tiles["triangle"].astype(np.int64)) >= 0).all(), "in order")
            accepted = model.triangle_clocks()["accepted"]
            self.assertEqual(len(accepted), 300)
            self.assertTrue((tiles["clock"] > accepted[tiles["triangle"]]).all())
            self.assertEqual(model.stats()["cycles"], max(tiles["clock"][-1], accepted[-1]) + 1)
            self.assertEqual(len(model.pull_tiles()), 0)

    def test_integers_are_subpixels_and_reals_are_pixels(self):
        hits = []
        for triangles in (self.triangles(), self.triangles() / 256.0,
                          self.triangles().astype(np.int32), self.triangles().astype(np.uint16)):
            model = halfspace.Model()
            model.begin_frame(100, 100)
            model.push(triangles)
            hits.append(model.hits())
        for other in hits[1:]:
            np.testing.assert_array_equal(hits[0], other)
        self.assertGreater(hits[0].sum(), 10000)

    def test_arrays_of_any_layout_are_read_alike(self):
        crc = set()
        source = self.triangles()
        for triangles in (source, np.asfortranarray(source), np.repeat(source, 2, axis=0)[::2],
                          source.tolist() and np.array(source.tolist())):
            model = halfspace.Model()
            model.begin_frame(100, 100)
            model.push(triangles)
            crc.add(model.stats()["coverage_crc32"])
        self.assertEqual(len(crc), 1)

    def test_scene_is_what_the_program_renders(self):
        program = os.environ["HALFSPACE"]
        with tempfile.TemporaryDirectory() as folder:
            stats = pathlib.Path(folder) / "s.json"
            subprocess.run([program, "render", SCENES / "bunny.obj", "--size", "640x480", "--level",
                            "cycle", "--out", pathlib.Path(folder) / "b.png", "--stats", stats],
                           check=True, timeout=120)
            told = json.loads(stats.read_text())
        model = halfspace.Model("full")
        model.begin_frame(640, 480)
        model.draw_scene(str(SCENES / "bunny.obj"))
        mine = model.stats()
        for key, value in mine.items():
            self.assertEqual(value, told[key], key)
        self.assertEqual(zlib.crc32(model.hits().tobytes()), told["coverage_crc32"])
        hit = model.hits() > 0
        self.assertTrue((model.depth()[~hit] == 2**24 - 1).all())
        self.assertTrue((model.depth()[hit] < 2**24 - 1).all())
        self.assertTrue((model.color()[~hit] == 0).all())
        self.assertTrue((model.color()[hit] > 0).any(axis=-1).all())

    def test_configuration_has_its_widths(self):
        self.assertEqual(halfspace.Model('{"preset": "full", "samples": 4}').config,
                         halfspace.Model("msaa4").config)
        config = halfspace.Model("tiny").config
        self.assertEqual((config["subpixel_bits"], config["vertex_bits"], config["snap"]),
                         (4, 15, "nearest_even"))

    def test_bad_input_is_refused_with_the_right_exception(self):
        for bad in ("teapot", "{", '{"samples": 3}'):
            with self.assertRaises(ValueError):
                halfspace.Model(bad)
        model = halfspace.Model("tiny")
        with self.assertRaisesRegex(RuntimeError, "hs_begin_frame"):
            model.push(np.zeros((1, 3, 2), dtype=int))
        for size in ((0, 5), (513, 5)):
            with self.assertRaises(ValueError):
                model.begin_frame(*size)
        model.begin_frame(32, 32, tiles=False, picture=False)
        for bad in (np.zeros((3, 3), dtype=int), np.zeros((2, 2, 3)), np.zeros(6, dtype=int),
                    np.full((1, 3, 2), 2**40), np.full((1, 3, 2), -1), np.full((1, 3, 2), np.nan)):
            with self.assertRaises(ValueError):
                model.push(bad)
        with self.assertRaises(TypeError):
            model.push(np.zeros((1, 3, 2), dtype=complex))
        with self.assertRaisesRegex(ValueError, "tag"):
            model.push(np.zeros((1, 3, 2), dtype=int), tag=1 << 16)
        for what in (model.depth, model.color, model.pull_tiles):
            with self.assertRaises(RuntimeError):
                what()
        with self.assertRaises(OSError):
            model.draw_scene("no_such.obj")
        with self.assertRaisesRegex(ValueError, "sideways"):
            model.begin_frame(8, 8, cull="sideways")
        self.assertEqual(model.stats()["triangles"], 0)


if __name__ == "__main__":
    unittest.main()
