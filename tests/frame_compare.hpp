// SPDX-License-Identifier: Apache-2.0
//
// Frames of the frame engine against those of the plain stages, sample by sample.
#pragma once

#include <gtest/gtest.h>

#include "engines/frame/frame_store.hpp"
#include "framebuffer.hpp"
#include "rasterizer.hpp"

namespace halfspace {

// Fails with the first sample that differs. Leaves every tile of `plain` touched.
inline void expect_equal(const Framebuffer& plain, const FrameStore& fast, const FrameState& frame,
                         const Config& config) {
  Framebuffer& tiles = const_cast<Framebuffer&>(plain);  // tile() finds every sample
  EXPECT_EQ(plain.resolve().pixel, fast.resolve().pixel);
  EXPECT_EQ(plain.depth(), fast.depth());
  const int grid = config.grid();
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      const FrameTile& tile = tiles.tile(x & -grid, y & -grid);
      const auto lane = static_cast<std::size_t>((y & (grid - 1)) * grid + (x & (grid - 1)));
      for (std::size_t m = 0; m < tile.depth.size(); ++m) {
        ASSERT_EQ(tile.depth[m][lane], fast.depth_at(x, y, static_cast<int>(m)))
            << "depth at " << x << ' ' << y << " sample " << m;
        ASSERT_EQ(tile.color[m][lane], fast.color_at(x, y, static_cast<int>(m)))
            << "colour at " << x << ' ' << y << " sample " << m;
      }
    }
  }
}

inline void expect_equal(const RasterStats& plain, const RasterStats& fast) {
  EXPECT_EQ(plain.triangles, fast.triangles);
  EXPECT_EQ(plain.triangles_zero_area, fast.triangles_zero_area);
  EXPECT_EQ(plain.triangles_culled, fast.triangles_culled);
  EXPECT_EQ(plain.triangles_no_sample, fast.triangles_no_sample);
  EXPECT_EQ(plain.tiles_covered, fast.tiles_covered);
  EXPECT_EQ(plain.samples_covered, fast.samples_covered);
  EXPECT_EQ(plain.fragments, fast.fragments);
  EXPECT_EQ(plain.fragments_shaded, fast.fragments_shaded);
}

}  // namespace halfspace
