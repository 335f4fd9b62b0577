#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""explain, stability, chart and report as a user runs them."""
import json
import os
import pathlib
import random
import struct
import subprocess
import tempfile
import unittest
import zlib

PROGRAM = os.environ["HALFSPACE"]
TESTS = pathlib.Path(os.environ["HALFSPACE_TESTS"])
SCENES = TESTS / "scenes"
PUBLIC = TESTS / "data" / "public.tcov"


def png_pixels(path):
    """Rows of an 8-bit RGB PNG."""
    data = path.read_bytes()
    at, packed = 8, b""
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, depth, color = struct.unpack(">IIBB", body[:10])
            assert (depth, color) == (8, 2)
        if kind == b"IDAT":
            packed += body
        at += size + 12
    raw, stride = zlib.decompress(packed), 3 * width
    rows, above = [], bytearray(stride)
    for y in range(height):
        kind, line = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:][:stride])
        for i in range(stride):
            left = line[i - 3] if i >= 3 else 0
            corner = above[i - 3] if i >= 3 else 0
            distance = {c: abs(left + above[i] - corner - c) for c in (left, above[i], corner)}
            paeth = min((left, above[i], corner), key=lambda c: distance[c])
            line[i] = (line[i] + (0, left, above[i], (left + above[i]) // 2, paeth)[kind]) & 255
        rows.append(line)
        above = line
    return rows


class Program(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.out = pathlib.Path(self.folder.name)

    def tearDown(self):
        self.folder.cleanup()

    def run_program(self, *args):
        return subprocess.run([PROGRAM, *map(str, args)], capture_output=True, text=True,
                              timeout=300)

    def succeed(self, *args):
        done = self.run_program(*args)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def refuse(self, code, *args, says=""):
        """One line with the code, exit status 2, and no file left behind."""
        before = set(self.out.iterdir())
        done = self.run_program(*args)
        self.assertEqual(done.returncode, 2, f"{args}: {done.stderr}")
        self.assertRegex(done.stderr, rf"\Ahalfspace: error\[{code}\]: [^\n]+\n\Z", str(args))
        self.assertIn(says, done.stderr)
        self.assertEqual(set(self.out.iterdir()), before, "a file was left behind")


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


if __name__ == "__main__":
    unittest.main()
