// SPDX-License-Identifier: Apache-2.0
#include "bit_frame.hpp"

#include <algorithm>
#include <thread>

#include "engines/common/threads.hpp"
#include "engines/cycle/cycle_engine.hpp"
#include "engines/frame/frame_engine.hpp"
#include "pictures.hpp"

namespace halfspace {
namespace {

FrameOptions engine_options(const BitFrameOptions& options) {
  FrameOptions out;
  out.depth = options.depth;
  out.scissor = options.scissor;
  out.background = options.background;
  out.count_hits = true;
  const auto cores = static_cast<int>(std::thread::hardware_concurrency());
  out.threads = options.threads > 0 ? options.threads : std::max(cores, 1);
  out.run = run_on_threads;
  return out;
}

}  // namespace

BitFrame draw_bit_frame(const Scene& scene, std::size_t index, const FrameState& frame,
                        const Config& config, const BitFrameOptions& options, RunStats& stats) {
  FrameOptions engine_settings = engine_options(options);
  // The frame engine walks no pyramid; the cycle engine does, and counts what the hardware counts.
  CycleEngine walk(frame, config, Stalls());
  if (options.count_nodes) {
    engine_settings.on_triangles = [&walk](std::span<const Triangle> triangles) {
      walk.run(triangles, [](const CycleChunk&) {});
    };
  }
  FrameEngine engine(frame, config, engine_settings);
  scene.draw(index, frame, config, stats, engine);

  RasterStats counted = engine.stats();
  const RasterStats& walked = walk.stats();
  counted.traversal = walked.traversal;
  counted.tiles_visited = walked.tiles_visited;
  counted.samples_tested = walked.samples_tested;
  counted.upper_nodes_skipped = walked.upper_nodes_skipped;
  stats.raster += counted;
  const FrameStore& framebuffer = engine.framebuffer();
  stats.tiles_touched += framebuffer.tiles_touched();
  const std::uint32_t far = config.depth_max();
  return {options.depth_picture
              ? picture_of_depth(framebuffer.depth(), frame.width, frame.height, far)
              : framebuffer.resolve(),
          engine.hits()};
}

}  // namespace halfspace
