#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""LUTs and clock of the RTL at several subpixel widths, measured as area.py measures.

Writes docs/charts/subpixel_area.json. Preset `tiny` with another number of subpixel bits, because
it is measured in minutes. What was measured before on the same RTL by the same recipe is taken
from the work folder, so an interrupted run goes on where it stopped.
"""
import argparse
import json
import pathlib
import re
import sys

sys.dont_write_bytecode = True
import area
from rtl_sources import ROOT, config

BITS = [0, 4, 6, 8, 12]


def package(bits, folder):
    """The configuration package of `tiny` with that many subpixel bits."""
    text, count = re.subn(r"(`define HS_SUBPIXEL_BITS) \d+", rf"\1 {bits}",
                          config("tiny").read_text())
    if count != 1:
        sys.exit("subpixel_area: the package of tiny has changed its form")
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / "hs_config_pkg.sv"
    if not path.exists() or path.read_text() != text:
        path.write_text(text)
    return path


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--bits", nargs="+", type=int, default=BITS)
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build/area",
                        help="folder for netlists, logs and what is measured already")
    arguments = parser.parse_args()
    figures = {}
    for bits in BITS:
        preset = package(bits, arguments.work / f"subpixel{bits}")
        for kind in ("flat", "asic"):
            folder = preset.parent / f"{kind}-{area.digest(preset, kind)}"
            result = folder / "figures.json"
            if bits in arguments.bits and not result.exists():
                print(f"subpixel_area: measuring {bits} bits, {kind}", flush=True)
                folder.mkdir(exist_ok=True)
                result.write_text(json.dumps(area.MEASURE[kind](preset, folder)))
            if result.exists():
                figures.setdefault(str(bits), {})[kind] = json.loads(result.read_text())
    data = {"command": "./run charts subpixel-area", "preset": "tiny",
            "tools": {"yosys": area.version("yosys", "-V").split(" (")[0].removeprefix("Yosys "),
                      "opensta": area.version("sta", "-version")},
            "subpixel_bits": figures}
    out = ROOT / "docs/charts/subpixel_area.json"
    out.write_text(json.dumps(data, indent=1) + "\n")
    print(f"subpixel_area: wrote {out.relative_to(ROOT)}: {len(figures)} widths")


if __name__ == "__main__":
    main()
