// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "engines/common/threads.hpp"
#include "frame_meshes.hpp"

namespace halfspace {
namespace {

// What the engine writes is what its framebuffer holds, at any alignment, in any width, with and
// without tiles that nothing was drawn to, in pictures small enough for caches and not.
TEST(FramePicture, EveryWayToPixelsWritesTheSamePicture) {
  const ShadedMesh mesh = scene("teapot.obj", {64, 48, Cull::kNone}, {});
  for (const FrameState& frame :
       {FrameState{117, 61, Cull::kNone}, FrameState{3, 9, Cull::kNone},
        FrameState{129, 200, Cull::kNone}, FrameState{1364, 773, Cull::kNone}}) {
    for (const Config& config : {kFull, kMsaa4, kTiny}) {
      if (frame.width > config.max_size() || frame.height > config.max_size()) continue;
      for (const std::string_view isa : fast_isas()) {
        SCOPED_TRACE(isa);
        FrameOptions options;
        options.isa = isa;
        options.background = {9, 8, 7};
        options.threads = frame.width % 3 + 1;
        options.run = run_on_threads;
        FrameEngine engine(frame, config, options);
        const std::size_t size =
            static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height);
        for (const std::size_t shift : {0u, 1u, 4u}) {
          std::vector<std::uint32_t> plain(size), fast(size + 5, 77);
          engine.framebuffer().resolve_rgba(plain);
          engine.resolve_rgba(std::span(fast).subspan(shift, size));
          ASSERT_TRUE(std::equal(plain.begin(), plain.end(), fast.data() + shift));
          for (std::size_t i = 0; i < fast.size(); ++i) {
            if (i >= shift && i < shift + size) continue;
            ASSERT_EQ(77u, fast[i]) << "beyond the picture";
          }
          engine.draw(mesh.view(), mesh.matrix);
        }
      }
    }
  }
}

}  // namespace
}  // namespace halfspace
