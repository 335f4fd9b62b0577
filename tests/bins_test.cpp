// SPDX-License-Identifier: Apache-2.0
#include "vectors/bins.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "samples.hpp"
#include "vectors/goal.hpp"

namespace halfspace {
namespace {

constexpr std::uint64_t kSeed = 20;

std::set<std::string> hit_names(const Config& config, const FrameState& frame,
                                const std::vector<Triangle>& triangles) {
  const BinModel model(config);
  BinSet hits = model.none();
  model.sample(frame, triangles, hits);
  std::set<std::string> names;
  for (std::size_t i = 0; i < model.bins().size(); ++i) {
    if (hits.has(i)) names.insert(model.bins()[i].name);
  }
  return names;
}

Triangle in_pixels(std::array<double, 6> v, const Config& config) {
  return {{snap_px(v[0], v[1], config), snap_px(v[2], v[3], config), snap_px(v[4], v[5], config)},
          0};
}

TEST(Bins, AQuadOnPixelCentresHitsItsTies) {
  const FrameState frame{64, 64, Cull::kNone};
  const auto names = hit_names(kTiny, frame,
                               {in_pixels({1.5, 1.5, 9.5, 1.5, 9.5, 9.5}, kTiny),
                                in_pixels({1.5, 1.5, 9.5, 9.5, 1.5, 9.5}, kTiny)});
  for (const char* name :
       {"tie.shared.SW", "tie.edge.S", "tie.edge.W", "tie.edge.SW", "tie.edge.NE", "tie.edge.E",
        "tie.edge.N", "tie.vertex1.lost", "cull.none.cw"}) {
    EXPECT_EQ(names.count(name), 1u) << name;
  }
  EXPECT_EQ(names.count("tie.edge.SE"), 0u);
}

TEST(Bins, OneLaneRowAndColumnAreTold) {
  const FrameState frame{64, 64, Cull::kNone};
  EXPECT_EQ(hit_names(kTiny, frame, {in_pixels({5.25, 6.25, 5.75, 6.25, 5.5, 6.75}, kTiny)})
                .count("mask.lane9"),
            1u);
  EXPECT_EQ(
      hit_names(kTiny, frame, {in_pixels({4, 6.25, 30, 6.25, 30, 6.75}, kTiny)}).count("mask.row2"),
      1u);
  EXPECT_EQ(hit_names(kTiny, frame, {in_pixels({5.25, 4, 5.75, 30, 5.25, 30}, kTiny)})
                .count("mask.column1"),
            1u);
}

TEST(Bins, ATileCutByTwoEdgesCountsForNeither) {
  // Tile (0, 0) is cut by edge 0 alone, tile (4, 0) by edges 0 and 2.
  const auto names =
      hit_names(kTiny, {8, 4, Cull::kNone}, {in_pixels({0, 0, 40, 20, 40, 4}, kTiny)});
  const auto cuts = [&names](const std::string& prefix) {
    return std::count_if(names.begin(), names.end(),
                         [&](const std::string& name) { return name.starts_with(prefix); });
  };
  EXPECT_EQ(cuts("cut.edge0"), 1);
  EXPECT_EQ(cuts("cut.edge1"), 0);
  EXPECT_EQ(cuts("cut.edge2"), 0);
}

TEST(Bins, AnAreaOfOneBitHasABinOfItsOwn) {
  const auto bits = [](const std::array<double, 6>& v) {
    std::set<std::string> found;
    for (const std::string& name : hit_names(kFull, {64, 64, Cull::kNone}, {in_pixels(v, kFull)})) {
      if (name.starts_with("area.") || name.starts_with("width.area.")) found.insert(name);
    }
    return found;
  };
  using Names = std::set<std::string>;
  EXPECT_EQ(bits({8, 8, 10, 8, 8, 10}), Names{"area.bit18"});  // 2^9 x 2^9 subpixels
  EXPECT_EQ(bits({8, 8, 8, 40, 24, 8}), Names{"area.bit25"});  // 2^13 x 2^12, the other way
  EXPECT_EQ(bits({0, 0, 12, 4, 4, 12}), Names{"area.bit23"});  // 8 x 2^10 x 2^10
  EXPECT_EQ(bits({8, 8, 14, 8, 8, 10}), Names{});              // 6 x 2 px: two bits
  EXPECT_EQ(bits({8, 8, 10, 8, 8, 9}), Names{});               // 2 x 1 px: too small for a bin
  EXPECT_EQ(bits({70, 8, 72, 8, 70, 10}), Names{});            // beyond the frame: not seen
  EXPECT_EQ(last_area_bit(kFull), 43);
  EXPECT_EQ(last_area_bit(kTiny), 2 * (kTiny.viewport_bits + kTiny.subpixel_bits));
}

// Where a bin is unreachable and where it is not.
TEST(Bins, ReasonsFollowTheConfiguration) {
  const auto reasons = [](const Config& config) {
    std::set<std::string> names;
    const BinModel model(config);
    for (const Bin& bin : model.bins()) {
      if (!bin.reason.empty()) names.insert(bin.name);
    }
    return names;
  };
  const auto tiny = reasons(kTiny), full = reasons(kFull), msaa4 = reasons(kMsaa4);
  EXPECT_EQ(tiny.count("mask.lacks.lane1"), 1u);
  EXPECT_EQ(tiny.count("mask.lacks.lane4"), 1u);
  EXPECT_EQ(tiny.count("mask.lacks.lane3"), 0u);
  EXPECT_EQ(tiny.count("mask.lacks.lane0"), 0u);
  EXPECT_EQ(tiny.count("box.cut.left"), 1u);
  EXPECT_EQ(full.count("box.cut.left"), 0u);
  EXPECT_EQ(full.count("cut.edge0.E"), 1u);
  // Of four samples the first, at (6, 2) / 16, is the topmost and neither leftmost nor rightmost.
  EXPECT_EQ(msaa4.count("cut.edge0.E"), 0u);
  EXPECT_EQ(msaa4.count("cut.edge0.W"), 0u);
  EXPECT_EQ(msaa4.count("cut.edge0.S"), 0u);
  EXPECT_EQ(msaa4.count("cut.edge0.N"), 1u);
}

// Every triangle with vertices on the lattice, frames of several sizes.
void exhaust(const Config& config, const std::vector<FrameState>& frames) {
  const BinModel model(config);
  BinSet hits = model.none();
  std::vector<Point> points;
  for (std::int64_t y = config.coordinate_min(); y <= config.coordinate_max(); ++y) {
    for (std::int64_t x = config.coordinate_min(); x <= config.coordinate_max(); ++x) {
      points.push_back({static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)});
    }
  }
  for (const FrameState& frame : frames) {
    for (std::size_t a = 0; a < points.size(); ++a) {
      for (std::size_t b = a; b < points.size(); ++b) {
        for (std::size_t c = b; c < points.size(); ++c) {
          const std::array<Triangle, 2> both{
              {{{points[a], points[b], points[c]}, 0}, {{points[a], points[c], points[b]}, 0}}};
          model.sample(frame, both, hits);
        }
      }
    }
  }
  std::size_t claimed = 0;
  for (std::size_t i = 0; i < model.bins().size(); ++i) {
    const Bin& bin = model.bins()[i];
    claimed += bin.reason.empty() ? 0u : 1u;
    EXPECT_FALSE(hits.has(i) && !bin.reason.empty()) << bin.name << ": " << bin.reason;
  }
  EXPECT_GT(claimed, 10u);
  EXPECT_GT(hits.count(), model.reachable() / 3);
}

TEST(Bins, NoTriangleOfASmallLatticeHitsAnUnreachableBin) {
  Config config{.subpixel_bits = 0, .viewport_bits = 3, .guard_bits = 0, .grid_log2 = 2};
  exhaust(config, {{8, 8, Cull::kNone}, {1, 1, Cull::kNone}, {5, 3, Cull::kNone}});
  config.samples = 2;
  exhaust(config, {{8, 8, Cull::kNone}, {3, 5, Cull::kNone}});
  // Samples 9 and 12 lie on whole pixels in one direction, so ties along both axes exist.
  config.samples = 16;
  exhaust(config, {{8, 8, Cull::kNone}});
  config.samples = 1;
  config.guard_bits = 3;
  exhaust(config, {{4, 4, Cull::kNone}});
  config = {.subpixel_bits = 1, .viewport_bits = 3, .guard_bits = 0, .grid_log2 = 3};
  exhaust(config, {{8, 3, Cull::kNone}});
}

// Ties of every configuration that samples and subpixels make, against the samples themselves.
TEST(Bins, TiesAreReachableWhereASampleLiesOnTheLattice) {
  for (const int samples : {1, 2, 4, 8, 16}) {
    for (int bits = 0; bits <= 4; ++bits) {
      const BinModel model({.subpixel_bits = bits, .viewport_bits = 9, .samples = samples});
      const int step = 16 >> bits;
      std::set<std::string> on_line;
      bool on_point = false;
      for (const SamplePosition p : sample_positions(samples)) {
        if (p.x % step == 0) on_line.insert({"E", "W"});
        if (p.y % step == 0) on_line.insert({"S", "N"});
        if ((p.x + p.y) % step == 0) on_line.insert({"SE", "NW"});
        if ((p.x - p.y) % step == 0) on_line.insert({"SW", "NE"});
        on_point = on_point || (p.x % step == 0 && p.y % step == 0);
      }
      for (const Bin& bin : model.bins()) {
        const std::string wind = bin.name.substr(bin.name.rfind('.') + 1);
        if (bin.name.starts_with("tie.vertex")) {
          EXPECT_EQ(bin.reason.empty(), on_point) << bin.name << " " << samples << " " << bits;
        } else if (bin.name.starts_with("tie.")) {
          EXPECT_EQ(bin.reason.empty(), wind.size() == 3 || on_line.count(wind) == 1)
              << bin.name << " " << samples << " " << bits;
        }
      }
    }
  }
}

TEST(Goal, AMinimalSetHitsWhatTheSearchHit) {
  const BinModel model(kTiny);
  const auto units = search_goal(model, 1.0, 2, 20000, kSeed, [](std::size_t) {});
  BinSet searched = model.none();
  std::vector<std::size_t> met(model.bins().size());
  for (const SampledUnit& unit : units) searched.add(unit.hits);
  for (const std::size_t times : {1u, 2u}) {
    const auto chosen = minimal_units(units, times, model);
    BinSet kept = model.none();
    std::fill(met.begin(), met.end(), 0u);
    for (const SampledUnit& unit : chosen) {
      kept.add(unit.hits);
      for (std::size_t i = 0; i < met.size(); ++i) met[i] += unit.hits.has(i) ? 1u : 0u;
    }
    EXPECT_EQ(kept.count(), searched.count());
    EXPECT_EQ(kept.count_common(searched), searched.count());
    EXPECT_LT(chosen.size(), units.size() / 2);
    // Every unit is needed by some bin.
    for (const SampledUnit& unit : chosen) {
      bool needed = false;
      for (std::size_t i = 0; i < met.size(); ++i) needed |= unit.hits.has(i) && met[i] <= times;
      EXPECT_TRUE(needed);
    }
  }
}

TEST(Goal, TheSameSeedGivesTheSameTriangles) {
  const BinModel model(kMsaa4);
  const auto draw = [&](std::uint64_t seed) {
    const auto units = search_goal(model, 0.5, 1, 3000, seed, [](std::size_t) {});
    return by_frame(minimal_units(units, 1, model), true, kMsaa4);
  };
  const auto first = draw(3), second = draw(3), other = draw(4);
  ASSERT_EQ(first.size(), second.size());
  bool differs = first.size() != other.size();
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_TRUE(first[i].triangles == second[i].triangles);
    differs = differs || !(first[i].triangles == other[i].triangles);
  }
  EXPECT_TRUE(differs);
}

}  // namespace
}  // namespace halfspace
