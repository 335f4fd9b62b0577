// SPDX-License-Identifier: Apache-2.0
//
// Which samples a triangle owns, decided by someone else's arithmetic: CGAL's exact orientation
// predicate on doubles. Shares no code, no type and no shortcut with cmodel/, and decides ties
// differently: not by a bias on edges, but by asking which triangle holds the sample moved right by
// an infinitesimal and down by an infinitesimal square. Contract: docs/03_design/exactness.md.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace halfspace::oracle {

// A position in pixels: x right, y down, origin at the frame's top-left corner. Any finite double
// for a vertex; a multiple of 2^-20 below 2^20 for a sample, so that a step of one pixel is exact.
struct Vec {
  double x = 0;
  double y = 0;
  bool operator==(const Vec&) const = default;
};

using Corners = std::array<Vec, 3>;

// Standard sample positions within a pixel for 1, 2, 4, 8 or 16 samples, typed from the Vulkan
// specification's table of standard sample locations. Empty for any other number.
std::span<const Vec> standard_samples(int samples);

// +1, 0 or -1: c lies clockwise (as seen, y down) of the way from a to b, on its line, or
// counter-clockwise. Exact.
int turn(Vec a, Vec b, Vec c);

// The same for p moved by (eps, eps^2), eps > 0 infinitesimal: 0 only when a equals b.
int side(Vec a, Vec b, Vec p);

// The cross product whose sign turn() is, px^2: exact, then rounded to a double of that sign.
double cross(Vec a, Vec b, Vec p);

// p lies on the line of a and b, strictly between them. Exact.
bool strictly_between(Vec a, Vec b, Vec p);

// Does the triangle own the sample? Either winding; a triangle without area owns nothing.
bool covered(const Corners& triangle, Vec sample);

// Bit m is set when the triangle owns sample m of pixel (x, y); at most 16 samples.
std::uint32_t pixel_mask(const Corners& triangle, int x, int y, std::span<const Vec> samples);

// How many triangles own a sample of each pixel, row by row from the top, saturating at 255. Tests
// every pixel of the vertices' bounding box and two pixels around it.
std::vector<std::uint8_t> hit_count(std::span<const Corners> triangles, int width, int height,
                                    std::span<const Vec> samples);

}  // namespace halfspace::oracle
