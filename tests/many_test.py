#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A sweep on a real scheduler: Slurm on loopback, GNU parallel, this machine; tasks that are killed
or run into their limit are found, rerun, and the bytes are those of one process."""
import json
import shutil
import subprocess
import sys
import unittest

sys.dont_write_bytecode = True
import slurm_cluster  # noqa: E402
from program import HAS_RTL, PROGRAM, SCENES, TESTS, Program  # noqa: E402

MANY = TESTS.parent / "testbench/sweep/many.py"
QUICK = {"scenes": [str(SCENES / "cube.gltf")], "size": ["32x24"], "views": 4,
         "config": {"base": "full", "subpixel_bits": {"from": 2, "to": 8}},
         "measure": ["clocks", "area"]}


class ManyProgram(Program):
    def setUp(self):
        super().setUp()
        self.spec = self.out / "spec.json"
        self.write(QUICK)

    def write(self, values):
        self.spec.write_text(json.dumps(values))

    def many(self, *args, environment=None):
        command = [sys.executable, MANY, "--program", PROGRAM, self.spec, *map(str, args)]
        return subprocess.run(command, capture_output=True, text=True, timeout=500, cwd=self.out,
                              env=environment)

    def one_process(self):
        self.succeed("sweep", self.spec, "--out", "one")
        self.succeed("merge", "one", "--out", "one.jsonl")
        return (self.out / "one.jsonl").read_bytes()

    def expect_all(self, done):
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertEqual((self.out / "d/sweep.jsonl").read_bytes(), self.one_process())


class Many(ManyProgram):
    def test_local(self):
        done = self.many("--out", "d", "-n", 5, "--jobs", 2)
        self.expect_all(done)
        self.assertIn("28/28 cases", done.stderr)

    def test_the_same_command_makes_what_is_missing(self):
        self.many("--out", "d", "-n", 5)
        whole = (self.out / "d/sweep.jsonl").read_bytes()
        times = {p.name: p.stat().st_mtime_ns for p in (self.out / "d").glob("shard-*")}
        (self.out / "d/shard-00003-of-00005.jsonl").unlink()
        self.expect_all(self.many("--out", "d"))
        self.assertEqual((self.out / "d/sweep.jsonl").read_bytes(), whole)
        changed = [p.name for p in (self.out / "d").glob("shard-*")
                   if p.stat().st_mtime_ns != times[p.name]]
        self.assertEqual(changed, ["shard-00003-of-00005.jsonl"])

    def test_bad_input_stops_before_any_task(self):
        self.write(dict(QUICK, views=0))
        done = self.many("--out", "d")
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, r"\Ahalfspace: error\[HS100\]: [^\n]*views = 0[^\n]*\n\Z")
        self.assertFalse((self.out / "d").exists())
        self.write(QUICK)
        self.assertEqual(self.many("--out", "d", "-n", 3).returncode, 0)
        done = self.many("--out", "d", "-n", 4)
        self.assertEqual((done.returncode, done.stderr),
                         (2, f"many.py: {self.out}/d has 3 shards, not 4\n"))

    def test_parallel(self):
        if not shutil.which("parallel"):
            self.skipTest("GNU parallel is not installed (package parallel)")
        self.expect_all(self.many("--out", "d", "--on", "parallel", "-n", 8))


class Slurm(ManyProgram):
    @classmethod
    def setUpClass(cls):
        missing = slurm_cluster.missing()
        if missing:
            raise unittest.SkipTest(missing)
        cls.cluster = slurm_cluster.Cluster()
        try:
            cls.cluster.__enter__()
        except RuntimeError as error:
            raise unittest.SkipTest(f"Slurm does not start here: {error}") from error

    @classmethod
    def tearDownClass(cls):
        cls.cluster.__exit__()

    def program_that(self, line):
        """The program, but a line of shell first: $shard is the task's number."""
        path = self.out / "wrapped"
        path.write_text("#!/bin/bash\n"
                        'shard=${@: -1}; shard=${shard%%/*}; [ "$1" = sweep ] || shard=\n'
                        f"{line}\nexec {PROGRAM} \"$@\"\n")
        path.chmod(0o755)
        return path

    def test_an_array_of_eight(self):
        done = self.many("--out", "d", "--on", "slurm", "-n", 8, "--time", 2,
                         environment=self.cluster.environment)
        self.expect_all(done)
        self.assertEqual(len(list((self.out / "d").glob("log-0+*.txt"))), 8)

    @unittest.skipUnless(HAS_RTL, "this build has no RTL")
    def test_the_rtl_is_built_before_the_array_runs(self):
        self.write(dict(QUICK, config={}, measure=["rtl"]))
        done = self.many("--out", "d", "--on", "slurm", "-n", 4, "--time", 5,
                         environment=self.cluster.environment)
        self.expect_all(done)
        self.assertEqual((self.out / "d/log-rtl.txt").read_text(), "1 configurations\n")

    def test_what_was_killed_or_ran_into_its_limit_is_run_again(self):
        # Task 2 is killed, task 5 hangs until its limit, one minute.
        program = self.program_that(
            f'case $shard in\n'
            f'  2) {PROGRAM} "$@" & kill -9 $!; kill -9 $$ ;;\n'
            f'  5) sleep 600 ;;\n'
            f'esac')
        arguments = ["--out", "d", "--on", "slurm", "-n", 8, "--time", 1]
        done = self.many(*arguments, "--program", program, environment=self.cluster.environment)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("2 of 8 shards are missing: 2,5\n", done.stderr)
        self.assertEqual(self.succeed("merge", "d", "--missing").stdout, "2,5\n")
        self.assertIn("DUE TO TIME LIMIT", (self.out / "d/log-0+5.txt").read_text())
        self.assertFalse((self.out / "d/sweep.jsonl").exists())
        self.expect_all(self.many(*arguments, environment=self.cluster.environment))


if __name__ == "__main__":
    unittest.main()
