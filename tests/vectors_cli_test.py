#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""halfspace vectors as a user runs it: what it writes, what --check finds, how it fails."""
import json
import re
import sys
import unittest
import zlib

sys.dont_write_bytecode = True
from program import SCENES, TESTS, Program  # noqa: E402

SETS = sorted((TESTS / "vectors").glob("*.hsv"))
STAGES = ("rasterizer", "triangle_setup", "half_plane_grid", "tile_traversal", "coverage",
          "interpolation", "depth")
PRESETS = ("tiny", "full", "d3d", "msaa4")


class Vectors(Program):
    PREFIX = ("vectors",)

    def differs(self, path, *says):
        done = self.run_program("--check", path)
        self.assertEqual(done.returncode, 1, f"{done.stdout}{done.stderr}")
        for text in says:
            self.assertIn(text, done.stderr)

    def make(self, *args, stage="rasterizer", config="tiny", count=40):
        """All four formats; the manifest's path."""
        self.succeed("--generate", "all", "--count", count, "--stage", stage, "--config", config,
                     "--stall", "0.3", "--out", self.out / "v.csv", "--out", self.out / "v.jsonl",
                     "--out", self.out / "v.hsv", "--out", self.out / "v.hex", *args)
        return self.out / "v.manifest.json"

    # --- what it writes ---------------------------------------------------------------------------

    def test_every_stage_and_format_passes_its_check(self):
        for stage in STAGES:
            manifest = self.make(stage=stage, count=25)
            said = self.succeed("--check", manifest).stdout
            self.assertEqual(said.count("as the model says"), 4, said)
            for name in ("v.csv", "v.jsonl", "v.hsv"):
                self.succeed("--check", self.out / name)

    def test_every_preset_passes_its_check(self):
        for config in PRESETS:
            self.succeed("--check", self.make(config=config, count=25))

    def test_the_manifest_says_what_was_made(self):
        told = json.loads(self.make("--seed", 7).read_text())
        self.assertEqual(told["halfspace_vectors"], 1)
        self.assertRegex(told["program"], r"^halfspace \d")
        self.assertEqual(told["config"]["viewport_bits"], 9)
        self.assertEqual((told["seed"], told["counts"]["inputs"]), (7, 40))
        self.assertEqual(told["source"], {"kind": "generator", "name": "all", "crc32": "00000000"})
        self.assertEqual(len(told["files"]), 7)
        for file in told["files"]:
            data = (self.out / file["name"]).read_bytes()
            self.assertEqual((file["bytes"], file["crc32"]), (len(data), f"{zlib.crc32(data):08x}"))

    def test_same_command_same_bytes(self):
        self.make()
        first = {p.name: p.read_bytes() for p in self.out.iterdir()}
        self.make()
        self.assertEqual({p.name: p.read_bytes() for p in self.out.iterdir()}, first)
        self.make("--seed", 2)
        self.assertNotEqual((self.out / "v.hsv").read_bytes(), first["v.hsv"])

    def test_a_mesh_and_a_tcov_file_are_sources(self):
        cube, public = SCENES / "tetrahedron.stl", TESTS / "data" / "public.tcov"
        for stage in ("rasterizer", "depth", "interpolation"):
            self.succeed(cube, "--size", "96x64", "--ortho", "0", "--stage", stage, "--out",
                         self.out / "m.csv")
            self.succeed("--check", self.out / "m.csv")
        told = json.loads((self.out / "m.manifest.json").read_text())
        self.assertEqual(told["source"], {"kind": "mesh", "name": "tetrahedron.stl",
                                          "crc32": f"{zlib.crc32(cube.read_bytes()):08x}"})
        said = self.succeed(public, "--count", 60, "--out", self.out / "t.hsv").stdout
        self.assertIn("60 inputs", said)
        self.succeed("--check", self.out / "t.hsv")

    def test_hex_words_are_whole_digits_and_ports_are_their_lowest_bits(self):
        self.make()
        told = json.loads((self.out / "v.manifest.json").read_text())
        for kind in ("run", "in", "out"):
            bits = sum(int(f.split()[1].rstrip("s")) for f in told["layout"][kind])
            lines = (self.out / f"v.{kind}.hex").read_text().splitlines()
            self.assertEqual({len(line) for line in lines}, {(bits + 3) // 4})
        # tag is the last field of triangle_t: numbers from 0.
        words = (self.out / "v.in.hex").read_text().splitlines()
        self.assertEqual([int(word, 16) & 0xffff for word in words], list(range(40)))

    def test_vectors_are_written_again_from_any_format(self):
        self.make()
        for name in ("v.csv", "v.jsonl", "v.manifest.json"):
            self.succeed("--from", self.out / name, "--out", self.out / "again.hsv")
            self.assertEqual((self.out / "again.hsv").read_bytes(),
                             (self.out / "v.hsv").read_bytes())

    # --- what --check finds -----------------------------------------------------------------------

    def test_a_changed_result_is_found_and_named(self):
        self.make(stage="coverage")
        lines = (self.out / "v.csv").read_text().splitlines()
        at = next(i for i, line in enumerate(lines) if line.startswith("out,"))
        cells = lines[at].split(",")
        mask = lines[1].split(",").index("out.mask[0]")
        cells[mask] = hex(int(cells[mask], 16) ^ 8)
        lines[at] = ",".join(cells)
        (self.out / "v.csv").write_text("\n".join(lines) + "\n")
        self.differs(self.out / "v.csv",
                     f"record {at - 2}: out 0: field=mask[0] file={cells[mask]}")

    def test_a_changed_clock_is_found(self):
        self.make()
        text = (self.out / "v.jsonl").read_text().splitlines()
        at = next(i for i, line in enumerate(text) if '"kind":"out"' in line)
        record = json.loads(text[at])
        record["clock"] += 1
        text[at] = json.dumps(record)
        (self.out / "v.jsonl").write_text("\n".join(text) + "\n")
        self.differs(self.out / "v.jsonl", f"record {at - 1}: out 0: field=clock")

    # --- how it fails -----------------------------------------------------------------------------

    def test_broken_files_are_refused(self):
        manifest = self.make()
        binary, csv = (self.out / "v.hsv").read_bytes(), (self.out / "v.csv").read_text()
        json_lines = (self.out / "v.jsonl").read_text()
        broken = self.out / "b.hsv"
        for data, says in ((binary[:-1], "CRC-32"), (b"", "truncated"), (binary[:12], "truncated"),
                           (b"X" + binary[1:], "magic"), (binary[:40] + b"?" + binary[41:], "CRC"),
                           (binary[:8] + b"\2" + binary[9:], "version 2")):
            broken.write_bytes(data)
            self.refuse("HS091", "--check", broken, says=says)
        broken = self.out / "b.csv"
        lines = csv.splitlines(keepends=True)
        for text in ("", lines[0], "".join(lines[:-1]), csv[:-1], csv.replace("in,", "inn,", 1),
                     csv.replace("kind,", "king,", 1), csv.replace('"samples":1', '"samples":2'),
                     csv.replace('"samples":1', '"samples":3'), csv.replace('"seed"', '"sead"'),
                     "".join([*lines[:2], lines[2].replace(",512,", ",70000,"), *lines[3:]])):
            broken.write_text(text)
            if text != csv:
                self.refuse("HS091", "--check", broken)
        broken = self.out / "b.jsonl"
        for text in ("", json_lines[:-1], json_lines.replace('"kind":"in"', '"kind":"im"', 1),
                     json_lines.replace('"offer":', '"ofer":', 1), json_lines + "{}\n"):
            broken.write_text(text)
            self.refuse("HS091", "--check", broken)
        hexed = self.out / "v.in.hex"
        hexed.write_text(hexed.read_text().replace("0", "1", 1))
        self.refuse("HS091", "--check", manifest, says="CRC-32")
        (self.out / "b.json").write_text("[]")
        self.refuse("HS091", "--check", self.out / "b.json")
        for name in ("none", "none.hsv", "none.csv", "none.json", "none.hex"):
            self.refuse("HS010", "--check", self.out / name, says="cannot read")
        for name in ("empty.csv", "empty.jsonl"):  # they have no line to name
            (self.out / name).write_text("")
            self.refuse("HS091", "--check", self.out / name, says=f"{name}: ")

    def test_illegal_stimulus_is_refused(self):
        self.make(stage="triangle_setup")
        text = (self.out / "v.jsonl").read_text().splitlines()
        record = json.loads(text[2])
        self.assertEqual(record["kind"], "in")
        record["vertex0.x"] = -1
        text[2] = json.dumps(record)
        (self.out / "v.jsonl").write_text("\n".join(text) + "\n")
        self.refuse("HS092", "--check", self.out / "v.jsonl", says="vertex0")

    def test_comparing_nothing_is_a_failure(self):
        self.refuse("HS093", "--generate", "no_area", "--stage", "coverage", "--out",
                    self.out / "n.csv", says="nothing to compare")
        self.make(stage="triangle_setup")
        lines = (self.out / "v.jsonl").read_text().splitlines()
        header = json.loads(lines[0])
        header["counts"] = {"runs": 1, "inputs": 0, "outputs": 0}
        (self.out / "v.jsonl").write_text(json.dumps(header) + "\n" + lines[1] + "\n")
        self.refuse("HS093", "--check", self.out / "v.jsonl")

    def test_requests_that_cannot_be_met_are_refused(self):
        csv = self.out / "v.csv"
        source = ("--generate", "all")
        self.refuse("HS090", "--out", csv, says="one source")
        self.refuse("HS090", *source, "--goal", "50", "--out", csv, says="one source")
        self.refuse("HS090", *source)
        self.refuse("HS090", *source, "--out", self.out / "v.txt", says=".jsonl")
        self.refuse("HS090", *source, "--out", csv, "--format", "xml")
        self.refuse("HS090", *source, "--out", csv, "--stage", "clip", says=", depth")
        self.refuse("HS090", "--generate", "round", "--out", csv, says="sliver")
        self.refuse("HS090", *source, "--out", csv, "--stall", "1")
        self.refuse("HS090", *source, "--out", csv, "--node-level", "1")
        self.refuse("HS090", *source, "--out", csv, "--stage", "tile_traversal", "--node-level",
                    "4")
        self.refuse("HS090", *source, "--bench", self.out / "b", "--stage", "depth",
                    says="RTL")
        self.refuse("HS090", "--goal", "0", "--out", csv)
        self.refuse("HS090", "--goal", "101%", "--out", csv)
        self.refuse("HS010", "--check", self.out / "absent.csv")
        self.refuse("HS030", *source, "--out", self.out / "no" / "v.csv")

    # --- coverage ---------------------------------------------------------------------------------

    def test_a_goal_that_is_missed_is_a_failure(self):
        done = self.run_program("--goal", "100", "--config", "tiny", "--tries", 20, "--out",
                                self.out / "g.csv")
        self.assertEqual(done.returncode, 1)
        self.assertIn("missed: ", done.stdout)
        lines = done.stdout.splitlines()
        self.assertIn("unreachable: mask.lacks.lane5: coverage is convex",
                      [line[:49] for line in lines])
        counts = {word: sum(line.startswith(f"{word}: ") for line in lines)
                  for word in ("missed", "unreachable")}
        said = re.search(r"(\d+) bins: (\d+) hit, (\d+) missed, (\d+) unreachable", done.stdout)
        self.assertEqual(counts, {"missed": int(said[3]), "unreachable": int(said[4])})
        self.assertGreater(counts["missed"], 0)

    def test_a_small_goal_takes_fewer_vectors(self):
        made = {}
        for goal in ("30%", "90%"):
            self.succeed("--goal", goal, "--config", "tiny", "--tries", 3000, "--out",
                         self.out / "g.csv")
            made[goal] = json.loads((self.out / "g.manifest.json").read_text())["counts"]["inputs"]
        self.assertLess(made["30%"], made["90%"])

    def test_committed_sets_are_right_and_hit_every_reachable_bin(self):
        self.assertEqual([p.stem for p in SETS], sorted(PRESETS))
        for path in SETS:
            self.succeed("--check", path.with_suffix(".manifest.json"))
            said = self.succeed("--bins", path).stdout
            self.assertIn("0 missed", said)
            self.assertIn("100.00 % of the reachable ones", said)
            # The command in docs/02_use/vectors.md makes them again.
            self.succeed("--goal", "100", "--times", 4, "--stall", "0.3", "--config", path.stem,
                         "--out", self.out / "new.csv")
            self.succeed("--from", path, "--out", self.out / "old.csv")
            new, old = ((self.out / f"{n}.csv").read_text().splitlines() for n in ("new", "old"))
            self.assertEqual(new[1:], old[1:])  # the first line names the program's version

    def test_a_bench_has_all_but_the_rtl(self):
        self.succeed("--generate", "all", "--count", 20, "--config", "tiny", "--bench",
                     self.out / "bench")
        names = {p.name for p in (self.out / "bench").iterdir()}
        self.assertEqual(names, {"hs_vectors_tb.sv", "hs_vectors_dut.sv", "hs_config_pkg.sv",
                                 "run_icarus.sh", "run_verilator.sh", "Makefile", "manifest.json",
                                 *(f"vectors.{k}.hex" for k in ("run", "in", "out", "ready"))})
        self.succeed("--check", self.out / "bench" / "manifest.json")
        for path in (self.out / "bench").iterdir():
            self.assertNotIn(str(self.out), path.read_text())


if __name__ == "__main__":
    unittest.main()
