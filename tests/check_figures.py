# SPDX-License-Identifier: Apache-2.0
"""The figures that a page quotes, computed anew from the file they come from. Part of
check_tree.py: problems(tree) gives a line for each sentence that the page does not have."""
import json
import re

CHARTS, README = "docs/charts/README.md", "README.md"


def data(tree, name):
    return json.loads(tree.text(f"docs/charts/{name}.json"))


def percent(before, after):
    return f"{100 * (after / before - 1):.0f} %"


def subpixel(tree):
    falls = []
    for scene in data(tree, "subpixel")["scenes"]:
        wrong = {r["subpixel_bits"]: r["wrong_ppm"] for r in scene["rows"]
                 if r["snap"] == "nearest_even"}
        falls.append(wrong[4] / wrong[8])
        if scene["name"] == "16 px triangles":
            yield CHARTS, (f"8 bits leave about {float(f'{wrong[8]:.2g}'):,.0f} wrong pixels per "
                           "million on 16 px triangles")
    area = data(tree, "subpixel_area")["subpixel_bits"]
    luts, clock, blocks = ({s: area[s][kind][key] for s in ("4", "8", "12")} for kind, key in
                           (("flat", "luts"), ("asic", "clock_ns"), ("flat", "mult18")))
    yield CHARTS, (f"from 4 to 8 bits the error falls {min(falls):.0f} to {max(falls):.0f} times "
                   f"for {percent(luts['4'], luts['8'])} more LUTs ({luts['4']:,} to "
                   f"{luts['8']:,}) and {percent(clock['4'], clock['8'])} more clock period "
                   f"({clock['4']} to {clock['8']} ns)")
    yield CHARTS, f"at 12 the multipliers double ({blocks['8']} to {blocks['12']} blocks)"


def methods(tree):
    def every(panel, mine):  # CPU times of the engine, or of the plain loops
        return [p["cpu_ns_per_triangle"] for p in panel["points"]
                if (p["family"] == "engine") == mine and not p["method"].startswith("halfspace_s")]

    faster = all(max(every(panel, True)) < min(every(panel, False))
                 for panel in data(tree, "methods")["panels"])
    yield CHARTS, f"The engine is {'' if faster else 'not '}faster than every plain loop"


def ladder(tree):
    seconds = {r["engine"]: r["cpu_seconds"] for r in data(tree, "ladder")["levels"]}

    def times(engine):  # as long as the coverage engine
        return seconds[engine] / seconds["coverage engine"]

    yield CHARTS, f"its frame engine takes {times('frame engine'):.1f} times as long as `coverage`"
    yield CHARTS, f"`cycle`, which takes {times('cycle engine'):.1f} times as long"
    yield CHARTS, f"take {times('plain stages'):.1f} times as long"
    yield CHARTS, f"`rtl` takes {times('Verilator'):.0f} times as long"


def efficiency(tree):
    speed = {t["tile_px"]: r["pixels_per_clock"] for t in data(tree, "efficiency")["tiles"]
             for r in t["rows"] if r["side_px"] == 64}
    luts = {n: v["luts"] for n, v in data(tree, "subpixel_area")["tile_px"].items()}
    yield CHARTS, (f"at 64 px it covers {speed[8] / speed[4]:.1f} times as much a clock, for "
                   f"{percent(luts['4'], luts['8'])} more LUTs ({luts['4']:,} to {luts['8']:,})")


def interpolation(tree):
    def knee(rows, bits, error):  # as the chart draws it
        most = min(r[error] for r in rows) + 0.05
        return next((r[bits], r[error]) for r in rows if r[error] <= most)

    measured = data(tree, "interpolation")
    bits, error = knee(measured["by_reciprocal_bits"], "reciprocal_bits", "attribute_max_lsb")
    most = measured["by_reciprocal_bits"][-1]
    table = {r: v["table_bits"]
             for r, v in data(tree, "interpolation_area")["reciprocal_bits"].items()}
    larger = table[str(most["reciprocal_bits"])] / table[str(bits)]
    gradient, _ = knee(measured["by_gradient_bits"], "gradient_bits", "depth_max_lsb")
    yield CHARTS, (f"a reciprocal of {bits} bits gives {error:.2f} LSB, and "
                   f"{most['reciprocal_bits']} bits, with a table {larger:.0f} times as large, "
                   f"{most['attribute_max_lsb']:.2f}; gradients need {gradient} fraction bits")


def accumulator(tree):
    fewer = {f"{r['wrong_ppm'] / 1e4:.0f}" for s in data(tree, "accumulator")["scenes"]
             for r in s["rows"] if r["bits"] == s["needed_bits"] - 1}
    yield CHARTS, f"one fewer makes {' to '.join(sorted(fewer))} % of samples wrong"


