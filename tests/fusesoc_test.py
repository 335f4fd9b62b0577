#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The FuseSoC core files: keys and types as CAPI2 has them, every file there, the order that of
rtl.f, and what Verilator is given clean.

The schema below was typed from the one of FuseSoC (https://github.com/olofk/fusesoc,
fusesoc/capi2/json_schema.py, draft 2020-12), the parts that the core files use; the expressions
from fusesoc/capi2/exprs.py. FuseSoC itself is not needed and was not run.
"""
import pathlib
import re
import subprocess
import sys
import unittest

import yaml

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "testbench/synth"))
import tool_versions

RTL = ROOT / "rtl"
CORES = [RTL / "halfspace.core", ROOT / "testbench/dpi/halfspace_scoreboard.core"]
WORD = r"[A-Za-z0-9:<>.\[\]_,=~/^+-]+"

STRINGS = [str]  # an array of strings


def any_of(*kinds):
    return lambda value: any(fits(value, kind) for kind in kinds)


SCALAR = any_of(str, int, float, bool)
FILE = {"file_type": str, "is_include_file": bool, "include_path": str, "logical_name": str,
        "tags": STRINGS, "copyto": str, "define": {"*": SCALAR}}
FILES = [any_of(str, lambda v: isinstance(v, dict) and len(v) == 1 and fits(v, {"*": FILE}))]
FILESET = {"file_type": str, "logical_name": str, "tags": STRINGS, "files": FILES,
           "files_append": FILES, "depend": STRINGS, "depend_append": STRINGS}
HOOKS = {f"{when}{more}": STRINGS for when in ("pre_build", "post_build", "pre_run", "post_run")
         for more in ("", "_append")}
TARGET = {"default_tool": str, "description": str, "flow": str, "flow_options": dict,
          "hooks": HOOKS, "tools": {"*": dict}, "toplevel": any_of(str, STRINGS), "flags": dict,
          **{f"{key}{more}": STRINGS for key in ("filesets", "filters", "parameters", "vpi")
             for more in ("", "_append")},
          "generate": list, "generate_append": list}
PARAMETER = {"datatype": lambda v: v in ("bool", "file", "int", "real", "str"), "default": SCALAR,
             "description": str, "paramtype": lambda v: v in ("cmdlinearg", "generic", "plusarg",
                                                              "vlogdefine", "vlogparam"),
             "scope": str}
CORE = {"name": lambda v: re.fullmatch(r"[\w.-]*:[\w.-]*:[\w.-]+:\d+\.\d+\.\d+", v) is not None,
        "description": str, "license": str, "filesets": {"*": FILESET},
        "parameters": {"*": PARAMETER}, "targets": {"*": TARGET}, "virtual": STRINGS,
        "mapping": {"*": str}, "generate": dict, "generators": dict, "scripts": dict,
        "provider": dict, "vpi": dict}


def fits(value, kind):
    """Whether a value is of a kind: a type, a list of one kind, a dictionary, or a test."""
    if isinstance(kind, type):
        return isinstance(value, kind) and (kind is bool or not isinstance(value, bool))
    if isinstance(kind, list):
        return isinstance(value, list) and all(fits(item, kind[0]) for item in value)
    if isinstance(kind, dict):
        return isinstance(value, dict) and all(
            fits(item, kind.get(key, kind.get("*", lambda _: False)))
            for key, item in value.items())
    return bool(kind(value))


def expand(text, flags):
    """The words of an expression that hold with these flags."""
    text = text.strip()
    if not text:
        return []
    if match := re.match(rf"(!?)\s*({WORD})\s*\?\s*\(", text):
        depth, at = 1, match.end()
        while depth:
            depth += {"(": 1, ")": -1}.get(text[at], 0)
            at += 1
        held = (match.group(2) in flags) != (match.group(1) == "!")
        inner = expand(text[match.end():at - 1], flags)
        return (inner if held else []) + expand(text[at:], flags)
    word = re.match(WORD, text)
    if not word:
        raise ValueError(f"not an expression: {text}")
    return [word.group(0)] + expand(text[word.end():], flags)


def load(path):
    first, text = path.read_text().split("\n", 1)
    if first != "CAPI=2:":
        raise ValueError(f"{path}: the first line is not CAPI=2:")
    return yaml.safe_load(text)


def files(core, target, flags):
    """The files of a target, in order."""
    chosen = core["targets"][target]
    names = [name for text in chosen["filesets"] + chosen.get("filesets_append", [])
             for name in expand(text, flags)]
    return [item if isinstance(item, str) else next(iter(item))
            for name in names for item in core["filesets"][name]["files"]]


class FuseSoc(unittest.TestCase):
    def test_core_files_fit_the_schema(self):
        for path in CORES:
            core = load(path)
            for key, value in core.items():
                self.assertTrue(fits({key: value}, CORE), f"{path.name}: {key}: {value}")
            for name, parameter in core.get("parameters", {}).items():
                self.assertLessEqual({"datatype", "paramtype"}, set(parameter), name)

    def test_schema_refuses_what_it_must(self):
        good = load(CORES[0])
        for change in ({"nmae": "x"}, {"name": "x"}, {"filesets": {"rtl": {"file": []}}},
                       {"filesets": {"rtl": {"files": "hs_pkg.sv"}}},
                       {"filesets": {"rtl": {"files": [{"a": {}, "b": {}}]}}},
                       {"targets": {"lint": {"filesets": "rtl"}}},
                       {"targets": {"lint": {"tool": "verilator"}}},
                       {"parameters": {"seed": {"datatype": "integer"}}}):
            self.assertFalse(fits({**good, **change}, CORE), change)

    def test_every_file_and_fileset_exists_below_its_core_file(self):
        version = re.search(r"project\(halfspace VERSION (\S+)",
                            (ROOT / "CMakeLists.txt").read_text()).group(1)
        for path in CORES:
            core = load(path)
            self.assertTrue(core["name"].endswith(f":{version}"), path)
            for fileset in core["filesets"].values():
                for item in fileset["files"]:
                    name = item if isinstance(item, str) else next(iter(item))
                    self.assertNotIn("..", name)
                    self.assertTrue((path.parent / name).is_file(), name)
            for target in core["targets"].values():
                for text in target["filesets"] + target.get("filesets_append", []):
                    for flag in ("", "tiny", "d3d", "msaa4", "tool_verilator"):
                        for name in expand(text, {flag}):
                            self.assertIn(name, core["filesets"])
                for text in target.get("parameters", []):
                    self.assertIn(text.split("=")[0], core["parameters"])
        depend = load(CORES[1])["filesets"]["model"]["depend"]
        self.assertEqual(depend, [load(CORES[0])["name"].rsplit(":", 1)[0]])

    def test_every_preset_is_one_flag_and_the_order_is_that_of_rtl_f(self):
        core = load(CORES[0])
        listed = (RTL / "rtl.f").read_text().split()
        presets = sorted(p.name for p in (RTL / "config").iterdir())
        for preset in presets:
            flags = set() if preset == "full" else {preset}
            self.assertEqual(files(core, "default", flags),
                             [f"config/{preset}/hs_config_pkg.sv", *listed])
        checkers = (RTL / "checkers/checkers.f").read_text().split()
        self.assertEqual(files(core, "lint", set())[1 + len(listed):],
                         [f"checkers/{name}" for name in checkers])

    def test_lint_target_is_clean_in_verilator(self):
        core = load(CORES[0])
        target = core["targets"]["lint"]
        tool = target["tools"]["verilator"]
        self.assertEqual(tool["mode"], "lint-only")
        for flags in (set(), {"tiny"}):
            names = files(core, "lint", {*flags, "tool_verilator"})
            done = subprocess.run([tool_versions.tool("verilator"), "--lint-only",
                                   *tool["verilator_options"], "--top-module", target["toplevel"],
                                   *names], cwd=RTL, capture_output=True, text=True, timeout=120,
                                  check=False)
            self.assertEqual((done.returncode, done.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main()
