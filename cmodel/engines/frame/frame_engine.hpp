// SPDX-License-Identifier: Apache-2.0
//
// Whole frames at level bit, by SIMD: geometry, coverage, depth, colour. Byte for byte what
// GeometryStage and Rasterizer make. Page: docs/03_design/frame_engine.md.
#pragma once

#include <functional>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "../../config.hpp"
#include "../../framebuffer.hpp"
#include "../../geometry.hpp"
#include "../../packets.hpp"
#include "../../rasterizer.hpp"
#include "../coverage/hit_plane.hpp"
#include "frame_geometry.hpp"
#include "frame_store.hpp"

namespace halfspace {

// Calls body(0) .. body(count - 1), each once, and returns when all are done; bodies may run at the
// same time or one after another. run_on_threads() of halfspace::parallel is one.
using FrameRunner = std::function<void(int count, const std::function<void(int)>& body)>;

struct FrameOptions {
  DepthState depth;
  std::optional<Box> scissor;  // as Rasterizer
  Rgb background{};
  std::string_view isa;     // one of coverage_isas(); empty: the best
  bool count_hits = false;  // also keep hits()
  int threads = 1;          // 1 or more; more than 1 needs `run`
  FrameRunner run;          // how to run the threads; not called for 1
  // When not empty: called with all triangles on their way to setup, in order, a few thousand at a
  // time, by one thread at a time. What it throws, draw() throws.
  std::function<void(std::span<const Triangle>)> on_triangles;
};

// An indexed mesh as its owner keeps it.
struct MeshView {
  std::span<const glm::vec3> positions;        // world units
  std::span<const glm::vec3> colors;           // red, green, blue, 0..255; one per position
  std::span<const TriangleIndices> triangles;  // indices in range (checked)
};

// One frame. Draws may be mixed; each sees what the earlier ones left.
//
//   frame, config  as Rasterizer
//
// The framebuffer, the counts of geometry() and of stats() are those of GeometryStage and
// Rasterizer for the same triangles in the same order, on every instruction set and for any number
// of threads. stats() leaves out what belongs to the walk down the pyramid, which does not happen
// here: traversal, tiles_visited and samples_tested stay 0.
class FrameEngine {
 public:
  FrameEngine(const FrameState& frame, const Config& config, const FrameOptions& options = {});
  ~FrameEngine();

  // Forgets everything drawn and counted; keeps the memory. Needed after a draw that threw: what
  // that left is not said.
  void clear();

  // As Rasterizer::draw() for each. Vertices and attributes must be legal (checked for every
  // triangle, visible or not).
  void draw(std::span<const ShadedTriangle> triangles);

  // As GeometryStage::process() and Rasterizer::draw() for each; attributes 0, 1, 2 only.
  void draw(std::span<const ClipVertex> vertices, std::span<const TriangleIndices> triangles);

  // The same for vertices matrix * dvec4(position, 1), computed as GLM does: columns times x and y
  // added, columns times z and 1 added, then both sums.
  void draw(const MeshView& mesh, const glm::dmat4& matrix);

  // framebuffer().resolve() as 32-bit pixels, in memory that the engine keeps from frame to frame:
  // only tiles drawn to in this frame or the last one are written.
  PictureView picture();

  const FrameStore& framebuffer() const;
  const RasterStats& stats() const;
  const GeometryStats& geometry() const;

  // Coverage hits per pixel, as HitCount::count(); only with count_hits.
  std::vector<std::uint8_t> hits() const;

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace halfspace
