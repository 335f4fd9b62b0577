#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""sweep_chart.py SWEEP.jsonl DIR: area against error against throughput, as DIR/sweep.svg and as
DIR/index.html, where pointing at a point shows its record. Needs Python's standard library alone.

A point is a case with coverage_error, clocks and area. Pareto points are those that no other case
of the same scene, size, view and samples equals or betters in all three and betters in one."""
import html
import json
import math
import pathlib
import sys

WIDTH, HEIGHT, LEFT, BOTTOM, TOP = 900, 340, 70, 46, 34
LIMITS_PPM = (10000, 3000, 1000, 300, 100, 30)
LEAST_PIXELS = (1, 2, 4, 8, 16)


class Point:
    def __init__(self, record):
        self.record = record
        self.area = record["area"]["luts"]
        self.ppm = record["coverage_error"]["ppm"]
        self.speed = record["clocks"]["pixels_per_clock"]
        self.is_pareto = False

    def betters(self, other):
        mine, its = (-self.area, -self.ppm, self.speed), (-other.area, -other.ppm, other.speed)
        return mine != its and all(a >= b for a, b in zip(mine, its))


def read(path):
    """Points by scene, size, view and samples, in the order of the file."""
    groups = {}
    for line in path.read_text().splitlines():
        record = json.loads(line)
        if "error" in record or not {"area", "coverage_error", "clocks"} <= record.keys():
            continue
        name = f"{record['scene']} {record['size']}"
        name += f", view {record['view']}" if record["view"] else ""
        samples = record["config"]["samples"]
        name += f", {samples} samples" if samples > 1 else ", 1 sample"
        groups.setdefault(name, []).append(Point(record))
    for points in groups.values():
        front = []  # a point is bettered only by one with no more area
        for point in sorted(points, key=lambda p: (p.area, p.ppm, -p.speed)):
            if not any(other.betters(point) for other in front):
                point.is_pareto = True
                front.append(point)
    return groups


def swept(groups):
    """The fields of the configuration that differ between records."""
    configs = [p.record["config"] for points in groups.values() for p in points]
    return [key for key in configs[0]
            if key != "samples" and any(c[key] != configs[0][key] for c in configs)]


def name_of(point, fields):
    return ", ".join(f"{key} {point.record['config'][key]}" for key in fields) or "the base"


def colour(share):
    """Slow is blue, fast is orange; both are told apart without red and green."""
    low, high = (33, 102, 172), (230, 120, 20)
    return "#" + "".join(f"{round(a + share * (b - a)):02x}" for a, b in zip(low, high))


def scale(values, low, high, logarithmic):
    """A function to pixels, and its ticks."""
    if logarithmic:
        first, last = math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))
        last = max(last, first + 1)
        ticks = [10.0 ** e for e in range(first, last + 1)]
        return (lambda v: low + (math.log10(v) - first) / (last - first) * (high - low)), ticks
    step = 10 ** math.floor(math.log10(max(values)))
    step = next(s for s in (step / 5, step / 2, step, 2 * step) if max(values) / s <= 10)
    last = math.ceil(max(values) / step)
    return (lambda v: low + v / (last * step) * (high - low)), [i * step for i in range(last + 1)]


def panel(name, points, fields, top, first):
    """One scene's points; `first` is the number of its first point in the page."""
    floor = min([p.ppm for p in points if p.ppm > 0] or [1]) / 2  # where no error is drawn
    x, x_ticks = scale([p.area for p in points], LEFT, WIDTH - 20, False)
    y, y_ticks = scale([max(p.ppm, floor) for p in points], top + HEIGHT - BOTTOM, top + TOP, True)
    fastest = max(p.speed for p in points) or 1
    out = [f'<text x="{LEFT}" y="{top + 20}" class="t">{html.escape(name)}</text>']
    for tick in x_ticks:
        out.append(f'<path d="M{x(tick):.1f} {top + TOP}V{top + HEIGHT - BOTTOM}" class="g"/>'
                   f'<text x="{x(tick):.1f}" y="{top + HEIGHT - 30}" class="m">{tick:g}</text>')
    for tick in y_ticks:
        out.append(f'<path d="M{LEFT} {y(tick):.1f}H{WIDTH - 20}" class="g"/>'
                   f'<text x="{LEFT - 6}" y="{y(tick) + 4:.1f}" class="e">{tick:g}</text>')
    out.append(f'<text x="{(LEFT + WIDTH) / 2:.0f}" y="{top + HEIGHT - 10}" class="m">estimated '
               f'area, LUTs of ECP5; blue {0} to orange {fastest:.1f} px/clk; ringed: Pareto</text>'
               f'<text transform="translate(16 {top + HEIGHT / 2:.0f}) rotate(-90)" class="m">'
               'wrong coverage, ppm</text>')
    for i, p in enumerate(points):
        ring = ' stroke="#000" stroke-width="1.6"' if p.is_pareto else ""
        out.append(f'<circle cx="{x(p.area):.1f}" cy="{y(max(p.ppm, floor)):.1f}" r="5" '
                   f'fill="{colour(p.speed / fastest)}"{ring} data-point="{first + i}">'
                   f'<title>{html.escape(name_of(p, fields))}: {p.area:.0f} LUTs, {p.ppm:.0f} ppm, '
                   f'{p.speed:.2f} px/clk</title></circle>')
    return "".join(out)


