#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""mutant_proof.py SURVIVORS FOLDER: which surviving faults change nothing?

SURVIVORS is what vector_mutants.py --survivors wrote, FOLDER a bench of the same configuration
(`halfspace vectors --bench FOLDER`). yosys compares the design with the faulty one: registers and
ports of the same name are assumed equal, everything they are computed from must be proven equal
(equiv_make, equiv_struct, equiv_simple). Wires between that differ stop being assumed and the proof
is made again without them. Equal next states from equal states, and equal outputs, mean equal for
ever; a fault that is not proven may still be equivalent. Prints a line a fault.
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from rtl_sources import RTL, listed


def yosys(script, folder):
    done = subprocess.run(["yosys", "-p", script], cwd=folder, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"mutant_proof: yosys failed:\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    return done.stdout


def states(folder):
    """Names that hold a register's output or a port."""
    module = json.loads((folder / "design.json").read_text())["modules"]["mutated"]
    bits = {bit for port in module["ports"].values() for bit in port["bits"]}
    for cell in module["cells"].values():
        if "dff" in cell["type"]:
            bits.update(cell["connections"]["Q"])
    return {name for name, net in module["netnames"].items() if bits & set(net["bits"])}


def proven(fault, state, folder):
    between = set()
    for _ in range(6):
        (folder / "between.txt").write_text("\n".join(sorted(between)) + "\n")
        said = yosys("read_ilang design.il; rename mutated gold; design -stash g; "
                     f"read_ilang design.il; {fault}; rename mutated gate; "
                     "design -copy-from g -as gold gold; "
                     "equiv_make -blacklist between.txt gold gate equiv; hierarchy -top equiv; "
                     "equiv_struct -icells; equiv_simple; equiv_status", folder)
        if re.search(r"Of those cells \d+ are proven and 0 are unproven", said):
            return True
        differ = set(re.findall(r"Unproven \$equiv \S+: \\?(\S+)_gold", said))
        if not differ or differ & state or differ <= between:
            return False
        between |= differ
    return False


def main():
    survivors = pathlib.Path(sys.argv[1]).read_text().splitlines()
    bench = pathlib.Path(sys.argv[2]).resolve()
    top = "hs_" + json.loads((bench / "manifest.json").read_text())["stage"]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        files = [bench / "hs_config_pkg.sv", *listed(RTL, "rtl.f")]
        yosys(f"read_verilog -sv {' '.join(map(str, files))}; hierarchy -check -top {top}; proc; "
              "flatten; opt -full; wreduce; peepopt; opt; clean -purge; rename -top mutated; "
              "write_ilang design.il; write_json design.json", folder)
        state = states(folder)
        count = 0
        for line in survivors:
            number, fault = line.split(" ", 1)
            if fault.startswith("unread"):
                continue
            equivalent = proven(fault, state, folder)
            count += equivalent
            print(f"{number} {'equivalent' if equivalent else 'not proven'}", flush=True)
        print(f"mutant_proof: {count} proven equivalent")


if __name__ == "__main__":
    main()
