// SPDX-License-Identifier: Apache-2.0
//
// What `halfspace render` draws: a mesh seen by a camera, or the cases of a TCOV file, as a stream
// of fixed-point triangles for each frame.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "../camera.hpp"
#include "../engines/frame/frame_engine.hpp"
#include "../geometry.hpp"
#include "../io/left_out.hpp"
#include "../io/stats_json.hpp"
#include "real_triangles.hpp"
#include "vertex_shader.hpp"

namespace halfspace {

// A triangle of a mesh, in clip space and where it stands in the world, from the mesh's origin.
struct MeshFace {
  std::array<ClipVertex, 3> clip;
  std::array<glm::dvec3, 3> world;
};
using FaceSink = std::function<void(const MeshFace&)>;

using TriangleSink = std::function<void(const ShadedTriangle&)>;

// A source of frames. Triangles are made one at a time: memory does not grow with their number
// beyond the loaded file itself.
class Scene {
 public:
  virtual ~Scene() = default;
  virtual std::size_t frames() const = 0;
  // The frame's size in pixels. Throws Error(kSize) when the configuration cannot hold it.
  virtual FrameState frame(std::size_t index, const Config& config) const = 0;
  virtual std::uint64_t triangles(std::size_t index) const = 0;
  // The TCOV case's id; -1 for a mesh.
  virtual int case_id(std::size_t index) const = 0;
  // Sends every triangle of a frame, in order. Throws Error(kFitRange) at the first that is outside
  // the range of a fitted configuration (extent_bits not 0), with its index. Adds to stats.geometry
  // and stats.resnapped. Each call of `sink` is counted in stats.simulate_seconds with the geometry
  // stage.
  virtual void draw(std::size_t index, const FrameState& frame, const Config& config,
                    RunStats& stats, const TriangleSink& sink) const = 0;
  // The same into a frame engine, many triangles at a time.
  virtual void draw(std::size_t index, const FrameState& frame, const Config& config,
                    RunStats& stats, FrameEngine& engine) const;
  // The same triangles before they are snapped, in the same order, as real_triangles(); a TCOV
  // case's are as in the file.
  virtual void real(std::size_t index, int guard_bits, const RealSink& sink) const = 0;
  void real(std::size_t index, const RealSink& sink) const { real(index, 0, sink); }
  // A mesh's camera, from the mesh's origin, and its triangles before clipping, in order; null and
  // none for a TCOV case.
  virtual const Camera* camera(std::size_t) const { return nullptr; }
  virtual void faces(std::size_t, const FaceSink&) const {}
  // What of the file is not drawn.
  virtual LeftOut left_out() const { return {}; }
};

// A mesh file (OBJ, glTF, GLB, PLY, STL). width x height in pixels. One frame for each of `views`
// cameras, the first as `camera` says, the others around its target. simplify_px: how far, in
// pixels of the first, simplification may move the surface; 0: not at all. Throws what
// load_mesh() and simplify() throw.
std::unique_ptr<Scene> make_mesh_scene(const std::string& path, int width, int height,
                                       const CameraOptions& camera, Lighting lighting,
                                       int views = 1, double simplify_px = 0);

// The cases of a TCOV file, or the one with that id (case_id >= 0). Triangles have one colour each
// and equal depth. Throws what read_tcov() throws, and Error(kScene) for an unknown id.
std::unique_ptr<Scene> make_tcov_scene(const std::string& path, int case_id);

// A frame's size in pixels.
struct FrameSize {
  int width = 0;
  int height = 0;
};

// "WxH", each 1..32768. Throws Error(kSize).
FrameSize parse_size(const std::string& text);

// What --size says; when it is empty 640x480, or less where the configuration is smaller. Throws
// Error(kSize).
FrameSize frame_size(const std::string& text, const Config& config);

// Throws Error(kSize) when the configuration's viewport is smaller.
void require_size(int width, int height, const Config& config, const std::string& place);

// Does the name end in .tcov, in capitals or not?
bool is_tcov(const std::string& path);

// A TCOV file's cases when the name ends in .tcov (size and camera are not used), else a mesh.
// Throws Error(kUsage) for a case of a mesh.
std::unique_ptr<Scene> open_scene(const std::string& path, int case_id, const FrameSize& size,
                                  const CameraOptions& camera, Lighting lighting, int views = 1,
                                  double simplify_px = 0);

}  // namespace halfspace
