// SPDX-License-Identifier: Apache-2.0
//
// The configurations whose RTL is built: the presets, and a few that exist to be tested, with what
// the presets leave out. SystemVerilog twins: rtl/config/ and testbench/rtl/config/.
#pragma once

#include "config.hpp"

namespace halfspace {

// Three clocks a triangle, no guard band, one level more than tiny needs.
inline constexpr Config kTestInterval3{.subpixel_bits = 6,
                                       .viewport_bits = 8,
                                       .guard_bits = 0,
                                       .samples = 1,
                                       .grid_log2 = 3,
                                       .setup_interval = 3,
                                       .tag_bits = 9};
// Sixteen samples below the sample grid's own resolution, a 4x4 grid, a guard band of one bit.
inline constexpr Config kTestSamples16{.subpixel_bits = 2,
                                       .viewport_bits = 6,
                                       .guard_bits = 7,
                                       .samples = 16,
                                       .grid_log2 = 2,
                                       .setup_interval = 1,
                                       .tag_bits = 8};
// Whole-pixel vertices, one level: the root is the leaf.
inline constexpr Config kTestOneLevel{.subpixel_bits = 0,
                                      .viewport_bits = 3,
                                      .guard_bits = 5,
                                      .samples = 2,
                                      .grid_log2 = 3,
                                      .setup_interval = 3,
                                      .tag_bits = 4};
// Edges shorter than the frame, without a guard band: what `halfspace fit` makes of a scene.
inline constexpr Config kTestFitted{.subpixel_bits = 5,
                                    .viewport_bits = 6,
                                    .guard_bits = 0,
                                    .extent_bits = 4,
                                    .samples = 1,
                                    .grid_log2 = 2,
                                    .setup_interval = 1,
                                    .tag_bits = 12};
// The same with a guard band, several samples, and edges so short that every node is narrow.
inline constexpr Config kTestFittedBand{.subpixel_bits = 3,
                                        .viewport_bits = 5,
                                        .guard_bits = 7,
                                        .extent_bits = 2,
                                        .samples = 4,
                                        .grid_log2 = 2,
                                        .setup_interval = 3,
                                        .tag_bits = 6};

// Other values of fields that the packages of configurations do not hold yet.
constexpr Config with_gradient_bits(Config config, int bits) {
  config.gradient_bits = bits;
  return config;
}

constexpr Config with_reciprocal_bits(Config config, int bits) {
  config.reciprocal_bits = bits;
  return config;
}
constexpr Config with_depth_bits(Config config, int bits) {
  config.depth_bits = bits;
  return config;
}

}  // namespace halfspace
