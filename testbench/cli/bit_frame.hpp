// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "depth.hpp"
#include "framebuffer.hpp"
#include "io/stats_json.hpp"
#include "scene/scene.hpp"

namespace halfspace {

struct BitFrameOptions {
  DepthState depth;
  Rgb background{};
  bool depth_picture = false;  // the depths instead of the colours
  bool count_nodes = false;    // also count the walk down the pyramid: costs about as much again
  int threads = 0;             // 0: as many as the machine has
  std::optional<Box> scissor;  // nothing is drawn outside
};

struct BitFrame {
  Image image;
  std::vector<std::uint8_t> hits;  // as HitCount::count()
};

// One frame of a scene at level bit, by the frame engine: the picture and the counts that
// Rasterizer makes. Adds to stats what LevelRun adds at that level, nodes only when asked for.
BitFrame draw_bit_frame(const Scene& scene, std::size_t index, const FrameState& frame,
                        const Config& config, const BitFrameOptions& options, RunStats& stats);

}  // namespace halfspace
