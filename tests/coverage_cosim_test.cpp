// SPDX-License-Identifier: Apache-2.0
//
// hs_coverage by itself against coverage() and the rules of timing.md.
#include "coverage.hpp"

#include "stage_cosim.hpp"

namespace halfspace {
namespace {

TEST(CoverageCosim, TilesOfEveryShapeAgreeInBitsAndClocks) {
  constexpr std::uint64_t kSeed = 75;
  for (const StageVariant& variant : coverage_stages()) {
    const Config& config = variant.config;
    for (const int cut : {0, 3}) {  // frames that end inside a tile, too
      const FrameState frame{config.max_size() - cut, config.max_size() - cut, Cull::kNone};
      std::vector<StagePacket> packets;
      std::size_t empty = 0;
      for (const auto& [node, setup] :
           random_nodes(kSeed, 10'000, config.levels() - 1, frame, config)) {
        StagePacket packet{values_of(node, setup, config), {}};
        if (const auto tile = coverage(node, setup, config)) {
          packet.out.push_back(values_of(*tile, config));
        }
        empty += packet.out.empty() ? 1 : 0;
        packets.push_back(std::move(packet));
      }
      EXPECT_GT(empty, 50u) << variant.name;
      EXPECT_LT(empty, 7000u) << variant.name;
      const StageRun run{coverage_clocks, traversal_layout(config), coverage_layout(config)};
      ASSERT_NO_FATAL_FAILURE(expect_same("coverage", variant, run, packets, frame, kSeed));
    }
  }
}

}  // namespace
}  // namespace halfspace
