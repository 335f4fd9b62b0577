// SPDX-License-Identifier: Apache-2.0
//
// What the charts and the stability lab measure on: triangles whose vertices have not been snapped.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "config.hpp"
#include "oracle/oracle.hpp"
#include "packets.hpp"

namespace halfspace {
class Scene;
}

namespace halfspace::lab {

// Triangles in pixels of a frame, as doubles: what a geometry stage has before it snaps.
struct RealScene {
  std::string name;
  int width = 0;   // px
  int height = 0;  // px
  std::vector<oracle::Corners> triangles;
};

// A scene's first frame: Scene::real() with a guard band of +-2^13 px, so that every mesh has its
// triangles in the range of the charts' configurations. A TCOV file's are as they are.
RealScene real_scene(const Scene& scene, const FrameState& frame, const std::string& name);

// Seeded triangles, each within a square of `side` px somewhere in the frame.
RealScene random_scene(std::uint64_t seed, int count, double side, int width, int height);

// The configuration's snap of every vertex. Tags are indices. Every coordinate must be in its range
// (checked).
std::vector<Triangle> snapped(const RealScene& scene, const Config& config);

// How often two coverages of the same scene differ, triangle by triangle.
struct Difference {
  std::uint64_t covered = 0;  // samples that the truth covers
  std::uint64_t missing = 0;  // of those, not covered
  std::uint64_t extra = 0;    // covered, and not by the truth
  double ppm() const {
    return covered == 0 ? 0.0
                        : 1e6 * static_cast<double>(missing + extra) / static_cast<double>(covered);
  }
};

// Which pixel centres of the frame each triangle owns, by the oracle on the real vertices: for each
// triangle, ascending y * width + x. Tests the bounding box alone, so the cost is its area.
std::vector<std::vector<std::uint32_t>> oracle_pixels(const RealScene& scene);

// The same of the model on snapped vertices.
std::vector<std::vector<std::uint32_t>> model_pixels(const std::vector<Triangle>& triangles,
                                                     const RealScene& scene, const Config& config);

Difference compare(const std::vector<std::vector<std::uint32_t>>& found,
                   const std::vector<std::vector<std::uint32_t>>& truth);

}  // namespace halfspace::lab
