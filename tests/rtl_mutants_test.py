#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The testbench bites: each fault put into a copy of the RTL is found, and its stage named.

A fault counts as found when cosim reports a mismatch of a stage, a bound checker fails, or a width
differs from the model's. The RTL without a fault must pass.

MUTANT_RUN is the program of testbench/synth/mutant_run.cpp, which builds the RTL it is given.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "testbench/synth"))
from rtl_sources import RTL

PROGRAM = os.environ["MUTANT_RUN"]
# Verilator's own part is the same for all.
COMPILER = "ccache c++" if shutil.which("ccache") else "c++"

# Fields of a node that a level hands on as they are; a difference must be named by the field.
PASSED_ON = ("slope1.b", "box.y_last", "corner2.inset")

# What goes wrong, the file, the text and what replaces it. A text occurs exactly once.
MUTANTS = [
    ("doubled area one bit narrower", "hs_pkg.sv",
     "2 * EXTENT_LOG2 + 2 * S + (EXTENT_REACHED ? 2 : 1);",
     "2 * EXTENT_LOG2 + 2 * S + (EXTENT_REACHED ? 1 : 0);"),
    ("constant's carry lost at the split of y", "hs_setup_edge.sv",
     "{high3 + low3, low3_q[Low-1:0]}", "{high3, low3_q[Low-1:0]}"),
    ("left edges not owned", "hs_setup_edge.sv",
     "assign top_left = a_above ||", "assign top_left = (a_above && !b_above) ||"),
    ("box's last pixel one too far", "hs_setup_box.sv",
     "LastStep = -1 - Low;", "LastStep = -Low;"),
    ("cull modes swapped", "hs_triangle_setup.sv",
     "hs_pkg::CULL_BACK: culled = !flipped5;\n      hs_pkg::CULL_FRONT: culled = flipped5;",
     "hs_pkg::CULL_BACK: culled = flipped5;\n      hs_pkg::CULL_FRONT: culled = !flipped5;"),
    ("triangle of no area not dropped", "hs_triangle_setup.sv",
     "dropped6_q <= area5_q == '0 || culled", "dropped6_q <= culled"),
    ("sign test of a lane flipped", "hs_half_plane_grid.sv",
     "assign covered[0]    = !left[Lane-1];", "assign covered[0]    = left[Lane-1];"),
    ("edge value at a child one bit narrower", "hs_child_step.sv",
     "ChildBits = hs_pkg::NODE_BASE_BITS + ChildLog2;",
     "ChildBits = hs_pkg::NODE_BASE_BITS + ChildLog2 - 1;"),
    ("saturation removed", "hs_child_step.sv",
     "assign over = !sum[NodeBits] && |sum[NodeBits-1:ChildBits-1];", "assign over = 1'b0;"),
    ("FIFO of one entry", "hs_fifo.sv",
     "assign ready_o   = !spare_valid_q;", "assign ready_o   = !head_valid_q;"),
    ("a register more between setup and root", "hs_rasterizer.sv",
     "assign link_valid[0]        = setup_valid;\n  assign link_node[0 +: Bits] = root;\n"
     "  assign setup_ready          = link_ready[0];",
     "hs_fifo #(.Bits(Bits)) u_more (.clk_i, .rst_ni, .valid_i(setup_valid), .ready_o(setup_ready),"
     " .data_i(root), .valid_o(link_valid[0]), .ready_i(link_ready[0]), "
     ".data_o(link_node[0 +: Bits]));"),
    ("a node stays after it was tested", "hs_tile_traversal.sv",
     "ready[2] = !valid_q[2] || ready[3];", "ready[2] = !valid_q[2];"),
    ("a node without a live child waits", "hs_tile_traversal.sv",
     "ready[3] = !valid_q[3] || !live3 || ready[4];", "ready[3] = !valid_q[3] || ready[4];"),
    ("empty tiles leave", "hs_coverage.sv",
     "assign covered4   = |coverage4_q.mask;", "assign covered4   = 1'b1;"),
    *((f"a bit of {field} flips on its way down", "hs_tile_traversal.sv",
       "    node_o.node.e0 = e0;",
       f"    node_o.node.e0 = e0;\n    node_o.{field}[0] = !node5_q.{field}[0];")
      for field in PASSED_ON),
]


def outcome(rtl, cache):
    """(passed, the line that says what was found)"""
    done = subprocess.run([PROGRAM], capture_output=True, text=True, timeout=600, check=False,
                          env={**os.environ, "HALFSPACE_RTL": str(rtl), "CXX": COMPILER,
                               "HALFSPACE_RTL_CACHE": str(cache)})
    text = done.stdout + done.stderr
    mismatch = re.search(r"mismatch: .*", text)
    if done.returncode == 0 and mismatch is None:
        return True, "; ".join(text.split("\n")).strip("; ")
    if mismatch is None:
        sys.exit(f"rtl_mutants: ended with {done.returncode} and no mismatch:\n{text[-3000:]}")
    if "stage=assertion" in mismatch[0]:
        where = re.search(r"Assertion failed in (.*)", text) or re.search(r"%Error: (.*)", text)
        return False, "checker: " + where[0]
    return False, mismatch[0]


def main():
    killed, start = 0, time.monotonic()
    with tempfile.TemporaryDirectory() as name:
        common = pathlib.Path(name)
        for number, mutant in enumerate([None, *MUTANTS]):
            folder = common / f"mutant{number}"
            rtl = folder / "rtl"
            shutil.copytree(RTL, rtl)
            if mutant is not None:
                what, file, before, after = mutant
                text = (rtl / file).read_text()
                if text.count(before) != 1:
                    sys.exit(f"rtl_mutants: {file} holds {text.count(before)} of: {before}")
                (rtl / file).write_text(text.replace(before, after))
            passed, line = outcome(rtl, folder / "cache")
            seconds = time.monotonic() - start
            if mutant is None:
                print(f"no fault: {line}  [{seconds:.0f} s]", flush=True)
                if not passed or "packets equal" not in line:
                    sys.exit("rtl_mutants: the RTL without a fault does not pass")
            else:
                killed += not passed
                wanted = [f"field={field} " for field in PASSED_ON if field in what]
                if not all(part in line for part in wanted):
                    sys.exit(f"rtl_mutants: {what}: the field is not named: {line}")
                verdict = "SURVIVES" if passed else "found"
                print(f"{verdict}: {what} ({file}): {line}  [{seconds:.0f} s]", flush=True)
            shutil.rmtree(folder)
    print(f"rtl_mutants: {killed} of {len(MUTANTS)} faults found")
    sys.exit(0 if killed == len(MUTANTS) and MUTANTS else 1)


if __name__ == "__main__":
    main()
