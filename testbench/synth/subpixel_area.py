#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""LUTs and clock of the RTL at several subpixel widths, LUTs at two tile sizes: area.py's recipe.

Writes docs/charts/subpixel_area.json. Preset `tiny` with one value changed, because it is measured
in minutes. What was measured before on the same RTL by the same recipe is taken
from the work folder, so an interrupted run goes on where it stopped.
"""
import argparse
import json
import pathlib
import re
import sys

sys.dont_write_bytecode = True
import area
import tool_versions
from rtl_sources import ROOT, config

BITS = list(range(13))
GRID_LOG2 = [2, 3]


def package(name, value, folder):
    """The configuration package of `tiny` with that value of one name."""
    text, count = re.subn(rf"(`define {name}) \d+", rf"\1 {value}", config("tiny").read_text())
    if count != 1:
        sys.exit("subpixel_area: the package of tiny has changed its form")
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / "hs_config_pkg.sv"
    if not path.exists() or path.read_text() != text:
        path.write_text(text)
    return path


def measured(preset, kind, wanted):
    """The figures of one package; nothing when they are not there and not wanted."""
    folder = preset.parent / f"{kind}-{area.digest(preset, kind)}"
    result = folder / "figures.json"
    if wanted and not result.exists():
        print(f"subpixel_area: measuring {preset.parent.name}, {kind}", flush=True)
        folder.mkdir(exist_ok=True)
        result.write_text(json.dumps(area.MEASURE[kind](preset, folder)))
    return json.loads(result.read_text()) if result.exists() else None


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--bits", nargs="+", type=int, default=BITS)
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build/area",
                        help="folder for netlists, logs and what is measured already")
    arguments = parser.parse_args()
    figures, tiles = {}, {}
    for bits in BITS:
        preset = package("HS_SUBPIXEL_BITS", bits, arguments.work / f"subpixel{bits}")
        rows = {kind: measured(preset, kind, bits in arguments.bits) for kind in ("flat", "asic")}
        if all(rows.values()):
            figures[str(bits)] = rows
    for log2 in GRID_LOG2:
        preset = package("HS_GRID_LOG2", log2, arguments.work / f"grid{log2}")
        row = measured(preset, "flat", True)
        if row:
            tiles[str(1 << log2)] = row
    data = {"command": "./run charts subpixel-area", "preset": "tiny",
            "tools": {"yosys": tool_versions.version("yosys"),
                      "opensta": area.version("sta", "-version")},
            "subpixel_bits": figures, "tile_px": tiles}
    out = ROOT / "docs/charts/subpixel_area.json"
    out.write_text(json.dumps(data, indent=1) + "\n")
    print(f"subpixel_area: wrote {out.relative_to(ROOT)}: {len(figures)} widths")


if __name__ == "__main__":
    main()
