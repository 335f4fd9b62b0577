// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace halfspace {

// Cuts polygons into triangles, always two fewer than corners. A quadrangle is cut at its reflex
// corner, a polygon whose corners see each other from the first one into a fan, any other by
// cutting ears. Corners may lie in a line, and be the same point twice, as where a hole is joined
// to the outline.
class Triangulator {
 public:
  // The next triangle, of corners of the polygon by their number.
  struct Cut {
    std::uint32_t a, b, c;
  };

  // polygon: vertices, three or more, of `positions`. Valid until the next call.
  std::span<const Cut> cut(std::span<const std::uint32_t> polygon,
                           const std::vector<glm::dvec3>& positions);

 private:
  void cut_quadrangle();
  bool cut_fan();
  void cut_ears();
  bool is_ear(std::uint32_t corner, bool convex_only) const;
  void unlink(std::uint32_t corner);

  std::vector<glm::dvec2> flat_;  // the corners in the polygon's plane, counter-clockwise
  std::vector<std::uint32_t> next_, previous_;
  std::vector<std::uint32_t> reflex_;   // corners that may lie in an ear, by x
  std::vector<std::uint32_t> waiting_;  // corners to look at: all, then those beside an ear
  std::vector<bool> gone_;
  std::vector<Cut> cuts_;
};

}  // namespace halfspace
