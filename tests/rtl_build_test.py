#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""RTL on demand: any legal configuration, built once, and what is said when it cannot be."""
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time
import unittest

sys.dont_write_bytecode = True
from program import PROGRAM, SCENES, TESTS, Program

sys.path.insert(0, str(TESTS.parent / "testbench/synth"))
from tool_versions import TESTED

TEAPOT = ("cosim", SCENES / "teapot.obj", "--size", "64x48", "--config", "c.json")
SMALL = {"subpixel_bits": 3, "viewport_bits": 6, "guard_bits": 0, "grid_log2": 2, "tag_bits": 11}


class RtlBuild(Program):
    def setUp(self):
        super().setUp()
        (self.out / "c.json").write_text(json.dumps(SMALL))
        self.cache = self.out / "cache"
        self.environment = {**os.environ, "HALFSPACE_RTL_CACHE": str(self.cache)}
        if shutil.which("ccache"):
            self.environment["CXX"] = "ccache c++"  # Verilator's own part is the same for all

    def cosim(self, **changes):
        return self.run_program(*TEAPOT, environment={**self.environment, **changes})

    def start(self):
        return subprocess.Popen([PROGRAM, *map(str, TEAPOT)], cwd=self.out, env=self.environment,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def cached(self, ending=""):
        return sorted(p.name for p in self.cache.glob(f"*{ending}") if p.name != "lock")

    def path_without(self, *names):
        """A PATH with every program of today's but these."""
        folder = self.out / "bin"
        folder.mkdir()
        for name in ("sh", "rm", "c++", "ccache", "verilator", "verilator_bin", "cat"):
            found = shutil.which(name)
            if found and name not in names:
                (folder / name).symlink_to(found)
        return str(folder)

    def test_two_processes_build_one_object_that_a_third_finds(self):
        both = [self.start(), self.start()]
        for process in both:
            said, complained = process.communicate(timeout=300)
            self.assertEqual(process.returncode, 0, complained)
            self.assertIn("identical in bits and clocks", said)
            self.assertEqual(complained, "")
        built = self.cached()
        self.assertEqual(len(built), 1, built)
        self.assertRegex(built[0], r"^s3n6k0x0m1g2i1t11-[0-9a-f]{16}\.so$")
        before = (self.cache / built[0]).stat()
        self.assertEqual(self.cosim().returncode, 0)
        self.assertEqual((self.cache / built[0]).stat().st_mtime_ns, before.st_mtime_ns)

    def test_what_a_killed_build_left_goes(self):
        process = self.start()
        while not self.cached(".log") and process.poll() is None:
            time.sleep(0.02)
        process.kill()
        process.communicate(timeout=60)
        self.assertEqual(len(self.cached()), 2, "a folder and a log")
        self.assertEqual(self.cosim().returncode, 0)
        self.assertEqual([pathlib.Path(name).suffix for name in self.cached()], [".so"])

    def test_an_interrupted_build_leaves_nothing(self):
        process = self.start()
        while not self.cached(".log") and process.poll() is None:
            time.sleep(0.02)
        process.send_signal(signal.SIGINT)
        complained = process.communicate(timeout=60)[1]
        self.assertEqual(process.returncode, 2, complained)
        self.assertIn("error[HS050]", complained)
        self.assertEqual(self.cached(), [])

    def test_a_build_that_fails_names_the_line_and_its_log(self):
        rtl = self.out / "rtl"
        shutil.copytree(TESTS.parent / "rtl", rtl)
        module = rtl / "hs_fifo.sv"
        module.write_text(module.read_text().replace("endmodule", "endmodul"))
        done = self.cosim(HALFSPACE_RTL=str(rtl))
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, r"\Ahalfspace: error\[HS042\]: [^\n]*hs_fifo\.sv[^\n]*\n\Z")
        log = pathlib.Path(done.stderr.split("log: ")[1].rstrip(")\n"))
        self.assertIn("hs_fifo.sv", log.read_text())
        self.assertEqual(self.cached(), [log.name])

    def test_another_rtl_is_another_object_and_its_fault_is_named(self):
        rtl = self.out / "rtl"
        shutil.copytree(TESTS.parent / "rtl", rtl)
        edge = rtl / "hs_setup_edge.sv"
        text, old = edge.read_text(), "assign top_left = a_above ||"
        self.assertEqual(text.count(old), 1)
        edge.write_text(text.replace(old, "assign top_left = (a_above && !b_above) ||"))
        done = self.cosim(HALFSPACE_RTL=str(rtl))
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("mismatch: stage=triangle_setup", done.stderr)
        self.assertRegex(done.stderr, r"field=e[012] ")

    def test_a_width_that_differs_is_a_mismatch(self):
        rtl = self.out / "rtl"
        shutil.copytree(TESTS.parent / "rtl", rtl)
        package = rtl / "hs_pkg.sv"
        text = package.read_text()
        old = "NODE_BASE_BITS /*verilator public*/ = EXTENT_LOG2 + S + SAMPLE_BITS + 2;"
        self.assertEqual(text.count(old), 1)
        package.write_text(text.replace(old, old.replace("+ 2;", "+ 3;")))
        done = self.cosim(HALFSPACE_RTL=str(rtl))
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("stage=configuration field=NODE_BASE_BITS model=11 rtl=12", done.stderr)
        done = self.run_program("render", SCENES / "teapot.obj", "--size", "64x48", "--config",
                                "c.json", "--level", "rtl", "--out", "x.png",
                                environment={**self.environment, "HALFSPACE_RTL": str(rtl)})
        self.assertEqual(done.returncode, 2)
        self.assertIn("error[HS043]", done.stderr)

    def test_a_machine_without_the_tools_is_told_which(self):
        for name, package, hidden in (("Verilator", "verilator", ("verilator", "verilator_bin")),
                                      ("c++", "g++", ("c++",))):
            shutil.rmtree(self.out / "bin", ignore_errors=True)
            done = self.cosim(PATH=self.path_without(*hidden), CXX="c++")
            self.assertEqual(done.returncode, 2, name)
            self.assertRegex(done.stderr, r"\Ahalfspace: error\[HS040\]: [^\n]+\n\Z")
            self.assertIn(f"{name} is not installed (package {package})", done.stderr)
        self.assertFalse(self.cache.exists())

    def test_a_verilator_that_was_not_tried_is_named(self):
        path = self.path_without("verilator_bin", "verilator")
        for name in ("verilator", "verilator_bin"):
            script = pathlib.Path(path) / name
            script.write_text(f"#!/bin/sh\n[ \"$1\" = --version ] && {{ echo 'Verilator 5.999 x'; "
                              f"exit 0; }}\nexec {shutil.which(name)} \"$@\"\n")
            script.chmod(0o755)
        done = self.cosim(PATH=f"{path}:{os.environ['PATH']}")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr, "halfspace: note: Verilator 5.999 x has not been tried with "
                                      f"this RTL ({', '.join(TESTED['verilator'][1])} have)\n")


if __name__ == "__main__":
    unittest.main()
