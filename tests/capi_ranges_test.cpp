// SPDX-License-Identifier: Apache-2.0
//
// Values beyond their range: the C interface refuses them and keeps what it had.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "capi_fixture.hpp"

namespace halfspace {
namespace {

using capi_test::expect_refused;
using capi_test::frame_of;
using capi_test::Handle;
using capi_test::kTriangle;
using capi_test::pull_all;

TEST(CapiRanges, EdgesBeyondTheExtentAreRefusedNotWrapped) {
  hs_model* model = nullptr;
  ASSERT_EQ(hs_create_json(R"({"extent_bits": 5})", &model), HS_OK);
  const hs_frame frame = frame_of(640, 480, HS_TILES);
  ASSERT_EQ(hs_begin_frame(model, &frame), HS_OK);
  const std::int32_t longest[6] = {0, 0, 32 * 256 - 1, 0, 0, 32 * 256 - 1};
  const std::int32_t beyond[6] = {0, 0, 32 * 256, 0, 0, 100};
  EXPECT_EQ(hs_push_triangle(model, longest, 0), HS_OK);
  expect_refused(hs_push_triangle(model, beyond, 1), HS_ERROR_RANGE, "extent_bits");
  hs_clip_vertex clip[3] = {};
  for (std::size_t i = 0; i < 3; ++i) clip[i].position[3] = 1;
  clip[1].position[0] = 0.5;  // 160 px
  clip[2].position[1] = 0.01;
  expect_refused(hs_push_clip(model, clip, 2), HS_ERROR_RANGE, "extent_bits");
  clip[1].position[0] = 1e6;  // cut at a side
  expect_refused(hs_push_clip(model, clip, 3), HS_ERROR_RANGE, "cut");
  clip[1].position[0] = 0.01;
  EXPECT_EQ(hs_push_clip(model, clip, 4), HS_OK);
  hs_stats stats{};
  stats.struct_size = sizeof stats;
  ASSERT_EQ(hs_get_stats(model, &stats), HS_OK);
  EXPECT_EQ(stats.triangles, 2u) << "what was refused was not drawn";
  const std::string cube = std::string(HALFSPACE_TEST_DIR) + "/scenes/cube.gltf";
  expect_refused(hs_draw_scene(model, cube.c_str(), nullptr), HS_ERROR_RANGE, "HS022");
  hs_destroy(model);
}

TEST(CapiRanges, CoordinatesBeyondTheRangeAreRefusedNotWrapped) {
  for (const char* preset : {"tiny", "full", "d3d"}) {
    const Handle model(preset);
    hs_info info{};
    info.struct_size = sizeof info;
    ASSERT_EQ(hs_get_info(model, &info), HS_OK);
    const hs_frame frame = frame_of(64, 64, HS_TILES);
    ASSERT_EQ(hs_begin_frame(model, &frame), HS_OK);
    const double unit = std::ldexp(1.0, -info.subpixel_bits);
    for (std::size_t i = 0; i < 6; ++i) {
      for (const std::int64_t beyond :
           {std::int64_t{info.coordinate_min} - 1, std::int64_t{info.coordinate_max} + 1,
            std::int64_t{INT32_MIN}, std::int64_t{INT32_MAX}}) {
        std::int32_t xy[6] = {0, 0, 4000, 0, 0, 4000};
        double px[6] = {0, 0, 30, 0, 0, 30};
        xy[i] = static_cast<std::int32_t>(beyond);
        px[i] = static_cast<double>(beyond) * unit;
        const std::string name = std::string(i % 2 == 0 ? "x" : "y") + std::to_string(i / 2);
        expect_refused(hs_push_triangle(model, xy, 0), HS_ERROR_RANGE, name);
        expect_refused(hs_push_triangle_px(model, px, 0), HS_ERROR_RANGE, name);
      }
      double px[6] = {0, 0, 30, 0, 0, 30};
      px[i] = std::nan("");
      expect_refused(hs_push_triangle_px(model, px, 0), HS_ERROR_RANGE, "finite");
      px[i] = std::numeric_limits<double>::infinity();
      expect_refused(hs_push_triangle_px(model, px, 0), HS_ERROR_RANGE, "finite");
      px[i] = 1e300;
      expect_refused(hs_push_triangle_px(model, px, 0), HS_ERROR_RANGE, "range");
    }
    const std::int32_t corners[6] = {info.coordinate_min, info.coordinate_min, info.coordinate_max,
                                     info.coordinate_min, info.coordinate_min, info.coordinate_max};
    EXPECT_EQ(hs_push_triangle(model, corners, 0), HS_OK) << "the extremes are legal";
    hs_stats stats{};
    stats.struct_size = sizeof stats;
    ASSERT_EQ(hs_get_stats(model, &stats), HS_OK);
    EXPECT_EQ(stats.triangles, 1u) << "what was refused was not drawn";
    EXPECT_EQ(stats.triangles_in, 1u);
  }
}

TEST(CapiRanges, TagsAndAttributesBeyondTheirWidthAreRefused) {
  const Handle model("full");
  const hs_frame frame = frame_of(64, 64, HS_FRAGMENTS);
  ASSERT_EQ(hs_begin_frame(model, &frame), HS_OK);
  expect_refused(hs_push_triangle(model, kTriangle, 1u << 16), HS_ERROR_RANGE, "tag");
  EXPECT_EQ(hs_push_triangle(model, kTriangle, (1u << 16) - 1), HS_OK);
  const hs_vertex good{0, 0, 1u << 29, 1u << 29, {255 << 8, 0, 128}};
  std::array<hs_vertex, 3> v{good, good, good};
  v[1].x = v[2].y = 4000;
  EXPECT_EQ(hs_push_shaded(model, v.data(), 0), HS_OK) << hs_last_error();
  for (std::size_t i = 0; i < 3; ++i) {
    auto bad = v;
    bad[i].depth = 1u << 30;
    expect_refused(hs_push_shaded(model, bad.data(), 0), HS_ERROR_RANGE, "depth");
    bad = v;
    bad[i].inverse_w = 0;
    expect_refused(hs_push_shaded(model, bad.data(), 0), HS_ERROR_RANGE, "inverse_w");
    bad[i].inverse_w = 1u << 30;
    expect_refused(hs_push_shaded(model, bad.data(), 0), HS_ERROR_RANGE, "inverse_w");
    bad = v;
    bad[i].value[2] = (255 << 8) + 1;
    expect_refused(hs_push_shaded(model, bad.data(), 0), HS_ERROR_RANGE, "value[2]");
    bad = v;
    bad[i].y = INT32_MIN;
    expect_refused(hs_push_shaded(model, bad.data(), 0), HS_ERROR_RANGE, "y");
  }
}

TEST(CapiRanges, FramesOutOfRangeKeepTheOldFrame) {
  const Handle model("tiny");
  hs_frame frame = frame_of(64, 64, HS_TILES);
  ASSERT_EQ(hs_begin_frame(model, &frame), HS_OK);
  ASSERT_EQ(hs_push_triangle(model, kTriangle, 0), HS_OK);
  const auto refuse = [&](auto change, const char* word) {
    hs_frame bad = frame_of(64, 64, HS_TILES);
    change(bad);
    const hs_status status = hs_begin_frame(model, &bad);
    EXPECT_TRUE(status == HS_ERROR_RANGE || status == HS_ERROR_ARGUMENT);
    expect_refused(status, status, word);
  };
  refuse([](hs_frame& f) { f.width = 0; }, "0 x 64");
  refuse([](hs_frame& f) { f.height = 513; }, "512");
  refuse([](hs_frame& f) { f.width = -5; }, "-5");
  refuse([](hs_frame& f) { f.cull = 3; }, "cull");
  refuse([](hs_frame& f) { f.depth_function = -1; }, "depth_function");
  refuse([](hs_frame& f) { f.depth_function = 8; }, "depth_function");
  refuse([](hs_frame& f) { f.flags = 4; }, "flags");
  refuse([](hs_frame& f) { f.flags = HS_DEPTH_CLEAR, f.depth_clear = 1u << 24; }, "depth_clear");
  refuse([](hs_frame& f) { f.flags = HS_SCISSOR; }, "scissor");
  const auto cut = [&](std::array<std::int32_t, 4> box) {
    refuse(
        [&](hs_frame& f) {
          f.flags = HS_SCISSOR;
          std::copy(box.begin(), box.end(), f.scissor);
        },
        "scissor");
  };
  cut({-1, 0, 8, 8});
  cut({0, 0, 65, 8});
  cut({60, 60, 4, 5});
  cut({0, INT32_MAX, 1, INT32_MAX});
  refuse([](hs_frame& f) { f.outputs = 1u << 31; }, "outputs");
  refuse([](hs_frame& f) { f.stall_probability = 1; }, "stall");
  refuse([](hs_frame& f) { f.stall_probability = std::nan(""); }, "stall");
  refuse([](hs_frame& f) { f.reserved = 1; }, "reserved");
  refuse([](hs_frame& f) { f.struct_size = 8; }, "struct_size");
  refuse([](hs_frame& f) { f.struct_size = 0; }, "struct_size");
  EXPECT_FALSE(pull_all(model).empty());
}

}  // namespace
}  // namespace halfspace
