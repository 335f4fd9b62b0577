#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The program as a user runs it: what it writes, what it says, and how it fails."""
import json
import pathlib
import re
import signal
import struct
import subprocess
import time
import sys
import unittest
import zlib

sys.dont_write_bytecode = True
from program import HAS_RTL, PROGRAM, PUBLIC, SCENES, Program  # noqa: E402

LEVELS = ("coverage", "bit", "cycle") + (("rtl",) if HAS_RTL else ())


def png_size(path):
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    return struct.unpack(">II", data[16:24])


class Cli(Program):
    # --- what it does -----------------------------------------------------------------------------

    def test_renders_every_format(self):
        for name in ("teapot.obj", "bunny.obj", *sorted(
                p.name for p in SCENES.iterdir() if p.suffix in (".gltf", ".glb", ".ply", ".stl"))):
            png, stats = self.out / f"{name}.png", self.out / f"{name}.json"
            self.succeed("render", SCENES / name, "--out", png, "--stats", stats,
                         "--size", "160x120")
            self.assertEqual(png_size(png), (160, 120))
            told = json.loads(stats.read_text())
            self.assertGreater(told["samples_covered"], 500, name)
            self.assertEqual(told["triangles_not_finite"], 0)

    def test_statistics_have_every_promised_field(self):
        stats = self.out / "s.json"
        self.succeed("render", SCENES / "teapot.obj", "--out", self.out / "t.png", "--stats", stats)
        told = json.loads(stats.read_text())
        for key in ("triangles", "triangles_culled", "tiles_visited", "tiles_covered",
                    "samples_tested", "samples_covered", "fragments", "coverage_crc32",
                    "wall_seconds", "simulate_seconds", "peak_memory_bytes", "config"):
            self.assertIn(key, told)
        self.assertEqual(told["triangles"], 992)
        self.assertLessEqual(told["tiles_covered"], told["tiles_visited"])
        self.assertEqual(told["samples_tested"], 64 * told["tiles_visited"])
        self.assertEqual(told["config"]["subpixel_bits"], 8)

    def test_levels_agree_on_coverage(self):
        crc = set()
        for level in LEVELS:
            stats = self.out / "s.json"
            self.succeed("render", SCENES / "bunny.obj", "--out", self.out / "b.png",
                         "--stats", stats, "--level", level)
            crc.add(json.loads(stats.read_text())["coverage_crc32"])
        self.assertEqual(len(crc), 1)

    def test_crc_is_that_of_the_hit_counts(self):
        case, stats = self.out / "one.tcov", self.out / "s.json"
        case.write_text("TCOV 1 1\ncase 5 t 8 8 1 0 0 0\n0 0 2048 0 0 2048\n")
        self.succeed("coverage", case, "--out", self.out / "o.tcov", "--stats", stats)
        image = bytes(1 if x + y < 7 else 0 for y in range(8) for x in range(8))
        self.assertEqual(json.loads(stats.read_text())["coverage_crc32"], zlib.crc32(image))

    def test_driver_cases_have_no_wrong_pixel(self):
        for level in LEVELS:
            out = self.out / f"{level}.tcov"
            self.succeed("coverage", PUBLIC, "--out", out, "--level", level)
            self.assertEqual(self.pictures(out), self.pictures(PUBLIC))

    @staticmethod
    def pictures(path):
        """The id, CRC and sum of every case: its header fields 1, 7 and 8."""
        return re.findall(r"^case (\S+) \S+ \S+ \S+ \S+ \S+ (\S+) (\S+)", path.read_text(), re.M)

    def test_shades_samples_and_cameras(self):
        pictures = set()
        for args in ((), ("--shade", "flat"), ("--shade", "depth"), ("--shade", "coverage"),
                     ("--shade", "tiles"), ("--samples", "4"), ("--cull", "back"),
                     ("--eye", "0,2,9", "--target", "0,1,0"), ("--fov", "20"), ("--ortho", "0"),
                     ("--ortho", "6"), ("--up", "1,1,0"), ("--config", "tiny"),
                     ("--depth-test", "less_equal")):
            png = self.out / "p.png"
            self.succeed("render", SCENES / "teapot.obj", "--out", png, "--size", "96x64", *args)
            pictures.add(png.read_bytes())
        self.assertGreaterEqual(len(pictures), 12)

    def test_same_command_same_bytes(self):
        for name in ("a.png", "b.png"):
            self.succeed("render", SCENES / "teapot.obj", "--out", self.out / name)
        self.assertEqual((self.out / "a.png").read_bytes(), (self.out / "b.png").read_bytes())

    def test_level_bit_draws_and_counts_what_level_cycle_does(self):
        for args in ((), ("--samples", "4"), ("--config", "tiny"), ("--shade", "flat"),
                     ("--shade", "depth", "--cull", "back"), ("--eye", "0.3,0.5,0.2")):
            seen = []
            for level in (("--level", "cycle"), ("--level", "bit"), ("--threads", "1"),
                          ("--threads", "3")):
                stats = self.out / "s.json"
                self.succeed("render", SCENES / "bunny.obj", "--out", self.out / "b.png",
                             "--size", "180x140", "--stats", stats, *args, *level)
                told = json.loads(stats.read_text())
                told = {k: v for k, v in told.items()
                        if k not in ("level", "peak_memory_bytes") and "second" not in k
                        and "cycle" not in k}
                seen.append(((self.out / "b.png").read_bytes(), told))
            for other in seen[1:]:
                self.assertEqual(seen[0][0], other[0], args)
                self.assertEqual(seen[0][1], other[1], args)

    def test_tcov_renders_one_case_or_a_sheet(self):
        self.succeed("render", PUBLIC, "--case", 0, "--out", self.out / "one.png")
        self.assertEqual(png_size(self.out / "one.png"), (231, 249))
        case = self.out / "two.tcov"
        case.write_text("TCOV 1 2\ncase 1 t 8 8 1 0 0 0\n0 0 2048 0 0 2048\n"
                        "case 2 t 8 8 1 0 0 0\n0 0 2048 0 0 2048\n")
        self.succeed("render", case, "--out", self.out / "two.png")
        self.assertEqual(png_size(self.out / "two.png"), (20, 10))

    def test_config_prints_what_it_reads(self):
        shown = json.loads(self.succeed("config", "--config", "tiny").stdout)
        file = self.out / "c.json"
        file.write_text(json.dumps(shown))
        again = json.loads(self.succeed("config", "--config", file).stdout)
        self.assertEqual(shown, again)
        derived = json.loads(self.succeed("config", "--derived").stdout)
        self.assertEqual(derived["delta_bits"], 23)

    def test_help_has_an_example(self):
        for command in ("render", "coverage", "config"):
            self.assertIn("Example: halfspace " + command,
                          self.succeed(command, "--help").stdout)

    def test_model_and_rtl_draw_the_same_picture_in_the_same_clocks(self):
        drawn = set()
        for level in LEVELS[2:]:
            stats = self.out / "s.json"
            self.succeed("render", SCENES / "teapot.obj", "--out", self.out / "t.png",
                         "--stats", stats, "--level", level)
            told = json.loads(stats.read_text())
            drawn.add(((self.out / "t.png").read_bytes(), told["cycles"], told["tiles_covered"],
                       told["samples_covered"], told["tiles_visited"], told["fragments_shaded"]))
        self.assertEqual(len(drawn), 1)
        self.succeed("render", SCENES / "teapot.obj", "--out", self.out / "b.png")
        self.assertEqual((self.out / "t.png").read_bytes(), (self.out / "b.png").read_bytes())

    @unittest.skipUnless(HAS_RTL, "built without RTL")
    def test_cosim_says_identical_and_how_much_it_compared(self):
        for config in ("tiny", "full", "d3d", "msaa4"):
            stats = self.out / "s.json"
            done = self.succeed("cosim", SCENES / "bunny.obj", "--config", config, "--stall", "0.3",
                                "--seed", "7", "--stats", stats)
            self.assertIn("identical in bits and clocks", done.stdout)
            told = json.loads(stats.read_text())
            self.assertTrue(told["identical"])
            self.assertGreater(told["packets_compared"], 10000)
            for key in ("cycles", "utilisation", "pixels_per_clock", "sample_test_efficiency",
                        "tiles_visited", "tiles_covered", "rtl_clocks_per_second"):
                self.assertIn(key, told)

    @unittest.skipUnless(HAS_RTL, "built without RTL")
    def test_cosim_that_compared_nothing_fails(self):
        empty = self.out / "empty.tcov"
        empty.write_text("TCOV 1 1\ncase 1 t 8 8 0 0 0 0\n")
        done = self.run_program("cosim", empty)
        self.assertEqual(done.returncode, 1)
        self.assertIn("nothing was compared", done.stderr)
        empty.write_text("TCOV 1 2\ncase 1 t 8 8 0 0 0 0\n")
        self.refuse("HS020", "cosim", empty)
        self.refuse("HS001", "cosim", SCENES / "teapot.obj", "--stall", "1.5", says="1.5")

    @unittest.skipUnless(HAS_RTL, "built without RTL")
    def test_level_rtl_takes_a_configuration_that_no_preset_has(self):
        odd = self.out / "odd.json"
        odd.write_text('{"subpixel_bits": 5, "viewport_bits": 9, "guard_bits": 11, "samples": 2}')
        pictures = set()
        for level in ("bit", "rtl"):
            self.succeed("render", SCENES / "teapot.obj", "--config", odd, "--size", "160x120",
                         "--level", level, "--out", self.out / "x.png")
            pictures.add((self.out / "x.png").read_bytes())
        self.assertEqual(len(pictures), 1)

    # --- how it fails -----------------------------------------------------------------------------

    def test_bad_options(self):
        out = self.out / "x.png"
        teapot = SCENES / "teapot.obj"
        self.refuse("HS001")
        self.refuse("HS001", "paint")
        self.refuse("HS001", "render", teapot)
        self.refuse("HS001", "render", teapot, "--out", out, "--colour")
        self.refuse("HS001", "render", teapot, "--out", out, "--shade", "toon", says="toon")
        self.refuse("HS001", "render", teapot, "--out", out, "--level", "gate", says="gate")
        self.refuse("HS001", "render", teapot, "--out", out, "--cull", "left", says="left")
        self.refuse("HS001", "render", teapot, "--out", out, "--eye", "1,2", says="1,2")
        self.refuse("HS001", "render", teapot, "--out", out, "--eye", "nan,nan,nan")
        self.refuse("HS001", "render", teapot, "--out", out, "--fov", "180", says="180")
        self.refuse("HS001", "render", teapot, "--out", out, "--level", "coverage",
                    "--shade", "depth")

    def test_bad_sizes(self):
        for size in ("0x0", "100000x100000", "640", "640x", "-1x5", "640x480x2", "4097x16",
                     "99999999999x1", "axb"):
            self.refuse("HS005", "render", SCENES / "teapot.obj", "--out", self.out / "x.png",
                        f"--size={size}")

    def test_bad_scenes(self):
        out = self.out / "x.png"
        self.refuse("HS010", "render", self.out / "none.obj", "--out", out, says="none.obj")
        self.refuse("HS010", "render", self.out, "--out", out)
        self.refuse("HS010", "coverage", self.out / "none.tcov", "--out", out)
        bunny = (SCENES / "bunny.obj").read_bytes()
        files = {
            "nan.obj": (b"v 0 0 0\nv 1 nan 0\nv 0 1 0\nf 1 2 3\n", "HS013", "nan.obj:2"),
            "cut.obj": (bunny[:len(bunny) * 3 // 4], "HS011", "cut.obj"),
            "index.obj": (b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "HS014", "index.obj:4"),
            "empty.obj": (b"", "HS012", "empty.obj"),
        }
        for name, (data, code, place) in files.items():
            path = pathlib.Path(self.folder.name) / name
            path.write_bytes(data)
            self.refuse(code, "render", path, "--out", out, says=place)

    def test_bad_configurations(self):
        out = self.out / "x.png"
        for text, code, says in (('{"subpixel_bits": 13}', "HS004", "subpixel_bits"),
                                 ('{"sub": 1}', "HS003", "sub"), ("{", "HS002", "c.json"),
                                 ('{"samples": 5}', "HS004", "samples")):
            file = self.out / "c.json"
            file.write_text(text)
            self.refuse(code, "render", SCENES / "teapot.obj", "--out", out, "--config", file,
                        says=says)
        self.refuse("HS002", "render", SCENES / "teapot.obj", "--out", out, "--config", "no.json")
        self.refuse("HS003", "render", SCENES / "teapot.obj", "--out", out, "--config", "huge")
        self.refuse("HS004", "render", SCENES / "teapot.obj", "--out", out, "--samples", "3")

    def test_bad_outputs(self):
        teapot = SCENES / "teapot.obj"
        self.refuse("HS030", "render", teapot, "--out", self.out / "no" / "such" / "x.png")
        self.refuse("HS030", "render", teapot, "--out", self.out)
        self.refuse("HS030", "render", teapot, "--out", "/dev/full", says="/dev/full")
        self.refuse("HS030", "coverage", PUBLIC, "--out", "/dev/full")

    def test_tcov_beyond_the_configuration(self):
        case = self.out / "far.tcov"
        case.write_text("TCOV 1 1\ncase 7 t 8 8 1 0 0 0\n0 0 2048 0 0 999999999\n")
        self.refuse("HS020", "coverage", case, "--out", self.out / "o.tcov", says="far.tcov:3")
        case.write_text("TCOV 1 1\ncase 7 t 8 8 1 0 0 0\n0 0 2048 0 0 99999999\n")
        self.refuse("HS021", "coverage", case, "--out", self.out / "o.tcov", says="case 7")
        case.write_text("TCOV 1 1\ncase 7 t 600 8 0 0 0 0\n")
        self.refuse("HS005", "coverage", case, "--config", "tiny", "--out", self.out / "o.tcov")
        case.write_text("TCOV 1 0\n")
        self.refuse("HS041", "coverage", case, "--out", self.out / "o.tcov")
        self.refuse("HS041", "render", PUBLIC, "--case", 9999, "--out", self.out / "o.png")

    def test_interrupt_leaves_nothing(self):
        # A picture large enough to be caught at work.
        run = subprocess.Popen([PROGRAM, "render", SCENES / "bunny.obj", "--size", "4096x4096",
                                "--samples", "16", "--out", self.out / "x.png"],
                               stderr=subprocess.PIPE, text=True)
        time.sleep(0.5)
        run.send_signal(signal.SIGINT)
        said = run.communicate(timeout=60)[1]
        self.assertEqual(run.returncode, 2, said)
        self.assertIn("error[HS050]", said)
        self.assertEqual(list(self.out.iterdir()), [])


if __name__ == "__main__":
    unittest.main()
