# SPDX-License-Identifier: Apache-2.0
"""docs/charts/area.json and docs/04_develop/area.md from area.py's figures."""
import json

# What the project promises itself, docs/04_develop/area.md.
LUTS_BELOW = {"tiny": 9000, "full": 30000}
CLOCK_BELOW = {"full": 7.0}

HEAD = """# Area and clock

Written by [testbench/synth/area.py](../../testbench/synth/area.py); the same figures as data are
in [docs/charts/area.json](../charts/area.json). To measure again (minutes for `tiny`, an hour for
all):

    ./run charts area
    python3 testbench/synth/area.py                      the same
    python3 testbench/synth/area.py --presets tiny --kinds flat asic

Needs yosys, opensta, qflow-tech-osu018, nextpnr-ice40 and fpga-icestorm-chipdb of Debian 12. What
was measured before on the same code is kept in `build/area`. Tools of the figures below: yosys
{yosys}, OpenSTA {opensta}, nextpnr {nextpnr}.
"""

ECP5 = """
## FPGA: Lattice ECP5
`synth_ecp5`, no place and route. *LUTs* is LUT4 + 2 CCU2C: a CCU2C, two bits of carry chain, takes
two LUT4s. The wide multiplexers PFUMX and L6MUX21 lie beside the LUT4s they join and take none of
their own.

| preset | LUTs | target | LUT4 | CCU2C | flip-flops | MULT18X18D |
| --- | --- | --- | --- | --- | --- | --- |
"""

STAGES = """
### Per stage
The same with the borders of the stages kept: LUT4 + 2 x CCU2C = LUTs, flip-flops in brackets. The
total is larger than above: without borders yosys removes what a neighbour does not use, such as
high bits of e that only repeat its sign.

"""

ASIC = """
## ASIC: OSU 0.18 um
yosys with `abc -D 7000 -constr`, OpenSTA, **ideal wires**: no wire load, no clock skew. A real
layout is slower. One gate equivalent (GE) is a NAND2X1, 24 um^2. The multipliers are made of gates
here. The clock is the longest path from register to register with setup time, over the whole
flattened design, chains of ready signals included. A register is named by a net that it drives.

| preset | kGE | flip-flops | clock, ns | target | from | to |
| --- | --- | --- | --- | --- | --- | --- |
"""

ASIC_STAGES = """
### Longest path per stage
Of the paths that end in a register of the stage, ns; where it begins and ends.

"""

ICE40 = """
## Placed and routed: Lattice iCE40 hx8k
A whole preset does not fit; one testing level of `tiny` does, the second, between the shift
registers of [level_on_pins.sv](../../testbench/synth/level_on_pins.sv): **{logic_cells} of {of}**
logic cells with them, **{mhz:.0f} MHz** (nextpnr-ice40, package ct256, seed 1).
"""


def verdict(value, limits, preset, form):
    if preset not in limits:
        return "none"
    return f"< {limits[preset]:{form}}: {'met' if value < limits[preset] else '**missed**'}"


def table_of_stages(figures, cell):
    """Presets as columns, stages as rows; a preset has as many levels as it has."""
    names = []
    for rows in figures.values():
        names += [name for name in rows if name not in names]
    order = {"triangle_setup": -1, "coverage": 100, "between stages": 101, "total": 102}
    names.sort(key=lambda n: order.get(n, int("".join(c for c in n if c.isdigit()) or 0)))
    out = f"| stage | {' | '.join(figures)} |\n| --- |{' --- |' * len(figures)}\n"
    for name in names:
        cells = [cell(rows[name]) if name in rows else "" for rows in figures.values()]
        out += f"| {name} | {' | '.join(cells)} |\n"
    return out


def page(data):
    presets = data["presets"]
    have = {kind: {p: f[kind] for p, f in presets.items() if kind in f}
            for kind in ("flat", "stages", "asic", "ice40")}
    text = HEAD.format(**data["tools"])
    if have["flat"]:
        text += ECP5
        for preset, f in have["flat"].items():
            text += (f"| {preset} | {f['luts']:,} | {verdict(f['luts'], LUTS_BELOW, preset, ',')} "
                     f"| {f['lut4']:,} | {f['ccu2c']:,} | {f['ff']:,} | {f['mult18']} |\n")
    if have["stages"]:
        text += STAGES + table_of_stages(
            {p: {**f["stages"], "total": f["total"]} for p, f in have["stages"].items()},
            lambda r: f"{r['lut4']:,} + 2 x {r['ccu2c']:,} = {r['luts']:,} ({r['ff']:,})")
    if have["asic"]:
        text += ASIC
        for preset, f in have["asic"].items():
            text += (f"| {preset} | {f['kge']} | {f['flip_flops']:,} | {f['clock_ns']} "
                     f"| {verdict(f['clock_ns'], CLOCK_BELOW, preset, 'g')} "
                     f"| `{f['path']['from']}` | `{f['path']['to']}` |\n")
        text += ASIC_STAGES + table_of_stages(
            {p: f["stages"] for p, f in have["asic"].items()},
            lambda r: f"{r['ns']}: `{r['from']}` to `{r['to']}`")
    for f in have["ice40"].values():
        text += ICE40.format(**f)
    return text


def write(data, root):
    (root / "docs/charts").mkdir(exist_ok=True)
    (root / "docs/charts/area.json").write_text(json.dumps(data, indent=1) + "\n")
    (root / "docs/04_develop/area.md").write_text(page(data))
