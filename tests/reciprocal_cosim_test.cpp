// SPDX-License-Identifier: Apache-2.0
//
// hs_reciprocal by itself against area_reciprocal() and reciprocal(), and the definition.
#include "interpolation.hpp"
#include "pipeline_cosim.hpp"
#include "shading.hpp"

namespace halfspace {
namespace {

constexpr std::uint64_t kSeed = 81;

// What the model says of a mantissa of so many bits.
std::int64_t expected(std::uint32_t mantissa, int bits) {
  if (bits == 32) {
    return static_cast<std::int64_t>(area_reciprocal(mantissa).factor >> 1);
  }
  Config config;
  config.reciprocal_bits = bits;
  return reciprocal(mantissa, config);
}

TEST(ReciprocalCosim, EveryMantissaHasTheModelsReciprocal) {
  for (const PipelineVariant& variant : reciprocal_stages()) {
    const int bits = variant.parameter;
    const std::int64_t least = std::int64_t{1} << (bits - 1);
    std::vector<PipelinePacket> packets;
    const auto add = [&](std::int64_t mantissa) {
      packets.push_back({{mantissa}, {expected(static_cast<std::uint32_t>(mantissa), bits)}});
      const auto divisor = static_cast<__int128>(2 * mantissa + 1);
      ASSERT_EQ(packets.back().out[0],
                static_cast<std::int64_t>((static_cast<__int128>(1) << (2 * bits)) / divisor));
    };
    Random random(kSeed);
    if (bits <= 16) {
      for (std::int64_t mantissa = least; mantissa < 2 * least; ++mantissa) add(mantissa);
    } else {
      for (int n = 0; n < 100; ++n) add(least + n);
      for (int n = 1; n <= 100; ++n) add(2 * least - n);
      for (int n = 0; n < 100'000; ++n) add(random.in(least, 2 * least - 1));
    }
    const Layout in{{"mantissa", bits, false}}, out{{"reciprocal", bits, false}};
    ASSERT_NO_FATAL_FAILURE(expect_pipeline(variant, in, out, packets, 1, false, kSeed));
  }
}

}  // namespace
}  // namespace halfspace
