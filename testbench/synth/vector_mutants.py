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

--bits-only compares packets and their order, not clocks. --only FILE plays the faults that another
run of the same --count and --seed left in its --survivors. --prove SECONDS asks a SAT solver
whether a survivor is equivalent: from any state and input, reachable or not, the same next state
and outputs.
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
from tool_versions import tool


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
            "write_rtlil design.il; write_json design.json")
    run([tool("yosys"), "-q", "-p", read], folder)
    run([tool("yosys"), "-q", "-p", f"read_rtlil design.il; mutate -list {count} -seed {seed} "
         "-o faults.txt"], folder)
    faults = [line for line in (folder / "faults.txt").read_text().splitlines()
              if line.startswith("mutate") and "-mode none" not in line]
    script = ["read_rtlil design.il"]
    for number, fault in enumerate(faults, 1):
        script.append(fault.replace("mutate ", f"mutate -ctrl mutsel 32 {number} ", 1))
    script += ["rename mutated " + top, "opt_clean", "write_verilog -noattr netlist.v"]
    (folder / "mutate.ys").write_text("\n".join(script) + "\n")
    run([tool("yosys"), "-q", "-s", "mutate.ys"], folder)
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


def cut_registers(source, target, top):
    """Makes what registers hold inputs of the module and what they get outputs."""
    design = json.loads(source.read_text())
    (module,) = design["modules"].values()
    registers = sorted(n for n, cell in module["cells"].items() if "Q" in cell["connections"])
    for number, name in enumerate(registers):
        for port, bits in module["cells"].pop(name)["connections"].items():
            if port != "CLK":
                label = f"register{number}_{port}"
                direction = "input" if port == "Q" else "output"
                module["ports"][label] = {"direction": direction, "bits": bits}
                module["netnames"][label] = {"hide_name": 0, "bits": bits, "attributes": {}}
    target.write_text(json.dumps({**design, "modules": {top: module}}))


def equivalent(folder, number, fault, seconds):
    """Proven by SAT within that time."""
    work = folder / f"proof{number}"
    work.mkdir()
    for name, change in (("gold", ""), ("gate", fault)):
        # Nothing is cleaned away yet: both must have the same registers.
        run([tool("yosys"), "-q", "-p", f"read_rtlil {folder}/design.il; {change}; "
             f"write_json {work}/raw.json"], work)
        cut_registers(work / "raw.json", work / f"{name}.json", name)
    done = run([tool("yosys"), "-q", "-p", "read_json gold.json; read_json gate.json; opt_clean; "
                "miter -equiv -ignore_gold_x -flatten gold gate miter; hierarchy -top miter; "
                "delete gold gate; opt_merge -share_all; opt_expr -fine; opt_clean; "
                "opt_merge -share_all; opt_expr -full; opt_clean; "
                f"sat -verify -prove trigger 0 -timeout {seconds} miter"], work, check=False)
    if done.returncode != 0 and not re.search("proof did (fail|time out)", done.stderr):
        sys.exit(f"vector_mutants: the proof of fault {number} failed:\n{done.stderr[-2000:]}")
    shutil.rmtree(work)
    return done.returncode == 0


def build(folder):
    if shutil.which("ccache"):
        os.environ["OBJCACHE"] = "ccache"
    run([tool("verilator"), "--binary", "--timing", "-O3", "-CFLAGS", "-O1", "--x-assign", "unique",
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
    parser.add_argument("--only", help="the survivors of another run: play these alone")
    parser.add_argument("--prove", type=int, default=0, metavar="SECONDS",
                        help="for each survivor: try to prove it equivalent")
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
        numbers = range(1, len(faults) + 1)
        if o.only:
            lines = pathlib.Path(o.only).read_text().splitlines()
            numbers = [int(line.split()[0]) for line in lines]
            if any(faults[int(line.split()[0]) - 1] not in line for line in lines):
                sys.exit(f"vector_mutants: {o.only}: not the faults of this --count and --seed")
        with concurrent.futures.ThreadPoolExecutor(o.jobs) as pool:
            results = list(pool.map(lambda n: play(folder, n, options), numbers))
            unread = unread_bits(folder)
            passed = [n for n, (ok, _) in zip(numbers, results) if ok]
            dead = {n for n in passed if unread(faults[n - 1])}
            asked = [n for n in passed if o.prove and n not in dead]
            proofs = pool.map(lambda n: equivalent(folder, n, faults[n - 1], o.prove), asked)
            proven = {n for n, same in zip(asked, proofs) if same}
    report(o, manifest, results, passed, dead, proven)
    if o.survivors:
        marks = {**{n: "unread " for n in dead}, **{n: "equivalent " for n in proven}}
        pathlib.Path(o.survivors).write_text(
            "".join(f"{n} {marks.get(n, '')}{faults[n - 1]}\n" for n in passed))
    killed = len(results) - len(passed)
    sys.exit(0 if results and killed >= o.least * len(results) else 1)


def report(o, manifest, results, passed, dead, proven):
    counts, killed = manifest["counts"], len(results) - len(passed)
    print(f"{pathlib.Path(o.vectors).name}: {counts['inputs']} inputs, "
          f"{counts['outputs']} outputs: {killed} of {len(results)} faults killed "
          f"({100 * killed / max(len(results), 1):.1f} %), "
          f"{len(dead)} of the others are on bits that no output depends on")
    if o.prove:
        print(f"  {len(proven):5} more are proven equivalent, "
              f"{len(passed) - len(dead) - len(proven)} are not")
    reasons = {}
    for ok, why in results:
        if not ok:
            reasons[why] = reasons.get(why, 0) + 1
    for why, count in sorted(reasons.items(), key=lambda item: -item[1]):
        print(f"  {count:5} by: {why}")


if __name__ == "__main__":
    main()
