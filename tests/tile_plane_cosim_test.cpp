// SPDX-License-Identifier: Apache-2.0
//
// hs_tile_plane by itself against tile_plane() and the rules of timing.md.
#include "interpolation.hpp"
#include "stage_cosim.hpp"
#include "vectors/back_end_layout.hpp"

namespace halfspace {
namespace {

constexpr std::uint64_t kSeed = 83;

StagePacket random_packet(Random& random, int planes, const Config& config) {
  const auto position = [&] {
    return static_cast<std::int32_t>(random.in(0, (config.max_size() >> config.grid_log2) - 1));
  };
  const std::int32_t column = position();
  const std::int32_t row = position();
  const auto gradient = [&] {  // of every length
    const std::uint64_t size = random.next() >> random.in(0, 63);
    return random.in(0, 1) == 0 ? size : 0 - size;
  };
  StagePacket packet;
  packet.out.resize(1);
  for (int p = 0; p < planes; ++p) {
    Plane plane;
    plane.at_origin = random.next();
    plane.dx = gradient();
    plane.dy = gradient();
    const CornerPlane corner = corner_plane(plane, {0, 0}, config);
    const TilePlane tile =
        tile_plane(corner, column << config.grid_log2, row << config.grid_log2, config);
    for (const std::int64_t value : values_of(corner)) packet.in.push_back(value);
    for (const std::int64_t value : values_of(tile)) packet.out[0].push_back(value);
  }
  const std::int64_t side = random.in(0, 255);
  packet.in.insert(packet.in.end(), {column, row, side});
  packet.out[0].push_back(side);
  return packet;
}

TEST(TilePlaneCosim, TilesAgreeInBitsAndClocks) {
  for (const StageVariant& variant : tile_plane_stages()) {
    const Config& config = variant.config;
    Random random(kSeed);
    std::vector<StagePacket> packets;
    for (int n = 0; n < 20'000; ++n) {
      packets.push_back(random_packet(random, variant.level, config));
    }
    const StageRun run{tile_plane_clocks, tile_plane_in_layout(variant.level, config),
                       tile_plane_out_layout(variant.level)};
    ASSERT_NO_FATAL_FAILURE(expect_same("tile_plane", variant, run, packets, {}, kSeed));
  }
}

}  // namespace
}  // namespace halfspace
