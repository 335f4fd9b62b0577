#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The area of one configuration by yosys, synth_ecp5, flattened, no place and route, as JSON:
synth_ecp5.py PRESET|hs_config_pkg.sv --work FOLDER [--out FILE]. The recipe is area.py's."""
import argparse
import json
import pathlib
import sys

sys.dont_write_bytecode = True
import area
import tool_versions


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("config", help="a preset, or the path of an hs_config_pkg.sv")
    parser.add_argument("--work", type=pathlib.Path, required=True, help="folder for logs")
    parser.add_argument("--out", type=pathlib.Path, help="default: standard output")
    arguments = parser.parse_args()
    arguments.work.mkdir(parents=True, exist_ok=True)
    figures = {**area.measure_flat(arguments.config, arguments.work),
               "yosys": tool_versions.version("yosys")}
    text = json.dumps(figures) + "\n"
    if arguments.out:
        arguments.out.write_text(text)
    else:
        sys.stdout.write(text)


if __name__ == "__main__":
    main()
