// SPDX-License-Identifier: Apache-2.0
//
// Level auto: the interval holds the clocks of level cycle as often as it says, and less is run.
#include "fit/estimate.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engines/cycle/cycle_engine.hpp"
#include "fit/replay.hpp"
#include "scene/scene.hpp"
#include "vectors/generators.hpp"

namespace halfspace {
namespace {

struct Work {
  const char* name;
  std::vector<Triangle> triangles;
  FrameState frame;
  Config config;
};

Work scene_work(const char* name, const char* file, int width, int height, const Config& config) {
  Work out{name, {}, {width, height, Cull::kNone}, config};
  const auto scene = open_scene(std::string(HALFSPACE_TEST_DIR) + "/scenes/" + file, -1,
                                {width, height}, {}, Lighting::kFlat);
  RunStats stats;
  scene->draw(0, out.frame, config, stats,
              [&](const ShadedTriangle& t) { out.triangles.push_back(t.triangle); });
  return out;
}

// Triangles whose size drifts along the stream and jumps at random.
Work generated(const char* name, std::uint64_t seed, int count, const Config& config) {
  Work out{name, {}, {512, 512, Cull::kNone}, config};
  Random random(seed);
  for (int i = 0; i < count; ++i) {
    const std::int64_t jump = random.in(0, 9) == 0 ? 6 : 1;
    const std::int64_t size = (4 + 20 * i / count) * jump << config.subpixel_bits;
    const std::int64_t limit = (512 << config.subpixel_bits) - size;
    const std::int64_t x = random.in(0, limit), y = random.in(0, limit);
    Triangle t;
    for (Point& p : t.vertex) {
      p = {static_cast<std::int32_t>(x + random.in(0, size)),
           static_cast<std::int32_t>(y + random.in(0, size))};
    }
    out.triangles.push_back(t);
  }
  return out;
}

std::uint64_t clocks_of(const Work& work) {
  CycleEngine engine(work.frame, work.config, Stalls());
  engine.run(work.triangles, [](const CycleChunk&) {});
  return engine.clocks();
}

Config interval3() {
  Config config = kFull;
  config.setup_interval = 3;
  return config;
}

TEST(Estimate, IntervalHoldsTheClocksOfTheFullRunForMostSeeds) {
  const std::vector<Work> all{scene_work("bunny", "bunny.obj", 1920, 1080, kFull),
                              scene_work("bunny, interval 3", "bunny.obj", 640, 480, interval3()),
                              generated("mixed", 5, 20'000, kFull),
                              generated("mixed, four samples", 6, 8'000, kMsaa4),
                              generated("mixed, interval 3", 7, 20'000, interval3())};
  int inside_all = 0, seeds_all = 0;
  for (const Work& work : all) {
    const auto clocks = static_cast<double>(clocks_of(work));
    int inside = 0, exact = 0;
    double width = 0;
    std::uint64_t run = 0;
    constexpr int kSeeds = 40;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      const ClockEstimate e = estimate_clocks(work.triangles, work.frame, work.config, seed);
      inside += e.low <= clocks && clocks <= e.high ? 1 : 0;
      exact += e.exact ? 1 : 0;
      width += (e.high - e.low) / 2 / clocks / kSeeds;
      run += e.triangles_at_cycle;
    }
    std::printf(
        "%s: %.0f clocks, %d of %d intervals hold them, half width %.2f %%, %.1f times "
        "fewer triangles, %d exact\n",
        work.name, clocks, inside, kSeeds, 100 * width,
        static_cast<double>(kSeeds * work.triangles.size()) / static_cast<double>(run), exact);
    EXPECT_GE(inside, kSeeds * 8 / 10) << work.name;
    EXPECT_LT(width, 0.1) << work.name;
    inside_all += inside;
    seeds_all += kSeeds;
  }
  EXPECT_GE(inside_all, seeds_all * 9 / 10);
}

TEST(Estimate, SmallFramesAreRunWholeAndExactly) {
  const Work teapot = scene_work("teapot", "teapot.obj", 320, 240, kFull);
  const ClockEstimate e = estimate_clocks(teapot.triangles, teapot.frame, teapot.config, 1);
  EXPECT_TRUE(e.exact);
  EXPECT_EQ(e.clocks, static_cast<double>(clocks_of(teapot)));
  EXPECT_EQ(e.low, e.high);
  EXPECT_EQ(estimate_clocks({}, teapot.frame, teapot.config, 1).clocks, 0);
}

TEST(Estimate, SameSeedSameAnswerAndSeedsDiffer) {
  const Work work = generated("mixed", 9, 20'000, kFull);
  const auto at = [&](std::uint64_t seed) {
    return estimate_clocks(work.triangles, work.frame, work.config, seed).clocks;
  };
  EXPECT_EQ(at(1), at(1));
  EXPECT_NE(at(1), at(2));
}

TEST(Estimate, StretchesAreInTheStreamSpreadAndShort) {
  const Work large = generated("mixed", 5, 20'000, kFull);
  const Work small = scene_work("teapot", "teapot.obj", 320, 240, kFull);
  for (const Work* work : {&large, &small}) {
    const ClockEstimate e = estimate_clocks(work->triangles, work->frame, work->config, 1);
    ASSERT_EQ(e.stretches.size(), 12u) << work->name;
    EXPECT_EQ(e.stretches.front().begin, 0u) << work->name;
    EXPECT_GT(e.stretches.back().begin, work->triangles.size() / 2) << work->name;
    std::size_t before = 0;
    for (const ClockEstimate::Stretch& s : e.stretches) {
      EXPECT_GE(s.begin, before) << work->name;
      EXPECT_LT(s.begin, s.end) << work->name;
      EXPECT_LE(s.end, work->triangles.size()) << work->name;
      before = s.begin;
    }
  }
  EXPECT_TRUE(estimate_clocks({}, small.frame, small.config, 1).stretches.empty());
}

// Every triangle covers the frame: 4096 leaf tiles, more than a stretch may have.
TEST(Estimate, AStretchEndsWhereItsWorkDoes) {
  Work work = generated("large", 1, 40, kFull);
  for (Triangle& t : work.triangles) t.vertex = {Point{0, 0}, {262'144, 0}, {0, 262'144}};
  const ClockEstimate e = estimate_clocks(work.triangles, work.frame, work.config, 1);
  ASSERT_EQ(e.stretches.size(), 10u);  // windows of four
  for (const ClockEstimate::Stretch& s : e.stretches) EXPECT_EQ(s.end - s.begin, 1u);
}

ClockEstimate with_stretches(int count) {
  ClockEstimate e;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    e.stretches.push_back({3 * i, 3 * i + 2});
  }
  return e;
}

TEST(Replay, CountsWhatTheRtlConfirms) {
  const Work work = generated("mixed", 5, 100, kFull);
  RunStats::Prediction::Rtl rtl;
  std::size_t at = 0;
  replay_stretches(
      with_stretches(4), work.triangles,
      [&](std::span<const Triangle> some) {
        EXPECT_EQ(some.data(), work.triangles.data() + 3 * at++);
        EXPECT_EQ(some.size(), 2u);
        return RtlAgreement{100, 7, ""};
      },
      rtl);
  EXPECT_EQ(at, 4u);
  EXPECT_TRUE(rtl.available);
  EXPECT_EQ(rtl.windows, 4u);
  EXPECT_EQ(rtl.clocks, 400u);
  EXPECT_EQ(rtl.packets, 28u);
  EXPECT_EQ(rtl.mismatch, "");
}

TEST(Replay, StopsAtTheFirstDifferenceAndSaysWhere) {
  const Work work = generated("mixed", 5, 100, kFull);
  RunStats::Prediction::Rtl rtl;
  int runs = 0;
  const RtlReplay replay = [&](std::span<const Triangle>) {
    return RtlAgreement{100, 7, ++runs == 2 ? "mismatch: field=e0" : ""};
  };
  replay_stretches(with_stretches(4), work.triangles, replay, rtl);
  EXPECT_EQ(runs, 2);
  EXPECT_EQ(rtl.mismatch, "triangles 3 to 4, counted from 3: mismatch: field=e0");
  replay_stretches(with_stretches(4), work.triangles, replay, rtl);  // of the next frame
  EXPECT_EQ(runs, 2);
}

TEST(Replay, WithoutTheRtlNothingIsConfirmed) {
  const Work work = generated("mixed", 5, 100, kFull);
  RunStats::Prediction::Rtl rtl;
  replay_stretches(
      with_stretches(4), work.triangles,
      [](std::span<const Triangle>) { return std::optional<RtlAgreement>(); }, rtl);
  EXPECT_FALSE(rtl.available);
  EXPECT_EQ(rtl.windows, 0u);
}

TEST(Replay, EndsWhenItHasRunEnough) {
  const Work work = generated("mixed", 5, 100, kFull);
  RunStats::Prediction::Rtl rtl;
  int runs = 0;
  for (int frame = 0; frame < 10; ++frame) {
    replay_stretches(
        with_stretches(4), work.triangles,
        [&](std::span<const Triangle>) {
          ++runs;
          return RtlAgreement{kReplayClocks / 6, 7, ""};
        },
        rtl);
  }
  EXPECT_EQ(runs, 7);
}

}  // namespace
}  // namespace halfspace
