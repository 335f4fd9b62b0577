// SPDX-License-Identifier: Apache-2.0
#include "entry.hpp"
#include "rasterizer.hpp"

namespace halfspace {
namespace {

// The stages one after the other, as halfspace render --level bit does it.
BenchOutput run_bit_frame(const Workload& work) {
  Rasterizer rasterizer(work.frame, kBenchConfig, DepthFunction::kLess, kBenchBackground);
  GeometryStage stage(work.frame, kBenchConfig);
  std::vector<ShadedTriangle> pieces;
  std::vector<ClipVertex> vertex;
  vertex.reserve(work.mesh->positions.size());
  for (std::uint32_t i = 0; i < work.mesh->positions.size(); ++i) {
    vertex.push_back(work.mesh->vertex(i));
  }
  std::uint32_t tag = 0;
  for (const auto& index : work.mesh->triangles) {
    pieces.clear();
    stage.process({vertex[index[0]], vertex[index[1]], vertex[index[2]]}, tag++, pieces);
    for (const ShadedTriangle& piece : pieces) rasterizer.draw(piece);
  }
  return {rasterizer.stats().samples_covered,
          rasterizer.stats().tiles_covered,
          {},
          rasterizer.framebuffer().resolve(),
          {}};
}

}  // namespace

std::vector<BenchEntry> frame_entries(const Workload& work, const BenchOptions&) {
  BenchRow row;
  row.work = "frame";
  row.engine = "bit";
  const auto draw = [&work] { return run_bit_frame(work); };
  return {{row, [draw] { draw(); }, draw}};
}

}  // namespace halfspace
