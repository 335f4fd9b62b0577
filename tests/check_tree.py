#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""check_tree.py ROOT: the tree's promises that no compiler checks.

- a stage has its header, body, test and page, and in rtl/ its module, checker and cosim test;
  a stage that lacks one is listed with the reason
- what a `Twin:` comment names exists: the file, and in it the function or constant
- a folder includes the folders above it in ARROWS that it lists, and no others; every folder is
  listed; CMake compiles no source of another folder, and no class stands in two files
- a stage includes no stage but those listed, and the core no I/O, threads or library but GLM
- a macro with arguments is one of those listed
- every error code has a section in docs/02_use/errors.md, and the other way round
- every relative link in a Markdown file leads to a file, and to a heading of it
- a line of Markdown has at most 100 columns, but for tables, code and what cannot be broken
- each file that docs/04_develop/add_a_stage.md names exists, for an example stage
- the figures that pages quote are those of the data (check_figures.py)
- the version is the same wherever it is written, and so is the maintainers' address

Each is seen failing by check_tree_test.py.
"""
import pathlib
import posixpath
import re
import subprocess
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import check_figures  # noqa: E402

FILES = {"header": "cmodel/{}.hpp", "body": "cmodel/{}.cpp", "test": "tests/{}_test.cpp",
         "page": "docs/03_design/{}.md", "module": "rtl/hs_{}.sv",
         "checker": "rtl/checkers/hs_{}_checker.sv", "cosim": "tests/{}_cosim_test.cpp"}
NO_RTL = ("module", "checker", "cosim")
# Each stage in flow order, and which of FILES it lacks.
STAGES = {"geometry": NO_RTL,                 # runs on the host
          "triangle_setup": (),
          "half_plane_grid": ("checker",),    # no handshake: a part of the next two
          "tile_traversal": (),
          "coverage": (),
          "scissor": NO_RTL,                  # no RTL yet, nor the next four
          "interpolation": NO_RTL,
          "depth": NO_RTL,
          "shading": NO_RTL,
          "framebuffer": NO_RTL}
# The stages that a stage may include, and for what.
INCLUDES = {"tile_traversal": {"half_plane_grid"},  # it is made of grids
            "coverage": {"half_plane_grid"}}        # and so is this
# The folders of the house, from the ground up, and which of those above it each may include. A
# folder never includes one below it.
ENGINES = ("cmodel/engines/coverage", "cmodel/engines/cycle", "cmodel/engines/frame")
ARROWS = {
    "cmodel": (),
    "cmodel/engines/common": ("cmodel",),
    "cmodel/engines/coverage": ("cmodel", "cmodel/engines/common"),
    "cmodel/engines/cycle": ("cmodel", "cmodel/engines/common"),
    "cmodel/engines/frame": ("cmodel", "cmodel/engines/common", "cmodel/engines/coverage"),
    "cmodel/io": ("cmodel",),
    "cmodel/meshes": ("cmodel", "cmodel/io"),
    "cmodel/scene": ("cmodel", "cmodel/engines/frame", "cmodel/io", "cmodel/meshes"),
    "cmodel/capi": ("cmodel", "cmodel/engines/cycle", "cmodel/io", "cmodel/scene"),
    "cmodel/python": ("cmodel/capi",),
    "testbench/oracle": (),  # shares no line with what it judges
    "testbench/vectors": ("cmodel", "cmodel/io", "testbench/oracle"),
    "testbench/methods": ("cmodel", "cmodel/io", "testbench/oracle", "testbench/vectors"),
    "testbench/fit": ("cmodel", "cmodel/engines/coverage", "cmodel/engines/cycle", "cmodel/io",
                      "cmodel/scene", "testbench/oracle"),
    "testbench/rtl": ("cmodel", "cmodel/io", "testbench/vectors"),
    "testbench/rtl/stage": ("cmodel", "testbench/vectors", "testbench/rtl"),
    "testbench/bench": ("cmodel", "cmodel/engines/common", *ENGINES, "cmodel/io", "cmodel/meshes",
                        "cmodel/scene", "testbench/vectors", "testbench/rtl"),
    "testbench/sweep": ("cmodel", *ENGINES, "cmodel/io", "cmodel/scene", "testbench/oracle",
                        "testbench/vectors", "testbench/fit", "testbench/rtl"),
    "testbench/lab": ("cmodel", "cmodel/engines/coverage", "cmodel/io", "cmodel/scene",
                      "testbench/oracle", "testbench/vectors", "testbench/methods"),
    "testbench/synth": ("cmodel", "testbench/vectors", "testbench/rtl"),
    "testbench/dpi": (),  # a user of the installed library
    "testbench/cli": ("cmodel", "cmodel/engines/common", *ENGINES, "cmodel/io", "cmodel/scene",
                      "testbench/vectors", "testbench/methods", "testbench/fit", "testbench/rtl",
                      "testbench/bench", "testbench/sweep", "testbench/lab"),
}
NOT_IN_CORE = {"thread", "mutex", "atomic", "future", "condition_variable", "iostream", "fstream",
               "sstream", "filesystem"}
# Macros with arguments: where a function cannot do it.
MACROS = {"HS_CHECK": "cmodel/fixed.hpp",                      # the condition's text and line
          "HS_UNLESS_DRAWING_ONLY": "testbench/cli/main.cpp",     # a name that is not linked
          "HS_CONSTANT": "testbench/rtl/rtl_object.cpp"}       # a name made of two


class Tree:
    """The files below a root that git knows; `changed` replaces the text of some, None removes."""

    def __init__(self, root, changed=()):
        self.root, self.changed = pathlib.Path(root), dict(changed)
        listed = subprocess.run(["git", "-C", str(root), "ls-files", "-co", "--exclude-standard"],
                                capture_output=True, text=True)
        self.paths = listed.stdout.splitlines() or [
            p.relative_to(root).as_posix() for folder in ("cmodel", "rtl", "testbench", "tests",
                                                          "docs")
            for p in self.root.glob(f"{folder}/**/*") if p.is_file()]

    def has(self, path):
        if path in self.changed:
            return self.changed[path] is not None
        return (self.root / path).exists()

    def text(self, path):
        return self.changed.get(path) or (self.root / path).read_text()

    def match(self, pattern):
        return [p for p in self.paths if re.fullmatch(pattern, p) and self.has(p)]


def stages(tree):
    for stage, lacks in STAGES.items():
        for kind, form in FILES.items():
            path = form.format(stage)
            if tree.has(path) == (kind in lacks):
                yield f"{path}: {'is there, and listed as lacking' if kind in lacks else 'missing'}"
        header = f"cmodel/{stage}.hpp"
        if tree.has(header) and "Twin: " not in tree.text(header):
            yield f"{header}: names no twin, nor says that there is none"


def twin_comments(text):
    """What each comment says after `Twin:`, up to its full stop or the comment's next heading."""
    for found in re.finditer(r"^ *// .*?Twins?:(.*(?:\n *// ?(?! *\w+: ).*)*)", text, re.M):
        said = re.sub(r"\n *//", " ", found[1])
        yield re.split(r"\.(?=\s|$)|;", said)[0]


