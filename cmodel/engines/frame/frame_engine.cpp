// SPDX-License-Identifier: Apache-2.0
#include "frame_engine.hpp"

#include "../../fixed.hpp"
#include "frame_work.hpp"

namespace halfspace {

FrameEngine::FrameEngine(const FrameState& frame, const Config& config, const FrameOptions& options)
    : work_(std::make_unique<Work>(frame, config, options)) {}
FrameEngine::~FrameEngine() = default;

void FrameEngine::clear() { work_->clear(); }
void FrameEngine::draw(std::span<const ShadedTriangle> triangles) { work_->draw(triangles); }

void FrameEngine::draw(std::span<const ClipVertex> vertices,
                       std::span<const TriangleIndices> triangles) {
  VertexSource source;
  source.clip = vertices;
  work_->draw(source, triangles);
}

void FrameEngine::draw(const MeshView& mesh, const glm::dmat4& matrix) {
  HS_CHECK(mesh.positions.size() == mesh.colors.size());
  work_->draw(VertexSource{{}, mesh.positions, mesh.colors, matrix}, mesh.triangles);
}

PictureView FrameEngine::picture() { return work_->picture(); }
const FrameStore& FrameEngine::framebuffer() const { return work_->store(); }
const RasterStats& FrameEngine::stats() const { return work_->stats(); }
const GeometryStats& FrameEngine::geometry() const { return work_->geometry(); }
std::vector<std::uint8_t> FrameEngine::hits() const { return work_->hits(); }

}  // namespace halfspace
