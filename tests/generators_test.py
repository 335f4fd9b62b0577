#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The generators make the same triangles for one seed, whichever compiler made them.

generators_test.py golden PROGRAM                  its lines against tests/data/generators.txt
generators_test.py other COMPILER LIBRARY [...]    the same of the generators by another compiler,
                                                   linked to the rest of the model as it is built

A draw whose place in the order is the compiler's choice (two in the arguments of one call) shows
as another checksum. Ends with 77, skipped, where the compiler is not installed.
"""
import difflib
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
GOLDEN = ROOT / "tests/data/generators.txt"
VECTORS = ROOT / "testbench/vectors"
SOURCES = [ROOT / "tests/generators_checksum.cpp", VECTORS / "generators.cpp",
           VECTORS / "directed.cpp", VECTORS / "stimulus.cpp"]
SKIPPED = 77


def compare(program, maker):
    made = subprocess.run([program], check=True, capture_output=True, text=True).stdout.splitlines()
    golden = GOLDEN.read_text().splitlines()
    if made != golden:
        diff = difflib.unified_diff(golden, made, str(GOLDEN), f"by {maker}", n=0, lineterm="")
        sys.exit("\n".join(diff))
    print(f"generators by {maker}: {len(made)} checksums as in {GOLDEN.relative_to(ROOT)}")


def by_other(compiler, libraries):
    path = shutil.which(compiler)
    if path is None:
        print(f"SKIPPED: {compiler} is not installed: its triangles are not compared")
        return SKIPPED
    with tempfile.TemporaryDirectory() as folder:
        program = pathlib.Path(folder) / "checksum"
        subprocess.run([path, "-std=c++20", "-ffp-contract=off", f"-I{ROOT}/cmodel",
                        f"-I{ROOT}/testbench", *SOURCES, *libraries, "-lfmt", "-o", program], check=True)
        compare(program, compiler)
    return 0


def main():
    match sys.argv[1:]:
        case ["golden", program]:
            compare(program, "the build's compiler")
            return 0
        case ["other", compiler, *libraries]:
            return by_other(compiler, libraries)
    print(__doc__, file=sys.stderr)
    return 2


if __name__ == "__main__":
    sys.exit(main())
