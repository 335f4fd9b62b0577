// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "generators.hpp"

namespace halfspace {

// Triangles that belong together, in one frame: one, or two with a common edge.
struct VectorUnit {
  FrameState frame;
  std::vector<Triangle> triangles;
};

// A unit built to hit something: ties in every direction, masks of one lane, row or column, corners
// of the legal square, phases, degenerate triangles; or a random_triangle(). Every triangle is
// legal and visits at most kUnitLeaves leaf tiles. Which kind it is depends on the draw alone.
VectorUnit directed_unit(Random& random, const Config& config);

inline constexpr int kUnitLeaves = 80;

}  // namespace halfspace
