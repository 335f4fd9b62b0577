#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What the program measures, drawn: SVG, the data as JSON beside it.

charts.py PROGRAM OUT [NAME ...]    measure with PROGRAM, write data and pictures into OUT
charts.py draw NAME DATA.json FILE  draw data that is there; FILE ends in .svg or .png

Needs Debian's python3-matplotlib. What the charts say: docs/charts/README.md."""
import json
import pathlib
import subprocess
import sys

import matplotlib

matplotlib.use("Agg")
matplotlib.rcParams.update({
    "svg.hashsalt": "halfspace",  # the same bytes every time
    "svg.fonttype": "none", "font.family": "DejaVu Sans", "font.size": 9,
    "axes.grid": True, "grid.alpha": 0.3, "axes.spines.top": False, "axes.spines.right": False,
    "legend.frameon": False, "figure.facecolor": "white"})

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import chart_figures  # noqa: E402
import chart_maps  # noqa: E402

FIGURES = {"methods": chart_maps.methods, "subpixel": chart_figures.subpixel,
           "ladder": chart_figures.ladder, "efficiency": chart_figures.efficiency,
           "interpolation": chart_figures.interpolation,
           "accumulator": chart_figures.accumulator, "stability": chart_maps.stability,
           "peers": chart_maps.peers}


def save(figure, path):
    figure.savefig(path, dpi=110, metadata={"Date": None} if path.suffix == ".svg" else None)


def measure(program, name, data):
    """Writes the data of a chart; false when this program cannot measure it."""
    scene = "tests/scenes/bunny.obj"  # from ROOT: its name is part of the data
    command = {"stability": [program, "stability", "--out", data],
               "ladder": [program, "chart", name, "--scene", scene, "--size", "1280x960",
                          "--out", data],
               "peers": [program, "bench", "--engine", "scalar", "bit", "coverage", "cycle",
                         "llvmpipe", "--threads", "1", "--scale", "0.2", "--workload", "small",
                         "medium", "large", "fullscreen", "sliver", "teapot", "bunny", "--out",
                         data]}
    done = subprocess.run(command.get(name, [program, "chart", name, "--out", data]),
                          stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, cwd=ROOT)
    if done.returncode != 0:
        print(f"charts: {name}: not measured: {done.stderr.strip()}", file=sys.stderr)
    return done.returncode == 0


def main():
    if sys.argv[1] == "draw":
        _, _, name, data, out = sys.argv
        try:
            save(FIGURES[name](json.loads(pathlib.Path(data).read_text())), pathlib.Path(out))
        except KeyboardInterrupt:
            return 130  # the program that started us says so
        except (ValueError, IndexError, KeyError, TypeError, ZeroDivisionError):
            return 3  # data of a scene that shows nothing
        return 0
    program, out = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    names = sys.argv[3:] or list(FIGURES)
    unknown = [n for n in names if n not in FIGURES]
    if unknown:
        sys.exit(f"charts: {unknown[0]} is not one of {', '.join(FIGURES)}")
    out.mkdir(parents=True, exist_ok=True)
    failed = 0
    for name in names:
        data = out / f"{name}.json"
        if not measure(program, name, data):
            failed += 1
            continue
        save(FIGURES[name](json.loads(data.read_text())), out / f"{name}.svg")
        print(f"charts: {out / name}.svg", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
