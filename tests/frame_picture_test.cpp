// SPDX-License-Identifier: Apache-2.0
//
// The picture that the frame engine keeps: whatever it drew in earlier frames, its bytes are those
// of an engine that never drew another frame.
#include <gtest/gtest.h>

#include <vector>

#include "engines/common/threads.hpp"
#include "frame_meshes.hpp"

namespace halfspace {
namespace {

using Draws = std::vector<glm::dmat4>;  // of the same mesh

// Depth of every vertex, between -1 and 1.
glm::dmat4 at_depth(glm::dmat4 matrix, double depth) {
  for (int column = 0; column < 4; ++column) matrix[column][2] = depth * matrix[column][3];
  return matrix;
}

glm::dmat4 moved(glm::dmat4 matrix, double right, double up) {
  for (int column = 0; column < 4; ++column) {
    matrix[column][0] += right * matrix[column][3];
    matrix[column][1] += up * matrix[column][3];
  }
  return matrix;
}

void expect_picture(const Image& image, const PictureView& picture) {
  ASSERT_EQ(static_cast<std::size_t>(image.width), picture.width);
  ASSERT_EQ(static_cast<std::size_t>(image.height), picture.height);
  for (std::size_t y = 0; y < picture.height; ++y) {
    for (std::size_t x = 0; x < picture.width; ++x) {
      const Rgb p = image.pixel[y * picture.width + x];
      ASSERT_EQ(0xff000000u | unsigned{p[2]} << 16 | unsigned{p[1]} << 8 | p[0], picture.line(y)[x])
          << x << ' ' << y;
    }
  }
}

// Depths are cleared to the middle: what is drawn at 0.9 covers tiles, and passes nowhere.
FrameOptions options(const Config& config, std::string_view isa, int threads) {
  FrameOptions out;
  out.depth = {DepthFunction::kLess, config.depth_max() / 2};
  out.background = {9, 8, 7};
  out.isa = isa;
  out.threads = threads;
  out.run = run_on_threads;
  return out;
}

TEST(FramePicture, IsThatOfAFreshEngineWhateverWasDrawnBefore) {
  const ShadedMesh mesh = scene("teapot.obj", {64, 48, Cull::kNone}, {});
  const glm::dmat4 near = at_depth(mesh.matrix, -0.9), far = at_depth(mesh.matrix, 0.9);
  const std::vector<Draws> frames{{},
                                  {near},
                                  {far},
                                  {moved(near, 0.3, 0.2)},
                                  {moved(near, -1.2, 0.9), far},
                                  {moved(far, 0.4, 0), moved(near, 0.5, 0.1)},
                                  {},
                                  {}};
  for (const FrameState& frame :
       {FrameState{117, 61, Cull::kNone}, FrameState{3, 9, Cull::kNone},
        FrameState{256, 200, Cull::kNone}, FrameState{1364, 773, Cull::kNone}}) {
    for (const Config& config : {kFull, kMsaa4, kTiny}) {
      if (frame.width > config.max_size() || frame.height > config.max_size()) continue;
      for (const std::string_view isa : fast_isas()) {
        const int threads = frame.width % 3 + 1;
        SCOPED_TRACE(std::string(isa) + ' ' + std::to_string(frame.width));
        FrameEngine kept(frame, config, options(config, isa, threads));
        for (std::size_t i = 0; i < frames.size(); ++i) {
          SCOPED_TRACE(i);
          FrameEngine fresh(frame, config, options(config, "scalar", 1));
          kept.clear();
          for (const glm::dmat4& matrix : frames[i]) {
            kept.draw(mesh.view(), matrix);
            fresh.draw(mesh.view(), matrix);
          }
          if (frame.width > 3 && i < 4) {
            EXPECT_EQ(i % 2 == 1, fresh.stats().fragments_shaded > 0);
          }
          EXPECT_EQ(fresh.framebuffer().resolve().pixel, kept.framebuffer().resolve().pixel);
          if (i % 3 == 2) continue;  // nobody looks: the next frame starts from what is there
          expect_picture(fresh.framebuffer().resolve(), kept.picture());
          if (testing::Test::HasFailure()) return;
        }
      }
    }
  }
}

}  // namespace
}  // namespace halfspace
