# SPDX-License-Identifier: Apache-2.0
"""consumer.py SCENE WIDTH HEIGHT: the CRC-32 of the scene's coverage, from the installed module."""
import sys
import zlib

import halfspace

path, width, height = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
model = halfspace.Model("full")
model.begin_frame(width, height, tiles=False, picture=False)
model.draw_scene(path)
crc = model.stats()["coverage_crc32"]
if zlib.crc32(model.hits().tobytes()) != crc:
    raise SystemExit("the hit counts are not those of the CRC")
print(crc)
