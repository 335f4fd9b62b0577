#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The RTL is clean in every configuration, and written in the subset that every tool reads alike.

- verilator --lint-only -Wall with the bound checkers, waivers only those of rtl/hs_lint.vlt
- yosys reads it, elaborates it, and check -assert finds nothing
- no construct that one of the tools does not read, or reads differently
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "testbench/synth"))
from rtl_sources import (BACK_END, PRESETS, RTL, TEST_CONFIGS, TOP, back_end, back_end_checkers,
                         checkers, config, design, yosys_read)
from tool_versions import tool

# What is read: the rasterizer in every configuration, each module of the back end in the presets.
DESIGNS = [(name, TOP) for name in [*PRESETS, *TEST_CONFIGS]]
DESIGNS += [(name, top) for name in PRESETS for top in BACK_END]
SAID = (f"{len(PRESETS)} presets and {len(TEST_CONFIGS)} test configurations, "
        f"{len(BACK_END)} modules of the back end in the presets")

DECLARED = re.compile(r"^\s*(?:(?:input|output)\s+)?(?:localparam\s+|parameter\s+)?"
                      r"(logic|bit|int|integer|genvar|[\w:]+_t)\b\s*(?:signed\b|unsigned\b)?\s*"
                      r"((?:\[[^\]]*\]\s*)*)(.*)")
# What a line must not hold, and why.
BANNED = [
    (re.compile(r"\bimport\b"), "import: yosys does not read it"),
    (re.compile(r"\breturn\b"), "return: yosys does not read it"),
    (re.compile(r"'\{"), "an assignment pattern: yosys does not read it"),
    (re.compile(r"\binside\b"), "inside: yosys does not read it"),
    (re.compile(r"\b(parameter|localparam)\s+type\b"), "a parameter type: yosys does not read it"),
    (re.compile(r"\b(interface|modport|class|union|queue)\b"), "beyond the subset"),
    (re.compile(r"\b(assert|assume|cover)\s+(property|\()"), "an assertion belongs to checkers/"),
    (re.compile(r"^\s*initial\b"), "an initial value: state begins with rst_ni"),
    (re.compile(r"\balways\b(?!_)"), "plain always: always_ff or always_comb"),
    (re.compile(r"\b(if\s*\(.*\)|else)\s+assign\b|\(\s*genvar\b(?!.*\bbegin : )"),
     "an unnamed generate block: newer Verilators warn"),
]


def faults(line):
    """What is wrong with one line of SystemVerilog."""
    code = re.sub(r"//.*|/\*.*?\*/", "", line)
    found = [why for pattern, why in BANNED if pattern.search(code)]
    declared = DECLARED.match(code)
    if declared:
        kind, packed, names = declared.groups()
        if kind.endswith("_t") and packed:
            found.append("an array of structs: yosys miscompiles it silently")
        if packed.count("[") > 1:
            found.append("an array of two dimensions: tools differ")
        names = names.split("=")[0]
        if re.match(r"\w+\s*\[", names) or re.search(r",\s*\w+\s*\[", names):
            found.append("an unpacked array: yosys miscompiles it silently")
    return found


class RtlLint(unittest.TestCase):
    def run_tool(self, *command):
        done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout[-3000:] + done.stderr[-3000:])

    def test_verilator_warns_of_nothing(self):
        for name, top in DESIGNS:
            with self.subTest(config=name, top=top):
                self.run_tool(tool("verilator"), "--lint-only", "-Wall", "--assert",
                              "--top-module", top, RTL / "hs_lint.vlt", config(name),
                              *([*design(), *checkers()] if top == TOP else
                                [*back_end(), *back_end_checkers()]))
        print(f"verilator: {SAID}")

    def test_yosys_finds_no_problem(self):
        for name, top in DESIGNS:
            with self.subTest(config=name, top=top):
                self.run_tool(tool("yosys"), "-q", "-e", "implicitly declared", "-p",
                              f"{yosys_read(name, top)}; proc; check -assert")
        print(f"yosys: {SAID}")

    def test_a_version_that_is_not_tested_is_noted_once(self):
        twice = "from tool_versions import tool; print(tool('yosys'), tool('yosys'))"
        for said, note in (("Yosys 0.52 (git sha1 0)", ""),
                           ("Yosys 0.60+1 (git sha1 0)",
                            "note: yosys 0.60 is not tested; 0.23 and 0.52 are\n")):
            with tempfile.TemporaryDirectory() as folder:
                fake = pathlib.Path(folder) / "yosys"
                fake.write_text(f"#!/bin/sh\necho '{said}'\n")
                fake.chmod(0o755)
                done = subprocess.run([sys.executable, "-B", "-c", twice], capture_output=True,
                                      text=True, check=True, cwd=ROOT / "testbench/synth",
                                      env={**os.environ, "PATH": f"{folder}:{os.environ['PATH']}"})
                self.assertEqual((done.stdout, done.stderr), ("yosys yosys\n", note))

    def test_every_module_is_listed(self):
        self.assertEqual(sorted({*design(), *back_end()}), sorted(RTL.glob("*.sv")))
        self.assertEqual(sorted({*checkers(), *back_end_checkers()}),
                         sorted((RTL / "checkers").glob("*.sv")))

    def test_source_stays_in_the_subset(self):
        lines = 0
        for path in {*design(), *back_end()}:
            for number, line in enumerate(path.read_text().splitlines(), 1):
                lines += 1
                if path.name == "hs_slot_memory.sv" and "memory [0:" in line:
                    continue  # the one memory: an array of plain words, which yosys reads right
                self.assertEqual(faults(line), [], f"{path.relative_to(ROOT)}:{number}: {line}")
        self.assertGreater(lines, 500)
        print(f"subset: {len(design())} files, {lines} lines, {len(BANNED) + 3} rules")

    def test_rules_of_the_subset_bite(self):
        bad = ["import hs_pkg::*;", "  hs_pkg::edge_t [2:0] edges;", "  hs_pkg::edge_t edges [3];",
               "  logic [3:0] a [4];", "  logic [3:0] a, b [4];", "  logic [3:0][1:0] a;",
               "  input  logic [7:0] a_i [2],", "    return a;", "  a = '{default: 0};",
               "  if (a inside {1, 2})", "  parameter type T = logic,", "  initial a = 0;",
               "  always @(posedge clk_i) a <= b;", "  assert property (a |-> b);",
               "  if (J == 0) assign a = b;", "  else assign a = b;",
               "  for (genvar j = 0; j < N; j++) begin", "  for (genvar j = 0; j < N; j++)"]
        good = ["  logic [3:0] a, b;", "  assign a = b[3:0];", "  hs_pkg::edge_t edge0, edge1;",
                "  localparam logic [3:0] A = B[3:0];", "  // import nothing, return nothing",
                "  logic signed [hs_pkg::N-1:0] a, b;", "  always_comb begin",
                "  for (genvar j = 0; j < N; j++) begin : gen_row", "  end else begin : gen_last"]
        for line in bad:
            self.assertNotEqual(faults(line), [], line)
        for line in good:
            self.assertEqual(faults(line), [], line)
        print(f"rules: {len(bad)} bad lines refused, {len(good)} good ones let through")


if __name__ == "__main__":
    if not PRESETS or not TEST_CONFIGS:
        sys.exit("no configurations found: nothing would be compared")
    unittest.main()