def peers(tree):
    times = {}
    frames = {}
    for row in data(tree, "peers"):
        if row["work"] == "coverage":
            key = row["workload"], row["engine"]
            times[key] = min(times.get(key, float("inf")), row["ns_per_triangle"])
        elif row["engine"] == "llvmpipe" or row["isa"] != "-":
            of = frames.setdefault((row["workload"], row["size"]), {})
            of[row["engine"]] = min(of.get(row["engine"], float("inf")), row["ns_per_triangle"])

    def faster(engine, choose, *workloads):
        return choose(times[w, "llvmpipe"] / times[w, engine] for w in workloads)

    every = ("small", "medium", "large", "fullscreen", "sliver")
    ahead = [of["llvmpipe"] / of["bit"] for of in frames.values()]
    yield CHARTS, (f"level coverage is {faster('coverage', min, 'sliver'):.0f} times (slivers), "
                   f"{faster('coverage', min, 'small', 'medium'):.0f} to "
                   f"{faster('coverage', max, 'small', 'medium'):.0f} times (medium, small) and up "
                   f"to {faster('coverage', max, *every):,.0f} times (full screen) faster than the "
                   "driver")
    yield CHARTS, f"level cycle is {faster('cycle', min, *every):.0f} times and more faster"
    yield CHARTS, (f"the plain stages of level bit take {1 / faster('bit', max, *every):.1f} to "
                   f"{1 / faster('bit', min, *every):.1f} times as long as the driver")
    yield CHARTS, f"the frame engine is {min(ahead):.1f} to {max(ahead):.1f} times faster"


def measured(tree):
    area = data(tree, "area")["presets"]
    yield README, (f"| {area['full']['flat']['luts']:,}, {area['tiny']['flat']['luts']:,}; "
                   f"{area['full']['asic']['clock_ns']} ns | `./run charts area`")
    hit = re.findall(r"^\| \w+ \| [\d,]+ \| \d+ \| ([\d,]+) of \1 ",
                     tree.text("docs/02_use/vectors.md"), re.M)
    yield README, f"| all: {', '.join(hit)} |"
    faults = re.search(r"^FAULTS = \[\n(.*?)^\]", tree.text("tests/dpi_test.py"), re.M | re.S)[1]
    count = len(re.findall(r"^    \(", faults, re.M))
    yield README, f"faulty copies of the RTL that the DPI-C scoreboard finds | {count} of {count} |"
    rows = re.findall(r"^\| bit avx3\w* (\|.*)$", tree.text("docs/02_use/bench.md"), re.M)
    ratios = [float(r) for row in rows for r in re.findall(r"\(([\d.]+)\)", row)]
    yield README, f"AVX-512 | {min(ratios):.1f} to {max(ratios):.1f} |"


def clocks(tree):
    page = tree.text("docs/03_design/timing.md")

    def per(row):
        return float(re.search(rf"^\| {row} \|.*\| ([\d.]+) per ", page, re.M)[1])

    yield README, (f"| {1 / per('triangles inside one tile'):.2f} a clock; "
                   f"{64 / per('one triangle over 1024 x 1024'):.0f} a clock; "
                   f"{per('in an 8 px box'):.2f} clocks a tile |")


def counted(tree):
    cases = re.match(r"TCOV 1 (\d+)\n", tree.text("tests/data/public.tcov"))[1]
    for page in (README, "docs/02_use/tcov.md", "docs/01_overview/levels.md"):
        yield page, f"{cases} cases"
    gallery = "docs/05_methods/README.md"
    rows = re.findall(r"^\| \d+ \|[^|]*\|[^|]*\|(.*)\|$", tree.text(gallery), re.M)
    names = sum(row.count("`") // 2 for row in rows)
    first, last = re.search(r"`halfspace_s(\d+)` to `halfspace_s(\d+)`", rows[-1]).groups()
    yield gallery, f"`methods` lists {names + int(last) - int(first) - 1} variants"
    for page in (README, "docs/01_overview/README.md"):
        yield page, f"{len(rows)} methods of the literature"


def sweep(tree):
    least, faster, waits, larger, smaller = {}, [], [], set(), set()
    records = [json.loads(line) for line in tree.text("docs/charts/sweep.jsonl").splitlines()]
    at = {(r["scene"], *(r["config"][key] for key in
                         ("samples", "subpixel_bits", "grid_log2", "setup_interval"))): r
          for r in records}
    yield CHARTS, f"{len(records)} cases"
    for (scene, samples, bits, grid, interval), r in at.items():
        if r["coverage_error"]["ppm"] <= 1000 and samples == 1:
            name = scene.split("/")[-1].split(".")[0]
            least[name] = min(bits, least.get(name, 99))
        if (bits, grid, interval) != (8, 3, 1):
            continue
        small, slow = at[scene, samples, 8, 2, 1], at[scene, samples, 8, 3, 3]
        speed = [x["clocks"]["pixels_per_clock"] for x in (r, small, slow)]
        faster.append(speed[0] / speed[1])
        waits.append(1 - speed[2] / speed[0])
        larger.add(percent(small["area"]["luts"], r["area"]["luts"]))
        smaller.add(f"{100 * (1 - slow['area']['luts'] / r['area']['luts']):.1f} %")
    yield CHARTS, (f"{min(faster):.1f} to {max(faster):.1f} times the pixels a clock for "
                   f"{' or '.join(sorted(larger))} more LUTs")
    yield CHARTS, (f"saves {' or '.join(sorted(smaller))} of the LUTs and costs up to "
                   f"{100 * max(waits):.0f} % of the pixels a clock")
    yield CHARTS, ", ".join(f"{bits} for {name}" for name, bits in
                            sorted(least.items(), key=lambda item: item[1]))


def problems(tree):
    for part in (methods, subpixel, ladder, efficiency, interpolation, accumulator, peers,
                 measured, clocks, counted, sweep):
        for page, sentence in part(tree):
            if sentence not in " ".join(tree.text(page).split()):
                yield f"{page}: the data says: {sentence}"
