#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""make_broken.py [DIRECTORY]: writes mesh files that must be refused, each with one thing wrong.

expected.txt, written beside them, has the error code of each; README.md the list. Standard library
only; the same bytes on every machine.
"""
import json
import pathlib
import struct
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "scenes"))
sys.dont_write_bytecode = True
import make_scenes  # noqa: E402

BROKEN, EMPTY, NOT_FINITE, INDEX = 11, 12, 13, 14

TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
PLY = make_scenes.PLY_HEADER.format(format="ascii", vertices=3, faces=1)
PLY_POINTS = "0 0 0 9 9 9\n1 0 0 9 9 9\n0 1 0 9 9 9\n"


def gltf(change):
    """The cube, changed."""
    root = json.loads(make_scenes.cube_gltf())
    change(root)
    return json.dumps(root)


def glb(change):
    """The gems, their bytes changed."""
    data = bytearray(make_scenes.gems_glb())
    change(data)
    return bytes(data)


def update(*path, value):
    def change(root):
        for key in path[:-1]:
            root = root[key]
        root[path[-1]] = value
    return change


def nan_position(data):
    start = data.index(b"BIN\0") + 4
    data[start:start + 4] = struct.pack("<f", float("nan"))


def bad_gem_index(data):
    data[-24] = 77  # the first of 24 one-byte indices


def files():
    """Name, error code, contents."""
    # OBJ
    yield "nan.obj", NOT_FINITE, "v 0 0 0\nv 1 nan 0\nv 0 1 0\nf 1 2 3\n"
    yield "inf.obj", NOT_FINITE, "v 0 0 0\nv 1 0 -inf\nv 0 1 0\nf 1 2 3\n"
    yield "overflow.obj", NOT_FINITE, "v 0 0 0\nv 1e39 0 0\nv 0 1 0\nf 1 2 3\n"
    yield "index_zero.obj", INDEX, TRIANGLE + "f 0 1 2\n"
    yield "index_beyond.obj", INDEX, TRIANGLE + "f 1 2 4\n"
    yield "index_negative_beyond.obj", INDEX, TRIANGLE + "f -1 -2 -4\n"
    yield "index_huge.obj", INDEX, TRIANGLE + "f 1 2 9000000000000000000\n"
    yield "face_garbage.obj", BROKEN, TRIANGLE + "f 1 2 three\n"
    yield "corner_slashes.obj", BROKEN, TRIANGLE + "f 1/1/1/1 2 3\n"
    yield "vertex_of_two.obj", BROKEN, "v 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
    yield "number_garbage.obj", BROKEN, "v 0 0 0\nv 1 0x 0\nv 0 1 0\nf 1 2 3\n"
    yield "truncated_face.obj", BROKEN, TRIANGLE + "v 1 1 0\nf 1 2 3\nf 2 4"
    yield "truncated_number.obj", BROKEN, TRIANGLE + "f 1 2 3\nv 1 1 -"
    yield "truncated_vertices.obj", BROKEN, "v 0 0 0\nv 1 0 0\nv 0 1.2"
    yield "empty.obj", EMPTY, ""
    yield "comments.obj", EMPTY, "# a mesh\n# without anything\n"
    yield "vertices_only.obj", EMPTY, TRIANGLE
    yield "lines_only.obj", EMPTY, TRIANGLE + "l 1 2 3\n"
    yield "binary.obj", BROKEN, bytes(range(256)) * 4
    # PLY
    yield "empty.ply", BROKEN, ""
    yield "truncated_header.ply", BROKEN, PLY[:120]
    yield "truncated_ascii.ply", BROKEN, PLY + PLY_POINTS[:20]
    yield "truncated_face.ply", BROKEN, PLY + PLY_POINTS + "3 0 1"
    yield "truncated_binary.ply", BROKEN, make_scenes.ply_binary(
        *[[(0.0, 0.0, 0.0)] * 3, [(1, 2, 3)] * 3, [(0, 1, 2)]])[:-3]
    yield "too_many_vertices.ply", EMPTY, PLY + "1 1 1 9 9 9\n" + PLY_POINTS + "3 0 1 2\n"
    yield "too_few_vertices.ply", BROKEN, PLY.replace("vertex 3", "vertex 4") + PLY_POINTS + \
        "3 0 1 2\n"
    yield "huge_count.ply", BROKEN, PLY.replace("vertex 3", "vertex 4000000000") + PLY_POINTS + \
        "3 0 1 2\n"
    yield "index_beyond.ply", INDEX, PLY + PLY_POINTS + "3 0 1 3\n"
    yield "index_negative.ply", INDEX, PLY + PLY_POINTS + "3 0 1 -1\n"
    yield "nan.ply", NOT_FINITE, PLY + PLY_POINTS.replace("1 0 0", "1 nan 0") + "3 0 1 2\n"
    yield "nan_binary.ply", NOT_FINITE, make_scenes.ply_binary(
        [(0.0, 0.0, 0.0), (float("inf"), 0.0, 0.0), (0.0, 1.0, 0.0)], [(1, 2, 3)] * 3,
        [(0, 1, 2)])
    yield "index_beyond_binary.ply", INDEX, make_scenes.ply_binary(
        [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)], [(1, 2, 3)] * 3, [(0, 1, 3)],
        big_endian=True)
    yield "no_faces.ply", EMPTY, PLY.replace("face 1", "face 0") + PLY_POINTS
    # STL
    stl = make_scenes.stl_binary([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)] * 3)
    yield "empty.stl", BROKEN, ""
    yield "truncated_binary.stl", BROKEN, stl[:-20]
    yield "wrong_count.stl", BROKEN, stl[:80] + struct.pack("<I", 4) + stl[84:]
    yield "huge_count.stl", BROKEN, stl[:80] + struct.pack("<I", 0xffffffff) + stl[84:]
    yield "nan_binary.stl", NOT_FINITE, stl[:96] + struct.pack("<f", float("nan")) + stl[100:]
    yield "no_triangles.stl", EMPTY, stl[:80] + struct.pack("<I", 0)
    text = make_scenes.stl_ascii([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)]).decode()
    yield "truncated_ascii.stl", BROKEN, text[:100]
    yield "garbage_ascii.stl", BROKEN, text.replace("vertex 1 0 0", "vertex 1 zero 0")
    yield "facet_of_two.stl", BROKEN, text.replace("      vertex 1 0 0\n", "")
    yield "inf_ascii.stl", NOT_FINITE, text.replace("vertex 1 0 0", "vertex 1 inf 0")
    # glTF and GLB
    yield "empty.gltf", BROKEN, ""
    yield "truncated.gltf", BROKEN, make_scenes.cube_gltf()[:700]
    yield "not_an_object.gltf", BROKEN, "[1, 2, 3]\n"
    yield "wrong_type.gltf", BROKEN, gltf(update("accessors", 0, "count", value="many"))
    yield "accessor_beyond.gltf", BROKEN, gltf(update("accessors", 0, "count", value=25))
    yield "view_beyond.gltf", BROKEN, gltf(update("bufferViews", 2, "byteLength", value=73))
    yield "buffer_short.gltf", BROKEN, gltf(update("buffers", 0, "byteLength", value=1000))
    yield "buffer_missing.gltf", BROKEN, gltf(update("buffers", 0, "uri", value="missing.bin"))
    yield "counts_differ.gltf", BROKEN, gltf(update("accessors", 1, "count", value=23))
    yield "node_cycle.gltf", BROKEN, gltf(update("nodes", 1, "children", value=[0]))
    yield "node_beyond.gltf", INDEX, gltf(update("nodes", 0, "children", value=[2]))
    yield "mesh_beyond.gltf", INDEX, gltf(update("nodes", 1, "mesh", value=1))
    yield "deep.gltf", BROKEN, '{"a":' + "[" * 5000 + "]" * 5000 + "}"
    yield "no_meshes.gltf", EMPTY, '{"asset": {"version": "2.0"}}\n'
    yield "huge_scale.gltf", NOT_FINITE, gltf(update("nodes", 0, "scale", value=[2e38, 2e38, 2e38]))
    yield "truncated.glb", BROKEN, make_scenes.gems_glb()[:-30]
    yield "not_a_glb.glb", BROKEN, b"PK\3\4" + bytes(100)
    yield "nan.glb", NOT_FINITE, glb(nan_position)
    yield "index_beyond.glb", INDEX, glb(bad_gem_index)
    # The name
    yield "unknown.xyz", BROKEN, TRIANGLE


def as_bytes(contents):
    return contents if isinstance(contents, bytes) else contents.encode()


if __name__ == "__main__":
    directory = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent)
    lines = []
    for name, code, contents in files():
        (directory / name).write_bytes(as_bytes(contents))
        lines.append(f"{code} {name}\n")
    (directory / "expected.txt").write_text("".join(lines))
    print(f"{len(lines)} files")
