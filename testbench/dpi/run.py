#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""run.py CONFIG [OPTIONS] [+PLUSARGS]: the scoreboard example in Verilator.

Builds hs_scoreboard_tb with the RTL of a configuration and the model over DPI-C, and runs it. Exit
status: 0 everything compared and equal, 1 not. Works in the source tree and in an installed
share/halfspace/dpi.
"""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(1, str(HERE.parent / "synth"))  # installed, it lies beside this file
from tool_versions import tool


def find(what, folders, name):
    for folder in folders:
        if folder and (folder / name).exists():
            return folder
    raise SystemExit(f"run.py: no {name}: name its folder with --{what}")


def arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     usage="run.py CONFIG [OPTIONS] [+PLUSARGS]",
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("config", help="preset: tiny, full, d3d or msaa4; or a .json file")
    parser.add_argument("--rtl", type=pathlib.Path, help="folder of rtl.f")
    parser.add_argument("--include", type=pathlib.Path, help="folder of halfspace.h")
    parser.add_argument("--library", type=pathlib.Path, help="folder of libhalfspace.so")
    parser.add_argument("--program", type=pathlib.Path,
                        help="halfspace, which makes the package of a .json configuration")
    parser.add_argument("--work", type=pathlib.Path, help="build here, and keep it")
    parser.add_argument("--triangles", type=int, default=1000, help="a frame (default 1000)")
    parser.add_argument("--seed", type=int, default=1)
    args, args.plusargs = parser.parse_known_args()
    for word in args.plusargs:
        if not word.startswith("+"):
            parser.error(f"unknown argument {word}")
    return args


def package(args, root, rtl, work):
    """hs_config_pkg.sv of the configuration."""
    if not args.config.endswith(".json"):
        config = rtl / "config" / args.config / "hs_config_pkg.sv"
        if not config.exists():
            raise SystemExit(f"run.py: no preset '{args.config}' in {rtl / 'config'}")
        return config
    built = [root / "build/release/halfspace", root.parent / "bin/halfspace"]
    program = args.program or next((path for path in built if path.exists()),
                                   shutil.which("halfspace"))
    if not program:
        raise SystemExit("run.py: no halfspace: name the program with --program")
    made = subprocess.run([program, "config", "--config", args.config, "--package"],
                          capture_output=True, text=True, check=False)
    if made.returncode != 0:
        raise SystemExit(f"run.py: {made.stderr.strip()}")
    config = work / "hs_config_pkg.sv"
    config.write_text(made.stdout)
    return config


def main():
    args = arguments()
    root = HERE.parents[1]  # the tree, or share/ when installed
    rtl = find("rtl", [args.rtl, HERE.parent / "rtl", root / "rtl"], "rtl.f")
    include = find("include", [args.include, root / "cmodel/capi", root.parent / "include"],
                   "halfspace.h").resolve()
    library = find("library", [args.library, root / "build/release/cmodel/capi",
                               *sorted(root.parent.glob("lib*")),
                               *sorted(root.parent.glob("lib/*"))], "libhalfspace.so").resolve()
    with tempfile.TemporaryDirectory() as folder:
        work = args.work or pathlib.Path(folder)
        work.mkdir(parents=True, exist_ok=True)
        config = package(args, root, rtl, work)
        sources = [rtl / "hs_lint.vlt", config,
                   *[rtl / line for line in (rtl / "rtl.f").read_text().split()],
                   HERE / "hs_model_pkg.sv", HERE / "hs_scoreboard.sv",
                   HERE / "hs_scoreboard_tb.sv", HERE / "hs_dpi.c"]
        environment = dict(os.environ)
        if shutil.which("ccache"):
            environment["OBJCACHE"] = "ccache"
        build = subprocess.run(
            [tool("verilator"), "--binary", "--assert", "-O3", "--timescale", "1ns/1ps",
             "--top-module", "hs_scoreboard_tb", "-Mdir", work, "-j", "2", "-o", "scoreboard",
             "-CFLAGS", f"-I{include}",
             "-MAKEFLAGS", "OPT_FAST=-O1 OPT_SLOW=-O0 OPT_GLOBAL=-O1", "-LDFLAGS",
             f"-L{library} -lhalfspace -Wl,-rpath,{library}", *sources],
            capture_output=True, text=True, env=environment, check=False)
        if build.returncode != 0:
            sys.stderr.write(build.stdout + build.stderr)
            raise SystemExit("run.py: Verilator failed")
        run = subprocess.run([work / "scoreboard", f"+triangles={args.triangles}",
                              f"+seed={args.seed}", *args.plusargs], check=False)
    # A $fatal ends the program by abort: any failure is 1.
    raise SystemExit(0 if run.returncode == 0 else 1)


if __name__ == "__main__":
    main()
