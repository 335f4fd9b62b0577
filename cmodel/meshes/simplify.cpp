// SPDX-License-Identifier: Apache-2.0
#include "simplify.hpp"

#include <cmath>
#include <glm/trigonometric.hpp>
#ifdef HALFSPACE_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

#include "../io/error.hpp"

namespace halfspace {

double pixel_size(const Camera& camera, int frame_height) {
  if (camera.orthographic) return camera.ortho_height / frame_height;
  return 2.0 * camera.near * std::tan(glm::radians(camera.fov_y_degrees) / 2.0) / frame_height;
}

#ifdef HALFSPACE_MESHOPTIMIZER
void simplify(Mesh& mesh, double world) {
  const float* const positions = &mesh.positions[0].x;
  const std::size_t count = mesh.positions.size();
  const float scale = meshopt_simplifyScale(positions, count, sizeof(glm::vec3));
  std::vector<std::array<std::uint32_t, 3>> out(mesh.triangles.size());
  const std::size_t indices = meshopt_simplify(
      &out[0][0], &mesh.triangles[0][0], 3 * mesh.triangles.size(), positions, count,
      sizeof(glm::vec3), std::size_t{3}, static_cast<float>(world) / scale, 0U, nullptr);
  if (indices < 3) return;  // everything would go
  out.resize(indices / 3);
  mesh.triangles = std::move(out);
}
#else
void simplify(Mesh&, double) {
  throw Error(ErrorCode::kFitTool, "--simplify",
              "this build has no meshoptimizer (install libmeshoptimizer-dev, configure again)");
}
#endif

}  // namespace halfspace
