#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What every subcommand refuses: numbers that are none, outputs that would replace each other,
scenes that show nothing. One line, status 2, and no file."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
from program import PROGRAM, TESTS, Program

TEAPOT = TESTS / "scenes/teapot.obj"
AWAY = ("--size", "64x48", "--eye", "0,0,100", "--target", "0,0,200")


class Refusals(Program):
    def test_numbers_that_no_option_means(self):
        for args in (("vectors", "--generate", "all", "--count", "-1", "--out", "a.csv"),
                     ("vectors", "--generate", "all", "--count", "0", "--out", "a.csv"),
                     ("vectors", "--generate", "all", "--seed", "-1", "--out", "a.csv"),
                     ("cosim", TEAPOT, "--seed", "99999999999999999999"),
                     ("fit", TEAPOT, "--out", "a.json", "--max-error", "nan"),
                     ("render", TEAPOT, "--out", "a.png", "--simplify", "inf"),
                     ("render", TEAPOT, "--out", "a.png", "--fov", "0"),
                     ("render", TEAPOT, "--out", "a.png", "--ortho", "-1"),
                     ("render", TEAPOT, "--out", "a.png", "--depth-clear", "1.01"),
                     ("render", TEAPOT, "--out", "a.png", "--depth-clear", "-0.5"),
                     ("render", TEAPOT, "--out", "a.png", "--depth-clear", "nan"),
                     ("render", TEAPOT, "--out", "a.png", "--samples", "0")):
            self.refuse("HS001", *args)

    def test_depth_tests_and_rectangles_that_are_none(self):
        render = ("render", TEAPOT, "--out", "a.png", "--size", "64x48")
        self.refuse("HS001", *render, "--depth-test", "nearer", says="greater_equal")
        self.refuse("HS001", "explain", TEAPOT, "1", "1", "--depth-test", "", says="empty")
        for text in ("1,2", "1,2,3,4", "0,0,64x48x", "0;0,64x48", "a,0,8x8", "0,0,99999999999x1"):
            self.refuse("HS001", *render, "--scissor", text, says="X,Y,WIDTHxHEIGHT")
        for text in ("0,0,65x48", "0,0,64x49", "-1,0,8x8", "64,0,1x1", "0,0,0x8", "8,8,-4x4",
                     "2147483647,0,1x1"):
            self.refuse("HS001", *render, "--scissor", text, says="64 x 48")
        for shade in ("coverage", "tiles"):
            self.refuse("HS001", *render, "--scissor", "0,0,8x8", "--shade", shade)
        self.refuse("HS001", *render, "--scissor", "0,0,8x8", "--method", "engine")

    def test_outputs_that_would_replace_each_other(self):
        tcov = TESTS / "data/public.tcov"
        for args in (("render", TEAPOT, "--out", "a.png", "--stats", "./a.png"),
                     ("coverage", tcov, "--out", "a.tcov", "--stats", "a.tcov"),
                     ("vectors", "--generate", "all", "--out", "a.csv", "a.csv"),
                     ("render", TEAPOT, "--out", "")):
            self.refuse("HS001", *args)

    def test_a_second_output_that_fails_leaves_no_first(self):
        tcov = TESTS / "data/public.tcov"
        small = ("render", TEAPOT, "--size", "64x48", "--out", "a.png", "--stats", "/dev/full")
        for args in (small, (*small, "--level", "cycle", "--trace", "a.json"),
                     ("coverage", tcov, "--out", "a.tcov", "--stats", "/dev/full"),
                     ("vectors", "--generate", "all", "--count", "3", "--config", "tiny", "--out",
                      "a.csv", "b.hsv", "--bench", "/proc/self")):
            self.refuse("HS030", *args)

    def test_cameras_without_a_direction(self):
        for args in (("--eye", "1,2,3", "--target", "1,2,3"), ("--up", "0,0,0"),
                     ("--eye", "1e200,0,0"), ("--ortho", "1", "--fov", "40"),
                     ("--target", "0,-1e101,0")):
            self.refuse("HS001", "render", TEAPOT, "--out", "a.png", *args)

    def test_options_that_would_do_nothing(self):
        vectors = TESTS / "vectors/tiny.hsv"
        for args in (("render", TEAPOT, "--case", "0", "--out", "a.png"),
                     ("explain", TEAPOT, "1", "1", "--case", "0"),
                     ("vectors", "--check", vectors, "--out", "a.csv"),
                     ("vectors", "--check", vectors, "--config", "tiny"),
                     ("vectors", "--bins", vectors, "--goal", "90"),
                     ("chart", "--list", "--out", "a.json"),
                     ("chart", "subpixel", "--size", "64x48", "--out", "a.json"),
                     ("stability", "--list", "--out", "a.json"),
                     ("stability", "--explain", "a/b", "--out", "a.json", "--picture", "a.png"),
                     ("config", "--derived", "--area"),
                     ("bench", "--mesh-out", "a.ply", "--out", "a.json")):
            self.refuse("HS001", *args)

    def test_files_without_a_case(self):
        with tempfile.TemporaryDirectory() as folder:
            empty = pathlib.Path(folder) / "empty.tcov"
            empty.write_text("TCOV 1 0\n")
            for args in (("render", empty, "--out", "a.png"),
                         ("coverage", empty, "--out", "a.tcov"),
                         ("explain", empty, "0", "0"),
                         ("report", empty, "--out", "page"),
                         ("chart", "subpixel", "--scene", empty, "--out", "a.json"),
                         ("fit", empty, "--out", "a.json")):
                self.refuse("HS041", *args)

    def test_configurations_that_say_a_thing_twice(self):
        with tempfile.TemporaryDirectory() as folder:
            twice = pathlib.Path(folder) / "twice.json"
            twice.write_text('{"samples": 1, "samples": 4}')
            self.refuse("HS003", "render", TEAPOT, "--config", twice, "--out", "a.png")

    def test_links_and_pipes_stay_what_they_are(self):
        draw = (PROGRAM, "render", TEAPOT, "--size", "64x48", "--out")
        (self.out / "link.png").symlink_to("real.png")
        subprocess.run([*draw, self.out / "link.png"], check=True, timeout=60)
        self.assertTrue((self.out / "link.png").is_symlink())
        picture = (self.out / "real.png").read_bytes()
        self.assertTrue(picture.startswith(b"\x89PNG"))

        (self.out / "stdout").symlink_to("/proc/self/fd/1")
        with open(self.out / "caught", "wb") as caught:
            subprocess.run([*draw, self.out / "stdout"], stdout=caught, check=True, timeout=60)
        self.assertTrue((self.out / "stdout").is_symlink())
        self.assertEqual((self.out / "caught").read_bytes(), picture)

        os.mkfifo(self.out / "pipe")
        with subprocess.Popen(["cat", self.out / "pipe"], stdout=subprocess.PIPE) as reader:
            subprocess.run([*draw, self.out / "pipe"], check=True, timeout=60)
            self.assertEqual(reader.communicate(timeout=60)[0], picture)

    def test_a_folder_in_the_way_keeps_the_rest_as_it_was(self):
        (self.out / "page/index.html").mkdir(parents=True)
        done = subprocess.run([PROGRAM, "report", TEAPOT, "--size", "64x48", "--out",
                               self.out / "page"], capture_output=True, text=True, timeout=300)
        self.assertEqual(done.returncode, 2)
        self.assertIn("error[HS030]", done.stderr)
        self.assertEqual(list((self.out / "page").iterdir()), [self.out / "page/index.html"])

    def test_views_that_show_nothing(self):
        self.refuse("HS041", "report", TEAPOT, *AWAY, "--out", "page")

    def test_vectors_that_have_their_own_configuration(self):
        self.refuse("HS001", "vectors", "--from", TESTS / "vectors/tiny.hsv", "--config", "full",
                     "--out", "a.csv")

    def test_output_that_takes_no_more_is_no_bug(self):
        with open("/dev/full", "w") as full:
            done = subprocess.run([PROGRAM, "methods"], stdout=full, stderr=subprocess.PIPE,
                                  text=True, timeout=60)
        self.assertEqual(done.returncode, 2)
        self.assertIn("error[HS030]", done.stderr)


if __name__ == "__main__":
    unittest.main()
