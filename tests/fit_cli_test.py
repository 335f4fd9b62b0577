#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""halfspace fit as a user runs it: files, refusals, the emitted RTL."""
import json
import os
import re
import signal
import subprocess
import sys
import time
import unittest

sys.dont_write_bytecode = True
from program import HAS_RTL, PROGRAM, SCENES, TESTS, Program  # noqa: E402
TEAPOT = SCENES / "teapot.obj"
sys.path.insert(0, str(TESTS.parent / "testbench/synth"))
from tool_versions import tool


class FitCli(Program):
    def crc(self, config, *scene):
        stats = self.out / "stats.json"
        self.succeed("render", *scene, "--out", self.out / "p.png", "--stats", stats, "--config",
                     config)
        return json.loads(stats.read_text())["coverage_crc32"]

    def test_the_configuration_draws_what_full_draws(self):
        fitted = self.out / "fitted.json"
        self.succeed("fit", TEAPOT, "--size", "160x120", "--subpixel-bits", 8, "--out", fitted)
        scene = [TEAPOT, "--size", "160x120"]
        self.assertEqual(self.crc(fitted, *scene), self.crc("full", *scene))

    def test_a_scene_outside_is_refused_with_its_index(self):
        fitted = self.out / "fitted.json"
        self.succeed("fit", TEAPOT, "--size", "160x120", "--out", fitted)
        for level in ("bit", "coverage", "cycle"):
            self.refuse("HS022", "render", SCENES / "cube.gltf", "--size", "160x120", "--config",
                        fitted, "--out", self.out / "x.png", "--level", level, says="triangle 0 ")
        self.refuse("HS022", "render", TEAPOT, "--size", "160x120", "--config", fitted, "--out",
                    self.out / "x.png", "--ortho", "1")
        self.refuse("HS005", "render", TEAPOT, "--size", "640x480", "--config", fitted, "--out",
                    self.out / "x.png")
        wide = self.out / "wide.tcov"
        wide.write_text("TCOV 1 1\ncase 3 x 160 120 2 0 00000000 0\n"
                        "0 0 512 0 0 512\n0 0 25600 0 0 512\n")
        self.refuse("HS022", "coverage", wide, "--config", fitted, "--out", self.out / "y.tcov",
                    says="case 3: triangle 1 spans 100 x 2 px")

    def test_every_view_of_an_orbit_is_held(self):
        fitted = self.out / "fitted.json"
        self.succeed("fit", TEAPOT, "--size", "160x120", "--orbit", 6, "--out", fitted)
        one = self.out / "one.json"
        self.succeed("fit", TEAPOT, "--size", "160x120", "--out", one)
        bits = [json.loads(p.read_text())["extent_bits"] for p in (fitted, one)]
        self.assertGreaterEqual(*bits)

    def test_several_scenes_get_the_widest_of_each_range(self):
        fitted = self.out / "fitted.json"
        self.succeed("fit", TEAPOT, SCENES / "cube.gltf", "--size", "160x120", "--out", fitted)
        for scene in (TEAPOT, SCENES / "cube.gltf"):
            self.succeed("render", scene, "--size", "160x120", "--config", fitted, "--out",
                         self.out / "x.png")

    def test_the_emitted_rtl_is_complete_and_lints(self):
        rtl = self.out / "rtl"
        self.succeed("fit", TEAPOT, "--size", "160x120", "--emit-rtl", rtl)
        files = (rtl / "files.f").read_text().split()
        self.assertEqual(files[0], "hs_config_pkg.sv")
        self.assertGreater(len(files), 10)
        listed = (rtl / "rtl/checkers/checkers.f").read_text().split()
        checkers = [f"rtl/checkers/{name}" for name in listed]
        subprocess.run([tool("verilator"), "--lint-only", "-Wall", "--assert", "--top-module",
                        "hs_rasterizer", "rtl/hs_lint.vlt", *files, *checkers], cwd=rtl, check=True)
        subprocess.run(["sh", "-n", rtl / "cosim.sh"], check=True)
        self.assertTrue(os.access(rtl / "cosim.sh", os.X_OK))
        self.succeed("config", "--config", rtl / "config.json")

    def test_cosim_ends_in_the_report(self):
        # Tools that do nothing, and a program that says what the RTL of a full run would say.
        tools = self.out / "bin"
        tools.mkdir()
        says = 'for last; do :; done\necho "$FAKE_STATS" > "$last"\nexit $FAKE_STATUS'
        for name, text in (("verilator", ""), ("yosys", "exit $FAKE_YOSYS"), ("halfspace", says)):
            (tools / name).write_text(f"#!/bin/sh\n{text}\n")
            (tools / name).chmod(0o755)
        run = {"identical": True, "stall": 0.3, "seed": 1, "cases": 1, "cases_skipped": 0,
               "triangles": 992, "packets_compared": 14338, "cycles": 6370}
        for identical, status, yosys, expected in ((True, 0, 0, 0), (False, 1, 0, 1),
                                                   (True, 0, 1, 2)):
            env = {**os.environ, "PATH": f"{tools}:{os.environ['PATH']}", "FAKE_YOSYS": str(yosys),
                   "FAKE_STATS": json.dumps({**run, "identical": identical}),
                   "FAKE_STATUS": str(status), "HALFSPACE": str(tools / "halfspace")}
            done = subprocess.run([PROGRAM, "fit", TEAPOT, "--size", "160x120", "--emit-rtl",
                                   self.out / "rtl", "--report", self.out / "report", "--cosim"],
                                  env=env, capture_output=True, text=True, timeout=300)
            self.assertEqual(done.returncode, expected, done.stdout + done.stderr)
            data = json.loads((self.out / "report/report.json").read_text())
            page = (self.out / "report/index.html").read_text()
            if expected == 2:
                self.assertRegex(done.stderr, r"error\[HS025\]: --cosim: .*cosim.sh failed")
                self.assertNotIn("cosim", data)
                continue
            self.assertEqual(data["cosim"], [{**run, "identical": identical}])
            self.assertIn("RTL and model identical in bits and clocks: 992 triangles, 14338 packets"
                          if identical else "RTL and model DIFFER", page)

    def test_the_report_shows_curves_and_choices(self):
        report = self.out / "report"
        done = self.succeed("fit", TEAPOT, "--size", "160x120", "--max-error", 2000, "--report",
                            report, "--out", self.out / "c.json")
        page = (report / "index.html").read_text()
        self.assertEqual(page.count("<svg"), 7)
        for bits in ("subpixel bit", "bit of the longest edge", "bit of the frame's side"):
            self.assertIn(f"What each {bits} costs (estimated)", page)
        data = json.loads((report / "report.json").read_text())
        curve = data["coverage_error"]["curve"]
        self.assertEqual([p["subpixel_bits"] for p in curve], list(range(13)))
        chosen = data["config"]["subpixel_bits"]
        self.assertLessEqual(curve[chosen]["ppm"], 2000)
        self.assertGreater(curve[chosen - 1]["ppm"], 2000)
        self.assertEqual(data["samples_different_from_reference"], 0)
        self.assertEqual(sum(s["chosen"] for s in data["shapes"]), 1)
        self.assertIn("samples differ from full", done.stdout)
        self.assertEqual([f["level"] for f in data["fifos"]["fifo"]],
                         [2, 0] if data["widths"]["fitted"]["levels"] == 3 else [1, 3])
        self.assertEqual(data["fifos"]["clocks"],
                         next(s["clocks"] for s in data["shapes"] if s["chosen"]))

    def test_what_cannot_be_is_refused(self):
        fit = ["fit", TEAPOT, "--size", "160x120", "--out", self.out / "c.json"]
        self.refuse("HS023", *fit, "--throughput", "65px/clk", says="px/clk")
        self.refuse("HS023", *fit, "--max-attribute-error", "0.1", says="levels")
        self.refuse("HS001", *fit, "--throughput", "fast")
        self.refuse("HS001", *fit, "--max-error", "100", "--subpixel-bits", "4")
        self.refuse("HS001", *fit, "--synth", says="--emit-rtl")
        self.refuse("HS001", "fit", TEAPOT, says="nothing to write")
        self.refuse("HS004", *fit, "--subpixel-bits", "13")
        self.refuse("HS010", "fit", self.out / "none.obj", "--out", self.out / "c.json")
        self.refuse("HS025", "fit", TEAPOT, "--emit-rtl", self.out / "e", "--source", self.out)
        self.refuse("HS030", "fit", TEAPOT, "--out", self.out / "no/such/c.json")

    def test_an_output_that_fails_leaves_no_other(self):
        report, rtl = self.out / "report", self.out / "rtl"
        fit = ["fit", TEAPOT, "--size", "64x48", "--emit-rtl", rtl, "--report", report]
        self.refuse("HS030", *fit, "--out", "/dev/full")
        self.refuse("HS001", *fit[:-1], rtl, says="two outputs")
        report.write_text("")
        self.refuse("HS030", *fit, says=str(report))
        report.unlink()
        (report / "index.html").mkdir(parents=True)
        (rtl / "rtl/checkers/checkers.f").mkdir(parents=True)
        before = set(self.out.rglob("*"))
        self.refuse("HS030", *fit, says="index.html")
        self.refuse("HS030", *fit[:-2], says="checkers.f")
        self.assertEqual(set(self.out.rglob("*")), before)

    def test_an_interrupted_tool_is_ended_and_its_inputs_stay(self):
        tools, started, late = (self.out / name for name in ("bin", "started", "late"))
        tools.mkdir()
        (tools / "verilator").write_text(f"#!/bin/sh\n> {started}\nsleep 1\n> {late}\n")
        (tools / "verilator").chmod(0o755)
        env = {**os.environ, "PATH": f"{tools}:{os.environ['PATH']}"}
        program = subprocess.Popen([PROGRAM, "fit", TEAPOT, "--size", "64x48", "--emit-rtl", "rtl",
                                    "--out", "c.json", "--cosim"], env=env, cwd=self.out,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        while not started.exists() and program.poll() is None:
            time.sleep(0.02)
        program.send_signal(signal.SIGINT)
        said = program.communicate(timeout=60)[1]
        self.assertEqual(program.returncode, 2, said)
        self.assertEqual(said.strip().splitlines()[-1],
                         "halfspace: error[HS050]: interrupted; what was written before stays")
        time.sleep(1.2)
        self.assertFalse(late.exists(), "the tool went on")
        self.assertEqual({p.name for p in self.out.iterdir()}, {"bin", "c.json", "rtl", "started"})

    def test_a_view_of_nothing_is_refused(self):
        away = ["--eye", "0,0,1000", "--target", "0,0,2000", "--size", "160x120"]
        for more in ([], ["--orbit", 3], ["--max-error", 1000, "--throughput", "1px/clk"]):
            self.refuse("HS041", "fit", TEAPOT, *away, *more, "--out", self.out / "c.json",
                        "--emit-rtl", self.out / "rtl", says="no triangle covers a sample")
        outside = self.out / "outside.tcov"
        outside.write_text("TCOV 1 1\ncase 0 x 16 16 1 0 0 0\n8000 8000 8512 8000 8000 8512\n")
        self.refuse("HS041", "fit", outside, "--out", self.out / "c.json")

    def test_level_auto_predicts_the_clocks_of_level_cycle(self):
        bunny = [SCENES / "bunny.obj", "--size", "1920x1080"]
        stats = {}
        for level in ("auto", "cycle"):
            file = self.out / f"{level}.json"
            self.succeed("render", *bunny, "--shade", "coverage", "--level", level, "--out",
                         self.out / f"{level}.png", "--stats", file)
            stats[level] = json.loads(file.read_text())
        predicted = stats["auto"]["cycles_predicted"]
        self.assertLessEqual(predicted["low"], stats["cycle"]["cycles"])
        self.assertGreaterEqual(predicted["high"], stats["cycle"]["cycles"])
        self.assertLess(predicted["triangles_at_cycle"], stats["cycle"]["triangles"] / 2)
        self.check_rtl_windows(predicted["rtl"])
        self.assertEqual(stats["auto"]["coverage_crc32"], stats["cycle"]["coverage_crc32"])
        tcov = self.out / "out.tcov"
        self.succeed("coverage", TESTS / "data/public.tcov", "--level", "auto", "--config", "d3d",
                     "--out", tcov, "--stats", self.out / "t.json")
        predicted = json.loads((self.out / "t.json").read_text())["cycles_predicted"]
        self.assertGreater(predicted["clocks"], 200_000)

    def check_rtl_windows(self, rtl):
        self.assertEqual(rtl["available"], HAS_RTL)
        if HAS_RTL:
            self.assertEqual(rtl["windows"], 12)
            self.assertGreater(rtl["clocks"], 1000)
            self.assertGreater(rtl["packets"], rtl["clocks"])
            self.assertTrue(rtl["identical"])
        else:
            self.assertEqual((rtl["windows"], rtl["clocks"], rtl["packets"]), (0, 0, 0))

    def test_level_auto_says_whether_the_rtl_confirms_it(self):
        plain = json.loads(self.succeed("config", "--config", "full").stdout)
        odd = self.out / "odd.json"
        odd.write_text(json.dumps({**plain, "subpixel_bits": 3}))
        for config in ("full", odd):
            stats = self.out / "s.json"
            done = self.succeed("render", TEAPOT, "--size", "160x120", "--level", "auto", "--shade",
                                "coverage", "--config", config, "--out", self.out / "p.png",
                                "--stats", stats)
            rtl = json.loads(stats.read_text())["cycles_predicted"]["rtl"]
            self.assertEqual(rtl["available"], HAS_RTL)
            self.assertIn("12 windows" if HAS_RTL else "no Verilator or C++ compiler here",
                          done.stderr)

    def test_savings_change_no_bit_of_the_picture(self):
        stats, picture = {}, {}
        for level in ("bit", "cycle"):
            file = self.out / f"{level}.json"
            self.succeed("render", TEAPOT, "--size", "320x240", "--level", level, "--out",
                         self.out / f"{level}.png", "--stats", file)
            stats[level] = json.loads(file.read_text())
            picture[level] = (self.out / f"{level}.png").read_bytes()
        self.assertEqual(picture["bit"], picture["cycle"])
        for key in ("nodes_per_level", "tiles_covered", "fragments_shaded", "coverage_crc32"):
            self.assertEqual(stats["bit"][key], stats["cycle"][key], key)
        self.assertEqual(stats["bit"]["savings"], stats["cycle"]["savings"])
        for key, value in stats["cycle"]["savings"].items():
            self.assertGreater(value, 0, key)

    def test_simplification_leaves_out_triangles(self):
        stats = self.out / "s.json"
        self.succeed("render", SCENES / "bunny.obj", "--size", "320x240", "--simplify", "1",
                     "--out", self.out / "s.png", "--stats", stats)
        triangles = json.loads(stats.read_text())["triangles"]
        self.assertLess(triangles, 3674 / 2)
        done = self.succeed("fit", SCENES / "bunny.obj", "--size", "320x240", "--simplify", "1",
                            "--out", self.out / "c.json")
        self.assertIn(f"simplified: {triangles} of 3674 triangles", done.stdout)

    def test_area_is_printed_for_any_configuration(self):
        area = json.loads(self.succeed("config", "--area", "--config", "full").stdout)
        self.assertAlmostEqual(area["luts"], 25309, delta=0.04 * 25309)
        self.assertIn("luts = lut4 + 2 ccu2c", area["unit"])
        self.assertAlmostEqual(area["luts"], area["lut4"] + 2 * area["ccu2c"], delta=2)

    def test_the_package_of_a_configuration_is_that_of_the_rtl(self):
        values = []
        for text in (self.succeed("config", "--package", "--config", "tiny").stdout,
                     (TESTS.parent / "rtl/config/tiny/hs_config_pkg.sv").read_text()):
            code = re.sub(r"//.*", "", text)
            values.append(re.findall(r"`define HS_(\w+) (\d+)|localparam int (\w+)", code))
        self.assertEqual(len(values[0]), 16)
        self.assertEqual(values[0], values[1])


if __name__ == "__main__":
    unittest.main()
