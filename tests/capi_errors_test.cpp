// SPDX-License-Identifier: Apache-2.0
//
// What the C interface refuses, and that refusing changes nothing.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <thread>

#include "capi_fixture.hpp"

namespace halfspace {
namespace {

using capi_test::expect_refused;
using capi_test::frame_of;
using capi_test::Handle;
using capi_test::kTriangle;
using capi_test::pull_all;

TEST(CapiErrors, LibraryIsOfTheHeadersVersion) {
  EXPECT_EQ(hs_api_version(), static_cast<std::uint32_t>(HALFSPACE_API_VERSION));
  EXPECT_EQ(std::string(hs_version()), HALFSPACE_VERSION);
}

TEST(CapiErrors, EveryStatusHasATextOfItsOwn) {
  std::set<std::string> texts;
  for (int status = HS_OK; status <= HS_ERROR_INTERNAL + 1; ++status) {
    texts.insert(hs_status_text(static_cast<hs_status>(status)));
  }
  EXPECT_EQ(texts.size(), static_cast<std::size_t>(HS_ERROR_INTERNAL + 2));
}

TEST(CapiErrors, TextOfAFailureIsTheThreadsOwn) {
  hs_model* model = nullptr;
  EXPECT_EQ(hs_create_preset("mine", &model), HS_ERROR_CONFIG);
  std::thread([] {
    hs_model* other = nullptr;
    EXPECT_EQ(std::string(hs_last_error()), "");
    EXPECT_EQ(hs_create_preset("theirs", &other), HS_ERROR_CONFIG);
  }).join();
  EXPECT_NE(std::string(hs_last_error()).find("'mine'"), std::string::npos) << hs_last_error();
}

TEST(CapiErrors, NullHandlesAndPointersAreRefused) {
  const Handle model("full");
  const hs_frame frame = frame_of(8, 8, HS_TILES | HS_FRAGMENTS | HS_PICTURE | HS_CLOCKS);
  hs_model* none = nullptr;
  std::size_t count = 1;
  hs_tile tile;
  expect_refused(hs_create_preset(nullptr, &none), HS_ERROR_ARGUMENT, "name");
  expect_refused(hs_create_preset("full", nullptr), HS_ERROR_ARGUMENT, "model");
  expect_refused(hs_create_json(nullptr, &none), HS_ERROR_ARGUMENT, "text");
  expect_refused(hs_begin_frame(nullptr, &frame), HS_ERROR_ARGUMENT, "model");
  expect_refused(hs_reset(nullptr), HS_ERROR_ARGUMENT, "model");
  expect_refused(hs_begin_frame(model, nullptr), HS_ERROR_ARGUMENT, "frame");
  expect_refused(hs_get_info(model, nullptr), HS_ERROR_ARGUMENT, "info");
  ASSERT_EQ(hs_begin_frame(model, &frame), HS_OK);
  expect_refused(hs_push_triangle(nullptr, kTriangle, 0), HS_ERROR_ARGUMENT, "model");
  expect_refused(hs_push_triangle(model, nullptr, 0), HS_ERROR_ARGUMENT, "xy");
  expect_refused(hs_push_triangles(model, nullptr, 1, 0, nullptr), HS_ERROR_ARGUMENT, "xy");
  expect_refused(hs_push_triangle_px(model, nullptr, 0), HS_ERROR_ARGUMENT, "xy");
  expect_refused(hs_push_shaded(model, nullptr, 0), HS_ERROR_ARGUMENT, "vertex");
  expect_refused(hs_push_clip(model, nullptr, 0), HS_ERROR_ARGUMENT, "vertex");
  expect_refused(hs_draw_scene(model, nullptr, nullptr), HS_ERROR_ARGUMENT, "path");
  expect_refused(hs_pull_tiles(model, nullptr, 1, &count), HS_ERROR_ARGUMENT, "tile");
  EXPECT_EQ(count, 0u);
  expect_refused(hs_pull_tiles(model, &tile, 1, nullptr), HS_ERROR_ARGUMENT, "count");
  expect_refused(hs_pull_fragments(model, nullptr, 1, &count), HS_ERROR_ARGUMENT, "fragment");
  expect_refused(hs_get_stats(model, nullptr), HS_ERROR_ARGUMENT, "stats");
  expect_refused(hs_read_hits(model, nullptr, 64), HS_ERROR_ARGUMENT, "hits");
  expect_refused(hs_read_depth(model, nullptr, 64), HS_ERROR_ARGUMENT, "depth");
  expect_refused(hs_read_color(model, nullptr, 192), HS_ERROR_ARGUMENT, "color");
  expect_refused(hs_read_triangle_clocks(nullptr, 0, 0, nullptr), HS_ERROR_ARGUMENT, "model");
  hs_destroy(nullptr);
}

TEST(CapiErrors, BadConfigurationsAreRefusedWithTheirKey) {
  hs_model* model = nullptr;
  expect_refused(hs_create_preset("fulll", &model), HS_ERROR_CONFIG, "fulll");
  EXPECT_EQ(model, nullptr);
  expect_refused(hs_create_json("{", &model), HS_ERROR_CONFIG, "JSON");
  expect_refused(hs_create_json("", &model), HS_ERROR_CONFIG, "HS002");
  expect_refused(hs_create_json("[]", &model), HS_ERROR_CONFIG, "object");
  expect_refused(hs_create_json(R"({"sub": 1})", &model), HS_ERROR_CONFIG, "sub");
  expect_refused(hs_create_json(R"({"samples": 3})", &model), HS_ERROR_CONFIG, "samples");
  expect_refused(hs_create_json(R"({"samples": "4"})", &model), HS_ERROR_CONFIG, "samples");
  expect_refused(hs_create_json(R"({"samples": 1e999})", &model), HS_ERROR_CONFIG, "1e999");
  const std::string deep =
      "{\"samples\":" + std::string(80000, '[') + std::string(80000, ']') + "}";
  expect_refused(hs_create_json(deep.c_str(), &model), HS_ERROR_CONFIG, "nested");
  expect_refused(hs_create_json("{\"a\\u001b[31mb\":1}", &model), HS_ERROR_CONFIG, "a\\x1b[31mb");
  EXPECT_EQ(model, nullptr);
}

// Of every kind of push: no count of what was refused, and the next one counts as ever.
TEST(CapiErrors, WhatIsRefusedIsNotCounted) {
  const Handle model(R"({"preset": "tiny", "extent_bits": 3})", Handle::kJson);
  const hs_frame frame = frame_of(64, 64, HS_COUNTS);
  ASSERT_EQ(hs_begin_frame(model, &frame), HS_OK);
  const auto stats = [&model] {
    hs_stats out{};
    out.struct_size = sizeof out;
    EXPECT_EQ(hs_get_stats(model, &out), HS_OK);
    return std::array{out.triangles_in, out.triangles_outside, out.triangles_clipped, out.triangles,
                      out.triangles_not_finite};
  };
  const auto none = stats();
  std::array<hs_clip_vertex, 3> cut{}, wide{};
  for (auto& v : cut) v.position[3] = 1;
  wide = cut;
  cut[0].position[0] = -3;
  cut[1].position[0] = 3;
  cut[2].position[1] = 0.9;
  wide[0].position[0] = -0.9;
  wide[1].position[0] = 0.9;
  wide[2].position[1] = 0.9;
  const std::array<std::int32_t, 6> far{0, 0, 1000, 0, 0, 1000};
  const std::array<double, 6> far_px{0, 0, 60, 0, 0, 60};
  std::array<hs_vertex, 3> shaded{};
  shaded[1].x = 1000;
  for (int twice = 0; twice < 2; ++twice) {
    expect_refused(hs_push_clip(model, cut.data(), 0), HS_ERROR_RANGE, "extent_bits");
    expect_refused(hs_push_clip(model, wide.data(), 0), HS_ERROR_RANGE, "extent_bits");
    expect_refused(hs_push_triangle(model, far.data(), 0), HS_ERROR_RANGE, "extent_bits");
    expect_refused(hs_push_triangle_px(model, far_px.data(), 0), HS_ERROR_RANGE, "extent_bits");
    expect_refused(hs_push_shaded(model, shaded.data(), 0), HS_ERROR_RANGE, "extent_bits");
    EXPECT_EQ(stats(), none);
  }
  for (auto& v : wide) {
    v.position[0] /= 10;
    v.position[1] /= 10;
  }
  ASSERT_EQ(hs_push_clip(model, wide.data(), 0), HS_OK);
  EXPECT_EQ(stats()[0], 1u);
  EXPECT_EQ(stats()[3], 1u);
}

TEST(CapiErrors, StructsOfANewerHeaderWorkWhileTheirNewFieldsAreZero) {
  struct Newer {
    hs_frame frame;
    std::uint64_t field;
  };
  const Handle model("full");
  Newer newer{frame_of(8, 8, HS_TILES), 0};
  newer.frame.struct_size = sizeof newer;
  EXPECT_EQ(hs_begin_frame(model, &newer.frame), HS_OK);
  newer.field = 1;
  expect_refused(hs_begin_frame(model, &newer.frame), HS_ERROR_ARGUMENT, "unknown");
  struct {
    hs_info info;
    std::uint64_t field;
  } info{{}, ~std::uint64_t{0}};
  info.info.struct_size = sizeof info;
  EXPECT_EQ(hs_get_info(model, &info.info), HS_OK);
  EXPECT_EQ(info.info.struct_size, sizeof info);
  EXPECT_EQ(info.info.subpixel_bits, 8);
  EXPECT_EQ(info.info.coordinate_max, (1 << 21) - 1);
  EXPECT_EQ(info.field, 0u) << "fields this library does not know are 0";
}

TEST(CapiErrors, CallsBeforeAFrameOrForOutputsNotKeptAreRefused) {
  const Handle model("full");
  std::array<hs_tile, 1> tile;
  std::array<hs_fragment, 1> fragment;
  std::array<std::uint32_t, 64> depth;
  std::array<std::uint8_t, 192> color;
  hs_triangle_clocks clocks;
  std::size_t count = 0;
  expect_refused(hs_push_triangle(model, kTriangle, 0), HS_ERROR_ORDER, "hs_begin_frame");
  expect_refused(hs_reset(model), HS_ERROR_ORDER, "hs_begin_frame");
  expect_refused(hs_draw_scene(model, "x.obj", nullptr), HS_ERROR_ORDER, "hs_begin_frame");
  expect_refused(hs_pull_tiles(model, tile.data(), 1, &count), HS_ERROR_ORDER, "hs_begin_frame");
  hs_frame frame = frame_of(8, 8, HS_COUNTS);
  ASSERT_EQ(hs_begin_frame(model, &frame), HS_OK);
  ASSERT_EQ(hs_push_triangle(model, kTriangle, 0), HS_OK);
  expect_refused(hs_pull_tiles(model, tile.data(), 1, &count), HS_ERROR_ORDER, "HS_TILES");
  expect_refused(hs_pull_fragments(model, fragment.data(), 1, &count), HS_ERROR_ORDER, "FRAGM");
  expect_refused(hs_read_depth(model, depth.data(), 64), HS_ERROR_ORDER, "HS_PICTURE");
  expect_refused(hs_read_color(model, color.data(), 192), HS_ERROR_ORDER, "HS_PICTURE");
  expect_refused(hs_read_triangle_clocks(model, 0, 1, &clocks), HS_ERROR_ORDER, "HS_CLOCKS");
  frame.outputs = 0;
  ASSERT_EQ(hs_begin_frame(model, &frame), HS_OK);
  EXPECT_EQ(hs_pull_tiles(model, tile.data(), 1, &count), HS_EMPTY) << "0 means tiles";
}

TEST(CapiErrors, ArraysOfTheWrongSizeAreRefused) {
  const Handle model("full");
  const hs_frame frame = frame_of(8, 8, HS_PICTURE | HS_CLOCKS);
  ASSERT_EQ(hs_begin_frame(model, &frame), HS_OK);
  ASSERT_EQ(hs_push_triangle(model, kTriangle, 0), HS_OK);
  std::array<std::uint8_t, 193> bytes;
  std::array<std::uint32_t, 65> words;
  std::array<hs_triangle_clocks, 2> clocks;
  for (const std::size_t wrong : {63u, 65u}) {
    expect_refused(hs_read_hits(model, bytes.data(), wrong), HS_ERROR_ARGUMENT, "not 64");
    expect_refused(hs_read_depth(model, words.data(), wrong), HS_ERROR_ARGUMENT, "not 64");
  }
  expect_refused(hs_read_color(model, bytes.data(), 64), HS_ERROR_ARGUMENT, "not 192");
  expect_refused(hs_read_triangle_clocks(model, 0, 2, clocks.data()), HS_ERROR_RANGE, "of 1");
  expect_refused(hs_read_triangle_clocks(model, 1, 1, clocks.data()), HS_ERROR_RANGE, "of 1");
  expect_refused(hs_read_triangle_clocks(model, 2, 0, clocks.data()), HS_ERROR_RANGE, "of 1");
  EXPECT_EQ(hs_read_triangle_clocks(model, 0, 1, clocks.data()), HS_OK);
}

TEST(CapiErrors, ManyTrianglesStopAtTheFirstRefusedAndKeepTheRest) {
  const Handle model("full");
  const hs_frame frame = frame_of(64, 64, HS_TILES);
  ASSERT_EQ(hs_begin_frame(model, &frame), HS_OK);
  std::vector<std::int32_t> xy;
  for (int i = 0; i < 2000; ++i) xy.insert(xy.end(), kTriangle, kTriangle + 6);
  xy[6 * 1500 + 3] = INT32_MAX;
  std::size_t pushed = 0;
  expect_refused(hs_push_triangles(model, xy.data(), 2000, 0, &pushed), HS_ERROR_RANGE,
                 "triangle 1500: y1");
  EXPECT_EQ(pushed, 1500u);
  hs_stats stats{};
  stats.struct_size = sizeof stats;
  ASSERT_EQ(hs_get_stats(model, &stats), HS_OK);
  EXPECT_EQ(stats.triangles, 1500u);
}

TEST(CapiErrors, ScenesThatCannotBeReadAreRefusedWithTheirCode) {
  const Handle model("full");
  const hs_frame frame = frame_of(64, 64, HS_TILES);
  ASSERT_EQ(hs_begin_frame(model, &frame), HS_OK);
  const std::string folder = HALFSPACE_TEST_DIR "/broken/";
  expect_refused(hs_draw_scene(model, "no_such.obj", nullptr), HS_ERROR_FILE, "HS010");
  expect_refused(hs_draw_scene(model, (folder + "nan.obj").c_str(), nullptr), HS_ERROR_FILE,
                 "HS013");
  hs_camera camera{};
  camera.struct_size = sizeof camera;
  camera.flags = HS_CAMERA_FOV;
  const std::string teapot = HALFSPACE_TEST_DIR "/scenes/teapot.obj";
  expect_refused(hs_draw_scene(model, teapot.c_str(), &camera), HS_ERROR_RANGE, "fov");
  camera.flags = HS_CAMERA_EYE;
  camera.eye[1] = std::nan("");
  expect_refused(hs_draw_scene(model, teapot.c_str(), &camera), HS_ERROR_RANGE, "finite");
  EXPECT_TRUE(pull_all(model).empty());
}

}  // namespace
}  // namespace halfspace
