// SPDX-License-Identifier: Apache-2.0
//
// A plane from the frame's first pixel on gives every tile the same bits as from its origin.
#include <gtest/gtest.h>

#include "interpolation.hpp"
#include "vectors/generators.hpp"

namespace halfspace {
namespace {

TEST(CornerPlane, EveryTileHasTheSameBits) {
  Random random(17);
  for (const int fraction : {0, 7, 16, 20}) {
    for (const Preset& preset : kPresets) {
      Config config = preset.config;
      config.gradient_bits = fraction;
      for (int n = 0; n < 20'000; ++n) {
        // Gradients of every length, slivers' included.
        const auto gradient = [&] {
          const std::uint64_t length = static_cast<std::uint64_t>(random.in(0, 63));
          const std::uint64_t size = random.next() >> length;
          return random.in(0, 1) == 0 ? size : 0 - size;
        };
        Plane plane;
        plane.dx = gradient();
        plane.dy = gradient();
        plane.at_origin = static_cast<std::uint64_t>(random.in(kDepthLeast, kDepthMost))
                          << fraction;
        Point origin;
        origin.x =
            static_cast<std::int32_t>(random.in(config.coordinate_min(), config.coordinate_max()));
        origin.y =
            static_cast<std::int32_t>(random.in(config.coordinate_min(), config.coordinate_max()));
        const CornerPlane moved = corner_plane(plane, origin, config);
        ASSERT_EQ(moved.at_pixel0 >> (31 + fraction + config.position_bits()) >> 1, 0u);
        ASSERT_EQ(moved.dx >> (35 + fraction) >> 1, 0u);
        const auto last = config.max_size() - 1;
        const auto x = static_cast<std::int32_t>(random.in(0, last));
        const auto y = static_cast<std::int32_t>(random.in(0, last));
        ASSERT_EQ(tile_plane(moved, x, y, config), tile_plane(plane, origin, x, y, config))
            << preset.name << ", F " << fraction << ", packet " << n;
      }
    }
  }
}

}  // namespace
}  // namespace halfspace
