# SPDX-License-Identifier: Apache-2.0
"""Where the RTL is and in which order it is read."""
import pathlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
RTL = ROOT / "rtl"
PRESETS = sorted(p.name for p in (RTL / "config").iterdir() if p.is_dir())
TEST_CONFIGS = sorted(p.name for p in (ROOT / "testbench/rtl/config").iterdir() if p.is_dir())
TOP = "hs_rasterizer"
# Modules of the back end that are read by themselves: no top holds them yet.
BACK_END = ["hs_reciprocal", "hs_gradient", "hs_tile_plane", "hs_depth_test",
            "hs_depth_setup", "hs_shade"]


def listed(folder, name):
    """The files that list `folder/name` names, in its order."""
    return [folder / line for line in (folder / name).read_text().split()]


def config(name):
    """The package of a preset or of a test configuration, or the package at that path."""
    if str(name).endswith(".sv"):
        return pathlib.Path(name).resolve()
    folder = RTL / "config" if name in PRESETS else ROOT / "testbench/rtl/config"
    return folder / name / "hs_config_pkg.sv"


def design():
    """All modules of the design."""
    return listed(RTL, "rtl.f")


def back_end():
    """The modules of the back end, and what they share with the others."""
    return [RTL / "hs_pkg.sv", *listed(RTL, "back_end.f")]


def checkers():
    """The bound checkers, Verilator only."""
    return listed(RTL / "checkers", "checkers.f")


def back_end_checkers():
    """Those of the back end."""
    return [RTL / "checkers/hs_handshake_checker.sv", *listed(RTL / "checkers", "back_end.f")]


def yosys_read(name, top=TOP, parameters=()):
    """The yosys commands that read a configuration and elaborate it; parameters: NAME=VALUE."""
    files = " ".join(str(f) for f in [config(name), *(design() if top == TOP else back_end())])
    values = "".join(f" -chparam {p.replace('=', ' ')}" for p in parameters)
    return f"read_verilog -sv {files}; hierarchy -check -top {top}{values}"
