#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What a perspective divider costs by the bits of its reciprocal: writes
docs/charts/interpolation_area.json.

The stage has no RTL yet, so this measures its arithmetic alone: the product of
cmodel/interpolation, perspective(), by yosys synth_ecp5 without multiplier blocks, and the size of
the table that a reciprocal would be read from, which is counted: 2^(R-1) words of R + 1 bits.
Seconds."""
import json
import pathlib
import sys

sys.dont_write_bytecode = True
import area
import tool_versions
from rtl_sources import ROOT

MODULE = """module divider(input [15:0] n, input [{r}:0] reciprocal, output [8:0] q);
  wire [{top}:0] sum = n * reciprocal + ({top}'d1 << {half});
  assign q = sum >> {shift};
endmodule
"""


def multiplier(bits, folder):
    shift = bits + 7
    source = folder / f"divider{bits}.v"
    source.write_text(MODULE.format(r=bits, top=bits + 17, half=shift - 1, shift=shift))
    out = folder / f"divider{bits}.json"
    area.yosys([f"read_verilog {source}", "synth_ecp5 -nodsp -top divider",
                f"tee -o {out} stat -json"], folder, f"divider{bits}")
    text = out.read_text()
    stat = json.loads(text[text.index("{"):text.rindex("}") + 1])
    return area.luts(stat["design"]["num_cells_by_type"])["luts"]


def main():
    folder = ROOT / "build/area/interpolation"
    folder.mkdir(parents=True, exist_ok=True)
    rows = {str(r): {"multiplier_luts": multiplier(r, folder),
                     "table_bits": (1 << (r - 1)) * (r + 1)} for r in range(6, 17)}
    data = {"command": "./run charts subpixel-area",
            "tools": {"yosys": tool_versions.version("yosys")},
            "reciprocal_bits": rows}
    out = pathlib.Path(ROOT / "docs/charts/interpolation_area.json")
    out.write_text(json.dumps(data, indent=1) + "\n")
    print(f"interpolation_area: wrote {out.relative_to(ROOT)}")


if __name__ == "__main__":
    main()
