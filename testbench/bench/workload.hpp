// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config.hpp"
#include "geometry.hpp"
#include "packets.hpp"

namespace halfspace {

inline constexpr Config kBenchConfig = kFull;

// A mesh before the geometry stage, three indices a triangle.
struct FrameMesh {
  std::vector<glm::vec3> positions;  // world units
  std::vector<glm::vec3> colors;     // red, green, blue 0..255, one per position
  std::vector<std::array<std::uint32_t, 3>> triangles;
  glm::dmat4 matrix{1.0};  // world to clip space

  ClipVertex vertex(std::uint32_t index) const;
};

// Triangles in a frame, of configuration kBenchConfig.
struct Workload {
  std::string name;
  FrameState frame;
  std::vector<Triangle> triangles;  // what coverage is timed on
  std::optional<FrameMesh> mesh;    // where there is a whole frame to draw: they come from it
};

// One of the generated workloads, the same on every machine:
//   small, medium, large, fullscreen, sliver   1024x1024 px: ~10, ~200, ~240,000, 1,048,576 and
//                                              ~260 px a triangle (330 px long)
//   quad, px32, px16, tile                     1920x1080 px: the whole frame in two triangles;
//                                              triangles in squares of 32, 16 and 8 px
// scale: of its number of triangles.
Workload make_workload(std::string_view name, double scale);

// Same names, without the frame.
std::vector<Triangle> bench_triangles(std::string_view name, double scale = 1);

// A scene (teapot, bunny: a file in `folder`; million: bumpy_torus()) as the camera of `halfspace
// render` sees it. Throws what load_mesh() throws.
Workload make_scene_workload(std::string_view name, int width, int height,
                             const std::string& folder, double scale);

}  // namespace halfspace
