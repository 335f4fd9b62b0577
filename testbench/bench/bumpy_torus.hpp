// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "meshes/mesh.hpp"

namespace halfspace {

inline constexpr double kMillion = 1'000'000;

// A closed mesh of at least `triangles` triangles (up to 2^30): a torus with bumps, coloured around
// its ring, with the surface's own normals. The same on every machine, to the last bits of its
// sines.
Mesh bumpy_torus(double triangles);

// The same as a binary PLY file with vertex colours, written as it is made. Throws
// Error(kFileWrite).
void write_bumpy_torus(const std::string& path, double triangles);

}  // namespace halfspace
