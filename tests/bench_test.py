#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""halfspace bench: what its rows say, and that engines are only compared on equal work. No times."""
import json
import re
import subprocess
import sys
import unittest

sys.dont_write_bytecode = True
from program import HAS_RTL, PROGRAM, TESTS, Program  # noqa: E402

FIELDS = {"workload": str, "engine": str, "isa": str, "threads": int, "ns_per_triangle": float,
          "mpixels_per_s": float, "tiles_per_s": float, "covered_samples": int,
          "repetitions": int, "min": float, "median": float, "max": float,
          "size": str, "work": str, "triangles": int, "time": str}
GENERATED = ("small", "medium", "large", "fullscreen", "sliver")


class Bench(Program):
    PREFIX = ("bench", "--scenes", TESTS / "scenes")

    def rows(self, *args):
        file = self.out / "b.json"
        done = self.run_program("--out", file, *args)
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = json.loads(file.read_text())
        machine = rows[0]["machine"]
        self.assertEqual(len(done.stdout.splitlines()), len(rows) + 2)
        self.assertIn(f"{machine['isa']} ({machine['vector_bits']}-bit vectors)",
                      done.stdout.splitlines()[0])
        return rows

    def refuse(self, code, *args, says=""):
        out = () if {"--out", "--mesh-out"} & set(args) else ("--out", self.out / "b.json")
        super().refuse(code, *args, *out, says=says)

    @classmethod
    def has_llvmpipe(cls):
        done = subprocess.run([PROGRAM, "bench", "--workload", "tile", "--scale", "0.001",
                               "--engine", "llvmpipe"], capture_output=True, text=True)
        return "HS060" not in done.stderr

    def engines(self):
        return ({"scalar", "bit", "coverage", "cycle"} | ({"rtl"} if HAS_RTL else set()) |
                ({"llvmpipe"} if self.has_llvmpipe() else set()))

    def test_every_engine_covers_the_same_samples_of_every_workload(self):
        rows = self.rows("--scale", "0.01", "--threads", 1, 2, "--repetitions", 1)
        covered, engines, tiles = {}, {}, {}
        for row in rows:
            for field, kind in FIELDS.items():
                self.assertIsInstance(row[field], kind, (field, row))
            self.assertEqual(row["repetitions"], 1)
            self.assertLessEqual(row["min"], row["median"])
            self.assertLessEqual(row["median"], row["max"])
            self.assertEqual(row["ns_per_triangle"], row["median"])
            self.assertGreater(row["min"], 0)
            self.assertEqual(row["time"], "wall" if row["threads"] > 1 else "thread")
            total = row["median"] * row["triangles"]
            self.assertAlmostEqual(row["mpixels_per_s"], 1e3 * row["covered_samples"] / total,
                                   delta=1e-6 * row["mpixels_per_s"])
            self.assertEqual("clocks" in row, row["engine"] in ("cycle", "rtl"))
            frame = (row["workload"], row["size"])
            tiles.setdefault(frame, set()).add(round(row["tiles_per_s"] * total * 1e-9))
            covered.setdefault(frame, set()).add(row["covered_samples"])
            engines.setdefault(frame, set()).add(row["engine"])
        self.assertEqual(len({(r["workload"], r["size"], r["work"], r["engine"], r["isa"],
                               r["threads"]) for r in rows}), len(rows))
        scenes = [(s, f) for s in ("teapot", "bunny", "million") for f in ("640x480", "1920x1080")]
        self.assertEqual(set(covered), {(w, "1024x1024") for w in GENERATED} | set(scenes))
        for frame, samples in covered.items():
            self.assertEqual(len(samples), 1, frame)
            self.assertGreater(min(samples), 0, frame)
            self.assertEqual(engines[frame], self.engines(), frame)
            self.assertEqual(len(tiles[frame]), 1, frame)
            self.assertLessEqual(min(samples), 64 * min(tiles[frame]))
            self.assertGreaterEqual(min(samples), min(tiles[frame]))
        # Engine bit's whole pictures, against the driver's.
        for row in rows:
            if row["work"] == "frame" and row["engine"] == "llvmpipe":
                self.assertLessEqual(row["largest_difference"], 255)
                self.assertLessEqual(row["pixels_off"], 20, row)

    def test_workloads_engines_and_isas_are_those_asked_for(self):
        rows = self.rows("--scale", "0.001", "--workload", "small", "px16", "--engine", "scalar",
                         "coverage", "cycle", "--isa", "scalar", "--threads", "1")
        self.assertEqual([(r["workload"], r["engine"], r["isa"], r["repetitions"]) for r in rows],
                         [(w, e, i, 5) for w in ("small", "px16")
                          for e, i in (("scalar", "-"), ("coverage", "scalar"),
                                       ("cycle", "scalar"))])
        self.assertEqual([r["triangles"] for r in rows], [1000] * 3 + [40] * 3)
        self.assertTrue(all(r["min"] <= r["median"] <= r["max"] for r in rows))
        self.assertTrue(any(r["min"] < r["median"] < r["max"] for r in rows))

    def test_cycle_simulates_the_clocks_of_the_rtl(self):
        rows = self.rows("--scale", "0.01", "--workload", "quad", "px32", "px16", "tile",
                         "--engine", "cycle", *(["rtl"] if HAS_RTL else []), "--threads", "1")
        for workload in ("quad", "px32", "px16", "tile"):
            clocks = {r["clocks"] for r in rows if r["workload"] == workload}
            self.assertEqual(len(clocks), 1, workload)

    def test_a_run_that_compares_nothing_fails(self):
        done = self.run_program("--workload", "small", "--scale", "0.001", "--engine", "cycle",
                              "--isa", "avx3_dl")
        # Engine cycle has no such form; on a machine without it the option itself is refused.
        self.assertIn(done.returncode, (1, 2), done.stdout)
        self.assertRegex(done.stderr, "nothing was compared|HS061")

    def test_mesh_out_writes_the_mesh_it_times(self):
        path = self.out / "m.ply"
        self.assertEqual(self.run_program("--mesh-out", path, "--scale", "0.1").returncode, 0)
        data = path.read_bytes()
        header = data[:data.index(b"end_header\n") + 11]
        vertices = int(re.search(rb"element vertex (\d+)", header)[1])
        faces = int(re.search(rb"element face (\d+)", header)[1])
        self.assertGreaterEqual(faces, 100000)
        self.assertEqual(len(data), len(header) + 27 * vertices + 13 * faces)
        stats = self.out / "s.json"
        subprocess.run([PROGRAM, "render", path, "--out", self.out / "m.png", "--stats", stats],
                       check=True, timeout=60)
        told = json.loads(stats.read_text())
        self.assertEqual(told["triangles"], faces)
        # From the file, a vertex at a time; and from memory, all of them at once.
        rows = self.rows("--workload", "million", "--scale", "0.1", "--engine", "scalar",
                         "--repetitions", "1")
        self.assertEqual((rows[0]["size"], rows[0]["triangles"]), ("640x480", faces))
        self.assertEqual(rows[0]["covered_samples"], told["samples_covered"])
        # The mesh, its file and what loading takes; drawing adds nothing.
        self.assertGreater(told["peak_memory_bytes"], 10 * faces)
        self.assertLess(told["peak_memory_bytes"], 30e6 + 200 * faces)

    def test_help_has_units_and_an_example(self):
        text = subprocess.run([PROGRAM, "bench", "--help"], capture_output=True, text=True).stdout
        self.assertIn("Example: halfspace bench", text)
        self.assertIn("ns per triangle", text)

    def test_a_scene_that_is_not_there(self):
        self.PREFIX = ("bench", "--scenes", self.out / "none")
        self.refuse("HS010", "--workload", "bunny", says="none/bunny.obj")

    def test_bad_options(self):
        small = ("--scale", "0.001", "--workload", "small")
        self.refuse("HS001", "--workload", "tiny", says="tiny")
        self.refuse("HS001", *small, "--engine", "gpu", says="gpu")
        self.refuse("HS001", *small, "--repetitions", "0", says="0")
        self.refuse("HS001", *small, "--repetitions", "1001", says="1001")
        self.refuse("HS001", *small, "--threads", "0", says="0")
        self.refuse("HS001", "--workload", "small", "--scale=-1", says="-1")
        self.refuse("HS001", "--workload", "small", "--scale", "nan", says="nan")
        self.refuse("HS001", *small, "--speed", "9")
        self.refuse("HS061", *small, "--isa", "avx1024", says="avx1024")
        self.refuse("HS030", *small, "--out", self.out / "no" / "b.json")
        self.refuse("HS030", "--mesh-out", self.out / "no" / "m.ply", "--scale", "0.001")
        if not HAS_RTL:
            self.refuse("HS040", *small, "--engine", "rtl")
        if not self.has_llvmpipe():
            self.refuse("HS060", *small, "--engine", "llvmpipe")


if __name__ == "__main__":
    unittest.main()