def twins(tree):
    for path in tree.match(r"(cmodel|rtl|testbench)/.*\.([ch]pp|sv|h)"):
        for said in twin_comments(tree.text(path)):
            named = re.findall(r"[\w/<>-]+\.(?:[ch]pp|sv)\b", said)
            files = [p for name in named
                     for p in tree.match(re.sub(r"<\w+>", r"\\w+", re.escape(name)))]
            if len(files) < len(named) or not (named or "none" in said or "rtl/" in said):
                yield f"{path}: Twin: {said.strip()}: no such file"
                continue
            words = re.sub(r"[\w/<>-]+\.(?:[ch]pp|sv)\b|\brtl/|\bRTL\b", " ", said)
            for name in re.findall(r"(?:\w+::)*(\w*(?:_|[A-Z])\w*|\w+(?=\(\)))", words):
                if not any(re.search(rf"\b{name}\b", tree.text(file)) for file in files):
                    yield f"{path}: Twin: {said.strip()}: no {name} there"


def includes(tree):
    for path in tree.match(r"cmodel/\w+\.[ch]pp"):
        stem = pathlib.PurePath(path).stem
        for form, header in re.findall(r'#include ([<"])([^">]+)[">]', tree.text(path)):
            other = pathlib.PurePath(header).stem
            if form == '"' and stem in STAGES and other in STAGES and (
                    other not in INCLUDES.get(stem, ()) and other != stem):
                yield f"{path} includes {header}: a stage knows no other"
            elif header in NOT_IN_CORE or form == "<" and (
                    "/" in header or "." in header) and not header.startswith("glm/"):
                yield f"{path} includes {header}: the core has no I/O, no threads, GLM alone"
    for stem, others in INCLUDES.items():
        texts = "".join(tree.text(f"cmodel/{stem}.{end}") for end in ("hpp", "cpp"))
        for other in others:
            if f'"{other}.hpp"' not in texts:
                yield f"cmodel/{stem}: no longer includes {other}.hpp, and is listed so"


def arrows(tree):
    sources = tree.match(r"(cmodel|testbench)/.*\.([ch]pp|[ch])")
    have, used = set(sources), {folder: set() for folder in ARROWS}
    for path in sources:
        folder = path.rpartition("/")[0]
        if folder not in ARROWS:
            yield f"{path}: folder {folder} is not in ARROWS"
            continue
        for header in re.findall(r'^#include "([^"]+)"', tree.text(path), re.M):
            places = [posixpath.normpath(f"{at}/{header}") for at in
                      (folder, "cmodel", "testbench", "cmodel/capi")]
            to = next((p.rpartition("/")[0] for p in places if p in have), folder)
            used[folder].add(to)
            if to != folder and to not in ARROWS[folder]:
                yield f"{path} includes {header}: no arrow from {folder} to {to}"
    folders = list(ARROWS)
    for folder, others in ARROWS.items():
        for other in others:
            if folders.index(other) >= folders.index(folder):
                yield f"ARROWS: {folder} lists {other}, which stands below it"
            elif other not in used[folder]:
                yield f"ARROWS: {folder} no longer includes {other}"
    for path in tree.match(r"(cmodel|testbench|tests)/.*CMakeLists\.txt"):
        for source in re.findall(r"\S*/\S+\.cpp\b", tree.text(path)):
            if source.startswith("../") or source.startswith("${PROJECT_SOURCE_DIR}"):
                yield f"{path}: compiles {source}, a source of another folder"


