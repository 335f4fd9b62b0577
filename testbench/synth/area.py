#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Area and clock of the RTL, measured with yosys, OpenSTA and nextpnr-ice40.

Writes docs/charts/area.json and docs/04_develop/area.md. What was measured before on the same RTL
by the same recipe is taken from the work folder, so an interrupted run goes on where it stopped.
"""
import argparse
import collections
import hashlib
import inspect
import json
import pathlib
import re
import subprocess
import sys

sys.dont_write_bytecode = True
import area_page
import tool_versions
from rtl_sources import PRESETS, ROOT, TOP, config, design, yosys_read
from tool_versions import tool

HERE = pathlib.Path(__file__).resolve().parent
LIBERTY = pathlib.Path("/usr/share/qflow/tech/osu018/osu018_stdcells.lib")
CONSTRAINTS = HERE / "osu018.constr"
NAND2 = 24.0  # area of osu018's NAND2X1, um^2: the unit of a gate equivalent
CLOCK_NS = 7.0
STAGES = ["hs_triangle_setup", "*hs_tile_traversal*", "hs_coverage"]
ORDER = ["tiny", "full", "d3d", "msaa4"]
KINDS = ["stages", "flat", "asic", "ice40"]


def run(command, log):
    """Runs a tool, its output in a file; a failure shows the end of it."""
    with open(log, "w") as out:
        code = subprocess.run(command, stdout=out, stderr=subprocess.STDOUT).returncode
    if code != 0:
        sys.exit(f"area: {command[0]} failed, {log} ends:\n" + log.read_text()[-2000:])
    return log.read_text()


def yosys(commands, folder, name):
    script = folder / f"{name}.ys"
    script.write_text("\n".join(commands) + "\n")
    return run([tool("yosys"), "-q", str(script)], folder / f"{name}.log")


def stage_of(path):
    """The stage that a register of the flattened design belongs to, from the net that it drives."""
    level = re.search(r"gen_level\[(\d+)\]", path)
    # A stage's last register may be known as the input of the next.
    if re.search(r"(u_fifo\.data|u_traversal\.node|u_coverage\.tile)_i", path) and level:
        return f"tile_traversal[{int(level[1]) - 1}]" if int(level[1]) else "triangle_setup"
    if level:
        return f"tile_traversal[{level[1]}]"
    if re.match(r"u_coverage|coverage_o", path):
        return "coverage"
    return "triangle_setup" if path.startswith("u_setup") else "between stages"


# --- FPGA: synth_ecp5 -----------------------------------------------------------------------------
def luts(cells):
    """A row of the table from the cells of a part of the design."""
    row = {"lut4": cells.get("LUT4", 0), "ccu2c": cells.get("CCU2C", 0),
           "ff": cells.get("TRELLIS_FF", 0), "mult18": cells.get("MULT18X18D", 0)}
    if "DP16KD" in cells:
        row["dp16kd"] = cells["DP16KD"]
    row["luts"] = row["lut4"] + 2 * row["ccu2c"]
    return row


def module_cells(modules, name):
    """Cells of a module and of all it instantiates."""
    total = collections.Counter()
    for cell, count in modules[name]["num_cells_by_type"].items():
        inner = module_cells(modules, cell) if cell in modules else {cell: 1}
        for kind, n in inner.items():
            total[kind] += n * count
    return total


def ecp5(preset, folder, keep, top=TOP, parameters=()):
    out = folder / "stat.json"
    keep_stages = [f"setattr -mod -set keep_hierarchy 1 {s}" for s in STAGES] if keep else []
    yosys([yosys_read(preset, top, parameters), *keep_stages, f"synth_ecp5 -top {top}",
           f"tee -o {out} stat -json"], folder, "ecp5")
    text = out.read_text()
    stat = json.loads(text[text.index("{"):text.rindex("}") + 1])
    return {m.lstrip("\\"): body for m, body in stat["modules"].items()}, \
        luts(stat["design"]["num_cells_by_type"])


def measure_flat(preset, folder, top=TOP, parameters=()):
    return ecp5(preset, folder, False, top, parameters)[1]


def measure_stages(preset, folder):
    modules, total = ecp5(preset, folder, keep=True)
    rows = {}
    for name in modules:
        level = re.search(r"hs_tile_traversal\\Level=s32'([01]+)", name)
        if level:
            rows[f"tile_traversal[{int(level[1], 2)}]"] = luts(module_cells(modules, name))
        elif name == "hs_tile_traversal":
            rows["tile_traversal[0]"] = luts(module_cells(modules, name))
        elif name in ("hs_triangle_setup", "hs_coverage"):
            rows[name[3:]] = luts(module_cells(modules, name))
    if sum(row["luts"] for row in rows.values()) > total["luts"]:
        sys.exit("area: the stages are larger than the design")
    return {"total": total, "stages": rows}


# --- ASIC: osu018, OpenSTA ------------------------------------------------------------------------
TIMING = """
read_liberty {liberty}
read_verilog {netlist}
link_design {top}
create_clock -name clk -period {clock} [get_ports clk_i]
set_driving_cell -lib_cell INVX4 [all_inputs]
foreach p [find_timing_paths -path_delay max -group_count 1000000] {{
  puts "path [get_property $p slack] [get_property [get_property $p startpoint] full_name] \
[get_property [get_property $p endpoint] full_name]"
}}
report_checks -path_delay max -format full_clock_expanded -fields {{net}}
"""


def measure_asic(preset, folder, top=TOP, parameters=()):
    netlist = folder / "netlist.v"
    area = yosys([
        yosys_read(preset, top, parameters), f"synth -flatten -top {top} -run begin:check",
        f"dfflibmap -liberty {LIBERTY}", "opt",
        f"abc -D {int(1000 * CLOCK_NS)} -constr {CONSTRAINTS} -liberty {LIBERTY}",
        "setundef -zero", "splitnets -ports", "opt_clean -purge",
        f"tee -o {folder / 'stat.txt'} stat -liberty {LIBERTY}",
        f"write_verilog -noattr -noexpr {netlist}"], folder, "osu018")
    area = float(re.search(r"Chip area.*?: ([\d.]+)", (folder / "stat.txt").read_text())[1])
    script = folder / "timing.tcl"
    script.write_text(TIMING.format(liberty=LIBERTY, netlist=netlist, top=top, clock=CLOCK_NS))
    report = run(["sta", "-no_splash", "-exit", str(script)], folder / "timing.log")
    if "Error" in report:
        sys.exit(f"area: OpenSTA: {re.search('.*Error.*', report)[0]}")
    # Registers are known by the net that they drive.
    register = dict(re.findall(r"DFFPOSX1 (\S+) \(.*?\.Q\(\\?([^)]*?) ?\)\s*\)",
                               netlist.read_text(), re.S))
    stages, worst = {}, None
    for slack, start, end in re.findall(r"^path (\S+) (\S+) (\S+)$", report, re.M):
        names = [register.get(pin.rsplit("/", 1)[0], pin) for pin in (start, end)]
        path = {"ns": round(CLOCK_NS - float(slack), 2), "from": names[0], "to": names[1]}
        stage = stage_of(names[1])
        if stage not in stages or path["ns"] > stages[stage]["ns"]:
            stages[stage] = path
        if worst is None or path["ns"] > worst["ns"]:
            worst = path
    if worst is None:
        sys.exit("area: OpenSTA found no path")
    return {"area_um2": area, "kge": round(area / NAND2 / 1000, 1), "flip_flops": len(register),
            "clock_ns": worst["ns"], "path": worst, "stages": stages}


# --- FPGA with place and route: one block on an iCE40 hx8k ----------------------------------------
def measure_ice40(preset, folder):
    """A testing level between shift registers, placed and routed."""
    block = folder / "block.json"
    files = " ".join(str(f) for f in [config(preset), *design(), HERE / "level_on_pins.sv"])
    yosys([f"read_verilog -sv {files}", "hierarchy -check -top level_on_pins",
           f"synth_ice40 -top level_on_pins -json {block}"], folder, "ice40")
    log = run(["nextpnr-ice40", "--hx8k", "--package", "ct256", "--seed", "1", "--freq", "60",
               "--timing-allow-fail", "--json", str(block), "--asc", str(folder / "block.asc")],
              folder / "nextpnr.log")
    cells = re.search(r"ICESTORM_LC:\s*(\d+)/\s*(\d+)", log)
    clock = re.findall(r"Max frequency for clock.*?: ([\d.]+) MHz", log)[-1]
    return {"block": "tile_traversal[1]", "device": "hx8k", "logic_cells": int(cells[1]),
            "of": int(cells[2]), "mhz": float(clock)}


MEASURE = {"stages": measure_stages, "flat": measure_flat, "asic": measure_asic,
           "ice40": measure_ice40}


def digest(preset, kind):
    """Changes when the figures may: code without comments, recipe, tool."""
    text = "".join(re.sub(r"//.*", "", f.read_text()) for f in [config(preset), *design()])
    text += inspect.getsource(MEASURE[kind]) + version("yosys", "-V")
    text += {"asic": TIMING + CONSTRAINTS.read_text() + str(CLOCK_NS),
             "ice40": (HERE / "level_on_pins.sv").read_text()}.get(kind, inspect.getsource(ecp5))
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def version(*command):
    done = subprocess.run(command, capture_output=True, text=True)
    return (done.stdout + done.stderr).strip().split("\n")[0]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--presets", nargs="+", choices=PRESETS, default=ORDER)
    parser.add_argument("--kinds", nargs="+", choices=KINDS, default=KINDS)
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build/area",
                        help="folder for netlists, logs and what is measured already")
    arguments = parser.parse_args()
    wanted = [(p, k) for k in arguments.kinds for p in arguments.presets
              if k != "ice40" or p == "tiny"]
    # All at once: the recipe is this file, which may change while it runs.
    digests = {(p, k): digest(p, k) for p in ORDER for k in KINDS}
    figures = {}
    for preset in ORDER:
        for kind in KINDS:
            folder = arguments.work / f"{preset}-{kind}-{digests[preset, kind]}"
            result = folder / "figures.json"
            if (preset, kind) in wanted and not result.exists():
                print(f"area: measuring {preset}, {kind}", flush=True)
                folder.mkdir(parents=True, exist_ok=True)
                result.write_text(json.dumps(MEASURE[kind](preset, folder)))
            if result.exists():
                figures.setdefault(preset, {})[kind] = json.loads(result.read_text())
    tools = {"yosys": tool_versions.version("yosys"),
             "opensta": version("sta", "-version"),
             "nextpnr": version("nextpnr-ice40", "-V").split("Version ")[-1].rstrip(")")}
    data = {"tools": tools, "presets": figures}
    area_page.write(data, ROOT)
    print(f"area: wrote docs/charts/area.json and docs/04_develop/area.md: "
          f"{sum(len(f) for f in figures.values())} measurements")


if __name__ == "__main__":
    main()
