// SPDX-License-Identifier: Apache-2.0
//
// Inputs on which methods fail, each with its reason: the meshes and shapes of
// docs/05_methods/README.md. Real-valued vertices in px; the same on every machine for one seed.
#pragma once

#include <cstdint>
#include <vector>

#include "oracle/oracle.hpp"

namespace halfspace::oracle {

// The square (0, 0) - (size, size) px cut into cells, every inner vertex moved by up to `amplitude`
// cells and each cell split along a random diagonal; then vertices are moved to the nearest
// multiple of 1/grid px plus `phase` px (halves to even), and all by `offset` px.
struct MeshSpec {
  std::uint64_t seed = 1;
  int size = 1024;
  int cell = 16;
  double amplitude = 0.45;  // above 0.25 cells may fold: a sample may then have no or two owners
  double grid = 256;
  double phase = 0;
  double offset = 0;
  bool square = true;  // vertices of the border stay on it
};
std::vector<Corners> jittered_mesh(const MeshSpec& spec);

// The three of the tables. 1024 x 1024 px from `offset` on.
std::vector<Corners> mesh16(double offset = 0);  // cells of 16 px, vertices on 1/256 px
std::vector<Corners> mesh4(double offset = 0);   // cells of 4 px
// mesh16 with every vertex, the border's too, on a pixel centre: samples on edges.
std::vector<Corners> mesh_h();

// A disc of slivers around the centre of pixel (512, 512), vertices on 1/256 px: edges through
// samples, boxes far larger than the triangles.
std::vector<Corners> needle_fan(int slivers = 2000, double radius = 500);

// Random triangles whose vertices lie within a box of `size` px somewhere in a frame of
// `frame` px; full doubles, not on any grid.
std::vector<Corners> random_triangles(std::uint64_t seed, int count, double size, double frame);

// The square (1.5, 1.5) - (9.5, 9.5) as two triangles: samples on all of its edges.
std::vector<Corners> quad_on_samples();
// A sliver between two rows' centres; 29 px of one row.
Corners thin_sliver();
// Three points on the diagonal, none of them between pixels.
Corners collinear();
// A square on its tip, vertices level with rows.
std::vector<Vec> diamond();

}  // namespace halfspace::oracle
