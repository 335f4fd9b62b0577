// SPDX-License-Identifier: Apache-2.0
//
// What the C interface draws, against the stages called one by one.
#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <random>
#include <thread>

#include "capi_fixture.hpp"
#include "cycle_model.hpp"

namespace halfspace {
namespace {

using capi_test::frame_of;
using capi_test::Handle;
using capi_test::pull_all;

constexpr std::uint32_t kSeed = 20261122;

struct Listener {
  std::vector<std::pair<std::uint64_t, CoverageTile>> tiles;
  std::vector<hs_triangle_clocks> clocks;
  void accepted(std::uint64_t clock) { clocks.push_back({clock, HS_NEVER}); }
  void setup(std::uint64_t clock, const SetupTriangle&) { clocks.back().setup = clock; }
  void node(int, std::uint64_t, const Node&) {}
  void tile(std::uint64_t clock, const CoverageTile& tile) { tiles.emplace_back(clock, tile); }
};

std::vector<std::int32_t> random_triangles(const Config& config, int count) {
  std::mt19937 random(kSeed);
  const auto side = static_cast<std::int32_t>(200 << config.subpixel_bits);
  std::vector<std::int32_t> xy;
  for (int i = 0; i < 6 * count; ++i) {
    xy.push_back(static_cast<std::int32_t>(random() % static_cast<std::uint32_t>(side)));
  }
  return xy;
}

Triangle triangle_at(const std::vector<std::int32_t>& xy, std::size_t i, std::uint32_t tag) {
  const auto* p = &xy[6 * i];
  return {{{{p[0], p[1]}, {p[2], p[3]}, {p[4], p[5]}}}, tag};
}

TEST(Capi, PullsTheTilesAndClocksOfTheCycleModelOfEveryPreset) {
  for (const Preset& preset : kPresets) {
    for (const double stall : {0.0, 0.4}) {
      const Handle model(std::string(preset.name).c_str());
      hs_frame frame = frame_of(150, 130, HS_TILES | HS_CLOCKS);
      frame.cull = HS_CULL_BACK;
      frame.stall_probability = stall;
      frame.stall_seed = 5;
      ASSERT_EQ(hs_begin_frame(model, &frame), HS_OK);
      const std::vector<std::int32_t> xy = random_triangles(preset.config, 60);
      ASSERT_EQ(hs_push_triangles(model, xy.data(), 60, 7, nullptr), HS_OK);

      CycleModel twin({150, 130, Cull::kBack}, preset.config, Stalls(stall, 5));
      Listener expected;
      for (std::size_t i = 0; i < 60; ++i) {
        twin.draw(triangle_at(xy, i, 7 + static_cast<std::uint32_t>(i)), expected);
      }
      const std::vector<hs_tile> tiles = pull_all(model);
      ASSERT_EQ(tiles.size(), expected.tiles.size()) << preset.name << " seed " << kSeed;
      ASSERT_GT(tiles.size(), 1000u);
      for (std::size_t i = 0; i < tiles.size(); ++i) {
        const auto& [clock, tile] = expected.tiles[i];
        EXPECT_EQ(tiles[i].x, tile.x);
        EXPECT_EQ(tiles[i].y, tile.y);
        EXPECT_EQ(tiles[i].tag, tile.tag);
        EXPECT_EQ(tiles[i].triangle + 7, tile.tag);
        EXPECT_EQ(tiles[i].clock, clock);
        EXPECT_EQ(tiles[i].samples, static_cast<std::uint32_t>(preset.config.samples));
        EXPECT_EQ(std::memcmp(tiles[i].mask, tile.mask.data(), sizeof tiles[i].mask), 0);
      }
      std::vector<hs_triangle_clocks> clocks(60);
      ASSERT_EQ(hs_read_triangle_clocks(model, 0, 60, clocks.data()), HS_OK);
      for (std::size_t i = 0; i < 60; ++i) {
        EXPECT_EQ(clocks[i].accepted, expected.clocks[i].accepted) << i;
        EXPECT_EQ(clocks[i].setup, expected.clocks[i].setup) << i;
      }
      hs_stats stats{};
      stats.struct_size = sizeof stats;
      ASSERT_EQ(hs_get_stats(model, &stats), HS_OK);
      EXPECT_EQ(stats.cycles, twin.clocks());
      EXPECT_EQ(stats.tiles_visited, twin.stats().tiles_visited);
      EXPECT_EQ(stats.triangles_culled, twin.stats().triangles_culled);
    }
  }
}

// The picture is the last fragment that passed at each pixel: one sample, no blending.
TEST(Capi, PictureIsWhatTheFragmentsLeft) {
  const Handle model("full");
  hs_frame frame = frame_of(96, 64, HS_FRAGMENTS | HS_PICTURE);
  frame.background[1] = 9;
  ASSERT_EQ(hs_begin_frame(model, &frame), HS_OK);
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> position(-1.2, 1.2);
  for (std::uint32_t tag = 0; tag < 40; ++tag) {
    hs_clip_vertex v[3] = {};
    for (hs_clip_vertex& vertex : v) {
      vertex.position[3] = 1.5 + position(random) / 2;
      for (int i = 0; i < 3; ++i) vertex.position[i] = position(random) * vertex.position[3];
      for (int i = 0; i < 3; ++i) vertex.value[i] = 100 * (1 + position(random));
    }
    ASSERT_EQ(hs_push_clip(model, v, tag), HS_OK);
  }
  std::vector<std::uint8_t> expected(96 * 64 * 3);
  for (std::size_t i = 1; i < expected.size(); i += 3) expected[i] = 9;
  std::vector<std::uint32_t> expected_depth(96 * 64, (1u << 24) - 1);
  std::uint64_t fragments = 0;
  std::vector<hs_fragment> part(1000);
  std::size_t count = 0;
  while (hs_pull_fragments(model, part.data(), part.size(), &count) == HS_OK) {
    for (std::size_t i = 0; i < count; ++i, ++fragments) {
      const auto at = static_cast<std::size_t>(part[i].y * 96 + part[i].x);
      EXPECT_EQ(part[i].covered, 1);
      EXPECT_EQ(part[i].passed, 1);
      EXPECT_LT(part[i].depth[0], expected_depth[at]) << "of two the nearer passes";
      expected_depth[at] = part[i].depth[0];
      std::memcpy(&expected[3 * at], part[i].color, 3);
    }
  }
  hs_stats stats{};
  stats.struct_size = sizeof stats;
  ASSERT_EQ(hs_get_stats(model, &stats), HS_OK);
  EXPECT_EQ(fragments, stats.fragments_shaded);
  EXPECT_GT(fragments, 1000u);
  EXPECT_EQ(stats.triangles_in, 40u);
  std::vector<std::uint8_t> color(expected.size());
  std::vector<std::uint32_t> depth(expected_depth.size());
  ASSERT_EQ(hs_read_color(model, color.data(), color.size()), HS_OK);
  ASSERT_EQ(hs_read_depth(model, depth.data(), depth.size()), HS_OK);
  EXPECT_EQ(color, expected);
  EXPECT_EQ(depth, expected_depth);
}

// Covered samples of each pixel, by tag, from the tiles' masks.
using Samples = std::map<std::pair<int, int>, unsigned>;
std::array<Samples, 2> covered_samples(const std::vector<hs_tile>& tiles) {
  std::array<Samples, 2> out;
  for (const hs_tile& tile : tiles) {
    for (int lane = 0; lane < 64; ++lane) {
      for (unsigned m = 0; m < 4; ++m) {
        if ((tile.mask[m] >> lane & 1) == 0) continue;
        out.at(tile.tag)[{tile.x + lane % 8, tile.y + lane / 8}] |= 1u << m;
      }
    }
  }
  return out;
}

// Two triangles of equal depth: of the second pass the samples that the first does not have.
TEST(Capi, FragmentsNameTheSamplesThatPassed) {
  const Handle model("msaa4");
  const hs_frame frame = frame_of(32, 32, HS_TILES | HS_FRAGMENTS);
  ASSERT_EQ(hs_begin_frame(model, &frame), HS_OK);
  const double first[6] = {1.3, 2.2, 30.1, 7.9, 9.4, 28.6};
  const double second[6] = {0, 0, 32, 0, 3, 32};
  ASSERT_EQ(hs_push_triangle_px(model, first, 0), HS_OK);
  ASSERT_EQ(hs_push_triangle_px(model, second, 1), HS_OK);
  auto covered = covered_samples(pull_all(model));
  std::vector<hs_fragment> fragment(2000);
  std::size_t count = 0;
  ASSERT_EQ(hs_pull_fragments(model, fragment.data(), fragment.size(), &count), HS_OK);
  std::array<std::size_t, 2> fragments{};
  int partly = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const hs_fragment& f = fragment[i];
    const unsigned hidden = f.tag == 1 ? covered[0][{f.x, f.y}] : 0u;
    EXPECT_EQ(f.covered, (covered.at(f.tag)[{f.x, f.y}]));
    EXPECT_EQ(f.passed, f.covered & ~hidden);
    partly += f.passed != f.covered ? 1 : 0;
    ++fragments.at(f.tag);
    for (unsigned m = 0; m < 16; ++m) EXPECT_EQ(f.depth[m] != 0, (f.passed >> m & 1) != 0);
  }
  EXPECT_EQ(static_cast<std::ptrdiff_t>(fragments[0]),
            std::count_if(covered[0].begin(), covered[0].end(),
                          [](const auto& pixel) { return pixel.second != 0; }));
  EXPECT_GT(partly, 10);
}

TEST(Capi, CrcIsThatOfTheHitsRead) {
  const Handle model("tiny");
  const hs_frame frame = frame_of(300, 200, HS_COUNTS);
  ASSERT_EQ(hs_begin_frame(model, &frame), HS_OK);
  const std::vector<std::int32_t> xy = random_triangles(kTiny, 300);
  ASSERT_EQ(hs_push_triangles(model, xy.data(), 300, 0, nullptr), HS_OK);
  std::vector<std::uint8_t> hits(300 * 200);
  ASSERT_EQ(hs_read_hits(model, hits.data(), hits.size()), HS_OK);
  HitCount expected(300, 200);
  RasterStats unused;
  for (std::size_t i = 0; i < 300; ++i) {
    rasterize(triangle_at(xy, i, 0), {300, 200, Cull::kNone}, kTiny, unused,
              [&](const CoverageTile& tile) { expected.add(tile, kTiny); });
  }
  EXPECT_EQ(hits, expected.count());
  EXPECT_EQ(capi_test::crc_of(model), ::crc32(0, hits.data(), static_cast<uInt>(hits.size())));
}

TEST(Capi, OneByOneTogetherAndInPixelsDrawTheSame) {
  const std::vector<std::int32_t> xy = random_triangles(kFull, 50);
  const hs_frame frame = frame_of(200, 200, HS_TILES);
  std::vector<std::vector<hs_tile>> all;
  for (int way = 0; way < 3; ++way) {
    const Handle model("full");
    ASSERT_EQ(hs_begin_frame(model, &frame), HS_OK);
    if (way == 0) {
      ASSERT_EQ(hs_push_triangles(model, xy.data(), 50, 0, nullptr), HS_OK);
    }
    for (std::uint32_t i = 0; way > 0 && i < 50; ++i) {
      double px[6];
      for (std::size_t k = 0; k < 6; ++k) px[k] = xy[6 * i + k] / 256.0;
      ASSERT_EQ(
          way == 1 ? hs_push_triangle(model, &xy[6 * i], i) : hs_push_triangle_px(model, px, i),
          HS_OK);
    }
    all.push_back(pull_all(model));
  }
  ASSERT_GT(all[0].size(), 100u);
  for (int way = 1; way < 3; ++way) {
    ASSERT_EQ(all[static_cast<std::size_t>(way)].size(), all[0].size());
    EXPECT_EQ(std::memcmp(all[static_cast<std::size_t>(way)].data(), all[0].data(),
                          all[0].size() * sizeof(hs_tile)),
              0);
  }
}

TEST(Capi, ResetStartsTheSameFrameAgain) {
  const Handle model("full");
  const hs_frame frame = frame_of(64, 64, HS_TILES);
  ASSERT_EQ(hs_begin_frame(model, &frame), HS_OK);
  const std::int32_t xy[6] = {0, 0, 10000, 300, 200, 9000};
  ASSERT_EQ(hs_push_triangle(model, xy, 3), HS_OK);
  const std::vector<hs_tile> first = pull_all(model);
  ASSERT_EQ(hs_push_triangle(model, xy, 3), HS_OK);
  ASSERT_EQ(hs_reset(model), HS_OK);
  EXPECT_TRUE(pull_all(model).empty());
  ASSERT_EQ(hs_push_triangle(model, xy, 3), HS_OK);
  const std::vector<hs_tile> again = pull_all(model);
  ASSERT_EQ(again.size(), first.size());
  EXPECT_EQ(std::memcmp(again.data(), first.data(), first.size() * sizeof(hs_tile)), 0);
}

TEST(Capi, TagsOfManyTrianglesWrapAtTheirWidth) {
  const Handle model(R"({"preset": "full", "tag_bits": 2})", Handle::kJson);
  const hs_frame frame = frame_of(64, 64, HS_TILES);
  ASSERT_EQ(hs_begin_frame(model, &frame), HS_OK);
  const std::vector<std::int32_t> xy{0, 0, 900, 0, 0, 900, 0, 0, 900, 0, 0, 900};
  ASSERT_EQ(hs_push_triangles(model, xy.data(), 2, 3, nullptr), HS_OK);
  const std::vector<hs_tile> tiles = pull_all(model);
  ASSERT_EQ(tiles.size(), 2u);
  EXPECT_EQ(tiles[0].tag, 3u);
  EXPECT_EQ(tiles[1].tag, 0u);
  EXPECT_EQ(tiles[1].triangle, 1u);
}

TEST(Capi, StallFunctionsAreThePatternOfTheModel) {
  const Stalls stalls(0.3, 99);
  for (std::uint64_t i = 0; i < 2000; ++i) {
    EXPECT_EQ(hs_stall_gap(0.3, 99, i), stalls.gap(i));
    EXPECT_EQ(hs_stall_ready(0.3, 99, i) != 0, stalls.ready(i));
  }
  EXPECT_EQ(hs_stall_ready(1.0, 99, 1), 1) << "never ready would wait for ever";
}

TEST(Capi, ModelsOfDifferentThreadsDoNotDisturbEachOther) {
  std::array<std::uint32_t, 4> crc{};
  std::vector<std::thread> threads;
  for (std::uint32_t& result : crc) {
    threads.emplace_back([&result] {
      const Handle model("full");
      const hs_frame frame = frame_of(320, 240, HS_COUNTS);
      hs_begin_frame(model, &frame);
      hs_draw_scene(model, HALFSPACE_TEST_DIR "/scenes/teapot.obj", nullptr);
      const std::int32_t beyond[6] = {INT32_MAX};
      hs_push_triangle(model, beyond, 0);
      if (std::string(hs_last_error()).find("2147483647") != std::string::npos) {
        result = capi_test::crc_of(model);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_NE(crc[0], 0u);
  for (const std::uint32_t result : crc) EXPECT_EQ(result, crc[0]);
}

}  // namespace
}  // namespace halfspace