def classes(tree):
    where = {}
    for path in tree.match(r"(cmodel|testbench)/.*\.hpp"):
        for name in re.findall(r"^(?:class|struct) (?:alignas\(\w+\) )?(\w+)(?![\w:]*::)[^;{]*\{", tree.text(path), re.M):
            space = re.search(r"^namespace ([\w:]+)", tree.text(path), re.M)
            where.setdefault((space and space[1], name), set()).add(path)
    for (space, name), paths in where.items():
        if len(paths) > 1:
            yield f"{' and '.join(sorted(paths))} both define {space}::{name}"


def macros(tree):
    for path in tree.match(r"(cmodel|testbench|tests)/.*\.([ch]pp|[ch])"):
        for name in re.findall(r"^ *# *define (\w+)\(", tree.text(path), re.M):
            if MACROS.get(name) != path:
                yield f"{path}: macro {name} is not one of those with a reason (check_tree.py)"


def errors(tree):
    codes = {int(n) for n in re.findall(r"= (\d+),", tree.text("cmodel/io/error.hpp"))}
    sections = {int(n) for n in re.findall(r"^## HS(\d{3})", tree.text("docs/02_use/errors.md"),
                                           re.M)}
    for code in sorted(codes ^ sections):
        yield f"error code HS{code:03} is in only one of error.hpp and errors.md"


def anchors(text):
    """The names that a page's headings are reached by."""
    text = re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)
    for heading in re.findall(r"^#+ +(.*)$", text, re.M):
        plain = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading)
        yield re.sub(r"[^\w\- ]", "", plain.lower()).replace(" ", "-")


def links(tree):
    for page in tree.match(r".*\.md"):
        for link, anchor in re.findall(r"\]\(([^)#\s]*)(?:#([^)\s]*))?\)", tree.text(page)):
            if re.match(r"[a-z]+:", link):
                continue
            to = (tree.root / page).parent / link if link else tree.root / page
            if not to.exists():
                yield f"{page}: broken link {link}"
            elif anchor:
                path = to.resolve().relative_to(tree.root.resolve()).as_posix()
                if anchor not in anchors(tree.text(path)):
                    yield f"{page}: {link}#{anchor}: no such heading"


def columns(tree):
    for page in tree.match(r".*\.md"):
        prose = re.sub(r"^ *```.*?^ *```", lambda code: "\n" * code[0].count("\n"),
                       tree.text(page), flags=re.M | re.S)
        for number, line in enumerate(prose.split("\n"), 1):
            words = re.sub(r"^ *(?:[-*+]|\d+\.)? *", "", line[:101])  # without a list's mark
            if len(line) > 100 and " " in words and not re.match(r" {4}|\||#|!\[", line):
                yield f"{page}:{number}: {len(line)} columns of prose; 100 are the most"


def places(tree):
    page = "docs/04_develop/add_a_stage.md"
    for path in re.findall(r"`((?:cmodel|docs|rtl|testbench|tests)/[^`]*)`", tree.text(page)):
        if not tree.has(path.replace("stipple", "coverage")):
            yield f"{page}: {path} is not there for coverage either"


def release(tree):
    version = re.search(r"project\(halfspace VERSION ([\d.]+)", tree.text("CMakeLists.txt"))[1]
    cited = re.search(r"^version: (.*)$", tree.text("CITATION.cff"), re.M)[1]
    date = re.search(r"^date-released: (.*)$", tree.text("CITATION.cff"), re.M)[1]
    if cited != version:
        yield f"CITATION.cff: version {cited}, and the program's is {version}"
    if f"## [{version}] - {date}\n" not in tree.text("CHANGELOG.md"):
        yield f"CHANGELOG.md: no release {version} of {date}, which CITATION.cff has"
    address = re.search(r'PACKAGE_CONTACT ".*<(.*)>"', tree.text("cmodel/package/debian.cmake"))[1]
    for line in tree.text(".github/CODEOWNERS").splitlines():
        if line and not line.startswith("#") and line.split()[1:] != [address]:
            yield f".github/CODEOWNERS: {line}: the maintainers are {address}"


def problems(tree):
    return [p for check in (stages, twins, arrows, classes, includes, macros, errors, links, columns,
                            places, release, check_figures.problems)
            for p in check(tree)]


if __name__ == "__main__":
    here = Tree(sys.argv[1])
    found = problems(here)
    pages = here.match(r".*\.md")
    print("\n".join(found) or f"tree in order: {len(STAGES)} stages, {len(pages)} pages")
    sys.exit(1 if found else 0)
