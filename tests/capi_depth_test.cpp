// SPDX-License-Identifier: Apache-2.0
//
// Depth, 1/w and the scissor through the C interface.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <string>

#include "capi_fixture.hpp"

namespace halfspace {
namespace {

using namespace capi_test;

constexpr unsigned kSeed = 20261130;

// A caller compiled before flags, depth_clear and scissor were there.
TEST(Capi, FramesOfTheFirstVersionAreTaken) {
  const Handle model("full");
  hs_frame frame = frame_of(16, 16, HS_PICTURE);
  frame.struct_size = offsetof(hs_frame, flags);
  frame.flags = 77;
  EXPECT_EQ(hs_begin_frame(model, &frame), HS_OK) << hs_last_error();
}

// Of 1/w only the ratios count: the same triangle with the same colours, whatever the scale.
TEST(Capi, SmallInverseWLosesNothing) {
  const Handle model("full");
  const auto colors = [&](std::uint32_t scale) {
    const hs_frame frame = frame_of(16, 16, HS_PICTURE);
    EXPECT_EQ(hs_begin_frame(model, &frame), HS_OK);
    const std::array<hs_vertex, 3> v{{{0, 0, 0, scale, {100 << 8, 200 << 8, 255 << 8}},
                                      {8192, 0, 0, 3 * scale, {0, 200 << 8, 10 << 8}},
                                      {0, 8192, 0, 2 * scale, {50 << 8, 200 << 8, 0}}}};
    EXPECT_EQ(hs_push_shaded(model, v.data(), 0), HS_OK);
    std::vector<std::uint8_t> out(16 * 16 * 3);
    EXPECT_EQ(hs_read_color(model, out.data(), out.size()), HS_OK);
    return out;
  };
  const auto greatest = colors(1u << 28);
  EXPECT_EQ(greatest[1], 200);
  for (int shift = 0; shift < 28; ++shift) EXPECT_EQ(colors(1u << shift), greatest) << shift;
}

// Reversed depth: the near plane at 1, cleared to 0, greater wins; inside a rectangle.
TEST(Capi, ReversedDepthKeepsTheNearer) {
  const auto draw = [](bool reversed, std::uint32_t bits) {
    const std::string json = "{\"preset\": \"full\", \"depth_bits\": " + std::to_string(bits) + "}";
    const Handle model(json.c_str(), Handle::kJson);
    hs_frame frame = frame_of(64, 48, HS_PICTURE);
    frame.depth_function = reversed ? HS_DEPTH_GREATER : HS_DEPTH_LESS;
    frame.flags = HS_DEPTH_CLEAR | HS_SCISSOR;
    frame.depth_clear = reversed ? 0 : 0xffffffffu >> (32 - bits);
    const std::int32_t box[4] = {8, 4, 40, 30};
    std::copy(box, box + 4, frame.scissor);
    EXPECT_EQ(hs_begin_frame(model, &frame), HS_OK) << hs_last_error();
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<double> in(-1, 1);
    for (std::uint32_t tag = 0; tag < 20; ++tag) {
      hs_clip_vertex v[3] = {};
      const double depth = in(random), color = 100 * (1 + in(random));
      for (hs_clip_vertex& vertex : v) {
        vertex.position[0] = in(random);
        vertex.position[1] = in(random);
        vertex.position[2] = reversed ? -depth : depth;
        vertex.position[3] = 1;
        std::fill(vertex.value, vertex.value + 3, color);
      }
      EXPECT_EQ(hs_push_clip(model, v, tag), HS_OK);
    }
    std::vector<std::uint8_t> out(64 * 48 * 3);
    EXPECT_EQ(hs_read_color(model, out.data(), out.size()), HS_OK);
    return out;
  };
  const auto expected = draw(false, 24);
  EXPECT_EQ(std::count(expected.begin(), expected.begin() + 4 * 64 * 3, 0), 4 * 64 * 3);
  EXPECT_GT(std::count_if(expected.begin(), expected.end(), [](int v) { return v != 0; }), 1000);
  for (const std::uint32_t bits : {16u, 24u, 30u, 31u, 32u}) {
    EXPECT_EQ(draw(true, bits), expected) << bits;
    EXPECT_EQ(draw(false, bits), expected) << bits;
  }
}

}  // namespace
}  // namespace halfspace
