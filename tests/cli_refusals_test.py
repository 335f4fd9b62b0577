#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What every subcommand refuses: numbers that are none, outputs that would replace each other,
scenes that show nothing. One line, status 2, and no file."""
import os
import pathlib
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["HALFSPACE"]
TESTS = pathlib.Path(os.environ["HALFSPACE_TESTS"])
TEAPOT = TESTS / "scenes/teapot.obj"
AWAY = ("--size", "64x48", "--eye", "0,0,100", "--target", "0,0,200")


class Refusals(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.out = pathlib.Path(self.folder.name)

    def tearDown(self):
        self.folder.cleanup()

    def refused(self, code, *args):
        done = subprocess.run([PROGRAM, *map(str, args)], capture_output=True, text=True,
                              timeout=120, cwd=self.out)
        self.assertEqual(done.returncode, 2, (args, done.stdout, done.stderr))
        self.assertRegex(done.stderr, rf"^halfspace: error\[{code}\]: [^\n]+\n$", args)
        self.assertEqual(list(self.out.iterdir()), [], args)

    def test_numbers_that_no_option_means(self):
        for args in (("vectors", "--generate", "all", "--count", "-1", "--out", "a.csv"),
                     ("vectors", "--generate", "all", "--count", "0", "--out", "a.csv"),
                     ("vectors", "--generate", "all", "--seed", "-1", "--out", "a.csv"),
                     ("cosim", TEAPOT, "--seed", "99999999999999999999"),
                     ("fit", TEAPOT, "--out", "a.json", "--max-error", "nan"),
                     ("render", TEAPOT, "--out", "a.png", "--simplify", "inf"),
                     ("render", TEAPOT, "--out", "a.png", "--fov", "0"),
                     ("render", TEAPOT, "--out", "a.png", "--ortho", "-1"),
                     ("render", TEAPOT, "--out", "a.png", "--samples", "0")):
            self.refused("HS001", *args)

    def test_outputs_that_would_replace_each_other(self):
        tcov = TESTS / "data/public.tcov"
        for args in (("render", TEAPOT, "--out", "a.png", "--stats", "./a.png"),
                     ("coverage", tcov, "--out", "a.tcov", "--stats", "a.tcov"),
                     ("vectors", "--generate", "all", "--out", "a.csv", "a.csv"),
                     ("render", TEAPOT, "--out", "")):
            self.refused("HS001", *args)

    def test_views_that_show_nothing(self):
        self.refused("HS041", "report", TEAPOT, *AWAY, "--out", "page")

    def test_vectors_that_have_their_own_configuration(self):
        self.refused("HS001", "vectors", "--from", TESTS / "vectors/tiny.hsv", "--config", "full",
                     "--out", "a.csv")

    def test_output_that_takes_no_more_is_no_bug(self):
        with open("/dev/full", "w") as full:
            done = subprocess.run([PROGRAM, "methods"], stdout=full, stderr=subprocess.PIPE,
                                  text=True, timeout=60)
        self.assertEqual(done.returncode, 2)
        self.assertIn("error[HS030]", done.stderr)


if __name__ == "__main__":
    unittest.main()
