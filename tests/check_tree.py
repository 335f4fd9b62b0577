#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""check_tree.py ROOT: the tree's promises that no compiler checks.

- a stage has its files: cmodel/X.hpp, cmodel/X.cpp, tests/X_test.cpp, docs/03_design/X.md
- every error code has a section in docs/02_use/errors.md, and the other way round
- every relative link in a Markdown file leads somewhere
- the core model includes no I/O, no threads and no other stage's internals
"""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(sys.argv[1])
STAGES = ["geometry", "triangle_setup", "half_plane_grid", "tile_traversal", "coverage",
          "interpolation", "depth_test", "framebuffer"]
problems = []


def need(path):
    if not (ROOT / path).is_file():
        problems.append(f"missing: {path}")


for stage in STAGES:
    for path in (f"cmodel/{stage}.hpp", f"cmodel/{stage}.cpp", f"tests/{stage}_test.cpp",
                 f"docs/03_design/{stage}.md"):
        need(path)

errors = (ROOT / "cmodel/io/error.hpp").read_text()
codes = {int(n) for n in re.findall(r"= (\d+),", errors)}
page = (ROOT / "docs/02_use/errors.md").read_text()
sections = {int(n) for n in re.findall(r"^## HS(\d{3})", page, re.M)}
for code in sorted(codes ^ sections):
    problems.append(f"error code HS{code:03} is in only one of error.hpp and errors.md")

listed = subprocess.run(["git", "-C", str(ROOT), "ls-files", "-co", "--exclude-standard", "*.md"],
                        capture_output=True, text=True)
pages = [ROOT / p for p in listed.stdout.split()] or list(ROOT.glob("docs/**/*.md"))
for md in pages:
    for link in re.findall(r"\]\(([^)#\s]+)(?:#[^)]*)?\)", md.read_text()):
        if not re.match(r"[a-z]+:", link) and not (md.parent / link).exists():
            problems.append(f"{md.relative_to(ROOT)}: broken link {link}")

for source in (ROOT / "cmodel").glob("*.[ch]pp"):
    for header in re.findall(r'#include [<"]([^">]+)[">]', source.read_text()):
        if header.startswith(("io/", "cli/", "thread", "iostream", "fstream", "gtest")):
            problems.append(f"{source.name} includes {header}: the core does no I/O")

print("\n".join(problems) or f"tree in order: {len(STAGES)} stages, {len(codes)} error codes, "
      f"{len(pages)} pages")
sys.exit(1 if problems else 0)
