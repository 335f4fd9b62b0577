# SPDX-License-Identifier: Apache-2.0
"""Charts of the gallery and of peers: a function each, data in, figure out."""
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LogNorm
from matplotlib.text import Text

BEST = 0.5  # where 0 is drawn on an axis of wrong pixels per million
DARK = "#2d3748"

# Each family's colour and mark; told apart by those who see fewer colours too.
FAMILIES = {"engine": ("#111827", "*"), "edge_walking": ("#e69f00", "^"),
            "polygons": ("#d55e00", "v"), "edge_functions": ("#0072b2", "o"),
            "fill_rules": ("#56b4e9", "s"), "barycentric": ("#009e73", "P"),
            "tiled": ("#cc79a7", "h"), "subdivision": ("#7c3aed", "X"),
            "interpolation": ("#9ca3af", "<"), "projection": ("#9ca3af", ">")}
# The points that a reader looks for: the fast, the exact, the textbook's, the slow.
NAMED = ("walk_prestep", "walk_no_prestep", "walk_exact", "parity_top_in", "aet_double",
         "edge_double_vertex", "edge_float_strict", "fill_top_left", "bary_area_float", "tiled_8",
         "table_n64", "hack_incremental_float", "warnock", "micropolygons", "engine_s0",
         "engine_s4", "engine_s8", "engine_s12", "halfspace_s0", "halfspace_s8")


def frontier(points):
    """Points that no other beats in both time and error, by time."""
    best, out = float("inf"), []
    for p in sorted(points, key=lambda p: (p["cpu_ns_per_triangle"], p["wrong_ppm"])):
        if p["wrong_ppm"] < best:
            best = p["wrong_ppm"]
            out.append(p)
    return out


def place(point):
    return point["cpu_ns_per_triangle"], max(point["wrong_ppm"], BEST)


def name_points(axis, named):
    """Writes each name beside its point, where it covers no other name and no point."""
    figure = axis.figure
    figure.canvas.draw()
    taken = [axis.transData.transform(offset) for scatter in axis.collections
             for offset in scatter.get_offsets()]
    boxes = []
    for text, at in named:
        best = None
        for away in (10, 18, 28, 40, 54, 70):
            for right, up in ((1, 0.5), (1, -0.5), (-1, 0.5), (-1, -0.5), (0.3, 1), (0.3, -1),
                              (-0.3, 1), (-0.3, -1)):
                label = axis.annotate(
                    text, at, (right * away, up * away), textcoords="offset points", fontsize=8,
                    ha="left" if right > 0 else "right", va="center", zorder=5,
                    arrowprops={"arrowstyle": "-", "color": DARK, "linewidth": 0.5, "shrinkA": 0,
                                "shrinkB": 2})
                label.update_positions(figure.canvas.get_renderer())
                box = Text.get_window_extent(label).padded(2)  # without the line to the point
                inside = axis.bbox.contains(box.x0, box.y0) and axis.bbox.contains(box.x1, box.y1)
                bad = (100 * (not inside) + 10 * sum(box.overlaps(b) for b in boxes)
                       + sum(box.contains(*xy) for xy in taken) + away / 1000)
                if best is None or bad < best[0]:
                    if best:
                        best[1].remove()
                    best = bad, label, box
                else:
                    label.remove()
        boxes.append(best[2])


def methods(data):
    panels = data["panels"]
    figure, axes = plt.subplots(len(panels), 1, figsize=(11, 4.9 * len(panels) + 0.5),
                                squeeze=False)
    families = [f for f in FAMILIES
                if any(p["family"] == f for panel in panels for p in panel["points"])]
    for axis, panel in zip(axes[:, 0], panels):
        engine = [p for p in panel["points"] if p["family"] == "engine"]
        stages = [p for p in panel["points"] if p["method"].startswith("halfspace_s")]
        loops = [p for p in panel["points"] if p not in engine and p not in stages]
        for family in families:
            mine = [place(p) for p in loops if p["family"] == family]
            if mine:
                axis.scatter(*zip(*mine), s=30, color=FAMILIES[family][0],
                             marker=FAMILIES[family][1], linewidths=0, zorder=3)
        axis.scatter(*zip(*map(place, engine)), s=75, color=FAMILIES["engine"][0], marker="*",
                     zorder=4)
        axis.scatter(*zip(*map(place, stages)), s=26, color="white", marker="D", zorder=4,
                     edgecolors=FAMILIES["engine"][0], linewidths=0.9)
        axis.set(xscale="log", yscale="log", xlabel="CPU time, ns per triangle",
                 ylabel="wrong pixels per million covered",
                 title=f"{panel['name'].split('/')[-1]} ({panel['triangles']:,} drawn)")
        for points, style in ((engine, "-"), (loops, "--")):
            front = [place(p) for p in frontier(points)]
            most = max(p["cpu_ns_per_triangle"] for p in points)
            axis.step([x for x, _ in front] + [most], [y for _, y in front] + [front[-1][1]],
                      where="post", color=DARK, linewidth=1, linestyle=style, zorder=2)
        ticks = [BEST, 10, 100, 1000, 1e4, 1e5, 1e6]
        axis.set_yticks(ticks, ["0", *(f"{t:,.0f}" for t in ticks[1:])])
        axis.set_ylim(BEST / 3, 2e6)
        axis.minorticks_off()
        left, right = axis.get_xlim()
        ticks = [t for n in range(7) for t in (10**n, 3 * 10**n) if left <= t <= right]
        axis.set_xticks(ticks, [f"{t:,}" for t in ticks])
    handles = [plt.Line2D([], [], linestyle="", marker=FAMILIES[f][1], color=FAMILIES[f][0],
                          label=f) for f in families if f != "engine"]
    handles[:0] = [
        plt.Line2D([], [], linestyle="-", marker="*", markersize=9, color=FAMILIES["engine"][0],
                   label="this design, engine, s = 0..12"),
        plt.Line2D([], [], linestyle="", marker="D", markeredgecolor=FAMILIES["engine"][0],
                   color="white", label="this design, stages, s = 0..12"),
        plt.Line2D([], [], color=DARK, linewidth=1, linestyle="--",
                   label="the best of the plain loops")]
    figure.suptitle("Speed against accuracy: exact methods are among the fastest",
                    fontweight="bold", y=0.997)
    figure.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0.983), fontsize=8,
                  ncol=4)
    figure.tight_layout(rect=(0, 0, 1, 1 - 0.85 / (4.9 * len(panels) + 0.5)))
    for axis, panel in zip(axes[:, 0], panels):
        name_points(axis, [(p["method"], place(p)) for p in panel["points"]
                           if p["method"] in NAMED])
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


