#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""charts.py PROGRAM OUT: what the model measures, drawn. SVG and PNG, the data as JSON beside them.

efficiency: covered / tested samples and pixels per clock by triangle size, for 4x4 and 8x8 grids.
Everything is counted by the program on seeded triangles; nothing is timed."""
import json
import pathlib
import random
import subprocess
import sys
import tempfile

import matplotlib

matplotlib.use("Agg")
matplotlib.rcParams["svg.hashsalt"] = "halfspace"  # the same bytes every time
import matplotlib.pyplot as plt  # noqa: E402

PROGRAM, OUT = sys.argv[1], pathlib.Path(sys.argv[2])
FRAME = 2048
SIZES = [2, 4, 8, 16, 32, 64, 128, 256, 512, 1024]  # side of the square that holds a triangle, px
GRIDS = {4: {"preset": "full", "grid_log2": 2}, 8: {"preset": "full"}}


def triangles(side):
    rng = random.Random(side)
    for _ in range(max(20, min(2000, 4_000_000 // (side * side)))):
        x, y = (rng.randrange((FRAME - side) * 256 + 1) for _ in "xy")
        yield [c + rng.randrange(side * 256 + 1) for _ in range(3) for c in (x, y)]


def measure(side, config, folder):
    scene, stats, settings = (folder / n for n in ("s.tcov", "s.json", "c.json"))
    lines = [" ".join(map(str, t)) for t in triangles(side)]
    scene.write_text(f"TCOV 1 1\ncase 0 t {FRAME} {FRAME} {len(lines)} 0 0 0\n" + "\n".join(lines) + "\n")
    settings.write_text(json.dumps(config))
    subprocess.run([PROGRAM, "coverage", scene, "--level", "cycle", "--config", settings,
                    "--out", folder / "o.tcov", "--stats", stats], check=True)
    s = json.loads(stats.read_text())
    return {"side_px": side, "triangles": s["triangles"], "samples_covered": s["samples_covered"],
            "samples_tested": s["samples_tested"], "cycles": s["cycles"],
            "efficiency": s["samples_covered"] / s["samples_tested"],
            "pixels_per_clock": s["fragments"] / s["cycles"]}


def draw(data):
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4))
    for grid, rows in data.items():
        sides = [r["side_px"] for r in rows]
        left.plot(sides, [r["efficiency"] for r in rows], marker="o", label=f"{grid}x{grid} grid")
        right.plot(sides, [r["pixels_per_clock"] for r in rows], marker="o", label=f"{grid}x{grid} grid")
    left.set_ylabel("covered / tested samples")
    right.set_ylabel("covered pixels per clock")
    for axes in (left, right):
        axes.set_xlabel("triangles in a square of this side, px")
        axes.set_xscale("log", base=2)
        axes.grid(True, alpha=0.3)
        axes.legend()
    left.set_ylim(0, 1)
    right.set_yscale("log", base=2)
    figure.suptitle("A small grid wastes fewer tests; a large one covers more a clock, at every size")
    figure.tight_layout()
    for kind in ("svg", "png"):
        figure.savefig(OUT / f"efficiency.{kind}", metadata={"Date": None} if kind == "svg" else None)


OUT.mkdir(parents=True, exist_ok=True)
with tempfile.TemporaryDirectory() as name:
    data = {grid: [measure(side, config, pathlib.Path(name)) for side in SIZES]
            for grid, config in GRIDS.items()}
(OUT / "efficiency.json").write_text(json.dumps(data, indent=1) + "\n")
draw(data)
for grid, rows in data.items():
    for r in rows:
        print(f"grid {grid}  side {r['side_px']:5} px  efficiency {r['efficiency']:.3f}  "
              f"{r['pixels_per_clock']:.2f} px/clock")
