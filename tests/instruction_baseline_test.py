#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""instruction_baseline_test.py [--update]: instructions of fixed small workloads against
tests/data/instructions.json.

Times are noise on a shared machine; instructions are not. Counted by valgrind's callgrind, which
knows no AVX-512. They depend on the compiler and on Highway, so the file has a baseline for each
pair of versions that was measured. More than 3 % off, either way, fails: a change that is meant is
written down with --update, which changes the baseline of this build only, and committed. Exit
status 77 (skipped) where counts cannot be compared: no baseline for this build, or no valgrind.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

PROGRAM = os.environ["INSTRUCTION_WORKLOADS"]
BASELINE = pathlib.Path(__file__).parent / "data" / "instructions.json"
TOLERANCE = 0.03
FUNCTION = "halfspace_counted_work"
UPDATE = "if this is meant: ./run bench baseline --update, and commit tests/data/instructions.json"


def skip(why):
    print(f"skipped: {why}")
    sys.exit(77)


def measure():
    """What counts depend on, and {name: instructions}."""
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run(
            ["valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/out",
             f"--toggle-collect={FUNCTION}", f"--dump-after={FUNCTION}", PROGRAM],
            capture_output=True, text=True, timeout=500)
        if run.returncode != 0:
            sys.exit(f"valgrind failed:\n{run.stderr}")
        built_by, *names = run.stdout.splitlines()
        counts = []
        for i in range(1, len(names) + 1):
            text = pathlib.Path(f"{folder}/out.{i}").read_text()
            counts.append(int(re.search(r"^(?:totals|summary): (\d+)", text, re.M)[1]))
    if not names or len(set(names)) != len(names) or min(counts) < 10000:
        sys.exit(f"nothing was counted, or not each workload once: {list(zip(names, counts))}")
    return built_by, dict(zip(names, counts))


def update(built_by, counts):
    baselines = json.loads(BASELINE.read_text())
    baselines[built_by] = counts
    BASELINE.write_text(json.dumps(dict(sorted(baselines.items())), indent=1) + "\n")
    print(f"wrote {len(counts)} counts of {built_by} to {BASELINE}")


def compare(built_by, counts):
    baselines = json.loads(BASELINE.read_text())
    if built_by not in baselines:
        skip(f"this build is of {built_by}, and the baselines are of {' and of '.join(baselines)}")
    baseline = baselines[built_by]
    wrong, compared = [], 0
    for name, old in baseline.items():
        if name not in counts:
            print(f"{name}: not on this machine")
            continue
        compared += 1
        change = counts[name] / old - 1
        print(f"{name}: {counts[name]} ({change:+.2%})")
        if abs(change) > TOLERANCE:
            wrong.append(f"{name}: {counts[name]} instructions, the baseline has {old} "
                         f"({change:+.1%}, allowed are 3 % either way)")
    wrong += [f"{name}: is not in the baseline" for name in counts
              if name not in baseline]
    if compared == 0:
        sys.exit("nothing was compared")
    if wrong:
        sys.exit("\n".join(wrong) + "\n" + UPDATE)


def main():
    if shutil.which("valgrind") is None:
        skip("no valgrind")
    built_by, counts = measure()
    (update if "--update" in sys.argv[1:] else compare)(built_by, counts)


if __name__ == "__main__":
    main()
