// SPDX-License-Identifier: Apache-2.0
#include "nothing_drawn.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace halfspace {
namespace {

// Triangles of which no part is before the eye.
std::uint64_t behind_the_eye(const Scene& scene, std::size_t index) {
  std::uint64_t behind = 0;
  const bool orthographic = scene.camera(index)->orthographic;
  scene.faces(index, [&](const MeshFace& face) {
    const bool all = std::all_of(face.clip.begin(), face.clip.end(), [&](const ClipVertex& v) {
      return orthographic ? v.position.z < -v.position.w : v.position.w <= 0.0;
    });
    behind += all ? 1 : 0;
  });
  return behind;
}

}  // namespace

std::string why_nothing_is_drawn(const Scene& scene, std::size_t index, const RunStats& stats) {
  if (stats.raster.samples_covered != 0 || scene.camera(index) == nullptr) return {};
  const GeometryStats& geometry = stats.geometry;
  const std::uint64_t behind =
      geometry.outside == 0 ? 0 : std::min(behind_the_eye(scene, index), geometry.outside);
  const std::vector<std::pair<std::uint64_t, const char*>> reasons{
      {behind, "behind the eye"},
      {geometry.outside - behind, "outside the frame"},
      {geometry.dropped_not_finite, "too far for the camera's numbers"},
      {stats.raster.triangles_culled, "culled, as they face the other way"},
      {stats.raster.triangles_zero_area, "without an area"},
      {stats.raster.triangles_no_sample, "between the samples"}};
  std::string text;
  int kinds = 0;
  for (const auto& [count, what] : reasons) {
    if (count == 0) continue;
    text += fmt::format("{}{} {}", kinds++ == 0 ? "" : ", ", count, what);
    if (count == geometry.triangles_in) {
      return fmt::format("all {} triangles are {}", count, what);
    }
  }
  return fmt::format("of {} triangles {}", geometry.triangles_in,
                     kinds == 0 ? "none covers a sample" : "are " + text);
}

}  // namespace halfspace
