// SPDX-License-Identifier: Apache-2.0
//
// A strict reader of OBJ text. The mesh library's own is lenient: it drops a vertex with five
// numbers, reads any keyword that starts with f as a face and takes garbage for zero. Here a line
// is either understood or reported by its number.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace halfspace {

// An OBJ file that every reader understands alike.
struct PlainObj {
  // `v x y z` or `v x y z r g b` for each vertex, `vn`, then `f`, `usemtl` and `mtllib` in the
  // file's order. Indices are positive; texture coordinates, groups, lines and points are left out.
  std::string text;
  std::size_t faces = 0;
};

// Checks `text`, the contents of `path`, and rewrites it.
//
// Lines may be continued with a backslash and end in LF, CR LF or CR. Unknown keywords are ignored.
// A vertex has 3 numbers, optionally a weight (ignored) or a colour r g b [a].
// Throws Error, with the place path:line: kMeshBroken (not a number, too few of them, a NUL byte, a
// last line cut short), kMeshNotFinite (NaN, infinity, beyond a float), kMeshIndex (index 0 or no
// such vertex). A file without a final line end counts as truncated when its last line is not
// understood or some vertex is used by no face.
PlainObj check_obj(const std::string& path, std::string_view text);

}  // namespace halfspace
