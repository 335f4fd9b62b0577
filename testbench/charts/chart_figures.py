# SPDX-License-Identifier: Apache-2.0
"""Charts of widths and levels: a function each, data in, figure out."""
import json
import pathlib

import matplotlib.pyplot as plt

CHARTS = pathlib.Path(__file__).resolve().parents[2] / "docs" / "charts"
BLUE, ORANGE, GREEN, RED, GREY, DARK = ("#2b6cb0", "#dd6b20", "#2f855a", "#c53030", "#718096",
                                        "#2d3748")


def stored(name):
    """A file of docs/charts, or nothing: what takes too long to measure with the rest."""
    path = CHARTS / name
    return json.loads(path.read_text()) if path.exists() else None


def subpixel(data):
    area = stored("subpixel_area.json")
    figure = plt.figure(figsize=(11, 5))
    grid = figure.add_gridspec(2, 2 if area else 1, width_ratios=(3, 2) if area else None)
    left = figure.add_subplot(grid[:, 0])
    for scene, color in zip(data["scenes"], (RED, BLUE, GREEN)):
        for snap, style in (("nearest_even", "-o"), ("truncate", "--")):
            rows = [r for r in scene["rows"] if r["snap"] == snap]
            label = scene["name"].split("/")[-1] + ("" if snap == "nearest_even" else ", truncated")
            left.plot([r["subpixel_bits"] for r in rows], [r["wrong_ppm"] or None for r in rows],
                      style, color=color, markersize=4, linewidth=1.2, label=label)
    left.set(yscale="log", xlabel="subpixel bits s", xticks=range(13),
             ylabel="wrong pixels per million covered",
             title="Error against vertices that were not snapped")
    left.legend()
    if area:
        rows = sorted((int(s), v) for s, v in area["subpixel_bits"].items())
        bits = [s for s, _ in rows]
        panels = (("LUTs (ECP5)", [v["flat"]["luts"] for _, v in rows], "{:,.0f}"),
                  ("clock period, ns\n(0.18 um, ideal wires)",
                   [v["asic"]["clock_ns"] for _, v in rows], "{:.2f}"))
        for n, (label, values, form) in enumerate(panels):
            axis = figure.add_subplot(grid[n, 1])
            axis.plot(bits, values, ":o", color=DARK, markersize=5, linewidth=1)
            for s, v in zip(bits, values):
                axis.annotate(form.format(v), (s, v), (0, 6), textcoords="offset points",
                              ha="center", fontsize=8)
            axis.set(ylabel=label, xlim=(-0.7, 12.9), ylim=(0, 1.25 * max(values)),
                     xticks=range(0, 13, 2))
            if n == 0:
                axis.set_title(f"Cost of the RTL, preset {area['preset']} at that width")
                axis.yaxis.set_major_formatter("{x:,.0f}")
        axis.set_xlabel(f"subpixel bits s (measured: {', '.join(map(str, bits))})")
    figure.suptitle("Each subpixel bit halves the error and costs a few per cent of area",
                    fontweight="bold")
    figure.tight_layout()
    return figure


