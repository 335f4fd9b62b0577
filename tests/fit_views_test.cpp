// SPDX-License-Identifier: Apache-2.0
//
// fit: views that ask for nothing, and what the FIFOs hold.
#include <gtest/gtest.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>

#include "fit/fit.hpp"
#include "io/error.hpp"
#include "io/output_file.hpp"

namespace halfspace {
namespace {

std::vector<FitView> teapot(const CameraOptions& camera = {}, int views = 1) {
  const std::string path = std::string(HALFSPACE_TEST_DIR) + "/scenes/teapot.obj";
  return fit_views(open_scene(path, -1, {64, 64}, camera, Lighting::kGouraud, views), path,
                   Cull::kNone);
}

CameraOptions turned_away() {
  CameraOptions camera;
  camera.eye = glm::dvec3{0, 0, 1e5};
  camera.target = glm::dvec3{0, 0, 2e5};
  return camera;
}

// The same large triangle again and again: while the first hands its children down, everything
// before it fills. Registers 2, 3 and 4 of level 0 hold a triangle each and its FIFO two, so the
// fifth is the first that waits behind another.
TEST(FitFifos, TheSecondEntryIsUsedWhenAllBeforeItIsFull) {
  FifoUses before;  // of one triangle fewer
  for (const auto& [triangles, waited] :
       {std::pair(4, 0), std::pair(5, 1), std::pair(6, 2), std::pair(7, 3), std::pair(8, 4)}) {
    std::string text = "TCOV 1 1\ncase 0 x 512 512 " + std::to_string(triangles) + " 0 0 0\n";
    for (int i = 0; i < triangles; ++i) text += "0 0 130816 0 0 130816\n";
    const std::string path = testing::TempDir() + "fifos_" + std::to_string(triangles) + ".tcov";
    OutputFile file(path);
    file.write(text);
    file.commit();
    const Config config = kTiny;
    ASSERT_EQ(config.levels(), 5);  // 0, 2 and 4 have FIFOs
    const auto views =
        fit_views(open_scene(path, -1, {512, 512}, {}, Lighting::kFlat), path, Cull::kNone);
    const FifoUses uses = fifo_uses(views, config);
    ASSERT_EQ(uses.fifo.size(), 3u);
    EXPECT_EQ(uses.fifo[0].level, 0);
    EXPECT_EQ(uses.fifo[1].level, 2);
    EXPECT_EQ(uses.fifo[2].level, 4);
    EXPECT_EQ(uses.fifo[0].packets, static_cast<std::uint64_t>(triangles));
    EXPECT_EQ(uses.fifo[0].waited, static_cast<std::uint64_t>(waited)) << triangles;
    EXPECT_EQ(uses.fifo[0].both_clocks > 0, waited > 0) << triangles;
    EXPECT_LT(uses.fifo[0].both_clocks, uses.clocks);
    // When all is full, each waits as long as one takes, but for the clock in which it enters.
    if (triangles == 8) {
      EXPECT_EQ(uses.fifo[0].both_clocks - before.fifo[0].both_clocks,
                uses.clocks - before.clocks - 1);
    }
    before = uses;
    EXPECT_EQ(uses.fifo[2].waited, 0u);  // coverage takes a tile every clock
    std::remove(path.c_str());
  }
}

TEST(Fit, NothingToDrawIsNothingToFitTo) {
  for (const int views : {1, 3}) {
    for (const std::optional<double> limit : {std::optional<double>(), std::optional(1000.0)}) {
      FitOptions options;
      options.max_error = limit;
      options.target = parse_target("1px/clk");
      try {
        fit(teapot(turned_away(), views), options);
        ADD_FAILURE() << views;
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::kScene) << error.what();
        EXPECT_NE(std::string(error.what()).find("no triangle covers a sample"), std::string::npos);
      }
    }
  }
}

TEST(Fit, AnEmptyViewAmongOthersIsCounted) {
  auto views = teapot(turned_away());
  const auto more = teapot();
  EXPECT_EQ(fit(more, {}).views_empty, 0u);
  views.insert(views.end(), more.begin(), more.end());
  EXPECT_EQ(fit(views, {}).views_empty, 1u);
}

}  // namespace
}  // namespace halfspace
