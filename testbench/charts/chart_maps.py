# SPDX-License-Identifier: Apache-2.0
"""Charts of the gallery and of peers: a function each, data in, figure out."""
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LogNorm

BEST = 0.5  # where 0 is drawn on an axis of wrong pixels per million


def pareto(points):
    """Points that no other beats in both time and error, by time."""
    best, out = float("inf"), []
    for p in sorted(points, key=lambda p: (p["cpu_ns_per_triangle"], p["wrong_ppm"])):
        if p["wrong_ppm"] < best:
            best = p["wrong_ppm"]
            out.append(p)
    return out


def methods(data):
    panels = data["panels"]
    families = sorted({p["family"] for panel in panels for p in panel["points"]})
    colors = {f: plt.cm.tab20(i % 20) for i, f in enumerate(families)}
    figure, axes = plt.subplots(1, len(panels), figsize=(5.6 * len(panels) + 2.2, 5.8),
                                sharey=True, squeeze=False)
    for axis, panel in zip(axes[0], panels):
        for p in panel["points"]:
            mine = p["family"] == "engine" or p["method"].startswith("halfspace_s")
            axis.scatter(p["cpu_ns_per_triangle"], max(p["wrong_ppm"], BEST), s=42 if mine else 22,
                         marker="*" if p["family"] == "engine" else "D" if mine else "o",
                         color=colors[p["family"]], edgecolors="black" if mine else "none",
                         linewidths=0.6, zorder=3)
        front = pareto(panel["points"])
        x = [p["cpu_ns_per_triangle"] for p in front]
        y = [max(p["wrong_ppm"], BEST) for p in front]
        axis.step(x + [max(p["cpu_ns_per_triangle"] for p in panel["points"])], y + [y[-1]],
                  where="post", color="#2d3748", linewidth=1, zorder=2, label="Pareto frontier")
        for n, p in enumerate(front):
            axis.annotate(p["method"], (x[n], y[n]), (3, 5) if n % 2 else (0, -12), ha="left",
                          textcoords="offset points", fontsize=7)
        axis.set(xscale="log", yscale="log", xlabel="CPU time, ns per triangle",
                 title=f"{panel['name'].split('/')[-1]} ({panel['triangles']:,} drawn)")
        ticks = [BEST, 10, 100, 1000, 1e4, 1e5, 1e6]
        axis.set_yticks(ticks, ["0", *(f"{t:,.0f}" for t in ticks[1:])])
        axis.set_ylim(BEST / 4, 3e6)
        axis.minorticks_off()
    axes[0][0].set_ylabel("wrong pixels per million covered")
    handles = [plt.Line2D([], [], linestyle="", marker="*" if f == "engine" else "o",
                          color=colors[f], label=f) for f in families]
    handles.append(plt.Line2D([], [], color="#2d3748", linewidth=1, label="Pareto frontier"))
    handles.append(plt.Line2D([], [], linestyle="", marker="D", markeredgecolor="black",
                              color="white", label="this design, s = 0..12"))
    axes[0][-1].legend(handles=handles, loc="center left", bbox_to_anchor=(1.0, 0.5), fontsize=8)
    figure.suptitle("Speed against accuracy: exact methods are among the fastest",
                    fontweight="bold")
    figure.tight_layout()
    return figure


MARKS = {"nan": "N", "crash": "X", "hang": "H", "order": "O"}


def stability(data):
    suites = [s["name"] for s in data["suites"]]
    names = [m["name"] for m in data["methods"]]
    cells = {(c["method"], c["suite"]): c for c in data["cells"]}
    grid = np.full((len(names), len(suites)), np.nan)
    for (method, suite), cell in cells.items():
        grid[names.index(method)][suites.index(suite)] = max(cell["wrong_ppm"], 0.1)
    figure, axes = plt.subplots(figsize=(3.6 + 0.52 * len(suites), 1.8 + 0.165 * len(names)))
    colors = plt.get_cmap("YlOrRd").copy()
    colors.set_bad("#e2e8f0")
    colors.set_under("#2f855a")
    image = axes.imshow(grid, aspect="auto", cmap=colors, norm=LogNorm(vmin=1, vmax=1e6))
    axes.grid(False)
    for (method, suite), cell in cells.items():
        text = "".join(MARKS[m] for m in cell["marks"])
        if text:
            axes.text(suites.index(suite), names.index(method), text, ha="center", va="center",
                      fontsize=6, fontweight="bold")
    exact = {s["name"] for s in data["suites"] if s["exact"]}
    axes.set_xticks(range(len(suites)), [s + ("" if s in exact else " *") for s in suites],
                    rotation=55, ha="left", rotation_mode="anchor")
    axes.xaxis.tick_top()
    axes.set_yticks(range(len(names)), names, fontsize=7)
    rows = [m["row"] for m in data["methods"]]
    for i in range(1, len(rows)):
        if rows[i] != rows[i - 1]:
            axes.axhline(i - 0.5, color="white", linewidth=1.5)
    bar = figure.colorbar(image, ax=axes, extend="min", shrink=0.4, pad=0.02)
    bar.set_label("wrong pixels per million covered; green: 0")
    axes.set_xlabel("grey: the method takes no such input.  N: NaN, X: crash, H: hang, "
                    "O: depends on order.\n*: not an exact column")
    figure.suptitle("Where methods fail", fontweight="bold", x=0.12, y=0.997)
    figure.tight_layout()
    return figure


def peers(data):
    rows = [r for r in data if r["threads"] == 1]
    works = [w for w in ("coverage", "frame") if any(r.get("work") == w for r in rows)]
    figure, axes = plt.subplots(1, max(len(works), 1), figsize=(5.8 * max(len(works), 1) + 1, 4.8),
                                squeeze=False)
    order = ["small", "medium", "large", "fullscreen", "sliver"]
    for axis, work in zip(axes[0], works):
        mine = [r for r in rows if r["work"] == work]
        workloads = [w for w in order if any(r["workload"] == w for r in mine)]
        workloads += sorted({r["workload"] for r in mine} - set(workloads))
        engines = list(dict.fromkeys(r["engine"] for r in mine))
        width = 0.8 / len(engines)
        for n, engine in enumerate(engines):
            best = {}
            for r in mine:
                if r["engine"] == engine:
                    w = r["workload"]
                    best[w] = min(best.get(w, float("inf")), r["ns_per_triangle"])
            x = [i + (n - (len(engines) - 1) / 2) * width for i in range(len(workloads))]
            axis.bar(x, [best.get(w, 0) for w in workloads], width, color=plt.cm.tab10(n),
                     label=engine)
        axis.set(yscale="log", ylabel="ns per triangle, one thread",
                 title=f"{work}: the same triangles, " + {
                     "coverage": "and llvmpipe writes pixels"}.get(work, "the same work"))
        axis.set_xticks(range(len(workloads)), workloads)
        axis.grid(False, axis="x")
        axis.legend(fontsize=8)
    figure.suptitle("Against llvmpipe, by the size of triangles", fontweight="bold")
    figure.tight_layout()
    return figure