def picture(groups, fields):
    parts, first = [], 0
    for row, (name, points) in enumerate(groups.items()):
        parts.append(panel(name, points, fields, row * HEIGHT, first))
        first += len(points)
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" '
            f'height="{HEIGHT * len(groups)}" font-family="DejaVu Sans, sans-serif" '
            'font-size="12"><style>.t{font-size:14px;font-weight:bold}.m{text-anchor:middle}'
            '.e{text-anchor:end}.g{stroke:#ddd;fill:none}</style>'
            f'<rect width="100%" height="100%" fill="#fff"/>{"".join(parts)}</svg>\n')


def choice(points, ppm, pixels):
    """The smallest that keeps both limits; None: none does."""
    kept = [p for p in points if p.ppm <= ppm and p.speed >= pixels]
    return min(kept, key=lambda p: (p.area, p.ppm, -p.speed), default=None)


def cells(values, kind="td"):
    return "<tr>" + "".join(f"<{kind}>{html.escape(str(v))}</{kind}>" for v in values) + "</tr>"


def tables(groups, fields):
    out = []
    for name, points in groups.items():
        out.append(f"<h2>{html.escape(name)}</h2><p>With at most E ppm and at least P px/clk, take "
                   "this:</p><table>" + cells(["E, ppm \\ P, px/clk", *LEAST_PIXELS], "th"))
        for ppm in LIMITS_PPM:
            best = [choice(points, ppm, pixels) for pixels in LEAST_PIXELS]
            out.append(cells([ppm, *(f"{name_of(p, fields)} ({p.area:.0f} LUTs)" if p else "none"
                                     for p in best)]))
        out.append("</table><p>Pareto points:</p><table>"
                   + cells([*fields, "area, LUTs", "error, ppm", "px/clk"], "th"))
        for p in sorted((p for p in points if p.is_pareto), key=lambda p: p.area):
            out.append(cells([*(p.record["config"][key] for key in fields), f"{p.area:.0f}",
                              f"{p.ppm:.0f}", f"{p.speed:.2f}"]))
        out.append("</table>")
    return "".join(out)


SCRIPT = """
const records = JSON.parse(document.getElementById('records').textContent);
const shown = document.getElementById('record');
document.querySelectorAll('circle').forEach(c => c.addEventListener('pointerenter', () => {
  shown.textContent = JSON.stringify(records[c.dataset.point], null, 1);
}));
"""


def page(groups, fields):
    records = [p.record for points in groups.values() for p in points]
    data = json.dumps(records, separators=(",", ":")).replace("<", "\\u003c")
    return ('<!DOCTYPE html><html lang="en"><meta charset="utf-8"><title>Sweep</title><style>'
            "body{font:14px DejaVu Sans,sans-serif;margin:20px}table{border-collapse:collapse}"
            "td,th{border:1px solid #ccc;padding:3px 8px;text-align:left}#view{display:flex}"
            "#record{position:sticky;top:10px;height:90vh;overflow:auto;margin:0 0 0 20px;"
            "min-width:300px}</style>"
            f'<h1>Area, error and throughput of {len(records)} cases</h1><div id="view"><div>'
            f"{picture(groups, fields)}</div>"
            '<pre id="record">Point at a point: its record.</pre></div>'
            f'{tables(groups, fields)}<script type="application/json" id="records">{data}</script>'
            f"<script>{SCRIPT}</script></html>\n")


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: sweep_chart.py SWEEP.jsonl DIR")
    out = pathlib.Path(sys.argv[2])
    groups = read(pathlib.Path(sys.argv[1]))
    if not groups:
        sys.exit(f"sweep_chart.py: {sys.argv[1]}: no case has coverage_error, clocks and area")
    fields = swept(groups)
    out.mkdir(parents=True, exist_ok=True)
    (out / "sweep.svg").write_text(picture(groups, fields))
    (out / "index.html").write_text(page(groups, fields))


if __name__ == "__main__":
    main()
