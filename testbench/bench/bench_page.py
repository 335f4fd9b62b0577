#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""bench_page.py BENCH.json ... PAGE.md: replaces the tables of docs/02_use/bench.md, between its
two marks, by those of one or several outputs of `halfspace bench --out`.
"""
import json
import pathlib
import sys

BEGIN, END = "<!-- tables: bench_page.py -->", "<!-- end of tables -->"
COVERAGE = ("small", "medium", "large", "fullscreen", "sliver")


def number(value):
    return f"{value:,.0f}" if value >= 1000 else f"{value:.3g}"


def unique(values):
    return list(dict.fromkeys(values))


def table(head, lines):
    return "\n".join(["| " + " | ".join(line) + " |" for line in
                      [head, ["---"] * len(head), *lines]]) + "\n"


class Rows:
    def __init__(self, rows):
        self.rows = rows

    def find(self, **wanted):
        for row in self.rows:
            if all(row[key] == value for key, value in wanted.items()):
                return row
        return None

    def forms(self, work, engines):
        """Every (engine, isa, threads) that was timed at that work."""
        return unique((r["engine"], r["isa"], r["threads"]) for r in self.rows
                      if r["work"] == work and r["engine"] in engines)

    def frames(self, work, workloads=None, engine=None):
        return unique((r["workload"], r["size"], r["run"]) for r in self.rows
                      if r["work"] == work and (workloads is None or r["workload"] in workloads)
                      and (engine is None or r["engine"] == engine))

    def ratio(self, row, engine):
        """Of two rows of one run."""
        other = self.find(workload=row["workload"], size=row["size"], work=row["work"],
                          engine=engine, run=row["run"])
        return "-" if other is None else number(other["median"] / row["median"])


def name(form):
    engine, isa, threads = form
    return " ".join([engine] + [isa] * (isa != "-")
                    + [f"{threads} threads (wall)"] * (threads > 1))


def coverage(rows):
    frames = rows.frames("coverage", COVERAGE, "scalar")
    lines = []
    for form in rows.forms("coverage", ("scalar", "bit", "coverage", "llvmpipe")):
        line = [name(form)]
        for workload, size, run in frames:
            row = rows.find(workload=workload, size=size, work="coverage", engine=form[0],
                            isa=form[1], threads=form[2], run=run)
            line.append("-" if row is None else
                        f"{number(row['median'])} ({rows.ratio(row, 'scalar')}, "
                        f"{rows.ratio(row, 'llvmpipe')})")
        lines.append(line)
    return ("**Coverage**: ns per triangle (the plain loop's time over this one, llvmpipe's time "
            "over this one)\n\n" + table(["engine"] + [w for w, *_ in frames], lines))


def whole_frames(rows):
    frames = rows.frames("frame")
    lines = []
    for form in rows.forms("frame", ("bit", "llvmpipe")):
        line = [name(form)]
        for workload, size, run in frames:
            row = rows.find(workload=workload, size=size, work="frame", engine=form[0],
                            isa=form[1], threads=form[2], run=run)
            line.append("-" if row is None else
                        f"{number(row['median'] * row['triangles'] * 1e-6)} "
                        f"({rows.ratio(row, 'llvmpipe')})")
        lines.append(line)
    return ("**Whole frames**: ms per frame (llvmpipe's time over this one)\n\n"
            + table(["engine"] + [f"{w} {s}" for w, s, _ in frames], lines))


def cycles(rows):
    frames = rows.frames("coverage", None, "rtl")
    lines = []
    for form in rows.forms("coverage", ("cycle", "rtl")):
        line = [name(form)]
        for workload, size, run in frames:
            row = rows.find(workload=workload, size=size, work="coverage", engine=form[0],
                            isa=form[1], threads=form[2], run=run)
            line.append("-" if row is None else
                        f"{number(1e3 * row['clocks'] / row['median'] / row['triangles'])} "
                        f"({rows.ratio(row, 'rtl')})")
        lines.append(line)
    return ("**Clocks**: millions simulated per second (times the Verilated RTL)\n\n"
            + table(["engine"] + [f"{w} {s}" for w, s, _ in frames], lines))


def main():
    *inputs, page = map(pathlib.Path, sys.argv[1:])
    rows = Rows([row | {"run": run} for run, file in enumerate(inputs)
                 for row in json.loads(file.read_text())])
    text = page.read_text()
    before, rest = text.split(BEGIN)
    after = rest.split(END)[1]
    parts = [part(rows) for part in (coverage, whole_frames, cycles)]
    page.write_text(before + BEGIN + "\n" + "\n".join(parts) + "\n" + END + after)


if __name__ == "__main__":
    main()
