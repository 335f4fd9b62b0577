#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Command lines that a person types, each with its exit status and what standard error says.

A line that is refused leaves every file as it was; one that is done leaves its inputs as they were.
"""
import os
import shlex
import shutil
import sys
import unittest

sys.dont_write_bytecode = True
from program import HAS_LAB, HAS_RTL, PROGRAM, SCENES, TESTS, Program  # noqa: E402

DONE, NOTE = 0, 0
USAGE = r"halfspace: error\[HS001\]: "

# words, exit status, what stderr says (a regular expression; empty: nothing). Files of the folder:
# cube.gltf, its link `link.gltf`, its hard link `hard.gltf`, teapot.obj, two.tcov, c.json, v.csv.
LINES = [
    # Typing.
    ("rendr cube.gltf --out a.png", 2, USAGE + "'rendr' is not a subcommand: is it 'render'?"),
    ("redner cube.gltf --out a.png", 2, USAGE + "'redner' is not a subcommand: is it 'render'?"),
    ("cov two.tcov --out a.tcov", 2, USAGE + "'cov' is not a subcommand: is it 'coverage'?"),
    ("paint cube.gltf", 2, USAGE + r"'paint' is not a subcommand \("),
    ("render cube.gltf --sise 64x48 --out a.png", 2,
     USAGE + "--sise is not an option of render: is it '--size'?"),
    ("render cube.gltf --sise=64x48 --out a.png", 2, USAGE + "--sise is not .* is it '--size'?"),
    ("render cube.gltf --sam 4 --out a.png", 2, USAGE + "--sam is not .* is it '--samples'?"),
    ("render cube.gltf -size 64x48 --out a.png", 2, USAGE + "-size is not .* is it '--size'?"),
    ("coverage two.tcov --output a.tcov --out b.tcov", 2,
     USAGE + "--output is not an option of coverage: is it '--out'?"),
    ("config --confg tiny", 2, USAGE + "--confg is not an option of config: is it '--config'?"),
    ("--versoin", 2, USAGE + "--versoin is not an option of halfspace: is it '--version'?"),
    ("help", DONE, ""),
    ("help render", DONE, ""),
    ("help rendr", 2, USAGE + "'rendr' is not a subcommand: is it 'render'?"),
    ("render", 2, USAGE + ".*SCENE"),
    ("render cube.gltf", 2, USAGE + ".*--out"),
    ("render cube.gltf --shade phong --out a.png", 2, USAGE + "--shade: 'phong' is not gouraud, "),
    ("render cube.gltf --out", 2, USAGE + "--out"),
    ("render cube.gltf --out a.png --stats ''", 2, USAGE + "--stats: .*empty"),
    # An output that is an input, by every name that it has.
    ("render cube.gltf --out cube.gltf", 2, USAGE),
    ("render cube.gltf --out a.png --stats cube.gltf", 2, USAGE + "cube.gltf: is an input"),
    ("render cube.gltf --out a.png --stats link.gltf", 2, USAGE + "link.gltf: is an input"),
    ("render link.gltf --out a.png --stats cube.gltf", 2, USAGE + "cube.gltf: is an input"),
    ("render hard.gltf --out a.png --stats cube.gltf", 2, USAGE + "cube.gltf: is an input"),
    ("render cube.gltf --out a.png --stats away/../cube.gltf", 2, USAGE + ".*: is an input"),
    ("render cube.gltf --out a.png --stats /dev/fd/9", 2, USAGE + "/dev/fd/9: is an input"),
    ("render cube.gltf --config c.json --out a.png --stats c.json", 2, USAGE + "c.json: is an in"),
    ("coverage two.tcov --out two.tcov", 2, USAGE + "two.tcov: is an input"),
    ("vectors two.tcov --out two.tcov --format csv", 2, USAGE + "two.tcov: is an input"),
    ("vectors --from v.csv --out v.csv", 2, USAGE + "v.csv: is an input"),
    ("fit cube.gltf --out cube.gltf", 2, USAGE + "cube.gltf: is an input"),
    ("cosim cube.gltf --stats cube.gltf", 2, USAGE + "cube.gltf: is an input"),
    # Standard input and output; here standard input is cube.gltf, and output is kept.
    ("render - --format gltf --size 64x48 --out a.png", DONE, ""),
    ("render - --size 64x48 --out a.png", 2, USAGE + "-: .*give --format obj|gltf"),
    ("render - --format obj --out a.png", 2, r"halfspace: error\[HS01.\]: -"),
    ("render - --format jpg --out a.png", 2, USAGE + "--format: 'jpg' is not obj, "),
    ("render cube.gltf --format obj --out a.png", 2, USAGE + "--format: is for standard input"),
    ("render - --format gltf --out cube.gltf", 2, USAGE),
    ("render - --format gltf --out a.png --stats cube.gltf", 2, USAGE + "cube.gltf: is an input"),
    ("render cube.gltf --size 64x48 --out -", DONE, ""),
    ("coverage two.tcov --out -", DONE, ""),
    ("coverage - --format gltf --out a.tcov", 2, USAGE + "--format: only TCOV"),
    ("coverage - --format tcov --out a.tcov", 2, r"halfspace: error\[HS020\]: -:1: not a TCOV"),
    ("coverage two.tcov --format tcov --out a.tcov", 2, USAGE + "--format: is for standard input"),
    ("explain - 1 1 --format gltf", DONE, ""),
    ("fit - --format gltf --size 64x48 --out -", DONE, "wrote -"),
    ("fit - --format gltf --emit-rtl rtl", 2, USAGE + "--emit-rtl: .*standard input"),
    ("vectors --generate all --count 3 --config tiny --out - --format csv", DONE, "rasterizer: 1"),
    ("vectors --generate all --out -", 2, r"halfspace: error\[HS090\]: --out: .*--format"),
    ("vectors - --out a.csv", 2, r"halfspace: error\[HS090\]: IN: "),
    # Options that change nothing beside others.
    ("render cube.gltf --size 64x48 --level cycle --threads 2 --out a.png", NOTE,
     "note: --threads has no effect: "),
    ("render cube.gltf --size 64x48 --shade coverage --threads 2 --out a.png", NOTE,
     "note: --threads has no effect: "),
    ("render cube.gltf --size 64x48 --level coverage --depth-test less --out a.png", NOTE,
     "note: --depth-test has no effect: "),
    ("render cube.gltf --size 64x48 --threads 2 --depth-test less --out a.png", DONE, ""),
    ("render cube.gltf --level coverage --shade flat --out a.png", 2, USAGE + "--shade: level cov"),
    ("render cube.gltf --level cycle --shade tiles --out a.png", 2, USAGE + "--shade: tiles are "),
    ("render two.tcov --size 64x48 --out a.png", NOTE, "note: --size has no effect: a TCOV"),
    ("render two.tcov --eye 1,2,3 --simplify 1 --out a.png", NOTE,
     "note: --eye has no .*\n.*note: --simplify has no effect"),
    ("explain two.tcov 1 1 --case 1 --fov 20", NOTE, "note: --fov has no effect: a TCOV"),
    ("explain cube.gltf 1 1 --all --json", NOTE, "note: --all has no effect: "),
    ("fit two.tcov --size 64x48 --orbit 3 --out a.json", NOTE,
     "note: --size has no .*\n.*note: --orbit has no effect"),
    ("stability --method walk_prstep", 2, r"halfspace: error\[HS08[25]\]: "),
    ("fit cube.gltf --source . --out a.json", 2, USAGE + "--source"),
    ("fit cube.gltf --target 2px/clk --out a.json", 2, USAGE + "--target: .* --throughput"),
    ("vectors --generate all --tries 5 --out a.csv", 2, USAGE + "--tries .*--goal"),
    ("vectors cube.gltf --max-tiles 5 --out a.csv", 2, USAGE + "--max-tiles .*--generate"),
    ("vectors --generate all --eye 1,2,3 --out a.csv", 2, USAGE + "--eye .*IN"),
    ("vectors --from v.csv --seed 3 --out a.csv", 2, USAGE + ".*--(seed|from)"),
    # Names that say another format.
    ("render cube.gltf --out a.jpg", 2, USAGE + "--out: 'a.jpg' does not end in .png"),
    ("render cube.gltf --out a.JPEG", 2, USAGE + "--out: 'a.JPEG' does not end in .png"),
    ("render cube.gltf --size 64x48 --out a.PNG", DONE, ""),
    ("render cube.gltf --method edge_functon --out a.png", 2,
     r"halfspace: error\[HS070\]: --method: no method 'edge_functon'"),
]
RTL_LINES = [
    ("cosim cube.gltf --size 64x48 --config tiny --seed 3", NOTE, "note: --seed has no effect: "),
    ("cosim two.tcov --size 64x48 --orbit 2", NOTE, "note: --size has .*\n.*note: --orbit has no"),
    ("cosim - --format gltf --size 64x48 --config tiny --stats -", DONE, "identical in bits"),
]
LAB_LINES = [
    ("stability --explain ''", 2, USAGE + "--explain: .*empty"),
    ("stability --picture a.png", 2, USAGE + "--picture"),
    ("stability --explain a/b --picture a.gif", 2, USAGE + "--picture: 'a.gif' does not end"),
    ("report cube.gltf --out cube.gltf", 2, r"halfspace: error\[HS030\]: cube.gltf"),
    ("chart subpixel --scene cube.gltf --out cube.gltf", 2, USAGE),
]


class Lines(Program):
    def setUp(self):
        super().setUp()
        for scene in ("cube.gltf", "teapot.obj"):
            shutil.copy(SCENES / scene, self.out)
        (self.out / "link.gltf").symlink_to("cube.gltf")
        os.link(self.out / "cube.gltf", self.out / "hard.gltf")
        (self.out / "elsewhere/deep").mkdir(parents=True)
        # The folder above a link's is not the one its name has: away/.. is elsewhere.
        (self.out / "away").symlink_to("elsewhere/deep")
        os.link(self.out / "cube.gltf", self.out / "elsewhere/cube.gltf")
        (self.out / "two.tcov").write_text("TCOV 1 2\ncase 1 t 8 8 1 0 0 0\n0 0 2048 0 0 2048\n"
                                           "case 2 t 8 8 1 0 0 0\n0 0 2048 0 0 2048\n")
        (self.out / "c.json").write_text('{"preset": "full"}')
        self.succeed("vectors", "--generate", "all", "--count", "3", "--config", "tiny", "--out",
                     "v.csv")

    def files(self):
        return {path.relative_to(self.out): path.read_bytes() for path in self.out.rglob("*")
                if path.is_file()}

    def check(self, lines):
        before = self.files()
        for line, status, says in lines:
            with self.subTest(line):
                with open(self.out / "cube.gltf", "rb") as scene:
                    os.dup2(scene.fileno(), 9)
                    done = self.run_program(*shlex.split(line), binary=True, stdin=scene,
                                            pass_fds=(9,))
                    done.stderr = done.stderr.decode()
                os.close(9)
                self.assertEqual(done.returncode, status, done.stderr)
                self.assertRegex(done.stderr, says) if says else self.assertEqual(done.stderr, "")
                after = self.files()
                if status == 2:
                    self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
                    self.assertEqual(after, before, "a file was made or changed")
                for path, content in before.items():
                    self.assertEqual(after[path], content, path)
                for path in after.keys() - before.keys():
                    (self.out / path).unlink()

    def test_lines(self):
        self.check(LINES)

    @unittest.skipUnless(HAS_RTL, "built without RTL")
    def test_lines_with_rtl(self):
        self.check(RTL_LINES)

    @unittest.skipUnless(HAS_LAB, "built without the lab")
    def test_lines_with_lab(self):
        self.check(LAB_LINES)

    def test_standard_output_holds_the_file_and_nothing_else(self):
        for words, name in ((("render", "cube.gltf", "--size", "64x48"), "a.png"),
                            (("coverage", "two.tcov"), "a.tcov"),
                            (("vectors", "--generate", "all", "--count", "3", "--config", "tiny",
                              "--format", "csv"), "a.csv"),
                            (("fit", "cube.gltf", "--size", "64x48"), "a.json")):
            self.succeed(*words, "--out", name)
            shown = self.run_program(*words, "--out", "-", binary=True)
            self.assertEqual(shown.returncode, 0, shown.stderr)
            self.assertEqual(shown.stdout, (self.out / name).read_bytes(), words)

    def test_standard_input_is_the_scene(self):
        for name, kind in (("cube.gltf", "gltf"), ("teapot.obj", "obj"), ("two.tcov", "tcov")):
            self.succeed("render", name, "--out", "file.png")
            with open(self.out / name, "rb") as scene:
                done = self.run_program("render", "-", "--format", kind, "--out", "in.png",
                                        stdin=scene)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual((self.out / "in.png").read_bytes(),
                             (self.out / "file.png").read_bytes(), name)

    def test_no_text_of_a_file_reaches_the_terminal_as_it_is(self):
        for name, text, words in (
                ("e.json", '{"a\\u001b[31mb\\nhalfspace: error[HS999]: forged":1}',
                 ("config", "--config", "e.json")),
                ("e.tcov", "TCOV 1 1\ncase 0 x 8 8 1 0 0 0\n1 2 3 \x1b]0;title\x07\x1b[31mred 5 6\n",
                 ("coverage", "e.tcov", "--out", "o.tcov")),
                ("e.csv", '# {"halfspace_vectors": 1, "stage": "\\u001b[31m\\u009b1m"}\n',
                 ("vectors", "--check", "e.csv")),
                ("e\x1b[31m.csv", "nothing\n", ("vectors", "--check", "e\x1b[31m.csv"))):
            (self.out / name).write_text(text)
            done = self.run_program(*words)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertRegex(done.stderr, r"\Ahalfspace: error\[HS\d+\]: [^\x00-\x1f\x7f-\x9f]+\n\Z")
            self.assertLess(len(done.stderr), 600)

    def test_there_are_as_many_lines_as_promised(self):
        self.assertGreaterEqual(len(LINES), 40)
        self.assertTrue(TESTS and PROGRAM)


if __name__ == "__main__":
    unittest.main()
