// SPDX-License-Identifier: Apache-2.0
//
// hs_shade by itself against shading() and the rules of timing.md.
#include "shading.hpp"

#include "stage_cosim.hpp"
#include "vectors/back_end_layout.hpp"

namespace halfspace {
namespace {

constexpr std::uint64_t kSeed = 86;

// 1/w of every length, below 1 now and then; an attribute from below 0 to beyond it.
ShadingPlanes random_planes(Random& random) {
  const auto slope = [&](std::int64_t about) {
    return static_cast<std::uint32_t>(random.in(-about / 16 - 3, about / 16 + 3));
  };
  ShadingPlanes planes;
  const std::int64_t w = (random.in(0, 1 << 30) >> random.in(0, 30)) - random.in(0, 2);
  planes.inverse_w.center = {static_cast<std::uint32_t>(w), slope(w), slope(w)};
  for (std::size_t c = 0; c < 3; ++c) {
    const std::int64_t most = w + w / 8 + 3;
    const auto at = static_cast<std::uint32_t>(random.in(-most / 8 - 2, most));
    planes.color[c].center = {at, slope(w), slope(w)};
    planes.level[c] = static_cast<std::uint8_t>(random.in(0, 3) == 0 ? random.in(0, 255) : 0);
  }
  return planes;
}

GridMask random_mask(Random& random, const Config& config) {
  GridMask mask = 0;
  const auto kind = random.in(0, 3);
  while (mask == 0) {
    mask = kind == 0 ? ~GridMask{0} : random.next();
    if (kind > 1) mask &= random.next() & random.next() & random.next();
    mask >>= 64 - config.lanes();
  }
  return mask;
}

// The groups that hold a lane of the mask, row by row, as values of shade_group_layout().
std::vector<Values> groups_of(GridMask passed, const ColorTile& colors, std::int64_t slot,
                              int fragments, const Config& config) {
  const int width = fragments == 1 ? 1 : fragments == 4 ? 2 : 4;
  const int height = fragments / width;
  std::vector<Values> out;
  std::int64_t group = 0;
  for (int y = 0; y < config.grid(); y += height) {
    for (int x = 0; x < config.grid(); x += width, ++group) {
      std::int64_t mask = 0;
      Values values{slot, group, 0};
      for (int k = fragments - 1; k >= 0; --k) {
        const int lane = (y + k / width) * config.grid() + x + k % width;
        mask |= static_cast<std::int64_t>(passed >> lane & 1) << k;
        const Rgb& color = colors[static_cast<std::size_t>(lane)];
        values.insert(values.end(), {color[2], color[1], color[0]});
      }
      values[2] = mask;
      if (mask != 0) out.push_back(values);
    }
  }
  return out;
}

// The colour of a lane that is not in the mask is nobody's.
void clear_others(Values& rtl) {
  const std::size_t fragments = (rtl.size() - 3) / 3;
  for (std::size_t k = 0; k < fragments; ++k) {
    if ((rtl[2] >> k & 1) != 0) continue;
    for (std::size_t c = 0; c < 3; ++c) rtl[3 + 3 * (fragments - 1 - k) + c] = 0;
  }
}

TEST(ShadeCosim, GroupsAgreeInBitsAndClocks) {
  for (const StageVariant& variant : shade_stages()) {
    const Config& config = variant.config;
    Random random(kSeed);
    std::vector<StagePacket> packets;
    for (int n = 0; n < 3000; ++n) {
      const ShadingPlanes planes = random_planes(random);
      CoverageTile tile;
      tile.mask[0] = random_mask(random, config);
      const std::int64_t slot = random.in(0, 511);
      StagePacket packet;
      packet.in = {static_cast<std::int64_t>(tile.mask[0]), slot, planes.level[2], planes.level[1],
                   planes.level[0]};
      for (const std::size_t c : {2, 1, 0}) {
        for (const std::int64_t v : values_of(planes.color[c].center)) packet.in.push_back(v);
      }
      for (const std::int64_t v : values_of(planes.inverse_w.center)) packet.in.push_back(v);
      packet.out = groups_of(tile.mask[0], shading(tile, tile.mask, planes, 3, config), slot,
                             variant.level, config);
      packets.push_back(std::move(packet));
    }
    const StageRun run{shade_clocks, shade_tile_layout(config),
                       shade_group_layout(variant.level, config), clear_others};
    ASSERT_NO_FATAL_FAILURE(expect_same("shade", variant, run, packets, {}, kSeed));
  }
}

}  // namespace
}  // namespace halfspace