# What an engine of bench is called here, its colour and its mark.
ENGINES = {"llvmpipe": ("Mesa llvmpipe", "#111827", "D"), "scalar": ("plain loop", "#9ca3af", "s"),
           "bit": ("plain stages of level bit", "#d55e00", "v"),
           "frame": ("frame engine, which render uses", "#0072b2", "o"),
           "cycle": ("cycle engine", "#e69f00", "^"),
           "coverage": ("coverage engine", "#009e73", "P")}
WORKS = {"coverage": ("Coverage of the same triangles", "ns per triangle",
                      "llvmpipe also writes pixels that level coverage only counts"),
         "frame": ("Whole frames of the same meshes: depth and colour", "ms per frame",
                   "the same pixels but for rounding")}


def peer_times(rows, work):
    """{engine: {workload: least time}}, in the unit of that work. Coverage is of the triangles that
    bench generates; meshes are drawn as frames."""
    meshes = {r["workload"] for r in rows if r["work"] == "frame"}
    times = {}
    for r in rows:
        if r["work"] != work or work == "coverage" and r["workload"] in meshes:
            continue
        engine, workload, value = r["engine"], r["workload"], r["ns_per_triangle"]
        if work == "frame":
            engine = "frame" if engine == "bit" and r["isa"] != "-" else engine
            workload += f"\n{r['size']}"
            value *= 1e-6 * r["triangles"]
        of = times.setdefault(engine, {})
        of[workload] = min(of.get(workload, float("inf")), value)
    return times


def peers(data):
    rows = [r for r in data if r["threads"] == 1]
    works = [w for w in WORKS if any(r["work"] == w for r in rows)]
    figure, axes = plt.subplots(len(works), 1, figsize=(10, 4.6 * len(works) + 0.4), squeeze=False)
    for axis, work in zip(axes[:, 0], works):
        times = peer_times(rows, work)
        workloads = list(dict.fromkeys(w for of in times.values() for w in of))
        title, unit, note = WORKS[work]
        for x, workload in enumerate(workloads):
            reach = [of[workload] for of in times.values() if workload in of]
            axis.plot([x, x], [min(reach), max(reach)], color="#e5e7eb", linewidth=6, zorder=1,
                      solid_capstyle="round")
        for engine, (label, color, mark) in ENGINES.items():
            of = times.get(engine, {})
            at = [(x, of[w]) for x, w in enumerate(workloads) if w in of]
            if at:
                axis.scatter(*zip(*at), s=46, color=color, marker=mark, label=label, zorder=3)
        axis.set(yscale="log", ylabel=f"{unit}, one thread", title=f"{title}\n({note})",
                 xlim=(-0.5, len(workloads) - 0.5))
        low, high = axis.get_ylim()
        ticks = [t for n in range(-3, 9) for t in (10.0**n, 3 * 10.0**n) if low <= t <= high]
        axis.set_yticks(ticks, [f"{t:,g}" if t < 1 else f"{t:,.0f}" for t in ticks])
        axis.minorticks_off()
        axis.set_xticks(range(len(workloads)), workloads)
        axis.legend(fontsize=8, loc="center left", bbox_to_anchor=(1, 0.5))
    figure.suptitle("Against llvmpipe: coverage by the size of triangles, and whole frames"
                    if "frame" in works else "Against llvmpipe, by the size of triangles",
                    fontweight="bold")
    figure.tight_layout()
    return figure
