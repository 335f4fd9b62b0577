// SPDX-License-Identifier: Apache-2.0
//
// hs_depth_test by itself against depth_test() and the rules of timing.md.
#include <map>

#include "depth.hpp"
#include "stage_cosim.hpp"
#include "vectors/back_end_layout.hpp"

namespace halfspace {
namespace {

constexpr std::uint64_t kSeed = 84;

// A plane over a tile, its values in -2^29..3 2^29; one in four beyond the near or the far plane,
// one in four so flat that depths are equal.
TilePlane random_plane(Random& random, const Config& config) {
  const auto kind = random.in(0, 3);
  const int steps = 2 * (config.grid() - 1);
  const std::int64_t most = kind == 1 ? 3 : (std::int64_t{1} << 30) / steps;
  TilePlane plane;
  plane.dx = static_cast<std::uint32_t>(random.in(-most, most));
  plane.dy = static_cast<std::uint32_t>(random.in(-most, most));
  const std::int64_t far = std::int64_t{1} << 30;
  const std::int64_t middle = kind == 0   ? (random.in(0, 1) == 0 ? 0 : far) + random.in(-99, 99)
                              : kind == 1 ? far / 2 + random.in(-200, 200)
                                          : random.in(0, far);
  const auto first = static_cast<std::uint32_t>(middle);
  plane.base = first - (plane.dx + plane.dy) * static_cast<std::uint32_t>(config.grid() / 2);
  return plane;
}

GridMask random_mask(Random& random, const Config& config) {
  GridMask mask = random.next();
  const auto kind = random.in(0, 3);
  if (kind == 0) mask &= random.next() & random.next();
  if (kind == 1) mask = ~GridMask{0};
  return mask >> (64 - config.lanes());
}

// Tiles that often meet the one before in its slot; the first of a slot is fresh, some others too.
std::vector<StagePacket> random_tiles(std::uint64_t seed, std::size_t count, int slots_log2,
                                      const DepthState& state, const Config& config) {
  Random random(seed);
  std::map<std::int64_t, DepthTile> stored;
  std::vector<StagePacket> packets;
  std::int64_t slot = 0;
  for (std::size_t n = 0; n < count; ++n) {
    if (random.in(0, 1) == 0) slot = random.in(0, (1 << slots_log2) - 1);
    const bool fresh = stored.count(slot) == 0 || random.in(0, 63) == 0;
    if (fresh) stored[slot].fill(state.cleared(config));
    const TilePlane plane = random_plane(random, config);
    const GridMask mask = random_mask(random, config);
    const std::int64_t index = random.in(0, 127);
    StagePacket packet{values_of(plane), {}};
    packet.in.insert(packet.in.end(), {static_cast<std::int64_t>(mask), slot, fresh, index});
    const GridMask passed = depth_test(mask, plane, state.function, stored[slot], config);
    if (passed != 0) packet.out.push_back({static_cast<std::int64_t>(passed), slot, index});
    packets.push_back(std::move(packet));
  }
  return packets;
}

TEST(DepthTestCosim, EveryFunctionAgreesInBitsAndClocks) {
  for (const StageVariant& variant : depth_test_stages()) {
    const Config& config = variant.config;
    const std::uint32_t far = config.depth_max();
    for (int function = 0; function < kDepthFunctions; ++function) {
      for (const std::uint32_t clear : {far, 0u, far / 3}) {
        const DepthState state{static_cast<DepthFunction>(function), clear};
        const auto packets = random_tiles(kSeed, 2000, variant.level, state, config);
        const StageRun run{depth_test_clocks, depth_tile_layout(config),
                           depth_passed_layout(config)};
        ASSERT_NO_FATAL_FAILURE(
            expect_same("depth_test", variant, run, packets, {}, kSeed,
                        pack(values_of(state, config), depth_state_layout(config))))
            << "function " << function << ", cleared to " << clear;
      }
    }
  }
}

}  // namespace
}  // namespace halfspace