def efficiency(data):
    figure, (left, right, bars) = plt.subplots(1, 3, figsize=(13, 4.4))
    colors = {4: GREEN, 8: BLUE, 16: RED}
    for tile in data["tiles"]:
        px, rows = tile["tile_px"], tile["rows"]
        style = "--o" if tile["how"] == "counted" else "-o"
        label = f"{px}x{px} px" + (": counted only, no RTL" if tile["how"] == "counted" else "")
        for axes, key in ((left, "efficiency"), (right, "pixels_per_clock")):
            axes.plot([r["side_px"] for r in rows], [r[key] for r in rows], style, markersize=4,
                      color=colors[px], label=label)
    for axes in (left, right):
        axes.set_xscale("log", base=2)
        sides = [r["side_px"] for r in data["tiles"][0]["rows"]]
        axes.set_xticks(sides, [f"{side:g}" for side in sides])
        axes.minorticks_off()
        axes.set_xlabel("side of the square around a triangle, px")
    left.set(ylim=(0, 1), ylabel="covered samples per tested sample",
             title="Share of the tests that count")
    right.set_yscale("log", base=2)
    ticks = [2.0**n for n in range(-4, 9) if right.get_ylim()[0] <= 2.0**n <= right.get_ylim()[1]]
    right.set_yticks(ticks, [f"{t:g}" for t in ticks])
    right.set(ylabel="covered pixels per clock", title="Speed at a tile per clock")
    left.legend()
    right.legend()
    area = stored("subpixel_area.json")
    luts = [v["luts"] for _, v in sorted((area or {}).get("tile_px", {}).items())]
    bars.set_visible(bool(luts))
    names = ["4x4 px", "8x8 px"]
    bars.bar(names[:len(luts)], luts, color=[GREEN, BLUE], width=0.55)
    for i, v in enumerate(luts):
        bars.text(i, v, f"{v:,.0f}", ha="center", va="bottom")
    bars.bar(["16x16 px"], [0])
    bars.text(len(luts), 0, "no RTL:\nnot measured", ha="center", va="bottom", color=RED)
    bars.yaxis.set_major_formatter("{x:,.0f}")
    bars.set(ylabel="LUTs (ECP5)", title="Area, preset tiny with that tile",
             ylim=(0, 1.12 * max(luts, default=1)))
    bars.grid(False, axis="x")
    figure.suptitle("A small tile wastes fewer tests; a large one covers more a clock"
                    f"\n{data['scene'].split('/')[-1]}", fontweight="bold")
    figure.tight_layout()
    return figure


def knee(rows, bits, error, slack=0.05):
    """The fewest bits whose error is within `slack` LSB of the best."""
    best = min(r[error] for r in rows)
    return min(r[bits] for r in rows if r[error] <= best + slack)


def interpolation(data):
    cost = stored("interpolation_area.json")
    figure, axes = plt.subplots(1, 3 if cost else 2, figsize=(13 if cost else 10, 4.4))
    panels = (("by_reciprocal_bits", "reciprocal_bits", "attribute", "8-bit attribute",
               "reciprocal bits R"),
              ("by_gradient_bits", "gradient_bits", "depth", f"{data['depth_bits']}-bit depth",
               "gradient fraction bits F"))
    for axis, (group, bits, what, name, label) in zip(axes, panels):
        rows = data[group]
        x = [r[bits] for r in rows]
        axis.plot(x, [r[f"{what}_max_lsb"] for r in rows], "-o", color=RED, label="greatest")
        axis.plot(x, [r[f"{what}_rms_lsb"] for r in rows], "-o", color=BLUE, label="RMS")
        axis.axhline(0.5, color=GREY, linestyle=":", label="rounding alone: 1/2")
        at = knee(rows, bits, f"{what}_max_lsb")
        value = next(r[f"{what}_max_lsb"] for r in rows if r[bits] == at)
        axis.annotate(f"knee: {at} bits, {value:.2f} LSB", (at, value), (0.45, 0.62),
                      textcoords="axes fraction", arrowprops={"arrowstyle": "->"})
        axis.set(yscale="log", xlabel=label, ylabel=f"error of {name}, LSB", title=name,
                 xticks=x)
        axis.set_yticks([0.25, 0.5, 1, 2, 4, 8], ["1/4", "1/2", "1", "2", "4", "8"])
        axis.minorticks_off()
        axis.legend()
    if cost:
        rows = sorted(((int(r), v) for r, v in cost["reciprocal_bits"].items()))
        axes[2].plot([r for r, _ in rows], [v["multiplier_luts"] for _, v in rows], "-o",
                     color=BLUE, label="multiplier, LUTs")
        axes[2].plot([r for r, _ in rows], [v["table_bits"] / 16 for _, v in rows], "--s",
                     color=ORANGE, label="reciprocal table, bits / 16 (a LUT4 each)")
        axes[2].set(yscale="log", xlabel="reciprocal bits R", ylabel="LUTs (ECP5)",
                    title="Cost of one perspective divider", xticks=range(6, 17))
        axes[2].legend()
    figure.suptitle("Interpolation: past the knee bits buy nothing, the final rounding remains"
                    f"\n{data['scene'].split('/')[-1]}", fontweight="bold")
    figure.tight_layout()
    return figure


