// SPDX-License-Identifier: Apache-2.0
//
// Seeded stimulus: the same triangles on every machine for the same seed. All results are legal
// input to triangle_setup() for the configuration given.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "config.hpp"
#include "packets.hpp"
#include "splitmix.hpp"

namespace halfspace {

// splitmix64: one word of state, the same sequence on every platform (the standard library's
// distributions are not).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() { return splitmix_next(state_); }
  // A value of low..high, both included; low <= high, high - low < 2^32. Uniform to within 2^-32.
  std::int64_t in(std::int64_t low, std::int64_t high);

 private:
  std::uint64_t state_;
};

// What kind of trouble a random triangle makes.
enum class Shape : std::uint8_t {
  kAnywhere,        // three legal positions
  kInFrame,         // three positions in the frame
  kSmall,           // at most 40 px across
  kTiny,            // at most 2 px across
  kSliver,          // long, the third vertex within a few subpixels of the other two's line
  kNearHorizontal,  // rows at most 3 subpixels apart
  kNearVertical,    // columns at most 3 subpixels apart
  kOnSamples,       // vertices on pixel centres, or as near as the coordinates allow
  kThroughSample,   // an edge through a pixel centre, or a subpixel beside it
  kExtreme,         // vertices at or next to the corners of the legal square
  kNoArea,          // collinear, or two or three equal vertices
};
inline constexpr std::array<Shape, 11> kShapes{
    Shape::kAnywhere,      Shape::kInFrame,        Shape::kSmall,        Shape::kTiny,
    Shape::kSliver,        Shape::kNearHorizontal, Shape::kNearVertical, Shape::kOnSamples,
    Shape::kThroughSample, Shape::kExtreme,        Shape::kNoArea};

const char* shape_name(Shape shape);

// One triangle of that shape; no promise that it covers anything.
Triangle random_triangle(Random& random, Shape shape, const FrameState& frame,
                         const Config& config);

// A position in pixels, snapped half to even and cut to the legal square.
Point snap_px(double x, double y, const Config& config);

// The square (0, 0) - (size, size) px cut into cells of cell px, every inner vertex moved by up to
// a quarter of a cell and every cell split along a diagonal chosen by the seed: every sample of the
// square belongs to exactly one triangle. Windings alternate at random.
//
//   step   vertices are multiples of `step` subpixels; cell is a multiple of 4 steps
std::vector<Triangle> jittered_mesh(std::uint64_t seed, int size, int cell, int step,
                                    const Config& config);

// A disc around (x, y) px cut into slivers that share its centre.
std::vector<Triangle> fan(double x, double y, double radius, int slivers, const Config& config);

// Every triple of distinct points among the corners of the legal square, their neighbours one
// subpixel inside, and the frame's corners: the widest triangles there are.
std::vector<Triangle> widest_triangles(const Config& config);

}  // namespace halfspace
