// SPDX-License-Identifier: Apache-2.0
//
// GeometryStage for many vertices: each is projected once, by SIMD, and triangles that no plane
// cuts are put together from the results. Everything else goes through GeometryStage itself.
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "../../config.hpp"
#include "../../geometry.hpp"
#include "../../packets.hpp"
#include "frame_records.hpp"

namespace halfspace {

using TriangleIndices = std::array<std::uint32_t, 3>;

// What projection needs of a frame and a configuration.
struct ProjectConstants {
  ClipVolume volume;
  double half_width = 0;   // px
  double half_height = 0;  // px
  double depth_scale = 0;  // of ndc z + 1, units
  double subpixels = 0;    // 2^s
  SnapMode snap = SnapMode::kNearestEven;
  int colors = 3;  // attributes that are colours, 0..3
};
ProjectConstants project_constants(const FrameState& frame, const Config& config);

// Vertices: in clip space already, or positions and colours to be taken there by `matrix`.
struct VertexSource {
  std::span<const ClipVertex> clip;
  std::span<const glm::vec3> position;
  std::span<const glm::vec3> color;
  glm::dmat4 matrix{1.0};

  std::size_t size() const { return clip.empty() ? position.size() : clip.size(); }
  ClipVertex vertex(std::size_t i) const;
};

// Triangles ready for coverage.
struct Assembly {
  // Bit 31 of a corner: the record is in `extra`, not among the mesh's.
  static constexpr std::uint32_t kExtra = 0x80000000u;

  std::vector<Triangle> triangle;       // `count` of them
  std::vector<TriangleIndices> corner;  // the records of each
  std::vector<VertexRecord> extra;
  std::size_t count = 0;

  void clear() {
    count = 0;
    extra.clear();
  }
  void reserve(std::size_t more);
  void append(const ShadedTriangle& shaded, int colors);
};

// Appends the pieces of mesh triangles, as GeometryStage::process() would in that order.
//
//   records   of the source's vertices; all indices are below its size
//   plain     for those that are cut; its counts are separate
//   stats     added to, for those that are not
void assemble(const VertexSource& source, const std::vector<VertexRecord>& records,
              std::span<const TriangleIndices> triangles, int colors, GeometryStage& plain,
              Assembly& out, GeometryStats& stats);

}  // namespace halfspace
