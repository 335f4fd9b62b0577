#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""wave_svg.py TRACE.json OUT.svg --from CLOCK --to CLOCK --track NAME ... [--title TEXT]

Draws the handshakes of a recorded trace (halfspace cosim --trace TRACE.json) as a waveform: for
each track valid, ready and the packet. Ready is hatched where the trace does not tell: while no
packet is offered. A packet that ends in the stage (dropped, empty) is drawn grey, with valid low.
"""
import argparse
import html
import json

CLOCK, ROW, LEFT, TOP = 30, 24, 190, 44
HIGH, LOW = 4, 18
GROUND, INK, LINE = "#ffffff", "#1f2937", "#2563eb"
GRID, FILL, GREY = "#d1d5db", "#dbeafe", "#e5e7eb"


def read(path):
    """Slices by track: name -> [(first clock, last clock, label, ends here)]."""
    with open(path) as file:
        events = json.load(file)["traceEvents"]
    names = {e["tid"]: e["args"]["name"] for e in events if e["name"] == "thread_name"}
    tracks = {name: [] for name in names.values()}
    for event in events:
        if event["ph"] == "X":
            name = event["name"]
            ends = name.startswith(("dropped ", "empty "))
            tracks[names[event["tid"]]].append(
                (event["ts"], event["ts"] + event["dur"] - 1, name, ends))
    return tracks


class Wave:
    def __init__(self, first, last, title):
        self.first, self.last, self.row = first, last, 0
        self.parts, self.title = [], title

    def x(self, clock):
        return LEFT + (clock - self.first) * CLOCK

    def y(self):
        return TOP + self.row * ROW

    def text(self, x, y, words, anchor="start", size=12, fill=INK):
        self.parts.append(f'<text x="{x}" y="{y}" text-anchor="{anchor}" font-size="{size}" '
                          f'fill="{fill}">{html.escape(words)}</text>')

    def label(self, words):
        self.text(LEFT - 8, self.y() + 15, words, "end")

    def levels(self, name, level_at):
        """One bit: level_at(clock) is 0, 1 or None for what the trace does not tell."""
        self.label(name)
        path, before = [], None
        for clock in range(self.first, self.last + 1):
            level, x, y = level_at(clock), self.x(clock), self.y()
            if level is None:
                self.parts.append(f'<rect x="{x}" y="{y + HIGH}" width="{CLOCK}" '
                                  f'height="{LOW - HIGH}" fill="url(#unknown)"/>')
            else:
                at = y + (HIGH if level else LOW)
                path.append(f'{"M" if before is None else "L"}{x} {at}h{CLOCK}')
            before = level
        self.parts.append(f'<path d="{"".join(path)}" fill="none" stroke="{LINE}" '
                          'stroke-width="1.6"/>')
        self.row += 1

    def clock(self):
        self.label("clk_i")
        x, y = self.x(self.first), self.y()
        pulse = f"V{y + HIGH}h{CLOCK // 2}V{y + LOW}h{CLOCK // 2}"
        self.parts.append(f'<path d="M{x} {y + LOW}{pulse * (self.last - self.first + 1)}" '
                          f'fill="none" stroke="{LINE}" stroke-width="1.2"/>')
        self.row += 1

    def packets(self, name, slices):
        self.label(name)
        y = self.y()
        for first, last, words, ends in slices:
            first, last = max(first, self.first), min(last, self.last)
            if first > last:
                continue
            width = (last - first + 1) * CLOCK
            self.parts.append(f'<rect x="{self.x(first) + 1}" y="{y + 3}" width="{width - 2}" '
                              f'height="16" rx="3" fill="{GREY if ends else FILL}" '
                              f'stroke="{LINE}" stroke-width="0.8"/>')
            short = words.split(" ")[-1].strip("()")
            size = 9 if len(short) > 4 else 11
            self.text(self.x(first) + width / 2, y + 15, short, "middle", size)
        self.row += 1

    def svg(self):
        width, height = self.x(self.last + 1) + 12, self.y() + 8
        lines = []
        for clock in range(self.first, self.last + 2):
            x = self.x(clock)
            lines.append(f'<path d="M{x} {TOP - 4}V{height - 8}" stroke="{GRID}"/>')
            if clock <= self.last:
                lines.append(f'<text x="{x + CLOCK / 2}" y="{TOP - 8}" text-anchor="middle" '
                             f'font-size="9" fill="{INK}">{clock}</text>')
        return "\n".join([
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" '
            f'width="{width}" height="{height}" font-family="sans-serif">',
            f'<title>{html.escape(self.title)}</title>',
            '<defs><pattern id="unknown" width="6" height="6" patternUnits="userSpaceOnUse">'
            f'<path d="M0 6L6 0" stroke="{GRID}"/></pattern></defs>',
            f'<rect width="{width}" height="{height}" fill="{GROUND}"/>',
            f'<text x="8" y="20" font-size="13" fill="{INK}">{html.escape(self.title)}</text>',
            *lines, *self.parts, "</svg>", ""])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("trace")
    parser.add_argument("out")
    parser.add_argument("--from", dest="first", type=int, default=0)
    parser.add_argument("--to", dest="last", type=int, default=30)
    parser.add_argument("--track", action="append", required=True)
    parser.add_argument("--title", default="")
    args = parser.parse_args()
    tracks = read(args.trace)
    missing = [name for name in args.track if name not in tracks]
    if missing:
        parser.error(f"no track {missing[0]}; there are: {', '.join(tracks)}")

    wave = Wave(args.first, args.last, args.title)
    wave.clock()
    for name in args.track:
        offered, taken = set(), set()
        for first, last, _, ends in tracks[name]:
            if not ends:
                offered.update(range(first, last + 1))
                taken.add(last)
        wave.levels(f"{name} valid", lambda clock: int(clock in offered))
        wave.levels("ready", lambda clock: int(clock in taken) if clock in offered else None)
        wave.packets("packet", tracks[name])
    with open(args.out, "w") as file:
        file.write(wave.svg())


if __name__ == "__main__":
    main()
