#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""halfspace soak as a user runs it: clean runs, a faulty RTL found and shrunk, refusals."""
import json
import os
import shlex
import shutil
import sys
import unittest

sys.dont_write_bytecode = True
from program import HAS_RTL, TESTS, Program  # noqa: E402


class Soak(Program):
    def specification(self, **values):
        path = self.out / "soak.json"
        path.write_text(json.dumps(values))
        return path

    def test_a_clean_run_says_what_it_compared(self):
        spec = self.specification(configurations=4, triangles=100)
        done = self.succeed("soak", spec)
        self.assertEqual(done.stdout, "no difference: 400 triangles, 4 configurations, "
                                      "checks engines frame cycle oracle interpolation\n")
        self.assertIn("200 triangles, 2 c", self.succeed("soak", spec, "--shard", "1/2").stdout)

    def test_a_replay_without_a_difference_says_so(self):
        done = self.succeed("soak", self.specification(), "--point", 3, "--check", "oracle",
                            "--triangles", "0,0,1,0,0,1,0")
        self.assertEqual(done.stdout, "oracle: no difference\n")

    @unittest.skipUnless(HAS_RTL, "this build has no RTL")
    def test_a_fault_in_the_rtl_is_found_shrunk_and_replayed(self):
        rtl = self.out / "rtl"
        shutil.copytree(TESTS.parent / "rtl", rtl)
        edge = rtl / "hs_setup_edge.sv"
        text = edge.read_text()
        faulty = text.replace("a_above || (a_zero5_q && b_above)", "a_above || a_zero5_q", 1)
        self.assertNotEqual(text, faulty)
        edge.write_text(faulty)
        environment = dict(os.environ, HALFSPACE_RTL=str(rtl),
                           HALFSPACE_RTL_CACHE=str(self.out / "cache"))
        spec = self.specification(configurations=1, triangles=50, checks=["rtl"])
        done = self.run_program("soak", spec, environment=environment)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertRegex(done.stderr, r"\Ahalfspace: rtl: [^\n]*; a triangle of [^\n]*\n\Z")
        replay = shlex.split(done.stderr.split("replay: halfspace ")[1])
        again = self.run_program(*replay, environment=environment)
        self.assertEqual((again.returncode, again.stderr), (1, done.stderr))
        # The same triangle on the RTL as it should be.
        self.assertIn("no difference", self.succeed(*replay).stdout)

    def test_bad_input_is_refused_in_one_line(self):
        for values, *says in (({"seeds": 1}, "'seeds'"), ({"configurations": 0}, "= 0"),
                              ({"shapes": ["round"]}, "shapes", "round"),
                              ({"checks": []}, "checks = []"), ({"checks": ["all"]}, "all"),
                              ({"stall": 1}, "stall = 1"), ({"triangles": -1}, "= -1")):
            self.refuse("HS100", "soak", self.specification(**values), says=["soak.json", *says])
        spec = self.specification()
        replay = ["soak", spec, "--point", 0, "--check"]
        for text in ("0,0,0", "0,0,0,0,0,0,0;", "0,0,0,0,0,0,-1", "99999999,0,0,0,0,0,0", "x"):
            self.refuse("HS001", *replay, "oracle", "--triangles", text, says="--triangles")
        self.refuse("HS001", *replay, "none", "--triangles", "0,0,0,0,0,0,0", says="--check")
        self.refuse("HS001", *replay, "oracle", says="need each other")
        self.refuse("HS001", "soak", spec, "--shard", "2/2", says="--shard")


if __name__ == "__main__":
    unittest.main()
