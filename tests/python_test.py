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

    def test_clip_space_is_projected_and_cut(self):
        model = halfspace.Model("full")
        model.begin_frame(64, 48)
        # Half of the picture: clip space's left half, drawn by two triangles far beyond its sides.
        left = np.array([[[-3, -1.5, 0, 1], [0, -1.5, 0, 1], [-3, 1.5, 0, 1]],
                         [[0, -1.5, 0, 1], [0, 1.5, 0, 1], [-3, 1.5, 0, 1]]])
        model.push_clip(left, tag=7)
        np.testing.assert_array_equal(model.hits(), np.repeat([[1] * 32 + [0] * 32], 48, axis=0))
        self.assertEqual(set(model.pull_tiles()["tag"]), {7, 8})
        self.assertEqual(model.stats()["triangles"], 2)
        self.assertTrue((model.color()[:, :32] == 255).all(), "white without values")
        for values in (np.broadcast_to([10.0, 20.0, 30.0], (2, 3, 3)),
                       np.broadcast_to([10, 20, 30, 40], (2, 3, 4))):
            model.reset()
            self.assertEqual(model.hits().sum(), 0)
            model.push_clip(left, values)
            self.assertTrue((model.color()[:, :32] == [10, 20, 30]).all())
        np.testing.assert_array_equal(model.depth()[:, :32], model.depth()[0, 0])
        for bad in (left[:, :, :3], left[:, :2], np.zeros(4)):
            with self.assertRaisesRegex(ValueError, "positions"):
                model.push_clip(bad)
        for bad in (np.zeros((1, 3, 3)), np.zeros((2, 3, 9)), np.zeros((2, 2, 3))):
            with self.assertRaisesRegex(ValueError, "values"):
                model.push_clip(left, bad)

    def test_shaded_vertices_and_their_fragments(self):
        model = halfspace.Model("msaa4")
        widths = model.config
        model.begin_frame(16, 16, fragments=True, depth_test="less")
        xy = np.array([[[0, 0], [16, 0], [0, 16]]]) * 256
        w = np.full((1, 3), 1 << (widths["inverse_w_bits"] - 1))
        colour = np.broadcast_to(np.array([200, 100, 50]) * 256, (1, 3, 3))
        for depth, tag in ((2000, 1), (3000, 2), (1000, 3)):
            model.push_shaded(xy, np.full((1, 3), depth * 64), w, colour, tag=tag)
        fragments = model.pull_fragments()
        self.assertEqual(set(fragments["tag"]), {1, 3}, "the second is behind the first")
        self.assertEqual(len(model.pull_fragments()), 0)
        self.assertEqual(len(fragments), 2 * (model.hits() != 0).sum() - 0)
        self.assertTrue((fragments["color"] == [200, 100, 50]).all())
        self.assertTrue((fragments["passed"] & ~fragments["covered"] == 0).all())
        first = fragments[fragments["tag"] == 1]
        for sample in range(4):
            inside = first["passed"] >> sample & 1 == 1
            self.assertTrue((first["depth"][inside, sample] == 2000).all())
            self.assertTrue((first["depth"][~inside, sample] == 0).all())
        self.assertEqual(set(np.unique(model.depth())), {1000, 2**24 - 1})
        for wrong in ({"depth": np.full((1, 3), 2**31)}, {"inverse_w": np.zeros((1, 3), int)},
                      {"xy": xy + 2**40}, {"values": np.full((1, 3, 3), 65281)},
                      {"depth": np.zeros((2, 3), int)}):
            given = {"xy": xy, "depth": np.zeros((1, 3), int), "inverse_w": w, "values": colour}
            with self.assertRaises(ValueError):
                model.push_shaded(**{**given, **wrong})
        with self.assertRaises(TypeError):
            model.push_shaded(xy, np.zeros((1, 3)), w, colour)

    def test_a_scene_has_the_programs_camera(self):
        def hits(**camera):
            model = halfspace.Model("full")
            model.begin_frame(160, 120)
            model.draw_scene(str(SCENES / "teapot.obj"), **camera)
            return model.hits(), model.color()

        program = os.environ["HALFSPACE"]
        for camera in ({"eye": (0, 2, 9), "target": (0, 1, 0), "fov": 30},
                       {"up": (1, 1, 0), "ortho": 6}, {"flat": True}):
            words = []
            for name, value in camera.items():
                text = ",".join(map(str, value)) if isinstance(value, tuple) else str(value)
                words += ["--shade", "flat"] if name == "flat" else [f"--{name}", text]
            with tempfile.TemporaryDirectory() as folder:
                stats = pathlib.Path(folder) / "s.json"
                subprocess.run([program, "render", SCENES / "teapot.obj", "--size", "160x120",
                                *words, "--out", pathlib.Path(folder) / "t.png", "--stats", stats],
                               check=True, timeout=120)
                crc = json.loads(stats.read_text())["coverage_crc32"]
            self.assertEqual(zlib.crc32(hits(**camera)[0].tobytes()), crc, camera)
        self.assertFalse((hits(flat=True)[1] == hits()[1]).all())

    def test_the_stall_pattern_is_the_models(self):
        model = halfspace.Model("tiny")
        model.begin_frame(64, 64, stall=0.5, seed=3)
        model.push(self.triangles(1)[:, :, :] % 256)
        self.assertEqual(model.triangle_clocks()["accepted"][0], halfspace.stall_gap(0.5, 3, 0))
        self.assertEqual({halfspace.stall_ready(0.5, 3, c) for c in range(50)}, {False, True})
        self.assertTrue(all(halfspace.stall_ready(0, 3, c) for c in range(50)))

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