def accumulator(data):
    figure, axes = plt.subplots(figsize=(12, 4.8))
    colors = plt.cm.viridis([i / max(len(data["scenes"]) - 0.5, 1)
                             for i in range(len(data["scenes"]))])
    floor = min((r["wrong_ppm"] for s in data["scenes"] for r in s["rows"] if r["wrong_ppm"]),
                default=1) / 10
    for scene, color in zip(data["scenes"], colors):
        x = [r["bits"] for r in scene["rows"]]
        name = scene["name"].split("/")[-1]
        if "extent_px" in scene:
            name += f": |x|, |y| < {scene['extent_px']} px"
        axes.plot(x, [max(r["wrong_ppm"], floor) for r in scene["rows"]], "-o", markersize=4,
                  color=color, label=f"{name}\n  formula {scene['formula_bits']}, "
                                     f"needed {scene['needed_bits']} bits")
        axes.axvline(scene["needed_bits"], color=color, linestyle=":", linewidth=1)
    axes.axvline(32, color=RED, linewidth=1)
    axes.text(32.1, floor * 1.3, "int32", color=RED)
    axes.set(yscale="log", xlabel="bits of the register that holds an edge value",
             ylabel="wrong samples per million tested")
    ticks = [10.0**n for n in range(-2, 7) if 10.0**n > 1.5 * floor]
    axes.set_yticks([floor, *ticks], ["0", *(f"{t:,.0f}" if t >= 1 else f"{t:g}" for t in ticks)])
    axes.minorticks_off()
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5))
    figure.suptitle(
        f"2k + s + 3 bits are exact (s = {data['subpixel_bits']}); one fewer is a cliff",
        fontweight="bold")
    figure.tight_layout()
    return figure


def ladder(data):
    rows = data["levels"][::-1]
    figure, axis = plt.subplots(figsize=(11, 1.4 + 0.62 * len(rows)))
    colors = {"coverage": GREEN, "bit": BLUE, "cycle": ORANGE, "rtl": RED}
    speed = [r.get("mpixels_per_cpu_second") for r in rows]
    least, most = min(filter(None, speed)), max(filter(None, speed))
    for y, (row, value) in enumerate(zip(rows, speed)):
        if not value:
            axis.text(least, y, "not in this build", va="center")
            continue
        axis.plot([value], [y], "o", color=colors[row["level"]], markersize=9)
        label = f"{value:,.3g}"
        if "mclocks_per_cpu_second" in row:
            label += f" ({row['mclocks_per_cpu_second']:,.2g} Mclk/s)"
        axis.annotate(label, (value, y), (0, 8), textcoords="offset points", ha="center")
    axis.set(xscale="log", xlim=(least / 2.5, most * 2.5), ylim=(-0.6, len(rows) - 0.2),
             xlabel="million covered pixels per CPU second of one thread")
    axis.set_yticks(range(len(rows)), [f"{r['level']}: {r['engine']}" for r in rows])
    ticks = [t for n in range(-2, 5) for t in (10**n, 3 * 10**n) if least / 2 < t < most * 2]
    axis.set_xticks(ticks, [f"{t:g}" for t in ticks])
    axis.minorticks_off()
    columns = (("coverage", 1.08), ("packets", 1.22), ("clocks", 1.37))
    for name, x in columns:
        axis.text(x, len(rows) - 0.35, name, transform=axis.get_yaxis_transform(), ha="center",
                  fontweight="bold")
        for y, row in enumerate(rows):
            axis.text(x, y, row[name], transform=axis.get_yaxis_transform(), ha="center",
                      va="center")
    figure.suptitle("Model no more than a question needs"
                    f"\n{data['scene'].split('/')[-1]}, {data['width']}x{data['height']}, "
                    f"{data['triangles']:,} triangles; the frame engine draws depth and colour too",
                    fontweight="bold")
    figure.subplots_adjust(left=0.16, right=0.68, top=0.8, bottom=0.14)
    return figure
