// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare.hpp"
#include "explain.hpp"
#include "vectors/generators.hpp"

namespace halfspace {

inline Config with_index_tags(Config config) {
  config.tag_bits = 32;
  return config;
}

inline SamplePoint random_point(Random& random, const FrameState& frame, const Config& config) {
  return {static_cast<int>(random.in(0, frame.width - 1)),
          static_cast<int>(random.in(0, frame.height - 1)),
          static_cast<int>(random.in(0, config.samples - 1))};
}

// Triangles of a scene of its own frame that the reasons below are tried on; 8 subpixel bits.
inline constexpr Config kPlain{
    .subpixel_bits = 8, .viewport_bits = 6, .guard_bits = 7, .tag_bits = 32};
inline constexpr FrameState kFrame{64, 64, Cull::kNone};

}  // namespace halfspace
