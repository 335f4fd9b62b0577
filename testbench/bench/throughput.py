#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""throughput.py PROGRAM [CONFIG]: clocks of the RTL by triangle size and shape, a Markdown table.

Each row is a stream of triangles run through `halfspace cosim` without stalls, so the clocks are
the RTL's and the model's alike. Nothing here is timed: a row is a fact about the design."""
import json
import pathlib
import random
import subprocess
import sys
import tempfile

PROGRAM = sys.argv[1]
CONFIG = sys.argv[2] if len(sys.argv) > 2 else "full"
LATENCY = 25  # clocks, at most


def box(count, side, frame=2048):
    rng = random.Random(side)
    out = []
    for _ in range(count):
        x, y = (rng.randrange((frame - side) * 256) for _ in "xy")
        out.append([c + rng.randrange(side * 256 + 1) for _ in range(3) for c in (x, y)])
    return out


def px(*corners):
    return [[round(256 * c) for c in corners]]


one_tile = [[x, y, x + 2047, y, x, y + 2047]
            for i in range(2000) for x, y in [((i % 64) * 2048, (i // 64) * 2048)]]
ROWS = [  # name, frame side, triangles, target: clocks per triangle or per covered tile
    ("triangles inside one tile", 2048, one_tile, ("triangle", 1.00)),
    ("one triangle over 1024 x 1024", 1024, px(-1024, -1024, 4096, -1024, -1024, 4096),
     ("tile", 1.00)),
    ("in a 64 px box", 2048, box(4000, 64), ("tile", None)),
    ("in a 32 px box", 2048, box(4000, 32), ("tile", 1.08)),
    ("in a 16 px box", 2048, box(4000, 16), ("tile", 1.17)),
    ("in an 8 px box", 2048, box(4000, 8), ("tile", 1.30)),
    ("640 px diagonal sliver, 2.8 px wide", 648, px(0, 0, 640, 636, 636, 640), ("tile", 1.20)),
    ("640 px sliver, 1.4 px wide", 648, px(0, 0, 640, 638, 638, 640), ("tile", 1.20)),
    ("640 px sliver, 0.7 px wide", 648, px(0, 0, 640, 639, 639, 640), ("tile", 1.20)),
    ("640 px sliver off the diagonal", 656, px(3.3, 5.7, 643.3, 640.2, 642.1, 642.9),
     ("tile", 1.20)),
    ("640 px needle, 1 px at its end", 656, px(7.2, 3.6, 647.6, 642.9, 647.1, 643.9),
     ("tile", 1.20)),
]

print("| work | triangles | tiles | leaf tests | empty | clocks | clocks per, without latency "
      "| target |")
print("| --- | --- | --- | --- | --- | --- | --- | --- |")
for name, side, triangles, (unit, target) in ROWS:
    with tempfile.TemporaryDirectory() as folder:
        scene, stats = pathlib.Path(folder, "s.tcov"), pathlib.Path(folder, "s.json")
        lines = "\n".join(" ".join(map(str, t)) for t in triangles)
        scene.write_text(f"TCOV 1 1\ncase 0 t {side} {side} {len(triangles)} 0 0 0\n{lines}\n")
        subprocess.run([PROGRAM, "cosim", scene, "--config", CONFIG, "--stats", stats], check=True,
                       stdout=subprocess.DEVNULL)
        s = json.loads(stats.read_text())
    tiles, tests, clocks = s["tiles_covered"], s["tiles_visited"], s["cycles"]
    per = (clocks - LATENCY) / (len(triangles) if unit == "triangle" else tiles)
    met = "" if target is None else "met" if per <= target + 1e-9 else "missed"
    verdict = "" if target is None else f"{target:.2f}, {met}"
    print(f"| {name} | {len(triangles)} | {tiles} | {tests} | {100 * (1 - tiles / tests):.1f} % "
          f"| {clocks} | {per:.3f} per {unit} | {verdict} |")
