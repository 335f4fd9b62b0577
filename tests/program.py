# SPDX-License-Identifier: Apache-2.0
"""What the tests of the program share: running it, how it must refuse, and reading its pictures."""
import os
import pathlib
import struct
import subprocess
import tempfile
import unittest
import zlib

PROGRAM = os.environ["HALFSPACE"]
TESTS = pathlib.Path(os.environ["HALFSPACE_TESTS"])
SCENES = TESTS / "scenes"
PUBLIC = TESTS / "data" / "public.tcov"
HAS_LAB = os.environ.get("HALFSPACE_HAS_LAB") == "ON"
HAS_RTL = os.environ.get("HALFSPACE_HAS_RTL") == "ON"


def png_pixels(path):
    """Rows of an 8-bit RGB PNG."""
    data = path.read_bytes()
    at, packed = 8, b""
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, depth, color = struct.unpack(">IIBB", body[:10])
            assert (depth, color) == (8, 2)
        if kind == b"IDAT":
            packed += body
        at += size + 12
    raw, stride = zlib.decompress(packed), 3 * width
    rows, above = [], bytearray(stride)
    for y in range(height):
        kind, line = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:][:stride])
        for i in range(stride):
            left = line[i - 3] if i >= 3 else 0
            corner = above[i - 3] if i >= 3 else 0
            distance = {c: abs(left + above[i] - corner - c) for c in (left, above[i], corner)}
            paeth = min((left, above[i], corner), key=lambda c: distance[c])
            line[i] = (line[i] + (0, left, above[i], (left + above[i]) // 2, paeth)[kind]) & 255
        rows.append(line)
        above = line
    return rows


class Program(unittest.TestCase):
    """PREFIX: what comes before the arguments of every command."""
    PREFIX = ()

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.out = pathlib.Path(self.folder.name)

    def tearDown(self):
        self.folder.cleanup()

    def run_program(self, *args, environment=None, binary=False, **more):
        """more: as subprocess.run() takes it."""
        return subprocess.run([PROGRAM, *map(str, (*self.PREFIX, *args))], capture_output=True,
                              text=not binary, timeout=300, env=environment, cwd=self.out, **more)

    def succeed(self, *args):
        done = self.run_program(*args)
        self.assertEqual(done.returncode, 0, f"{args}: {done.stdout}{done.stderr}")
        return done

    def refuse(self, code, *args, says="", environment=None):
        """One line with the code and the text (or texts), exit status 2, no file left behind."""
        before = set(self.out.iterdir())
        done = self.run_program(*args, environment=environment)
        self.assertEqual(done.returncode, 2, f"{args}: {done.stderr}")
        self.assertRegex(done.stderr, rf"\Ahalfspace: error\[{code}\]: [^\n]+\n\Z", str(args))
        for text in ([says] if isinstance(says, str) else says):
            self.assertIn(text, done.stderr)
        self.assertEqual(set(self.out.iterdir()), before, "a file was left behind")
