#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The RTL means the same to every tool: source in Verilator, yosys's netlist in Verilator and in
Icarus, all compared with the cycle model, clock for clock.

Icarus has four states: no output may be unknown after reset, no coverage while it is offered.
NETLIST_VECTORS names the program that writes the vectors (testbench/synth/netlist_vectors.cpp).
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "testbench/synth"))
from rtl_sources import config, design, yosys_read
from tool_versions import tool

START = time.monotonic()
VECTORS = os.environ["NETLIST_VECTORS"]
TESTBENCH = ROOT / "testbench/synth/netlist_tb.sv"
# Words, not gates: Icarus takes minutes to read the gates.
PASSES = "proc; flatten; opt -full; wreduce; peepopt; opt; clean -purge"


def run(*command, cwd):
    if os.environ.get("NETLIST_TIMES"):
        print(f"{time.monotonic() - START:6.1f} s {command[0]}", flush=True)
    done = subprocess.run([str(c) for c in command], cwd=cwd, capture_output=True, text=True)
    if done.returncode != 0:
        raise AssertionError(f"{command[0]}: {done.stdout[-2000:]}{done.stderr[-2000:]}")


def defines(folder):
    return [f"-D{name}={value}" for name, value in
            (line.split() for line in (folder / "widths.txt").read_text().splitlines())]


def verilator(name, sources, folder):
    build = folder / name
    if shutil.which("ccache"):
        os.environ["OBJCACHE"] = "ccache"  # Verilator's runtime is the same for all
    run(tool("verilator"), "--binary", "--timing", "-O3",
        "--x-assign", "unique", "--x-initial", "unique",
        "-Wno-fatal", "-Wno-lint", "-Wno-style", "-CFLAGS", "-O0", "--top-module", "netlist_tb",
        "--Mdir", build, "-o", "simulation", *defines(folder), *sources, TESTBENCH, cwd=folder)
    program = [build / "simulation", "+verilator+rand+reset+2", "+verilator+seed+7"]
    return play(program, name, folder)


def icarus(name, sources, folder):
    run("iverilog", "-g2012", "-s", "netlist_tb", "-o", folder / f"{name}.vvp", *defines(folder),
        *sources, TESTBENCH, cwd=folder)
    return play(["vvp", "-n", folder / f"{name}.vvp"], name, folder)


def play(command, name, folder):
    out = folder / f"{name}.txt"
    run(*command, f"+stimulus={folder / 'stimulus.hex'}", f"+out={out}", cwd=folder)
    return out.read_text().splitlines()


def handshakes(lines, folder):
    """What changed hands, in the words of expected.txt."""
    stimulus = (folder / "stimulus.hex").read_text().splitlines()
    bits = sum(int(d.split("=")[1]) for d in defines(folder) if re.match("-D(FRAME|TRIANGLE)", d))
    out = []
    for line in lines:
        clock, ready_o, valid_o, _, coverage = line.split()
        word = int(stimulus[int(clock)], 16) >> bits
        if word & 1 and ready_o == "1":
            out.append(f"accept {clock}")
        if word >> 1 & 1 and valid_o == "1":
            out.append(f"tile {clock} {coverage}")
    return out


class Netlist(unittest.TestCase):
    def same(self, preset):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            run(VECTORS, preset, folder, cwd=folder)
            netlist = folder / "netlist.v"
            run(tool("yosys"), "-q", "-p", f"{yosys_read(preset)}; {PASSES}; "
                f"write_verilog -noattr {netlist}", cwd=folder)
            outputs = {
                "verilator-source": verilator("source", [config(preset), *design()], folder),
                "verilator-netlist": verilator("netlist", [netlist], folder),
                "icarus-netlist": icarus("icarus", [netlist], folder)}
            expected = (folder / "expected.txt").read_text().splitlines()
            beats = sum(line.startswith("tile") for line in expected)
            self.assertGreater(beats, 100, "too little to compare")
            for simulator, lines in outputs.items():
                unknown = [line for line in lines if re.search("[xz]", line)]
                self.assertEqual(unknown[:3], [], f"{simulator}: unknown outputs")
                self.assertEqual(handshakes(lines, folder), expected, f"{simulator}: model differs")
                self.assertEqual(lines, outputs["verilator-source"], f"{simulator}: source differs")
                self.assertEqual(lines[-1].split()[3], "0", f"{simulator}: busy at the end")
            clocks = len(outputs["icarus-netlist"])
            print(f"{preset}: {beats} beats in {clocks} clocks equal in {', '.join(outputs)} "
                  f"and cycle model")

    def test_tiny_is_the_same_everywhere(self):
        self.same("tiny")

    def test_full_is_the_same_everywhere(self):
        self.same("full")


if __name__ == "__main__":
    unittest.main()
