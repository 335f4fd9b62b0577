// SPDX-License-Identifier: Apache-2.0
//
// The cycle engine against CycleModel: every packet, every clock, every count, on every instruction
// set this machine has.
#include "engines/cycle/cycle_engine.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "cycle_model.hpp"
#include "rtl/rtl_configs.hpp"
#include "vectors/generators.hpp"

namespace halfspace {
namespace {

// A packet of any link, in the order in which the listener was called.
struct Event {
  int link = 0;  // 0 accepted, 1 setup, 2 node, 3 tile
  std::uint64_t clock = 0;
  int level = 0;
  SetupTriangle setup;
  Node node;
  CoverageTile tile;
  bool operator==(const Event&) const = default;
};

struct Everything {
  std::vector<Event> event;
  void accepted(std::uint64_t clock) { push(0, clock); }
  void setup(std::uint64_t clock, const SetupTriangle& packet) { push(1, clock).setup = packet; }
  void node(int level, std::uint64_t clock, const Node& packet) {
    Event& out = push(2, clock);
    out.level = level;
    out.node = packet;
  }
  void tile(std::uint64_t clock, const CoverageTile& packet) { push(3, clock).tile = packet; }

 protected:
  Event& push(int link, std::uint64_t clock) {
    event.emplace_back();
    event.back().link = link;
    event.back().clock = clock;
    return event.back();
  }
};

struct WithoutNodes : Everything {
  static constexpr bool kWantsNodes = false;
};

std::string text(const Event& e) {
  return "link " + std::to_string(e.link) + " clock " + std::to_string(e.clock) + " level " +
         std::to_string(e.level) + " node (" + std::to_string(e.node.x) + "," +
         std::to_string(e.node.y) + ") tile (" + std::to_string(e.tile.x) + "," +
         std::to_string(e.tile.y) + ") mask[0] " + std::to_string(e.tile.mask[0]) + " tag " +
         std::to_string(e.tile.tag);
}

void expect_same(const std::vector<Event>& model, const std::vector<Event>& engine,
                 bool skip_nodes) {
  std::size_t at = 0;
  for (const Event& expected : model) {
    if (skip_nodes && expected.link == 2) continue;
    ASSERT_LT(at, engine.size());
    ASSERT_TRUE(expected == engine[at])
        << "event " << at << "\nmodel  " << text(expected) << "\nengine " << text(engine[at]);
    ++at;
  }
  EXPECT_EQ(at, engine.size());
}

void expect_same(const RasterStats& model, const RasterStats& engine) {
  EXPECT_EQ(model.triangles, engine.triangles);
  EXPECT_EQ(model.triangles_zero_area, engine.triangles_zero_area);
  EXPECT_EQ(model.triangles_culled, engine.triangles_culled);
  EXPECT_EQ(model.triangles_no_sample, engine.triangles_no_sample);
  EXPECT_EQ(model.traversal.nodes, engine.traversal.nodes);
  EXPECT_EQ(model.tiles_visited, engine.tiles_visited);
  EXPECT_EQ(model.tiles_covered, engine.tiles_covered);
  EXPECT_EQ(model.samples_tested, engine.samples_tested);
  EXPECT_EQ(model.samples_covered, engine.samples_covered);
  EXPECT_EQ(model.fragments, engine.fragments);
}

// One stream through the model and through every kernel, with nodes, without, in pieces.
void compare(std::vector<Triangle> triangles, const FrameState& frame, const Config& config,
             const Stalls& stalls) {
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    triangles[i].tag = static_cast<std::uint32_t>(i);
  }
  CycleModel model(frame, config, stalls);
  Everything expected;
  for (const Triangle& triangle : triangles) model.draw(triangle, expected);
  for (const std::string_view isa : cycle_isas()) {
    SCOPED_TRACE(std::string(isa));
    CycleEngine all(frame, config, stalls, isa);
    Everything with;
    all.draw(triangles, with);
    expect_same(expected.event, with.event, false);
    expect_same(model.stats(), all.stats());
    EXPECT_EQ(model.clocks(), all.clocks());

    CycleEngine fast(frame, config, stalls, isa);
    WithoutNodes without;
    fast.draw(triangles, without);
    expect_same(expected.event, without.event, true);
    expect_same(model.stats(), fast.stats());
    EXPECT_EQ(model.clocks(), fast.clocks());
    if (::testing::Test::HasFatalFailure()) return;

    CycleEngine pieces(frame, config, stalls, isa);  // odd pieces, and both kinds of listener
    Random random(triangles.size());
    std::vector<Event> together;
    for (std::size_t done = 0; done < triangles.size();) {
      const auto size =
          std::min(triangles.size() - done, static_cast<std::size_t>(random.in(1, 100)));
      const std::span<const Triangle> piece(triangles.data() + done, size);
      Everything listener;
      WithoutNodes short_listener;
      const bool nodes = random.in(0, 3) == 0;
      nodes ? pieces.draw(piece, listener) : pieces.draw(piece, short_listener);
      for (const Event& event : nodes ? listener.event : short_listener.event) {
        if (event.link != 2) together.push_back(event);
      }
      done += size;
    }
    expect_same(expected.event, together, true);
    if (::testing::Test::HasFatalFailure()) return;
  }
}

struct Named {
  const char* name;
  Config config;
};
std::vector<Named> configurations() {
  std::vector<Named> out;
  for (const Preset& preset : kPresets) out.push_back({preset.name.data(), preset.config});
  out.push_back({"interval3", kTestInterval3});
  out.push_back({"samples16", kTestSamples16});
  out.push_back({"one_level", kTestOneLevel});
  out.push_back({"fitted", kTestFitted});
  out.push_back({"fitted_band", kTestFittedBand});
  out.push_back({"full, short edges", {.extent_bits = 5}});
  Config config = kFull;
  config.setup_interval = 3;
  out.push_back({"full, interval 3", config});
  config = kMsaa4;
  config.samples = 16;
  out.push_back({"16 samples", config});
  config = kFull;
  config.samples = 8;
  config.viewport_bits = 10;
  out.push_back({"8 samples, 4 levels", config});
  out.push_back({"wide lanes", {.subpixel_bits = 12, .viewport_bits = 15, .guard_bits = 16}});
  out.push_back({"32-bit lanes", {.subpixel_bits = 9, .viewport_bits = 15, .guard_bits = 16}});
  out.push_back({"whole pixels", {.subpixel_bits = 0, .viewport_bits = 6, .guard_bits = 6}});
  out.push_back({"one level", {.subpixel_bits = 8, .viewport_bits = 3, .guard_bits = 0}});
  return out;
}

// Frames that end inside a tile, at the edge of one, and where the viewport does.
std::vector<FrameState> frames(const Config& config) {
  const int most = std::min(config.max_size(), 512);
  return {{most, most, Cull::kNone}, {std::max(most - 5, 1), most / 2 + 1, Cull::kBack}};
}

Stalls stalls_of(int which) {
  return which == 0 ? Stalls() : which == 1 ? Stalls(0.1, 7) : Stalls(0.7, 9);
}

TEST(CycleEngine, Shapes) {
  for (const Named& named : configurations()) {
    SCOPED_TRACE(named.name);
    for (const FrameState& frame : frames(named.config)) {
      for (int which = 0; which < 3; ++which) {
        Random random(static_cast<std::uint64_t>(which) + 1);
        std::vector<Triangle> triangles;
        for (const Shape shape : kShapes) {
          const bool large =
              shape == Shape::kAnywhere || shape == Shape::kInFrame || shape == Shape::kExtreme;
          for (int i = 0; i < (large ? 1 : 16); ++i) {
            triangles.push_back(random_triangle(random, shape, frame, named.config));
          }
        }
        for (std::size_t i = triangles.size() - 1; i > 0; --i) {
          std::swap(triangles[i],
                    triangles[static_cast<std::size_t>(random.in(0, static_cast<int>(i)))]);
        }
        compare(triangles, frame, named.config, stalls_of(which));
        if (HasFatalFailure()) return;
      }
    }
  }
}

// Streams in which the free flow starts, goes on and stops: small triangles, now and then a larger.
TEST(CycleEngine, FreeFlow) {
  for (const Named& named : configurations()) {
    SCOPED_TRACE(named.name);
    const FrameState frame = frames(named.config)[0];
    for (const int seldom : {2, 5, 40, 1000}) {
      for (int which = 0; which < 2; ++which) {
        Random random(static_cast<std::uint64_t>(seldom));
        std::vector<Triangle> triangles;
        for (int i = 0; i < 400; ++i) {
          const Shape shape = random.in(1, seldom) == 1 ? Shape::kSmall : Shape::kTiny;
          triangles.push_back(random_triangle(random, shape, frame, named.config));
        }
        compare(triangles, frame, named.config, stalls_of(which));
        if (HasFatalFailure()) return;
      }
    }
  }
}

TEST(CycleEngine, Meshes) {
  for (const Named& named : configurations()) {
    if (named.config.extent_bits != 0) continue;  // cells and fans may be wider
    SCOPED_TRACE(named.name);
    const FrameState frame = frames(named.config)[1];
    const int size = std::min(named.config.max_size(), 128);
    for (const int cell : {4, 8, 24}) {
      const int step = named.config.subpixel_bits == 0 ? 1 : 1 << (named.config.subpixel_bits - 1);
      if (cell * (1 << named.config.subpixel_bits) % (4 * step) != 0 || cell > size) continue;
      std::vector<Triangle> mesh = jittered_mesh(5, size / cell * cell, cell, step, named.config);
      std::erase_if(mesh, [&](const Triangle& t) { return !within_extent(t, named.config); });
      compare(mesh, frame, named.config, stalls_of(cell == 24 ? 1 : 0));
      if (HasFatalFailure()) return;
    }
    std::vector<Triangle> slivers = fan(size / 2.0, size / 2.0, size / 2.0, 60, named.config);
    std::erase_if(slivers, [&](const Triangle& t) { return !within_extent(t, named.config); });
    compare(slivers, frame, named.config, stalls_of(0));
  }
}

// Two triangles over a whole frame, one-pixel triangles, and long chunks split in the middle.
TEST(CycleEngine, FullScreen) {
  for (const Config& config : {kFull, kMsaa4, kD3d}) {
    const FrameState frame{1000, 601, Cull::kNone};
    std::vector<Triangle> triangles;
    for (int i = 0; i < 2; ++i) {
      const Point p = snap_px(0, 0, config), q = snap_px(1000, 0, config);
      const Point r = snap_px(1000, 601, config), s = snap_px(0, 601, config);
      triangles.push_back({{p, q, r}, 0});
      triangles.push_back({{p, r, s}, 0});
      for (int x = 0; x < 50; ++x) {
        triangles.push_back(
            {{snap_px(x, x, config), snap_px(x + 1, x, config), snap_px(x + 1, x + 1, config)}, 0});
      }
      triangles.push_back(
          {{snap_px(-900, -900, config), snap_px(2900, -900, config), snap_px(-900, 2900, config)},
           0});
    }
    compare(triangles, frame, config, Stalls());
    if (HasFatalFailure()) return;
  }
}

TEST(CycleEngine, Widest) {
  for (const Named& named : configurations()) {
    if (named.config.max_size() > 1 << 12) continue;
    SCOPED_TRACE(named.name);
    const std::vector<Triangle> all = widest_triangles(named.config);
    std::vector<Triangle> some;
    for (std::size_t i = 0; i < all.size(); i += all.size() / 60 + 1) some.push_back(all[i]);
    const int side = std::min(named.config.max_size(), 100);
    compare(some, {side, side, Cull::kNone}, named.config, Stalls());
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace halfspace
