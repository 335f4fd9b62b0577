#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The SystemVerilog scoreboard over DPI-C: passes on the RTL, fails on every faulty copy of it.

The faults are all in one build, each chosen by a plusarg; without one the copy must pass.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(os.environ["HALFSPACE_SOURCE"])
LIBRARY = os.environ["HALFSPACE_LIBRARY"]
PROGRAM = os.environ["HALFSPACE"]
RUN = ROOT / "testbench/dpi/run.py"

# file, line (unique in the file), what it becomes when `fault` is 1, what the scoreboard says
FAULTS = [
    ("hs_setup_edge.sv", "assign top_left = a_above || (a_zero5_q && b_above);",
     "assign top_left = a_above || (a_zero5_q && (b_above ^ fault));", "tile"),
    ("hs_setup_box.sv", "last6_q  <= last5_q;", "last6_q  <= fault ? last5_q ^ N'(1) : last5_q;",
     "tile"),
    ("hs_coverage.sv", "tag3_q    <= tile2.tag;",
     "tag3_q    <= tile2.tag ^ hs_pkg::TAG_BITS'(fault);", "tag"),
    ("hs_coverage.sv", "assign valid_o = valid_q[4] && covered4;",
     "assign valid_o = valid_q[4] && covered4 && !(fault && coverage4_q.x == hs_pkg::N'(8));",
     "tile"),
    ("hs_coverage.sv", "covered0 & covered1 & covered2 & box_mask;",
     "covered0 & covered1 & (covered2 | {Lanes{fault}}) & box_mask;", "tile"),
    ("hs_coverage.sv", "x3_q      <= tile2.node.x;",
     "x3_q      <= tile2.node.x ^ (fault ? hs_pkg::N'(Grid) : '0);", "model ("),
    ("hs_coverage.sv", "assign ready4 = !valid_q[4] || !covered4 || ready_i;",
     "assign ready4 = !valid_q[4] || (!covered4 && !fault) || ready_i;", "clock"),
    ("hs_fifo.sv", "assign ready_o   = !spare_valid_q;",
     "assign ready_o   = !spare_valid_q && !(fault && head_valid_q);", "tile"),
]


def faulty_copy(folder):
    shutil.copytree(ROOT / "rtl", folder)
    for number, (name, line, becomes, _) in enumerate(FAULTS):
        path = folder / name
        text = path.read_text()
        if text.count(line) != 1:
            raise AssertionError(f"{name} has {text.count(line)} lines '{line}'")
        text = text.replace(line, becomes.replace("fault", f"fault{number}"))
        head, tail = text.split(");\n", 1)  # the end of the ports
        declared = (f"  logic fault{number};\n"
                    f"  initial fault{number} = $test$plusargs(\"fault{number}_\") != 0;\n")
        path.write_text(f"{head});\n{declared}{tail}")


class Dpi(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.top = pathlib.Path(self.folder.name)

    def tearDown(self):
        self.folder.cleanup()

    def run_example(self, *options):
        return subprocess.run([sys.executable, RUN, *map(str, options), "--library", LIBRARY],
                              capture_output=True, text=True, timeout=600, check=False)

    def test_scoreboard_finds_the_rtl_of_full_equal(self):
        done = self.run_example("full", "--triangles", 400)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertRegex(done.stdout, r"seed 1, 800 triangles, \d{4,} tiles: bits and clocks")

    def test_scoreboard_names_the_tile_of_every_fault(self):
        faulty_copy(self.top / "rtl")
        options = ("tiny", "--rtl", self.top / "rtl", "--work", self.top / "work")
        done = self.run_example(*options)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertRegex(done.stdout, r"seed 1, 2000 triangles, \d{4,} tiles")
        for number, (name, _, becomes, word) in enumerate(FAULTS):
            with self.subTest(fault=number, file=name, line=becomes):
                run = subprocess.run([self.top / "work/scoreboard", f"+fault{number}_"],
                                     capture_output=True, text=True, timeout=60, check=False)
                told = run.stdout + run.stderr
                self.assertNotEqual(run.returncode, 0, told)
                self.assertRegex(told, r"scoreboard: (tile|triangle) \d+")
                self.assertIn(word, told)
        done = self.run_example(*options, "+fault0_")
        self.assertEqual(done.returncode, 1, "the command's own exit status")

    def test_any_viewport_and_frames_without_a_reset(self):
        """A frame smaller than the example's usual one, short edges, a guard band of its size."""
        for number, free in enumerate((
                {"preset": "tiny", "viewport_bits": 7},
                {"preset": "tiny", "viewport_bits": 5, "guard_bits": 5, "extent_bits": 3,
                 "samples": 2})):
            config = self.top / f"{number}.json"
            config.write_text(json.dumps(free))
            work = self.top / f"work{number}"
            done = self.run_example(config, "--program", PROGRAM, "--work", work,
                                    "--triangles", 300)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            again = subprocess.run([work / "scoreboard", "+triangles=300", "+no_reset"],
                                   capture_output=True, text=True, timeout=60, check=False)
            self.assertEqual(again.returncode, 0, again.stdout + again.stderr)
            self.assertEqual(done.stdout.splitlines()[0], again.stdout.splitlines()[0])
            self.assertRegex(again.stdout, r"600 triangles, [1-9]\d{2,} tiles")

    def test_what_no_reset_parts_is_compared_too(self):
        faulty_copy(self.top / "rtl")
        done = self.run_example("tiny", "--rtl", self.top / "rtl", "--work", self.top / "work")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        # A lost clock that only a stalled output shows: the second frame's.
        run = subprocess.run([self.top / "work/scoreboard", "+fault6_", "+no_reset"],
                             capture_output=True, text=True, timeout=60, check=False)
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("clock", run.stdout + run.stderr)

    def test_no_comparison_takes_an_x_for_equal(self):
        """Verilator knows no X; other simulators do."""
        text = (ROOT / "testbench/dpi/hs_scoreboard.sv").read_text()
        code = re.sub(r"//.*", "", text)
        for port in ("coverage_i", "triangle_i", "frame_i"):
            self.assertNotRegex(code, rf"{port}[\w.\[\]*:+ ]*\s(!=|==)\s", port)
        for field in ("x", "y", "tag", "mask"):
            self.assertRegex(code, rf"coverage_i\.{field}\S*(\s\+: hs_pkg::LANES\])? !== ", field)
        self.assertRegex(code, r"\$isunknown\(triangle_i\)")
        for port in ("in_valid_i", "in_ready_i", "out_valid_i", "out_ready_i"):
            self.assertRegex(code, rf"\$isunknown\(\{{[^}}]*{port}", port)

    def test_configurations_that_are_none_are_refused(self):
        for text, says in (('{"samples": 3}', "HS004"), ("{", "HS002")):
            config = self.top / "c.json"
            config.write_text(text)
            done = self.run_example(config, "--program", PROGRAM)
            self.assertEqual(done.returncode, 1)
            self.assertIn(says, done.stderr)

    def test_unknown_preset_is_refused(self):
        done = self.run_example("teapot")
        self.assertEqual(done.returncode, 1)
        self.assertIn("no preset 'teapot'", done.stderr)


if __name__ == "__main__":
    unittest.main()
