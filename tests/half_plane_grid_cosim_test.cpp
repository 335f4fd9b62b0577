// SPDX-License-Identifier: Apache-2.0
//
// hs_half_plane_grid by itself against half_plane_grid().
#include "half_plane_grid.hpp"

#include <gtest/gtest.h>

#include "rtl/stage/stage.hpp"
#include "vectors/generators.hpp"

namespace halfspace {
namespace {

constexpr std::uint64_t kSeed = 76;

struct GridInput {
  std::int64_t base = 0;
  EdgeSlope slope;
};

// Of every size, and near the turns: where some lane's value is 0 or -1.
GridInput random_input(Random& random, const Config& config, int side) {
  const auto value = [&](int bits) {
    const auto kept = random.in(1, bits - 1);
    return random.in(-(std::int64_t{1} << (kept - 1)), (std::int64_t{1} << (kept - 1)) - 1);
  };
  GridInput input;
  input.slope = {static_cast<std::int32_t>(value(config.delta_bits())),
                 static_cast<std::int32_t>(value(config.delta_bits()))};
  const std::int64_t column = random.in(0, side - 1), row = random.in(0, side - 1);
  const std::int64_t turn = input.slope.a * column + input.slope.b * row;
  input.base = random.in(0, 3) == 0 ? value(config.delta_bits()) : random.in(-1, 0) - turn;
  return input;
}

// The model's lanes that a narrower grid has.
GridMask expected_mask(const GridInput& input, const Config& config, int side) {
  const GridMask all = half_plane_grid(input.base, input.slope, config);
  GridMask mask = 0;
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      mask |= (all >> (j * config.grid() + i) & 1) << (j * side + i);
    }
  }
  return mask;
}

TEST(HalfPlaneGridCosim, LanesAgreeForEverySlope) {
  for (const GridVariant& variant : half_plane_grid_stages()) {
    const std::unique_ptr<GridRtl> rtl = variant.make();
    Random random(kSeed);
    std::uint64_t turns = 0;
    for (int n = 0; n < 300'000; ++n) {
      const GridInput input = random_input(random, variant.config, variant.side);
      rtl->clock(input.base, input.slope, true);
      const GridMask expected = expected_mask(input, variant.config, variant.side);
      ASSERT_EQ(rtl->covered(), expected)
          << variant.name << " side " << variant.side << " packet " << n << ", seed " << kSeed
          << ": base " << input.base << " a " << input.slope.a << " b " << input.slope.b;
      ASSERT_EQ(rtl->ab(), std::int64_t{input.slope.a} + input.slope.b)
          << variant.name << " packet " << n << ", seed " << kSeed;
      turns += expected != 0 && ~expected << (64 - variant.side * variant.side) != 0 ? 1u : 0u;
    }
    EXPECT_GT(turns, 50'000u);
  }
}

TEST(HalfPlaneGridCosim, HoldsWhatItLoaded) {
  for (const GridVariant& variant : half_plane_grid_stages()) {
    const std::unique_ptr<GridRtl> rtl = variant.make();
    Random random(kSeed + 1);
    GridInput held;
    for (int n = 0; n < 20'000; ++n) {
      const GridInput input = random_input(random, variant.config, variant.side);
      const bool load = n == 0 || random.in(0, 2) == 0;
      if (load) held = input;
      rtl->clock(input.base, input.slope, load);
      ASSERT_EQ(rtl->covered(), expected_mask(held, variant.config, variant.side))
          << variant.name << " packet " << n << ", seed " << kSeed + 1;
    }
  }
}

}  // namespace
}  // namespace halfspace
