#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""skipped.py LOG: the tests that a run of ctest skipped, each with its reason."""
import pathlib
import re
import sys

log = pathlib.Path(sys.argv[1])
text = log.read_text(errors="replace") if log.exists() else ""
skipped = []
# One part a test: "12/663 Testing: NAME", then what it printed.
for part in re.split(r"^\d+/\d+ Testing: ", text, flags=re.M)[1:]:
    name = part.split("\n", 1)[0]
    # A whole script ("skipped: WHY"), tests of a script (unittest), a GoogleTest.
    for why in re.findall(r"^(?:-- )?skipped: (.*)$", part, re.M | re.I):
        skipped.append(f"{name}: {why}")
    for test, why in re.findall(r"^(\w+) \(.*\) \.\.\. skipped ['\"](.*)['\"]$", part, re.M):
        skipped.append(f"{name}, {test}: {why}")
    if re.search(r"^\[  SKIPPED \]", part, re.M):
        found = re.search(r": Skipped\n(.*)", part)
        skipped.append(f"{name}: {found[1].strip() if found else 'says no reason'}")
if skipped:
    print(f"{len(skipped)} skipped:")
    print("\n".join(f"  {line}" for line in skipped))
