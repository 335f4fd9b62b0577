#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The bench that `halfspace vectors --bench` writes: passes in Verilator on the RTL's source and in
Icarus on yosys's netlist, each by one command; fails for a changed word and for faulty RTL."""
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[1]
PROGRAM = os.environ["HALFSPACE"]
RTL = ROOT / "rtl"


def run(*command, **extra):
    return subprocess.run([str(c) for c in command], capture_output=True, text=True, timeout=300,
                          env={**os.environ, **{k: str(v) for k, v in extra.items()}})


class Bench(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.out = pathlib.Path(self.folder.name)

    def tearDown(self):
        self.folder.cleanup()

    def make(self, *args):
        bench = self.out / "bench"
        done = run(PROGRAM, "vectors", "--bench", bench, *args)
        self.assertEqual(done.returncode, 0, done.stderr)
        return bench

    def passes(self, done):
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertRegex(done.stdout, r"(?m)^PASS: \d+ inputs, \d+ outputs, \d+ runs$")

    def fails(self, done, says=""):
        self.assertNotEqual(done.returncode, 0, done.stdout)
        self.assertIn("FAIL", done.stdout)
        self.assertIn(says, done.stdout)

    def change(self, path, line):
        """The lowest digit of a word; returns the text before."""
        text = path.read_text()
        words = text.splitlines()
        words[line] = words[line][:-1] + format(int(words[line][-1], 16) ^ 1, "x")
        path.write_text("\n".join(words) + "\n")
        return text

    def test_icarus_on_the_netlist(self):
        bench = self.make("--from", ROOT / "tests/vectors/tiny.hsv")
        build = self.out / "build"
        self.passes(run(bench / "run_icarus.sh", RTL, build))
        netlist = build / "netlist.v"
        self.passes(run(bench / "run_icarus.sh", NETLIST=netlist, HS_PLUSARGS="+bits_only"))
        # A wrong expected word, the last one.
        before = self.change(bench / "vectors.out.hex", -1)
        self.fails(run(bench / "run_icarus.sh", NETLIST=netlist), "an output differs")
        (bench / "vectors.out.hex").write_text(before)
        # An expected output more, one fewer.
        lines = before.splitlines(keepends=True)
        (bench / "vectors.out.hex").write_text("".join(lines[1:] + lines[:1]))
        self.fails(run(bench / "run_icarus.sh", NETLIST=netlist))
        (bench / "vectors.out.hex").write_text(before)
        # Faulty RTL.
        rtl = self.out / "rtl"
        shutil.copytree(RTL, rtl)
        text = (rtl / "hs_setup_edge.sv").read_text()
        fault = text.replace("assign top_left = a_above ||",
                             "assign top_left = (a_above && !b_above) ||")
        self.assertNotEqual(fault, text)
        (rtl / "hs_setup_edge.sv").write_text(fault)
        self.fails(run(bench / "run_icarus.sh", rtl, build), "output")

    def test_verilator_on_the_source(self):
        bench = self.make("--from", ROOT / "tests/vectors/tiny.hsv")
        build = self.out / "build"
        if shutil.which("ccache"):
            os.environ["OBJCACHE"] = "ccache"
        self.passes(run(bench / "run_verilator.sh", RTL, build))
        self.change(bench / "vectors.out.hex", 3)
        self.assertEqual(run("sh", "-c", f"cd {bench} && {build}/bench").returncode != 0, True)

    def test_a_stage_alone(self):
        bench = self.make("--generate", "all", "--count", "40", "--config", "tiny", "--stage",
                          "tile_traversal", "--node-level", "3", "--stall", "0.3")
        self.passes(run(bench / "run_icarus.sh", RTL, self.out / "build"))


if __name__ == "__main__":
    unittest.main()
