#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Where something runs out: file size, memory, standard output, the reader of a pipe. And signals
of every kind. The program ends as documented, and every file is whole, as it was, or not there."""
import os
import re
import resource
import signal
import subprocess
import sys
import time
import unittest

sys.dont_write_bytecode = True
from program import HAS_LAB, HAS_RTL, PROGRAM, PUBLIC, SCENES, TESTS, Program  # noqa: E402

TEAPOT = SCENES / "teapot.obj"
VECTORS = ("vectors", "--generate", "all", "--count", "40", "--config", "tiny")
DRAW = ("render", TEAPOT, "--size", "200x150")


def limit(kind, value):
    return lambda: resource.setrlimit(kind, (value, value))


class Limits(Program):
    def setUp(self):
        super().setUp()
        self.old = {name: f"old {name}" for name in ("a.png", "a.json", "a.tcov", "a.csv")}
        for name, text in self.old.items():
            (self.out / name).write_text(text)

    def untouched(self, args):
        self.assertEqual({str(path.relative_to(self.out)): path.is_file() and path.read_text()
                          for path in self.out.rglob("*")}, self.old, args)

    def test_a_file_beyond_the_limit_is_no_file(self):
        lines = [(*DRAW, "--out", "a.png"), (*DRAW, "--out", "new.png", "--stats", "a.json"),
                 ("coverage", PUBLIC, "--out", "a.tcov"),
                 (*VECTORS, "--out", "a.csv"), (*VECTORS, "--out", "a.csv", "--bench", "v/bench"),
                 (*VECTORS, "--bench", "v/bench"),
                 ("fit", TEAPOT, "--size", "64x48", "--report", "r/page", "--out", "a.json"),
                 ("bench", "--mesh-out", "a.ply", "--scale", "0.001")]
        if HAS_LAB:
            lines += [("report", SCENES / "cube.gltf", "--size", "32x24", "--out", "r/page"),
                      ("stability", "--explain", "walk_closed/scanline", "--picture", "a.png")]
        if HAS_RTL:
            lines += [("cosim", TEAPOT, "--size", "64x48", "--config", "tiny", "--trace", "w.fst"),
                      ("cosim", TEAPOT, "--size", "64x48", "--config", "tiny", "--trace", "w.json")]
        for args in lines:
            done = self.run_program(*args, preexec_fn=limit(resource.RLIMIT_FSIZE, 700))
            self.assertEqual(done.returncode, 2, f"{args}: {done.stderr}")
            self.assertRegex(done.stderr, r"error\[HS0(30|42|83)\]: [^\n]+\n\Z", args)
            self.untouched(args)

    def test_standard_output_beyond_the_limit_is_said(self):
        with open(self.out / "shown", "wb") as shown:
            done = subprocess.run([PROGRAM, "config"], stdout=shown, stderr=subprocess.PIPE,
                                  text=True, timeout=60,
                                  preexec_fn=limit(resource.RLIMIT_FSIZE, 10))
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("error[HS030]: cannot write", done.stderr)

    def test_what_standard_output_does_not_take_replaces_no_file(self):
        lines = [(*VECTORS, "--out", "a.csv"), (*VECTORS, "--bench", "new/bench"),
                 ("fit", TEAPOT, "--size", "64x48", "--out", "a.json", "--report", "r"),
                 ("bench", "--workload", "small", "--engine", "coverage", "--repetitions", "1",
                  "--scale", "0.001", "--out", "a.json")]
        if HAS_LAB:
            lines += [("report", SCENES / "cube.gltf", "--size", "32x24", "--out", "r/page"),
                      ("stability", "--explain", "walk_closed/scanline", "--picture", "a.png")]
        if HAS_RTL:
            lines += [("cosim", TEAPOT, "--size", "64x48", "--config", "tiny", "--stats", "a.json")]
        for args in lines:
            with open("/dev/full", "w") as full:
                done = subprocess.run([PROGRAM, *map(str, args)], stdout=full, cwd=self.out,
                                      stderr=subprocess.PIPE, text=True, timeout=300)
            self.assertEqual(done.returncode, 2, f"{args}: {done.stderr}")
            self.assertIn("error[HS030]", done.stderr)
            self.untouched(args)

    def test_memory_that_is_not_there_is_said(self):
        enough = limit(resource.RLIMIT_AS, 300 << 20)
        if self.run_program("--version", preexec_fn=enough).returncode != 0:
            self.skipTest("this build needs more address space than that (a sanitizer)")
        large = ("--size", "4096x4096", "--samples", "16", "--out", "a.png")
        for args in (("render", TEAPOT, *large), ("render", TEAPOT, *large, "--threads", "2"),
                     ("render", TEAPOT, *large, "--level", "cycle"),
                     (*VECTORS[:3], "--count", "3000000", "--size", "16x16", "--config", "tiny",
                      "--stage", "interpolation", "--out", "a.csv")):
            done = self.run_program(*args, preexec_fn=enough)
            self.assertEqual(done.returncode, 2, f"{args}: {done.stderr}")
            self.assertRegex(done.stderr, r"\Ahalfspace: error\[HS041\]: not enough memory\n\Z")
            self.untouched(args)

    def test_a_reader_that_leaves_ends_the_run_and_leaves_nothing(self):
        run = subprocess.Popen([PROGRAM, *map(str, DRAW), "--out", "-", "--stats", "a.json"],
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=self.out)
        run.stdout.close()
        said = run.stderr.read()
        run.stderr.close()
        self.assertEqual(run.wait(60), -signal.SIGPIPE, said)
        self.assertEqual(said, b"")
        self.untouched("pipe")

    def test_every_signal_that_ends_leaves_nothing(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            run = subprocess.Popen([PROGRAM, "render", SCENES / "bunny.obj", "--size", "4096x4096",
                                    "--samples", "16", "--out", "a.png"], cwd=self.out,
                                   stderr=subprocess.PIPE, text=True,
                                   preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_DFL))
            time.sleep(0.4)
            run.send_signal(number)
            said = run.communicate(timeout=60)[1]
            self.assertEqual((run.returncode, said),
                             (2, "halfspace: error[HS050]: interrupted; nothing was written\n"))
            self.untouched(number)

    def test_a_run_that_ignores_hangups_goes_on(self):
        run = subprocess.Popen([PROGRAM, "render", SCENES / "bunny.obj", "--size", "2000x2000",
                                "--samples", "16", "--out", "new.png"], cwd=self.out,
                               preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        time.sleep(0.2)
        run.send_signal(signal.SIGHUP)
        self.assertEqual(run.wait(120), 0)
        self.assertTrue((self.out / "new.png").exists())

    def test_an_interrupt_at_any_time_says_what_is_true(self):
        """Sent every few milliseconds of a short run, which ends before or after it."""
        said = set()
        for delay in range(0, 60, 3):
            run = subprocess.Popen([PROGRAM, "render", SCENES / "cube.gltf", "--size", "64x48",
                                    "--out", "a.png", "--stats", "a.json"], cwd=self.out,
                                   stderr=subprocess.PIPE, text=True)
            time.sleep(delay / 1000)
            run.send_signal(signal.SIGTERM)
            line = run.communicate(timeout=60)[1]
            changed = [name for name in self.old if (self.out / name).read_bytes() !=
                       self.old[name].encode()]
            self.assertIn(changed, ([], ["a.png", "a.json"]), "all or none")
            if run.returncode == 2:
                stays = re.search("what was written before stays", line) is not None
                self.assertEqual(stays, bool(changed), line)
            said.add(run.returncode)
            for name, text in self.old.items():
                (self.out / name).write_text(text)
            self.untouched(delay)
        self.assertLessEqual(said, {0, 2, -signal.SIGTERM}, "before main() the default holds")


if __name__ == "__main__":
    unittest.main()
