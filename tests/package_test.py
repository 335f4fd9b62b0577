#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The installed package, as people outside the tree use it."""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["HALFSPACE_SOURCE"])
BUILD = pathlib.Path(os.environ["HALFSPACE_BUILD"])
CMAKE = os.environ["CMAKE_COMMAND"]
PYTHON = os.environ.get("HALFSPACE_PYTHON", "")  # the interpreter the module was built for, or none
SCENE = SOURCE / "tests/scenes/bunny.obj"
ARGUMENTS = [str(SCENE), "640", "480"]


def run(*command, **options):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True,
                          timeout=400, check=False, **options)
    if done.returncode != 0:
        raise AssertionError(f"{command}: exit {done.returncode}\n{done.stdout}\n{done.stderr}")
    return done.stdout


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.top = pathlib.Path(cls.folder.name)
        cls.prefix = cls.top / "installed"
        run(CMAKE, "--install", BUILD, "--prefix", cls.prefix)
        stats = cls.top / "stats.json"
        run(cls.prefix / "bin/halfspace", "render", SCENE, "--size", "640x480",
            "--out", cls.top / "bunny.png", "--stats", stats)
        cls.crc = str(json.loads(stats.read_text())["coverage_crc32"])
        cls.libdir = next(cls.prefix.glob("**/libhalfspace.so")).parent

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def consumer(self, name, *options):
        """Configures and builds a copy of the consumer: no path of the tree can help it."""
        project = self.top / name
        shutil.copytree(SOURCE / "tests/consumer", project)
        headers = sorted(p.relative_to(self.prefix / "include/halfspace")
                         for p in (self.prefix / "include/halfspace").rglob("*.hpp"))
        self.assertGreater(len(headers), 30)
        if name == "package":
            lines = "".join(f'#include "{h}"\n#include <halfspace/{h}>\n' for h in headers)
            (project / "headers.cpp").write_text(lines)
        ccache = shutil.which("ccache")
        launcher = [f"-DCMAKE_{l}_COMPILER_LAUNCHER={ccache}" for l in ("C", "CXX") if ccache]
        run(CMAKE, "-S", project, "-B", project / "build", "-G", "Ninja",
            *launcher, *options)
        run(CMAKE, "--build", project / "build")
        return project / "build"

    def test_find_package_gives_the_bunny(self):
        build = self.consumer("package", "-DCMAKE_BUILD_TYPE=Release",
                              f"-DCMAKE_PREFIX_PATH={self.prefix}")
        for program in ("consumer_c", "consumer_static", "consumer_cpp"):
            self.assertEqual(run(build / program, *ARGUMENTS).strip(), self.crc, program)

    def test_add_subdirectory_gives_the_bunny(self):
        # The whole library is compiled: without optimization that takes half the time.
        build = self.consumer("subdirectory", f"-DHALFSPACE_FROM={SOURCE}",
                              "-DCMAKE_BUILD_TYPE=Debug", "-DCMAKE_CXX_FLAGS_DEBUG=-O0")
        for program in ("consumer_c", "consumer_static", "consumer_cpp"):
            self.assertEqual(run(build / program, *ARGUMENTS).strip(), self.crc, program)

    def test_pkg_config_gives_the_bunny(self):
        path = {**os.environ, "PKG_CONFIG_PATH": str(self.libdir / "pkgconfig"),
                "LD_LIBRARY_PATH": str(self.libdir)}
        version = re.search(r"project\(halfspace VERSION (\S+)",
                            (SOURCE / "CMakeLists.txt").read_text()).group(1)
        self.assertEqual(run("pkg-config", "--modversion", "halfspace", env=path).strip(), version)
        flags = run("pkg-config", "--cflags", "--libs", "halfspace", env=path).split()
        self.assertNotIn("-lpng", flags)
        static = run("pkg-config", "--cflags", "--libs", "--static", "halfspace", env=path).split()
        static[static.index("-lhalfspace")] = "-l:libhalfspace.a"
        for name, options in (("shared", flags), ("static", static)):
            program = self.top / f"pkg_{name}"
            run("cc", "-std=c99", "-Wall", "-Wextra", "-pedantic", "-Werror",
                SOURCE / "tests/consumer/consumer.c", "-o", program, *options, env=path)
            self.assertEqual(run(program, *ARGUMENTS, env=path).strip(), self.crc, name)

    @unittest.skipUnless(PYTHON, "built without HALFSPACE_PYTHON")
    def test_python_gives_the_bunny(self):
        module = next(p for p in self.prefix.rglob("halfspace.*.so") if "cpython" in p.name)
        path = {**os.environ, "PYTHONPATH": str(module.parent)}
        out = run(PYTHON, SOURCE / "tests/consumer/consumer.py", *ARGUMENTS, env=path)
        self.assertEqual(out.strip(), self.crc)

    def test_example_of_the_c_page_prints_what_the_page_says(self):
        code, told = self.example("c_api.md", "c")
        source = self.top / "example.c"
        source.write_text(code)
        path = {**os.environ, "PKG_CONFIG_PATH": str(self.libdir / "pkgconfig"),
                "LD_LIBRARY_PATH": str(self.libdir)}
        flags = run("pkg-config", "--cflags", "--libs", "halfspace", env=path).split()
        run("cc", "-std=c99", "-Wall", "-Wextra", "-pedantic", "-Werror", source,
            "-o", self.top / "example", *flags, env=path)
        self.assertIn(run(self.top / "example", env=path), told)

    @unittest.skipUnless(PYTHON, "built without HALFSPACE_PYTHON")
    def test_example_of_the_python_page_prints_what_the_page_says(self):
        code, told = self.example("python.md", "python")
        module = next(p for p in self.prefix.rglob("halfspace.*.so") if "cpython" in p.name)
        path = {**os.environ, "PYTHONPATH": str(module.parent)}
        self.assertIn(run(PYTHON, "-c", code, env=path), told)

    @staticmethod
    def example(page, language):
        """The first example of a page, and the page's indented lines."""
        text = (SOURCE / "docs/02_use" / page).read_text()
        code = re.search(rf"```{language}\n(.*?)```", text, re.S).group(1)
        return code, "".join(re.findall(r"^    (.*\n)", text.split("```")[2], re.M))

    def test_shared_library_shows_its_interface_alone(self):
        names = run("nm", "-D", "--defined-only", self.libdir / "libhalfspace.so").split("\n")
        shown = {line.split()[-1].split("@")[0] for line in names if line}
        header = (self.prefix / "include/halfspace.h").read_text()
        declared = set(re.findall(r"\b(hs_\w+)\(", re.sub(r"/\*.*?\*/", "", header, flags=re.S)))
        version = re.search(r"HALFSPACE_API_VERSION (\d+)", header).group(1)
        self.assertEqual(shown, declared | {f"HALFSPACE_{version}"})
        soname = run("readelf", "-d", self.libdir / "libhalfspace.so")
        self.assertIn(f"libhalfspace.so.{version}]", soname)

    def test_nothing_installed_names_the_tree_it_came_from(self):
        for path in self.prefix.rglob("*"):
            if path.is_file():
                # Verilated code names the RTL's files, and its own, in its assertions.
                data = path.read_bytes()
                for folder in (SOURCE / "rtl", BUILD / "testbench/rtl"):
                    data = data.replace(str(folder).encode() + b"/", b"")
                for tree in (SOURCE, BUILD):
                    self.assertFalse(str(tree).encode() + b"/" in data, (path, tree))

    # --- find_package where something is missing --------------------------------------------------

    def find_package(self, name, prefix, arguments, linked=""):
        """Configures and builds a C program that finds the package and links what is named."""
        project = self.top / name
        project.mkdir()
        shutil.copy(SOURCE / "tests/consumer/consumer.c", project)
        (project / "CMakeLists.txt").write_text(
            f"cmake_minimum_required(VERSION 3.25)\nproject({name} LANGUAGES C)\n"
            f"find_package(halfspace {arguments})\nadd_executable(consumer consumer.c)\n"
            f"target_link_libraries(consumer PRIVATE {linked})\n")
        done = subprocess.run([CMAKE, "-S", project, "-B", project / "build", "-G", "Ninja",
                               f"-DCMAKE_PREFIX_PATH={prefix}"],
                              capture_output=True, text=True, timeout=60, check=False)
        if linked and done.returncode == 0:
            run(CMAKE, "--build", project / "build")
        return done

    def test_component_that_is_missing_is_said(self):
        done = self.find_package("missing", self.prefix, "REQUIRED COMPONENTS cmodel teapot")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("component teapot was not built", " ".join(done.stderr.split()))

    def test_shared_library_does_without_the_static_ones(self):
        prefix = self.top / "shared"
        shutil.copytree(self.prefix, prefix, symlinks=True)
        archives = list(prefix.rglob("*.a"))
        self.assertEqual(len(archives), 4)
        for path in archives:
            path.unlink()
        for name, arguments in (("default", "REQUIRED"), ("named", "REQUIRED COMPONENTS capi"),
                                ("optional", "COMPONENTS capi OPTIONAL_COMPONENTS cmodel io")):
            done = self.find_package(name, prefix, arguments, "halfspace::capi")
            self.assertEqual((done.returncode, done.stderr), (0, ""), name)
            said = f"component cmodel has no {prefix}" in done.stdout
            self.assertEqual(said, name != "named", done.stdout)
            self.assertEqual(run(self.top / name / "build/consumer", *ARGUMENTS).strip(), self.crc)
        for component in ("cmodel", "io", "capi_static"):
            done = self.find_package(f"needs_{component}", prefix,
                                     f"REQUIRED COMPONENTS capi {component}")
            self.assertNotEqual(done.returncode, 0, component)
            self.assertIn("component cmodel has no", " ".join(done.stderr.split()))

    # --- Components of cmake --install ------------------------------------------------------------

    def test_components_of_the_page_are_the_installation(self):
        page = (SOURCE / "docs/02_use/install.md").read_text()
        table = page.split("| --component |")[1].split("\n\n")[0]
        names = re.findall(r"^\| `(\w+)` \|", table, re.M)
        self.assertIn("runtime", names)
        if not PYTHON:
            names.remove("python")
        owner = {}
        for name in names:
            prefix = self.top / "components" / name
            run(CMAKE, "--install", BUILD, "--prefix", prefix, "--component", name)
            files = self.files(prefix)
            self.assertTrue(files, name)
            self.assertFalse(owner.keys() & files, "files of two components")
            owner.update(dict.fromkeys(files, name))
        self.assertEqual(owner.keys(), self.files(self.prefix), "files of no component")
        library = (self.libdir / "libhalfspace.so").relative_to(self.prefix)
        real = (self.libdir / "libhalfspace.so").resolve().relative_to(self.prefix)
        for path, name in (("bin/halfspace", "runtime"), ("share/halfspace/rtl/rtl.f", "runtime"),
                           (real, "library"), (library, "development"),
                           ("include/halfspace.h", "development")):
            self.assertEqual(owner[pathlib.Path(path)], name, path)

    @staticmethod
    def files(prefix):
        return {p.relative_to(prefix) for p in prefix.rglob("*") if not p.is_dir()}

    def test_unknown_component_is_refused(self):
        prefix = self.top / "unknown"
        done = subprocess.run([CMAKE, "--install", BUILD, "--prefix", prefix,
                               "--component", "teapot"],
                              capture_output=True, text=True, timeout=60, check=False)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("no component teapot, but runtime, ", done.stderr)
        self.assertFalse(prefix.exists())

    # --- Pages made from --help -------------------------------------------------------------------

    def test_manual_page_is_clean_and_names_every_option(self):
        page = self.prefix / "share/man/man1/halfspace.1"
        done = subprocess.run(["groff", "-man", "-ww", "-b", "-Tutf8", "-P-cbou", page],
                              capture_output=True, text=True, timeout=60, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        shown = " ".join(done.stdout.replace("\u2010", "-").split())
        program = self.prefix / "bin/halfspace"
        count = 0
        for words, text in self.helps(program):
            self.assertIn(" ".join(words), shown)
            for option in re.findall(r"^  (?:-\w,)?(--[a-z-]+)", text, re.M):
                self.assertIn(option, shown, words)
                count += 1
        self.assertGreater(count, 20)

    def helps(self, program, words=()):
        text = run(program, *words, "--help")
        yield words, text
        below = re.search(r"^Subcommands:\n((?:  .*\n)+)", text, re.M)
        for name in re.findall(r"^  (\S+)", below.group(1) if below else "", re.M):
            yield from self.helps(program, (*words, name))

    def complete(self, *words):
        script = self.prefix / "share/bash-completion/completions/halfspace"
        text = (f"source {script}; COMP_WORDS=({' '.join(repr(w) for w in words)}); "
                "COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _halfspace; echo ${COMPREPLY[@]}")
        return run("bash", "--norc", "-u", "-e", "-c", text).split()

    def test_completion_offers_what_help_lists(self):
        program = self.prefix / "bin/halfspace"
        pages = dict(self.helps(program))
        for words, text in pages.items():
            options = set(re.findall(r"(--?[a-z][a-z-]*)(?=[ ,\n])",
                                     "\n".join(re.findall(r"^  (-\S+ )", text, re.M))))
            self.assertEqual(set(self.complete("halfspace", *words, "-")), options, words)
        self.assertIn("render", self.complete("halfspace", ""))
        self.assertEqual(self.complete("halfspace", "rend"), ["render"])
        self.assertEqual(self.complete("/usr/bin/halfspace", "render", "--cull", "b"), ["back"])
        for option, words in (("--config", "tiny full d3d msaa4"), ("--samples", "1 2 4 8 16"),
                              ("--shade", "gouraud flat depth coverage tiles"),
                              ("--level", "coverage bit cycle rtl auto"),
                              ("--depth-test", "never less equal less_equal greater not_equal "
                                               "greater_equal always"),
                              ("--format", "obj gltf glb ply stl tcov")):
            self.assertEqual(self.complete("halfspace", "render", "x", option, ""), words.split())
        methods = [m["name"] for m in json.loads(run(program, "methods", "--json"))]
        self.assertGreater(len(methods), 20)
        for command in ("render", "explain", "stability"):
            self.assertEqual(self.complete("halfspace", command, "--method", ""), methods)
        if (BUILD / "CMakeCache.txt").read_text().find("HALFSPACE_LAB:BOOL=ON") >= 0:
            self.assertIn("shared_edges", self.complete("halfspace", "stability", "--suite", ""))
            self.assertIn("ladder", self.complete("halfspace", "chart", ""))
        self.assertIn("llvmpipe", self.complete("halfspace", "bench", "--engine", ""))
        self.assertEqual(self.complete("halfspace", "help", "rep"), ["report"])
        self.assertEqual(self.complete("halfspace", "render", "--out", ""), [], "file names")


if __name__ == "__main__":
    unittest.main()
