#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""docs/01_overview/tour.md is true: its commands run as written, and print what it says.

A block of ```sh is run; the block of ```text after it has lines of its output, in order. `./run` is
the program itself, in a folder with the repository's rtl/ and tests/. A block fails when a command
does, but for the one that ends in a mismatch. The numbers of setup's packet stand in the drawing.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import unittest

from program import PROGRAM, TESTS, Program

ROOT = TESTS.parent
PAGE = ROOT / "docs" / "01_overview" / "tour.md"
DRAWING = ROOT / "docs" / "03_design" / "triangle_setup.svg"
BLOCKS = re.findall(r"^```sh\n(.*?)^```\n(?:\s*^```text\n(.*?)^```\n)?", PAGE.read_text(),
                    re.M | re.S)


class Tour(Program):
    def setUp(self):
        super().setUp()
        shutil.copytree(ROOT / "rtl", self.out / "rtl")  # a link would let the tour break it
        (self.out / "tests").symlink_to(TESTS)
        run = self.out / "run"
        run.write_text(f'#!/bin/sh\nexec "{PROGRAM}" "$@"\n')
        run.chmod(0o755)
        self.environment = dict(os.environ)
        if shutil.which("ccache"):
            self.environment.setdefault("CXX", "ccache c++")

    def walk(self, commands, lines):
        done = subprocess.run(["bash", "-c", commands], cwd=self.out, text=True, timeout=500,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              env=self.environment)
        self.assertEqual(done.returncode, int("mismatch" in lines), done.stdout)
        printed = iter(line.rstrip() for line in done.stdout.splitlines())
        for line in lines.splitlines():
            self.assertIn(line, printed, f"{commands}\nprinted, in that order or not at all:\n"
                                         f"{done.stdout}")

    def test_every_command_prints_what_the_page_says(self):
        self.assertGreaterEqual(len(BLOCKS), 8)
        for commands, lines in BLOCKS:
            with self.subTest(commands):
                self.walk(commands, lines)
        packet = json.loads((self.out / "out" / "setup.jsonl").read_text().splitlines()[-1])
        drawn = re.findall(r">(-?\d+)</text>", DRAWING.read_text())
        for edge in range(3):
            for field in (f"slope{edge}.a", f"slope{edge}.b", f"e{edge}"):
                self.assertIn(str(packet[field]), drawn, field)


if __name__ == "__main__":
    unittest.main()
