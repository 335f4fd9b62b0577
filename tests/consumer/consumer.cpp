// SPDX-License-Identifier: Apache-2.0
//
// A C++ program against the installed headers and libraries, stage by stage: consumer_cpp SCENE
// WIDTH HEIGHT prints the CRC-32 of the scene's coverage, as `halfspace render --stats` has it.
// White vertices: coverage asks for no light.
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "camera.hpp"
#include "geometry.hpp"
#include "hit_count.hpp"
#include "io/tcov.hpp"
#include "meshes/mesh.hpp"
#include "rasterizer.hpp"

using namespace halfspace;

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const Config config = kFull;
  const FrameState frame{std::atoi(argv[2]), std::atoi(argv[3]), Cull::kNone};
  const double aspect = static_cast<double>(frame.width) / static_cast<double>(frame.height);
  const Mesh mesh = load_mesh(argv[1]);
  const glm::dmat4 matrix = world_to_clip(frame_camera(mesh.positions, aspect), aspect);
  GeometryStage geometry(frame, config);
  std::vector<ShadedTriangle> ready;
  for (const auto& index : mesh.triangles) {
    std::array<ClipVertex, 3> triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      triangle[i].position = matrix * glm::dvec4(glm::dvec3(mesh.positions[index[i]]), 1.0);
    }
    geometry.process(triangle, 0, ready);
  }
  HitCount hits(frame.width, frame.height);
  RasterStats stats;
  for (const ShadedTriangle& triangle : ready) {
    rasterize(triangle.triangle, frame, config, stats,
              [&](const CoverageTile& tile) { hits.add(tile, config); });
  }
  std::printf("%u\n", crc32_of(hits.count()));
}
