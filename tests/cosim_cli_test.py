#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What halfspace cosim leaves behind: whole files or none."""
import signal
import subprocess
import sys
import time
import unittest

sys.dont_write_bytecode = True
from program import PROGRAM, SCENES, Program


class CosimCli(Program):
    def names(self):
        return {path.name for path in self.out.iterdir()}

    def test_interrupted_waves_replace_nothing(self):
        (self.out / "x.fst").write_text("older")
        program = subprocess.Popen(
            [PROGRAM, "cosim", SCENES / "bunny.obj", "--size", "2000x2000", "--trace", "x.fst",
             "--stats", "s.json"], cwd=self.out, stderr=subprocess.PIPE, text=True)
        while len(self.names()) < 2 and program.poll() is None:
            time.sleep(0.01)
        time.sleep(0.1)
        program.send_signal(signal.SIGINT)
        said = program.communicate(timeout=60)[1]
        self.assertEqual(program.returncode, 2, said)
        self.assertIn("error[HS050]: interrupted; nothing was written", said)
        self.assertEqual(self.names(), {"x.fst"})
        self.assertEqual((self.out / "x.fst").read_text(), "older")

    def test_waves_of_a_whole_run_are_there(self):
        self.succeed("cosim", SCENES / "teapot.obj", "--size", "64x48", "--trace", "x.fst")
        self.assertEqual({n for n in self.names() if not n.endswith(".hier")}, {"x.fst"})
        self.assertGreater((self.out / "x.fst").stat().st_size, 1000)
        self.assertEqual(self.names(), {"x.fst"})

    def test_waves_go_through_a_link(self):
        (self.out / "x.fst").symlink_to("real.fst")
        self.succeed("cosim", SCENES / "teapot.obj", "--size", "64x48", "--trace", "x.fst")
        self.assertTrue((self.out / "x.fst").is_symlink())
        self.assertGreater((self.out / "real.fst").stat().st_size, 1000)

    def test_statistics_that_fail_leave_no_waves(self):
        done = self.run_program("cosim", SCENES / "teapot.obj", "--size", "64x48", "--trace",
                                "x.fst", "--stats", "/dev/full")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(self.names(), set())

    def test_statistics_do_not_replace_the_trace_of_the_model(self):
        done = self.run_program("cosim", SCENES / "teapot.obj", "--size", "64x48", "--trace",
                                "t.json", "--stats", "t.model.json")
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, r"error\[HS001\]: t.model.json: two outputs")
        self.assertEqual(self.names(), set())


if __name__ == "__main__":
    unittest.main()
