#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""vector_mutants.py HALFSPACE VECTORS: do these vectors, alone, find faults put into the RTL?

yosys puts N faults (`mutate`) into the flattened netlist of the vectors' stage, each switched on by
a number at run time. Verilator builds the netlist once with the bench that `halfspace vectors
--from VECTORS --bench` writes, and plays it once for each fault. A fault is killed when the bench
fails.
Prints killed / total, and how many of the survivors are on bits that no output depends on, so that
no test could find them; exits with 1 when the share is below --least or when the design without a
fault fails.

--bits-only compares packets and their order, not clocks.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from rtl_sources import RTL, listed


def run(command, folder, check=True):
    done = subprocess.run([str(c) for c in command], cwd=folder, capture_output=True, text=True)
    if check and done.returncode != 0:
        sys.exit(f"vector_mutants: {command[0]} failed:\n"
                 f"{done.stdout[-2000:]}{done.stderr[-2000:]}")
    return done


def make_netlist(folder, top, count, seed):
    """netlist.v with all faults in it; the list of them, fault n being line n - 1."""
    files = [folder / "hs_config_pkg.sv", *listed(RTL, "rtl.f")]
    read = (f"read_verilog -sv {' '.join(map(str, files))}; hierarchy -check -top {top}; proc; "
            "flatten; opt -full; wreduce; peepopt; opt; clean -purge; rename -top mutated; "
            "write_ilang design.il; write_json design.json")
    run(["yosys", "-q", "-p", read], folder)
    run(["yosys", "-q", "-p", f"read_ilang design.il; mutate -list {count} -seed {seed} "
         "-o faults.txt"], folder)
    faults = [line for line in (folder / "faults.txt").read_text().splitlines()
              if line.startswith("mutate") and "-mode none" not in line]
    script = ["read_ilang design.il"]
    for number, fault in enumerate(faults, 1):
        script.append(fault.replace("mutate ", f"mutate -ctrl mutsel 32 {number} ", 1))
    script += ["rename mutated " + top, "opt_clean", "write_verilog -noattr netlist.v"]
    (folder / "mutate.ys").write_text("\n".join(script) + "\n")
    run(["yosys", "-q", "-s", "mutate.ys"], folder)
    return faults


# Cells of which output bit i depends on bit i of the data alone, and those where on bits 0..i.
BITWISE = {"$and", "$or", "$xor", "$xnor", "$not", "$pos", "$mux", "$pmux", "$dff", "$dffe",
           "$sdff", "$sdffe", "$sdffce"}
CARRYING = {"$add", "$sub", "$neg", "$mul"}


def sources(cell, bit, width):
    """The input bits of a cell that bit `bit` of its output, `width` bits wide, depends on."""
    used = []
    for port, bits in cell["connections"].items():
        if cell["port_directions"][port] != "input":
            continue
        data = port in ("A", "B", "D")
        if data and cell["type"] == "$pmux" and port == "B":
            bits = bits[bit::width]  # a word for each selector
        elif data and cell["type"] in BITWISE:
            bits = bits[bit:bit + 1] or bits[-1:]  # shorter operands are extended
        elif data and cell["type"] in CARRYING:
            bits = bits[:bit + 1]
        used += [b for b in bits if not isinstance(b, str)]
    return used


def read_bits(module):
    """The bits on which an output of the module depends, now or later."""
    driver = {b: (cell, i, len(bits)) for cell in module["cells"].values()
              for port, bits in cell["connections"].items()
              if cell["port_directions"][port] == "output" for i, b in enumerate(bits)}
    read = set()
    waiting = [b for port in module["ports"].values() if port["direction"] == "output"
               for b in port["bits"] if not isinstance(b, str)]
    while waiting:
        bit = waiting.pop()
        if bit in read:
            continue
        read.add(bit)
        if bit in driver:
            waiting += sources(*driver[bit])
    return read


