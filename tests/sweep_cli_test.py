#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""halfspace sweep and merge as a user runs them: records, shards, what is refused, kill -9."""
import json
import os
import random
import signal
import subprocess
import sys
import time
import unittest

sys.dont_write_bytecode = True
from program import HAS_RTL, PROGRAM, SCENES, TESTS, Program  # noqa: E402

TEAPOT = str(SCENES / "teapot.obj")
SMALLEST = {"scenes": ["tests/scenes/teapot.obj"], "size": ["320x240"],
            "config": {"base": "full", "subpixel_bits": [4, 6, 8]},
            "measure": ["coverage_error", "clocks", "area"]}
# Many small cases.
QUICK = {"scenes": [str(SCENES / "cube.gltf")], "size": ["32x24", "16x16"], "views": 2,
         "config": {"base": "full", "subpixel_bits": {"from": 2, "to": 8}, "grid_log2": [2, 3]},
         "measure": ["clocks", "latency", "area"]}


class Sweep(Program):
    def specification(self, values, name="spec.json"):
        path = self.out / name
        path.write_text(values if isinstance(values, str) else json.dumps(values))
        return path

    def shards(self, spec, count, folder):
        for i in range(count):
            self.succeed("sweep", spec, "--out", folder, "--shard", f"{i}/{count}")

    def merged(self, spec, count):
        folder, out = self.out / f"of{count}", self.out / f"{count}.jsonl"
        self.shards(spec, count, folder)
        self.succeed("merge", folder, "--out", out)
        return out.read_bytes()

    def records(self, text):
        return [json.loads(line) for line in text.splitlines()]

    def test_the_smallest_specification(self):
        spec = self.specification(SMALLEST)
        done = subprocess.run([PROGRAM, "sweep", spec, "--out", self.out / "d"], text=True,
                              capture_output=True, cwd=TESTS.parent)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.succeed("merge", "d", "--out", "f.jsonl")
        records = self.records((self.out / "f.jsonl").read_text())
        self.assertEqual([r["config"]["subpixel_bits"] for r in records], [4, 6, 8])
        ppm = [r["coverage_error"]["ppm"] for r in records]
        self.assertGreater(ppm[0], ppm[1])
        self.assertGreater(ppm[1], ppm[2])
        luts = [r["area"]["luts"] for r in records]
        self.assertLess(luts[0], luts[2])
        # The clocks are those that render counts.
        self.succeed("render", TEAPOT, "--size", "320x240", "--level", "cycle", "--stats", "s.json",
                     "--out", "p.png")
        stats = json.loads((self.out / "s.json").read_text())
        self.assertEqual(records[2]["clocks"]["clocks"], stats["cycles"])

    def test_one_shard_and_seven_are_the_same_bytes(self):
        spec = self.specification(QUICK)
        whole = self.merged(spec, 1)
        self.assertEqual(len(whole.splitlines()), 2 * 2 * 14)
        self.assertEqual(whole, self.merged(spec, 7))
        self.assertEqual(whole, self.merged(spec, 60))  # more shards than cases

    def test_records_are_in_the_order_of_the_specification(self):
        records = self.records(self.merged(self.specification(QUICK), 3))
        self.assertEqual([r["case"] for r in records], list(range(56)))
        self.assertEqual([r["size"] for r in records[::14]], ["32x24", "32x24", "16x16", "16x16"])
        self.assertEqual([r["view"] for r in records[::14]], [0, 1, 0, 1])
        self.assertEqual([(r["config"]["subpixel_bits"], r["config"]["grid_log2"])
                          for r in records[:3]], [(2, 2), (2, 3), (3, 2)])

    def test_shards_come_from_the_environment(self):
        spec = self.specification(QUICK)
        for index, count, name in (
                ("TEST_SHARD_INDEX", "TEST_TOTAL_SHARDS", "shard-00001-of-00003"),
                ("SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_COUNT", "shard-00001-of-00004")):
            environment = dict(os.environ, **{index: "1", count: name[-1]})
            done = self.run_program("sweep", spec, "--out", "d", environment=environment)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertTrue((self.out / "d" / f"{name}.jsonl").exists())
        environment = dict(os.environ, SLURM_ARRAY_TASK_ID="7", SLURM_ARRAY_TASK_COUNT="3")
        self.refuse("HS001", "sweep", spec, "--out", "e", environment=environment,
                    says=["SLURM_ARRAY_TASK_ID", "7/3"])

    def test_illegal_combinations_are_named_and_left_out(self):
        values = dict(QUICK, config={"base": "full", "viewport_bits": [4, 12],
                                     "guard_bits": [0, 5]})
        done = self.succeed("sweep", self.specification(values), "--out", "d")
        self.assertIn("left out: viewport_bits 12, guard_bits 5", done.stderr)
        self.assertIn("size 32x24 is larger than viewport_bits = 4 allow", done.stderr)
        text = (self.out / "d/shard-00000-of-00001.jsonl").read_text().splitlines()
        manifest = json.loads(text[-1])
        self.assertEqual((manifest["cases"], manifest["left_out"]), (8, 3))

    def test_a_case_that_fails_is_a_record(self):
        (self.out / "broken.obj").write_text("v 0 0 zero\nf 1 1 1\n")
        values = dict(QUICK, scenes=[str(SCENES / "cube.gltf"), "broken.obj"], views=1,
                      config={"base": "full"})
        done = self.run_program("sweep", self.specification(values), "--out", "d")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("2 of 4 cases failed; the first of this run is case 2:", done.stderr)
        again = self.run_program("sweep", "spec.json", "--out", "d")
        self.assertEqual(again.returncode, 1, "a failure counts whenever it happened")
        self.assertEqual(self.run_program("merge", "d", "--out", "f.jsonl").returncode, 1)
        records = self.records((self.out / "f.jsonl").read_text())
        self.assertEqual([r.get("error", {}).get("code") for r in records],
                         [None, None, "HS011", "HS011"])

    def test_bad_specifications_are_refused_in_one_line(self):
        def refuse(values, *says):
            spec = self.specification(values)
            self.refuse("HS100", "sweep", spec, "--out", "d", says=["spec.json", *says])
        refuse(dict(QUICK, scene=[]), "'scene'")
        refuse(dict(QUICK, scenes=[]), "scenes = []")
        refuse(dict(QUICK, scenes=["none.obj"]), "scenes[0]", "none.obj")
        refuse(dict(QUICK, size=["32"]), "size", "32")
        refuse(dict(QUICK, measure=["speed"]), "measure", "speed", "coverage_error")
        refuse(dict(QUICK, config={"sub": 3}), "config.sub", "3")
        refuse(dict(QUICK, config=[{}, {"samples": []}]), "config[1].samples = []")
        refuse(dict(QUICK, config={"samples": ["4"]}), 'config.samples = "4"')
        refuse(dict(QUICK, config={"samples": [4, 4]}), "config.samples = 4", "twice")
        refuse(dict(QUICK, config={"samples": {"from": 4, "to": 1}}), "config.samples", "empty")
        refuse(dict(QUICK, config={"samples": 3}), "no configuration is legal", "samples")
        refuse(dict(QUICK, config={"base": "none"}), "config.base", "none")
        refuse(dict(QUICK, views=0), "views = 0")
        refuse(dict(QUICK, stall=1), "stall = 1")
        many = {"tag_bits": {"from": 1, "to": 32}, "gradient_bits": {"from": 0, "to": 20},
                "inverse_w_bits": {"from": 12, "to": 30}, "reciprocal_bits": {"from": 6, "to": 16},
                "depth_bits": {"from": 16, "to": 24}, "attributes": {"from": 0, "to": 8}}
        refuse(dict(QUICK, config=many), "config", "10000000 cases")
        refuse("{", "spec.json:1", "not valid JSON")
        refuse("[]", "not a JSON object")
        refuse('{"scenes": 1, "scenes": 2}', "'scenes' is there twice")
        refuse('{"scenes": ' + "[" * 100000, "nested deeper")
        refuse(" " * (1 << 20) + "{}", "1 MiB")
        self.refuse("HS010", "sweep", "none.json", "--out", "d", says="none.json")

    def test_bad_shards_are_refused(self):
        spec = self.specification(QUICK)
        for text in ("3/3", "-1/3", "0/0", "1", "1/", "/3", "1/3/5", "0/1000001"):
            self.refuse("HS001", "sweep", spec, "--out", "d", f"--shard={text}",
                        says=["--shard", text])

    def test_merge_names_what_is_missing(self):
        spec = self.specification(QUICK)
        for i in (0, 1, 4, 8):
            self.succeed("sweep", spec, "--out", "d", "--shard", f"{i}/10")
        done = self.run_program("merge", "d", "--out", "f.jsonl")
        self.assertEqual(done.returncode, 1)
        self.assertIn("6 of 10 shards are missing: 2-3,5-7,9", done.stderr)
        self.assertFalse((self.out / "f.jsonl").exists())
        self.assertEqual(self.succeed("merge", "d", "--missing").stdout, "2-3,5-7,9\n")
        for i in (2, 3, 5, 6, 7, 9):
            self.succeed("sweep", spec, "--out", "d", "--shard", f"{i}/10")
        self.assertEqual(self.succeed("merge", "d", "--missing").stdout, "")

    def test_merge_refuses_what_does_not_belong_together(self):
        spec = self.specification(QUICK)
        folder = self.out / "d"
        self.shards(spec, 2, folder)
        first, second = (folder / f"shard-0000{i}-of-00002.jsonl" for i in (0, 1))
        whole = second.read_text()

        def refuse(text, *says):
            second.write_text(text)
            self.refuse("HS101", "merge", folder, "--out", "f.jsonl", says=says)
        manifest = json.loads(whole.splitlines()[-1])
        for key in ("program", "rtl", "specification"):
            other = json.dumps(dict(manifest, **{key: "0" * 16}))
            refuse("\n".join([*whole.splitlines()[:-1], other]) + "\n", second.name, first.name,
                   "0" * 16)
        refuse(whole[:-1], second.name, "no manifest")
        refuse("".join(whole.splitlines(True)[:-1]), second.name, "no manifest")
        refuse(whole.replace('"clocks":{"clocks":', '"clocks":{"clocks":1', 1), second.name, "CRC")
        refuse("".join(whole.splitlines(True)[1:]), second.name, "is not case 1")
        refuse(first.read_text(), "shard 0/2 is there twice", first.name, second.name)
        second.write_text(whole)
        (folder / "copy.jsonl").write_text(whole)
        self.refuse("HS101", "merge", folder, "--out", "f.jsonl", says=["twice", "copy.jsonl"])
        (folder / "copy.jsonl").unlink()
        self.succeed("sweep", spec, "--out", folder, "--shard", "0/3")
        self.refuse("HS101", "merge", folder, "--out", "f.jsonl", says=["of shards", "shard-00000"])

    def test_merge_of_nothing_is_refused(self):
        (self.out / "empty").mkdir()
        for folder in ("empty", "none"):
            for what in (["--out", "f.jsonl"], ["--missing"]):
                self.refuse("HS101", "merge", folder, *what, says=folder)
        self.refuse("HS001", "merge", "empty", says="--missing")

    def test_a_killed_shard_loses_nothing_that_was_done(self):
        """At random times, 50 of them or as many as HALFSPACE_KILLS says, each after the last."""
        spec = self.specification(dict(
            QUICK, views=40, measure=["coverage_error", "clocks", "area"]))
        self.succeed("sweep", spec, "--out", "whole")
        want = (self.out / "whole/shard-00000-of-00001.jsonl").read_text().splitlines()[:-1]
        seconds = json.loads((self.out / "whole/shard-00000-of-00001.jsonl").read_text()
                             .splitlines()[-1])["run"]["seconds"]
        draw, kept, kills = random.Random(1), 0, 0
        folder = self.out / "killed"
        for _ in range(int(os.environ.get("HALFSPACE_KILLS", "8"))):
            running = subprocess.Popen([PROGRAM, "sweep", spec, "--out", folder], cwd=self.out,
                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            time.sleep(draw.random() * seconds / 4 + 0.02)
            running.send_signal(signal.SIGKILL)
            kills += running.wait() == -signal.SIGKILL
            if not folder.exists():
                continue
            done = max(len(p.read_text().split("\n")) - 1 for p in folder.iterdir())
            self.assertGreaterEqual(done, kept, "a record that was done is gone")
            kept = done
        self.succeed("sweep", spec, "--out", folder)
        lines = (folder / "shard-00000-of-00001.jsonl").read_text().splitlines()
        self.assertEqual(lines[:-1], want)
        if kept < len(want):
            self.assertEqual(json.loads(lines[-1])["run"]["resumed"], kept)
            self.assertGreater(kills, 0)
        self.assertEqual(len(list(folder.iterdir())), 1, "unfinished files are left")

    def test_an_interrupted_shard_says_so_and_goes_on(self):
        spec = self.specification(dict(QUICK, views=400))
        running = subprocess.Popen([PROGRAM, "sweep", spec, "--out", "d"], cwd=self.out, text=True,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        end = time.monotonic() + 30
        while not list(self.out.glob("d/*.partial-*")) and time.monotonic() < end:
            time.sleep(0.01)
        running.terminate()
        said = running.communicate()[1]
        self.assertEqual((running.returncode, said),
                         (2, "halfspace: error[HS050]: interrupted; what was written before stays\n"))
        done = max(p.read_text().count("\n") for p in self.out.glob("d/*.partial-*"))
        self.succeed("sweep", spec, "--out", "d")
        last = (self.out / "d/shard-00000-of-00001.jsonl").read_text().splitlines()[-1]
        self.assertEqual(json.loads(last)["run"]["resumed"], done)

    @unittest.skipUnless(HAS_RTL, "this build has no RTL")
    def test_the_rtl_is_compared_under_stalls(self):
        spec = self.specification(dict(QUICK, config={}, views=1, size=["32x24"], stall=0.2,
                                       measure=["clocks", "rtl"]))
        self.assertEqual(self.succeed("sweep", spec, "--build-rtl").stdout, "1 configurations\n")
        self.succeed("sweep", spec, "--out", "d")
        record = self.records((self.out / "d/shard-00000-of-00001.jsonl").read_text())[0]
        self.assertTrue(record["rtl"]["identical"])
        self.assertGreater(record["rtl"]["clocks"], record["clocks"]["clocks"])

    def test_a_torn_record_is_made_again(self):
        spec = self.specification(QUICK)
        self.succeed("sweep", spec, "--out", "d")
        whole = self.out / "d/shard-00000-of-00001.jsonl"
        text = whole.read_text()
        manifest = json.loads(text.splitlines()[-1])
        name = (f"{whole.name}.{manifest['program']}-{manifest['rtl']}-{manifest['specification']}"
                ".partial-node-1-0")
        whole.unlink()
        (self.out / "d" / name).write_text(text[:2000])
        self.succeed("sweep", spec, "--out", "d")
        again = whole.read_text()
        self.assertEqual(again.splitlines()[:-1], text.splitlines()[:-1])
        self.assertEqual(json.loads(again.splitlines()[-1])["run"]["resumed"],
                         text[:2000].count("\n"))


if __name__ == "__main__":
    unittest.main()
