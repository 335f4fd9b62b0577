# SPDX-License-Identifier: Apache-2.0
"""Charts of widths and levels: a function each, data in, figure out."""
import json
import pathlib

import matplotlib.pyplot as plt

CHARTS = pathlib.Path(__file__).resolve().parents[2] / "docs" / "charts"
BLUE, ORANGE, GREEN, RED, GREY = "#2b6cb0", "#dd6b20", "#2f855a", "#c53030", "#718096"


def stored(name):
    """A file of docs/charts, or nothing: what takes too long to measure with the rest."""
    path = CHARTS / name
    return json.loads(path.read_text()) if path.exists() else None


def subpixel(data):
    area = stored("subpixel_area.json")
    figure, axes = plt.subplots(1, 2 if area else 1, figsize=(11, 4.4), squeeze=False)
    left = axes[0][0]
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
        right = axes[0][1]
        rows = sorted((int(s), v) for s, v in area["subpixel_bits"].items())
        bits = [s for s, _ in rows]
        luts, = right.plot(bits, [v["flat"]["luts"] for _, v in rows], "-o", color=BLUE,
                           label="LUTs (ECP5)")
        clock = right.twinx()
        clock.grid(False)
        clock.spines["right"].set_visible(True)
        period, = clock.plot(bits, [v["asic"]["clock_ns"] for _, v in rows], "-s", color=ORANGE,
                             label="clock period (0.18 um, ideal wires)")
        clock.set(ylabel="clock period, ns", ylim=(0, None))
        right.set(xlabel=f"subpixel bits s (measured: {', '.join(map(str, bits))})",
                  ylabel="LUTs", ylim=(0, None), xticks=range(0, 13, 2),
                  title=f"Cost of the RTL, preset {area['preset']} at that width")
        right.legend(handles=[luts, period], loc="lower right")
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
        axes.set_xlabel("triangles in a square of this side, px")
    left.set(ylim=(0, 1), ylabel="covered / tested samples", title="Tests not wasted")
    right.set_yscale("log", base=2)
    right.set(ylabel="covered pixels per clock", title="Speed at a tile per clock")
    left.legend()
    right.legend()
    area = stored("subpixel_area.json")
    luts = [v["luts"] / 1000 for _, v in sorted((area or {}).get("tile_px", {}).items())]
    bars.set_visible(bool(luts))
    names = ["4x4 px", "8x8 px"]
    bars.bar(names[:len(luts)], luts, color=[GREEN, BLUE], width=0.55)
    for i, v in enumerate(luts):
        bars.text(i, v, f"{1000 * v:,.0f}", ha="center", va="bottom")
    bars.bar(["16x16 px"], [0])
    bars.text(len(luts), 0, "no RTL:\nnot measured", ha="center", va="bottom", color=RED)
    bars.set(ylabel="thousand LUTs (ECP5)", title="Area, preset tiny with that tile",
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
    ticks = [t for t in (1e-2, 1, 1e2, 1e4, 1e6) if t > floor]
    axes.set_yticks([floor, *ticks], ["0", *(f"{t:,.0f}" if t >= 1 else f"{t:g}" for t in ticks)])
    axes.minorticks_off()
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5))
    figure.suptitle(
        f"2k + s + 3 bits are exact (s = {data['subpixel_bits']}); one fewer is a cliff",
        fontweight="bold")
    figure.tight_layout()
    return figure


def ladder(data):
    rows = data["levels"]
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.6))
    colors = [GREEN, BLUE, ORANGE, RED]
    speed = [r.get("mpixels_per_cpu_second") or 0 for r in rows]
    least = min(s for s in speed if s)
    left.bar([r["level"] for r in rows], speed, color=colors, width=0.6)
    for i, r in enumerate(rows):
        v = r.get("mpixels_per_cpu_second")
        clocks = r.get("mclocks_per_cpu_second")
        label = f"{v:,.3g}" if v else "not in\nthis build"
        if clocks:
            label += f"\n({clocks:,.2g} Mclk/s)"
        left.text(i, speed[i] or least / 2, label, ha="center", va="bottom")
    left.set(yscale="log", ylabel="million covered pixels per CPU second", title="Speed",
             ylim=(least / 8, max(speed) * 5))
    ticks = [t for t in (0.01, 0.1, 1, 10, 100, 1000) if least / 8 <= t <= max(speed) * 5]
    left.set_yticks(ticks, [f"{t:g}" for t in ticks])
    left.minorticks_off()
    left.grid(False, axis="x")
    right.axis("off")
    right.grid(False)
    cells = [[r["level"], r["coverage"], r["packets"], r["clocks"]] for r in rows]
    table = right.table(cellText=cells, colLabels=["level", "coverage", "packets", "clocks"],
                        loc="center", cellLoc="center", colWidths=[0.2, 0.22, 0.24, 0.34])
    table.auto_set_font_size(False)
    table.set_fontsize(9)
    table.scale(1, 2.4)
    right.set_title("What is right")
    figure.suptitle("Model no more than a question needs"
                    f"\n{data['scene'].split('/')[-1]}, {data['width']}x{data['height']}, "
                    f"{data['triangles']:,} triangles", fontweight="bold")
    figure.subplots_adjust(top=0.8, bottom=0.1, left=0.08, right=0.98)
    return figure
