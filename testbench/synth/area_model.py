#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The coefficients of testbench/fit/area_model.cpp and their error: area_model.py HALFSPACE.

Least squares of relative errors over docs/charts/fit_area.json. The error printed for each
configuration is that of coefficients fitted to all the others. --measure synthesises the
configurations again first (a minute each)."""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy

sys.dont_write_bytecode = True
import tool_versions
from rtl_sources import ROOT

DATA = ROOT / "docs/charts/fit_area.json"
MODEL = {"ccu2c": ["pyramid_adders", "setup_adders"], "lut4": ["multiplexer", "one"],
         "ff": ["pyramid_state", "setup_state", "lanes"]}


def features(program, config):
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        file.write(json.dumps(config))
        file.flush()
        out = subprocess.run([program, "config", "--config", file.name, "--area"],
                             capture_output=True, text=True, check=True).stdout
    return {**json.loads(out)["features"], "one": 1.0}


def solve(rows, target, leave_out=None):
    keep = [r for i, r in enumerate(rows) if i != leave_out]
    matrix = [[f[name] / m[target] for name in MODEL[target]] for f, m in keep]
    return numpy.linalg.lstsq(numpy.array(matrix), numpy.ones(len(keep)), rcond=None)[0]


def predict(coefficients, f, target):
    return sum(c * f[name] for c, name in zip(coefficients, MODEL[target]))


def measure(program, entries):
    import area
    for entry in entries:
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "config.json").write_text(json.dumps(entry["config"]))
            package = subprocess.run([program, "config", "--config", folder / "config.json",
                                      "--package"], capture_output=True, text=True, check=True)
            (folder / "hs_config_pkg.sv").write_text(package.stdout)
            entry["measured"] = area.measure_flat(str(folder / "hs_config_pkg.sv"), folder)
    tools = json.dumps({"yosys": tool_versions.version("yosys")})
    rows = ",\n".join(" " + json.dumps(e) for e in entries)
    DATA.write_text(f'{{"tools": {tools}, "configurations": [\n{rows}\n]}}\n')


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", help="the halfspace program")
    parser.add_argument("--measure", action="store_true", help="synthesise again")
    arguments = parser.parse_args()
    entries = json.loads(DATA.read_text())["configurations"]
    if arguments.measure:
        measure(arguments.program, entries)
    rows = [(features(arguments.program, e["config"]), e["measured"]) for e in entries]
    for target in MODEL:
        print(target, dict(zip(MODEL[target], solve(rows, target).round(4).tolist())))
    worst = {"luts": 0.0, "ff": 0.0}
    for i, (f, m) in enumerate(rows):
        part = {t: predict(solve(rows, t, i), f, t) for t in MODEL}
        part["luts"] = part["lut4"] + 2 * part["ccu2c"]
        error = {t: 100 * (part[t] - m[t]) / m[t] for t in worst}
        worst = {t: max(worst[t], abs(error[t])) for t in worst}
        print(f"luts {m['luts']:6} {error['luts']:+5.1f} %   flip-flops {m['ff']:6} "
              f"{error['ff']:+5.1f} %   {entries[i]['config']}")
    print(f"worst: luts {worst['luts']:.1f} %, flip-flops {worst['ff']:.1f} %")


if __name__ == "__main__":
    main()