def unread_bits(folder):
    """A test whether a fault is where no output can depend on it: equivalent by structure."""
    module = json.loads((folder / "design.json").read_text())["modules"]["mutated"]
    read = read_bits(module)

    def unread(fault):
        name = re.search(r"-cell (\S+)", fault)
        at = re.search(r"-port (\S+) -portbit (\d+)", fault)
        if name is None or at is None:
            return False
        # yosys writes a private name with its $, a public one behind a backslash.
        cell = module["cells"][name[1][1:] if name[1].startswith("\\") else name[1]]
        port, bit = at[1].lstrip("\\"), int(at[2])
        (output, bits), = [(p, b) for p, b in cell["connections"].items()
                           if cell["port_directions"][p] == "output"]
        if port == output:
            return bits[bit] not in read
        # The fault changes what this cell sees of the bit, nothing else.
        seen = cell["connections"][port][bit]
        if isinstance(seen, str) or cell["connections"][port].count(seen) > 1:
            return not any(b in read for b in bits)
        return not any(b in read and seen in sources(cell, i, len(bits))
                       for i, b in enumerate(bits))

    return unread


def build(folder):
    if shutil.which("ccache"):
        os.environ["OBJCACHE"] = "ccache"
    run(["verilator", "--binary", "--timing", "-O3", "-CFLAGS", "-O1", "--x-assign", "unique",
         "--x-initial", "unique", "-Wno-fatal", "-Wno-lint", "-Wno-style", "-DHS_NETLIST",
         "-DHS_MUTSEL", "--top-module", "hs_vectors_tb", "--Mdir", "build", "-o", "bench",
         "-j", "2", "netlist.v", "hs_vectors_dut.sv", "hs_vectors_tb.sv"], folder)


def play(folder, number, options):
    """(passed, why not)"""
    done = run([folder / "build/bench", f"+mutsel={number}", "+verilator+seed+7",
                "+verilator+rand+reset+2", *options], folder, check=False)
    text = done.stdout + done.stderr
    if done.returncode == 0 and re.search("^PASS: ", text, re.M):
        return True, ""
    why = re.search("^FAIL: ([^:]*)", text, re.M)
    return False, why[1].strip() if why else "ended early"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("halfspace")
    parser.add_argument("vectors", help="file or manifest that `halfspace vectors` wrote")
    parser.add_argument("--count", type=int, default=1000, help="faults")
    parser.add_argument("--seed", type=int, default=1, help="of the choice of faults")
    parser.add_argument("--least", type=float, default=0, help="share that must be killed, 0..1")
    parser.add_argument("--bits-only", action="store_true")
    parser.add_argument("--survivors", help="file for the survivors, a line each")
    parser.add_argument("--jobs", type=int, default=2)
    o = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        run([pathlib.Path(o.halfspace).resolve(), "vectors", "--from",
             pathlib.Path(o.vectors).resolve(), "--bench", folder], folder)
        manifest = json.loads((folder / "manifest.json").read_text())
        faults = make_netlist(folder, "hs_" + manifest["stage"], o.count, o.seed)
        build(folder)
        options = ["+bits_only"] if o.bits_only else []
        clean, why = play(folder, 0, options)
        if not clean:
            sys.exit(f"vector_mutants: the design without a fault fails: {why}")
        with concurrent.futures.ThreadPoolExecutor(o.jobs) as pool:
            results = list(pool.map(lambda n: play(folder, n, options), range(1, len(faults) + 1)))
        unread = unread_bits(folder)
    passed = [(n, fault) for n, (fault, (ok, _)) in enumerate(zip(faults, results), 1) if ok]
    survivors = [f"{n} {'unread ' if unread(fault) else ''}{fault}" for n, fault in passed]
    equivalent = sum(unread(fault) for _, fault in passed)
    killed = len(faults) - len(survivors)
    counts = manifest["counts"]
    print(f"{pathlib.Path(o.vectors).name}: {counts['inputs']} inputs, "
          f"{counts['outputs']} outputs: {killed} of {len(faults)} faults killed "
          f"({100 * killed / max(len(faults), 1):.1f} %), "
          f"{equivalent} of the others are on bits that no output depends on")
    reasons = {}
    for ok, why in results:
        if not ok:
            reasons[why] = reasons.get(why, 0) + 1
    for why, count in sorted(reasons.items(), key=lambda item: -item[1]):
        print(f"  {count:5} by: {why}")
    if o.survivors:
        pathlib.Path(o.survivors).write_text("\n".join(survivors) + "\n")
    sys.exit(0 if faults and killed >= o.least * len(faults) else 1)


if __name__ == "__main__":
    main()
