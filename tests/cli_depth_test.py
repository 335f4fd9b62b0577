#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The depth test and the scissor as `render` has them: the same picture at levels bit and cycle."""
import sys
import unittest

sys.dont_write_bytecode = True
from program import SCENES, Program, png_pixels


class Depth(Program):
    def test_depth_functions_and_scissor_at_every_level(self):
        def draw(*args):
            self.succeed("render", SCENES / "bunny.obj", "--size", "64x48", "--out",
                         self.out / "p.png", *args)
            return png_pixels(self.out / "p.png")
        seen = []
        for args in ((), ("--depth-test", "greater", "--depth-clear", "0"),
                     ("--depth-test", "never"), ("--depth-test", "always"),
                     ("--scissor", "20,9,31x25")):
            seen.append(draw(*args))
            self.assertEqual(seen[-1], draw(*args, "--level", "cycle"), args)
        self.assertTrue(all(seen[i] != seen[j] for i in range(5) for j in range(i)))
        for y, row in enumerate(seen[0]):  # outside the rectangle the background stays
            kept = range(60, 153) if 9 <= y < 34 else ()
            self.assertEqual(list(seen[4][y]), [row[i] if i in kept else seen[2][y][i]
                                                for i in range(len(row))], y)


if __name__ == "__main__":
    unittest.main()
