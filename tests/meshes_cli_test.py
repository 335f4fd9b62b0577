#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Mesh files as a user draws them: every file of tests/meshes at two levels, what is said of what is
left out or not in view, and pictures that must be alike."""
import json
import subprocess
import sys
import unittest

sys.dont_write_bytecode = True
from program import PROGRAM, SCENES, TESTS, Program, png_pixels  # noqa: E402

MESHES = TESTS / "meshes"
EXPECTED = [line.split() for line in (MESHES / "expected.txt").read_text().splitlines()]


class Meshes(Program):
    def draw(self, mesh, *options, name="m"):
        """The statistics, what stderr had, and the picture."""
        png, stats = self.out / f"{name}.png", self.out / f"{name}.json"
        done = self.run_program("render", mesh, "--size", "96x72", "--out", png, "--stats", stats,
                                *options)
        self.assertEqual(done.returncode, 0, f"{mesh}: {done.stderr}")
        return json.loads(stats.read_text()), done.stderr, png_pixels(png)

    def test_every_file_at_two_levels(self):
        for name, triangles, _, *rest in EXPECTED:
            if triangles == "refused":
                done = self.run_program("render", MESHES / name, "--out", "a.png")
                self.assertEqual(done.returncode, 2, name)
                self.assertRegex(done.stderr, rf"^halfspace: error\[HS0{_}\]: [^\n]*{name}[^\n]*\n$")
                self.assertFalse((self.out / "a.png").exists(), name)
                continue
            told, said, _ = self.draw(MESHES / name)
            masks, _, _ = self.draw(MESHES / name, "--level", "coverage", name="c")
            self.assertEqual(told["triangles"], int(triangles), name)
            self.assertEqual(told["coverage_crc32"], masks["coverage_crc32"], name)
            self.assertGreater(told["samples_covered"], 100, name)
            left_out = {key: int(count) for key, count in (kind.split("=") for kind in rest[1:])} \
                if rest else {}
            self.assertEqual(told["left_out"], left_out, name)
            note = rf"^halfspace: note: [^\n]*{name}: left out: [^\n]*\n$" if left_out else "^$"
            self.assertRegex(said, note)

    def test_the_same_cube_looks_the_same(self):
        pictures = [self.draw(MESHES / name)[2] for name in
                    ("o06_face2.obj", "p15_oneline.ply", "s01_upper.stl", "s04_solid_bin.stl",
                     "g21_no_normals_shared.glb", "g07_quantized_short.glb")]
        for picture in pictures[1:]:
            worst = max(abs(a - b) for one, other in zip(pictures[0], picture)
                        for a, b in zip(one, other))
            self.assertLessEqual(worst, 1)

    def test_mirrored_nodes_show_their_outside(self):
        """A triangle that faces the eye and its copy: turned away only where z is mirrored too."""
        for name, culled in (("mir_plain", 0), ("mir_x", 0), ("mir_xy", 0), ("mir_xyz", 1)):
            told, _, _ = self.draw(MESHES / f"{name}.gltf", "--eye", "0,0,9", "--cull", "back")
            self.assertEqual(told["triangles_face_culled"], culled, name)
        cubes = MESHES / "g04_negative_scale.glb"
        told, _, front = self.draw(cubes, "--cull", "back")
        self.assertEqual(told["triangles_face_culled"], 12)
        self.assertEqual(front, self.draw(cubes)[2])

    def test_what_is_not_in_view_is_said(self):
        cube = SCENES / "cube.gltf"
        for options, words in (
                (("--eye", "0,0,50", "--target", "0,0,99"), "all 12 triangles are behind the eye"),
                (("--eye", "0,0,50", "--target", "50,0,50"), "12 triangles"),
                (("--eye", "0,9,50", "--target", "0,90,0", "--ortho", "1"), "outside the frame")):
            told, said, _ = self.draw(cube, *options)
            self.assertEqual(told["samples_covered"], 0)
            self.assertIn("halfspace: note: nothing is drawn: ", said)
            self.assertIn(words, said)
        (self.out / "flat.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 3 2\n")
        _, said, _ = self.draw(self.out / "flat.obj", "--cull", "back", "--eye", "0,0,5")
        self.assertIn("all 1 triangles are culled", said)
        _, said, _ = self.draw(cube)
        self.assertEqual(said, "")

    def test_a_map_is_as_smooth_as_a_model(self):
        """The same hills in metres of a map's grid and around the origin."""
        lines = (MESHES / "o14_utm.obj").read_text().splitlines()
        local = []
        for line in lines:
            words = line.split()
            if words and words[0] == "v":
                east, north, up = map(float, words[1:4])
                line = f"v {east - 456793:.4f} {north - 4567894:.4f} {up - 123:.4f}"
            local.append(line)
        (self.out / "local.obj").write_text("\n".join(local) + "\n")
        far, near = self.draw(MESHES / "o14_utm.obj")[2], self.draw(self.out / "local.obj")[2]
        differ = sum(abs(a - b) > 3 for one, other in zip(far, near) for a, b in zip(one, other))
        self.assertLess(differ, 60)

    def test_a_camera_is_in_the_files_coordinates(self):
        told, said, _ = self.draw(MESHES / "o14_utm.obj", "--eye", "456793,4567894,200",
                                  "--target", "456793,4567894.001,123")
        self.assertGreater(told["samples_covered"], 0, said)

    def test_names_reach_no_terminal(self):
        mesh = self.out / "a\x1b[31mb.obj"
        mesh.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\nf 1 2 3\n")
        _, said, _ = self.draw(mesh)
        self.assertIn("a\\x1b[31mb.obj", said)
        self.assertNotIn("\x1b", said)
        mesh.write_text("f \x1b]0;title\x07\n")
        done = subprocess.run([PROGRAM, "render", mesh, "--out", self.out / "x.png"],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)
        self.assertNotRegex(done.stderr, "[\x00-\x09\x0b-\x1f\x7f]")


if __name__ == "__main__":
    unittest.main(verbosity=2)
