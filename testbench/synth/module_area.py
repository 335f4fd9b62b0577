#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Area and clock of one module of the design, as JSON: module_area.py MODULE PRESET --work FOLDER
[--parameter NAME=VALUE]... [--asic]. synth_ecp5, or osu018 with OpenSTA; the recipes are
area.py's."""
import argparse
import json
import pathlib
import sys

sys.dont_write_bytecode = True
import area


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("module")
    parser.add_argument("preset")
    parser.add_argument("--work", type=pathlib.Path, required=True, help="folder for logs")
    parser.add_argument("--parameter", action="append", default=[], metavar="NAME=VALUE",
                        help="of the module; may be repeated")
    parser.add_argument("--asic", action="store_true", help="osu018 instead of ECP5")
    arguments = parser.parse_args()
    arguments.work.mkdir(parents=True, exist_ok=True)
    measure = area.measure_asic if arguments.asic else area.measure_flat
    figures = measure(arguments.preset, arguments.work, arguments.module, arguments.parameter)
    figures.pop("stages", None)
    print(json.dumps(figures))


if __name__ == "__main__":
    main()
