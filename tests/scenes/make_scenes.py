#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""make_scenes.py [DIRECTORY]: writes the meshes of this directory that are our own making.

Standard library only; the same bytes on every machine: coordinates are rounded to 1e-6 before they
are written. README.md says what each file is for.
"""
import base64
import json
import math
import pathlib
import struct
import sys


def rounded(values):
    return tuple(round(v, 6) + 0.0 for v in values)


def hue(t):
    """Red, green, blue 0..1 of a hue 0..1, pastel."""
    return tuple(0.6 + 0.4 * math.cos(2 * math.pi * (t - k / 3)) for k in range(3))


def bytes_of(colour):
    return tuple(round(255 * c) for c in colour)


# --- Shapes: a list of points and a list of faces ----------------------------------------------

def torus(around=32, across=16, big=1.0, small=0.4):
    points, faces = [], []
    for i in range(around):
        for j in range(across):
            a, b = 2 * math.pi * i / around, 2 * math.pi * j / across
            r = big + small * math.cos(b)
            points.append(rounded((r * math.cos(a), small * math.sin(b), -r * math.sin(a))))
            i1, j1 = (i + 1) % around, (j + 1) % across
            faces.append((i * across + j, i1 * across + j, i1 * across + j1, i * across + j1))
    return points, faces


def icosphere(rounds):
    g = (1 + math.sqrt(5)) / 2
    points = [(s * a, t * b, 0.0) for a, b in ((1, g),) for s in (-1, 1) for t in (-1, 1)]
    points = points + [(0.0, x, y) for x, y, _ in points] + [(y, 0.0, x) for x, y, _ in points]
    unit = lambda p: tuple(v / math.dist(p, (0, 0, 0)) for v in p)
    points = [unit(p) for p in points]
    edge = min(math.dist(points[0], p) for p in points[1:]) * 1.01
    near = lambda a, b: math.dist(points[a], points[b]) < edge
    faces = []
    for a in range(12):
        for b in range(a + 1, 12):
            for c in range(b + 1, 12):
                if near(a, b) and near(b, c) and near(c, a):
                    faces.append(outward(points, (a, b, c)))
    for _ in range(rounds):
        middle, split = {}, []

        def between(a, b):
            key = (min(a, b), max(a, b))
            if key not in middle:
                middle[key] = len(points)
                points.append(unit(tuple((x + y) / 2 for x, y in zip(points[a], points[b]))))
            return middle[key]

        for a, b, c in faces:
            ab, bc, ca = between(a, b), between(b, c), between(c, a)
            split += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        faces = split
    return [rounded(p) for p in points], faces


def outward(points, face):
    """The face, wound counter-clockwise as seen from outside a shape around the origin."""
    a, b, c = (points[i] for i in face)
    return face if dot(cross(minus(b, a), minus(c, a)), a) > 0 else (face[0], face[2], face[1])


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def knot(along=80, across=8, radius=0.3):
    """A tube around a trefoil knot."""
    points, faces = [], []
    for i in range(along):
        t = 2 * math.pi * i / along
        centre = (math.sin(t) + 2 * math.sin(2 * t), math.cos(t) - 2 * math.cos(2 * t),
                  -math.sin(3 * t))
        forward = (math.cos(t) + 4 * math.cos(2 * t), -math.sin(t) + 4 * math.sin(2 * t),
                   -3 * math.cos(3 * t))
        side = cross(forward, (0.0, 0.0, 1.0))
        side = tuple(v / math.sqrt(dot(side, side)) for v in side)
        up = cross(side, forward)
        up = tuple(v / math.sqrt(dot(up, up)) for v in up)
        for j in range(across):
            c, s = math.cos(2 * math.pi * j / across), math.sin(2 * math.pi * j / across)
            points.append(rounded(centre[k] + radius * (c * side[k] + s * up[k])
                                  for k in range(3)))
            i1, j1 = (i + 1) % along, (j + 1) % across
            a, b, d, e = (i * across + j, i1 * across + j, i1 * across + j1, i * across + j1)
            faces += [(a, b, e), (b, d, e)]
    return points, faces


# --- Writers -----------------------------------------------------------------------------------

PLY_HEADER = """ply
format {format} 1.0
comment Halfspace test scene, Apache-2.0
element vertex {vertices}
property float x
property float y
property float z
property uchar red
property uchar green
property uchar blue
element face {faces}
property list uchar int vertex_indices
end_header
"""


def ply_ascii(points, colours, faces):
    text = PLY_HEADER.format(format="ascii", vertices=len(points), faces=len(faces))
    for p, c in zip(points, colours):
        text += " ".join(f"{v:g}" for v in p) + " %d %d %d\n" % c
    for face in faces:
        text += " ".join(str(i) for i in (len(face), *face)) + "\n"
    return text.encode()


def ply_binary(points, colours, faces, big_endian=False):
    order = ">" if big_endian else "<"
    name = "binary_big_endian" if big_endian else "binary_little_endian"
    data = PLY_HEADER.format(format=name, vertices=len(points), faces=len(faces)).encode()
    for p, c in zip(points, colours):
        data += struct.pack(order + "fffBBB", *p, *c)
    for face in faces:
        data += struct.pack(order + "B3i", 3, *face)
    return data


def stl_binary(points, faces):
    data = b"Halfspace test scene, Apache-2.0".ljust(80, b"\0") + struct.pack("<I", len(faces))
    for face in faces:
        data += struct.pack("<12fH", 0, 0, 0, *(v for i in face for v in points[i]), 0)
    return data


def stl_ascii(points, faces):
    lines = ["solid tetrahedron"]
    for face in faces:
        lines += ["  facet normal 0 0 0", "    outer loop"]
        lines += ["      vertex %g %g %g" % points[i] for i in face]
        lines += ["    endloop", "  endfacet"]
    return ("\n".join(lines) + "\nendsolid tetrahedron\n").encode()


class Gltf:
    """A glTF document with one buffer; add() places an array in it and returns its accessor."""

    def __init__(self):
        self.data = b""
        self.root = {"asset": {"version": "2.0", "generator": "Halfspace make_scenes.py"},
                     "scene": 0, "accessors": [], "bufferViews": []}

    def add(self, rows, code, component, kind):
        packed = b"".join(struct.pack("<" + code * len(row), *row) for row in rows)
        self.root["bufferViews"].append({"buffer": 0, "byteOffset": len(self.data),
                                         "byteLength": len(packed)})
        accessor = {"bufferView": len(self.root["bufferViews"]) - 1, "componentType": component,
                    "count": len(rows), "type": kind}
        if kind == "VEC3" and code == "f":
            accessor["min"] = [min(c) for c in zip(*rows)]
            accessor["max"] = [max(c) for c in zip(*rows)]
        self.data += packed + b"\0" * (-len(packed) % 4)
        self.root["accessors"].append(accessor)
        return len(self.root["accessors"]) - 1

    def text(self):
        uri = "data:application/octet-stream;base64," + base64.b64encode(self.data).decode()
        self.root["buffers"] = [{"byteLength": len(self.data), "uri": uri}]
        return (json.dumps(self.root, indent=1) + "\n").encode()

    def binary(self):
        self.root["buffers"] = [{"byteLength": len(self.data)}]
        text = json.dumps(self.root, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        chunks = struct.pack("<I4s", len(text), b"JSON") + text
        chunks += struct.pack("<I4s", len(self.data), b"BIN\0") + self.data
        return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def cube_gltf():
    corners, colours, triangles = [], [], []
    for axis in range(3):
        for side in (-1, 1):
            first = len(corners)
            for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                p = [0, 0, 0]
                p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3] = side, u * side, v
                corners.append(tuple(map(float, p)))
                colours.append(tuple((c + 1) / 2 for c in p))
            triangles += [(first, first + 1, first + 2), (first, first + 2, first + 3)]
    gltf = Gltf()
    primitive = {"attributes": {"POSITION": gltf.add(corners, "f", 5126, "VEC3"),
                                "COLOR_0": gltf.add(colours, "f", 5126, "VEC3")},
                 "indices": gltf.add([(i,) for t in triangles for i in t], "H", 5123, "SCALAR")}
    s = round(math.sqrt(0.5), 6)
    gltf.root.update(
        meshes=[{"name": "cube", "primitives": [primitive]}],
        nodes=[{"name": "raised", "translation": [0, 2, 0], "children": [1]},
               {"name": "quarter turn", "rotation": [0, s, 0, s], "scale": [1, 1, 3], "mesh": 0}],
        scenes=[{"nodes": [0]}])
    return gltf.text()


def gems_glb():
    points = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    points = [tuple(map(float, p)) for p in points]
    faces = [outward(points, (x, y, z)) for x in (0, 1) for y in (2, 3) for z in (4, 5)]
    gltf = Gltf()
    position = gltf.add(points, "f", 5126, "VEC3")
    indices = gltf.add([(i,) for f in faces for i in f], "B", 5121, "SCALAR")
    material = lambda colour: {"pbrMetallicRoughness": {"baseColorFactor": [*colour, 1.0]}}
    mesh = lambda m: {"primitives": [{"attributes": {"POSITION": position}, "indices": indices,
                                      "material": m}]}
    gltf.root.update(
        materials=[material((0.9, 0.2, 0.2)), material((0.2, 0.5, 0.9))],
        meshes=[mesh(0), mesh(1)],
        nodes=[{"mesh": 0, "translation": [-2, 0, 0]}, {"mesh": 1, "scale": [0.5, 1.5, 0.5]},
               {"mesh": 0, "translation": [2, 0, 0], "scale": [0.8, 0.8, 0.8]}],
        scenes=[{"nodes": [0, 1, 2]}])
    return gltf.binary()


def files():
    """Name and contents of every file."""
    points, faces = torus()
    yield "torus.ply", ply_ascii(points, [bytes_of(hue(i // 16 / 32)) for i in range(len(points))],
                                 faces)
    points, faces = icosphere(3)
    colours = [bytes_of(tuple((v + 1) / 2 for v in p)) for p in points]
    yield "icosphere.ply", ply_binary(points, colours, faces)
    points, faces = icosphere(1)
    colours = [bytes_of(tuple((v + 1) / 2 for v in p)) for p in points]
    yield "icosphere_big_endian.ply", ply_binary(points, colours, faces, big_endian=True)
    yield "knot.stl", stl_binary(*knot())
    points = [(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)]
    faces = [outward(points, f) for f in ((0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3))]
    yield "tetrahedron.stl", stl_ascii(points, faces)
    yield "cube.gltf", cube_gltf()
    yield "gems.glb", gems_glb()


if __name__ == "__main__":
    directory = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent)
    for name, data in files():
        (directory / name).write_bytes(data)
        print(f"{name}: {len(data)} bytes")
