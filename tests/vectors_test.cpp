// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>

#include "bins.hpp"
#include "goal.hpp"
#include "io/error.hpp"
#include "io/vectors_format.hpp"
#include "io/vectors_meta.hpp"
#include "packets_of.hpp"
#include "stimulus.hpp"
#include "vector_builder.hpp"

#include <nlohmann/json.hpp>

namespace halfspace {
namespace {

constexpr std::uint64_t kSeed = 20;

VectorSet make_set(VectorStage stage, const Config& config, int triangles, std::uint32_t stall) {
  VectorMeta meta;
  meta.stage = stage;
  meta.config = config;
  meta.level = stage == VectorStage::kTileTraversal ? config.levels() - 2 : 0;
  meta.seed = kSeed;
  meta.program = "test";
  meta.source = "generator";
  VectorBuilder builder(meta);
  StimulusMaker stimulus(meta);
  Random random(kSeed);
  for (const FrameState frame :
       {FrameState{100, 70, Cull::kNone}, FrameState{31, 9, Cull::kBack}}) {
    stimulus.begin_frame(frame);
    builder.run(frame, stall, kSeed);
    for (int i = 0; i < triangles; ++i) {
      const Triangle triangle = random_triangle(
          random, kShapes[static_cast<std::size_t>(i) % kShapes.size()], frame, config);
      if (count_leaves(triangle, frame, config, 20) > 20) continue;
      stimulus.draw({triangle, random_attributes(random, config)},
                    [&builder](const Values& ports) { builder.add(ports); });
    }
  }
  return builder.finish();
}

std::vector<VectorStage> stages() {
  std::vector<VectorStage> all;
  for (int i = 0; i < kVectorStages; ++i) all.push_back(static_cast<VectorStage>(i));
  return all;
}

TEST(Vectors, EveryFormatGivesTheSetBack) {
  for (const Preset& preset : kPresets) {
    for (const VectorStage stage : stages()) {
      const VectorSet set = make_set(stage, preset.config, 12, 1u << 30);
      const std::string name = std::string(preset.name) + " " + std::string(stage_name(stage));
      EXPECT_GT(count_records(set).outputs, 0u) << name;
      const auto equal = [&](const VectorSet& read, const char* format) {
        EXPECT_EQ(read.meta, set.meta) << name << ' ' << format;
        EXPECT_TRUE(read.records == set.records) << name << ' ' << format;
      };
      equal(vectors_from_csv(vectors_to_csv(set), "x"), "csv");
      equal(vectors_from_json_lines(vectors_to_json_lines(set), "x"), "jsonl");
      equal(vectors_from_binary(vectors_to_binary(set), "x"), "binary");
      equal(vectors_from_hex(vectors_to_hex(set), vector_meta_json(set).dump(), "x"), "hex");
    }
  }
}

// Fields that the model answers: of the bookkeeping all but the stimulus, and whole outputs.
bool is_expected(const VectorRecord& record, std::size_t field, const VectorMeta& meta) {
  if (record.kind == RecordKind::kOut) return true;
  if (record.kind == RecordKind::kRun) return field <= kRunClocks;
  if (field < bookkeeping_fields(RecordKind::kIn, meta.stage)) return true;
  const Layout layout = vector_layout(RecordKind::kIn, meta);
  return layout[field].name.starts_with("corner");  // of traversal_t: follow from the slopes
}

TEST(Vectors, CheckFindsAnyChangedExpectedField) {
  for (const VectorStage stage : stages()) {
    VectorSet set = make_set(stage, kTiny, 5, 1u << 30);
    ASSERT_FALSE(check_vectors(set)) << stage_name(stage);
    const std::size_t step = std::max<std::size_t>(1, set.records.size() / 20);
    std::size_t changed = 0;
    for (std::size_t i = 0; i < set.records.size(); i += step) {
      for (std::size_t field = 0; field < set.records[i].values.size(); ++field) {
        if (!is_expected(set.records[i], field, set.meta)) continue;
        std::int64_t& value = set.records[i].values[field];
        value ^= 1;
        const auto difference = check_vectors(set);
        value ^= 1;
        ASSERT_TRUE(difference) << stage_name(stage) << " record " << i << " field " << field;
        EXPECT_EQ(difference->record, i) << difference->text;
        ++changed;
      }
    }
    EXPECT_GT(changed, 20u) << stage_name(stage);
  }
}

TEST(Vectors, CheckFindsALostAndAnAddedOutput) {
  const VectorSet set = make_set(VectorStage::kRasterizer, kTiny, 12, 0);
  for (std::size_t i = 0; i < set.records.size(); ++i) {
    if (set.records[i].kind != RecordKind::kOut) continue;
    VectorSet lost = set;
    lost.records.erase(lost.records.begin() + static_cast<std::ptrdiff_t>(i));
    const auto gone = check_vectors(lost);
    ASSERT_TRUE(gone) << "record " << i;
    EXPECT_GE(gone->record, i) << gone->text;  // the output, not the counts of its run
    VectorSet added = set;
    added.records.insert(added.records.begin() + static_cast<std::ptrdiff_t>(i), set.records[i]);
    const auto more = check_vectors(added);
    ASSERT_TRUE(more) << "record " << i;
    EXPECT_GE(more->record, i) << more->text;
  }
}

struct Clocks {
  std::vector<std::int64_t> accepts, tiles;
  void accepted(std::uint64_t clock) { accepts.push_back(static_cast<std::int64_t>(clock)); }
  void setup(std::uint64_t, const SetupTriangle&) {}
  void node(int, std::uint64_t, const Node&) {}
  void tile(std::uint64_t clock, const CoverageTile&) {
    tiles.push_back(static_cast<std::int64_t>(clock));
  }
};

TEST(Vectors, ClocksAreThoseOfTheCycleModel) {
  const std::uint32_t stall = 1u << 30;
  const VectorSet set = make_set(VectorStage::kRasterizer, kTiny, 40, stall);
  std::optional<CycleModel> model;
  Clocks expected, found;
  std::int64_t last_accept = -1;
  for (const VectorRecord& record : set.records) {
    if (record.kind == RecordKind::kRun) {
      model.emplace(frame_of(record.values), kTiny, Stalls(0.25, kSeed));
      last_accept = -1;
    } else if (record.kind == RecordKind::kIn) {
      EXPECT_GT(record.values[kInOffer], last_accept);
      EXPECT_GE(record.values[kInAccept], record.values[kInOffer]);
      last_accept = record.values[kInAccept];
      found.accepts.push_back(last_accept);
      model->draw(triangle_of(Values(record.values.begin() + 3, record.values.end())), expected);
    } else {
      found.tiles.push_back(record.values[0]);
    }
  }
  EXPECT_EQ(found.accepts, expected.accepts);
  EXPECT_EQ(found.tiles, expected.tiles);
  EXPECT_GT(found.tiles.size(), 50u);
}

// The RTL's ports, as the bench cuts them out of a word.
TEST(Vectors, APortIsTheLowestBitsOfItsWord) {
  const VectorSet set = make_set(VectorStage::kRasterizer, kFull, 12, 0);
  const Layout port = triangle_layout(kFull);
  const int bits = layout_bits(port);
  for (const VectorRecord& record : set.records) {
    if (record.kind != RecordKind::kIn) continue;
    PortWords words = pack(record.values, vector_layout(RecordKind::kIn, set.meta));
    const Values values = unpack(words, [&] {
      Layout padded{{"rest", 96, false}};
      padded.clear();
      for (const int rest : {32, 32, 32}) padded.push_back({"rest", rest, false});
      padded.insert(padded.end(), port.begin(), port.end());
      return padded;
    }());
    EXPECT_EQ(Values(values.begin() + 3, values.end()),
              Values(record.values.begin() + 3, record.values.end()));
    EXPECT_EQ(bits, 6 * kFull.vertex_bits() + kFull.tag_bits);
  }
}

bool refused(const VectorSet& set, ErrorCode code) {
  const VectorCounts counts = count_records(set);
  try {
    require_vectors(set, counts, "x");
  } catch (const Error& error) {
    return error.code() == code;
  }
  return false;
}

TEST(Vectors, IllegalStimulusIsRefusedBeforeAStageSeesIt) {
  VectorSet set = make_set(VectorStage::kTriangleSetup, kTiny, 12, 0);
  ASSERT_NO_THROW(require_vectors(set, count_records(set), "x"));
  set.records[1].values[1] = -1;  // tiny has no guard band
  EXPECT_TRUE(refused(set, ErrorCode::kVectorInput));
  set = make_set(VectorStage::kTriangleSetup, kTiny, 12, 0);
  set.records[0].values[kRunFrame] = 0;
  EXPECT_TRUE(refused(set, ErrorCode::kVectorInput));
  set = make_set(VectorStage::kCoverage, kTiny, 12, 0);
  set.records[1].values[1] |= 1;  // x
  EXPECT_TRUE(refused(set, ErrorCode::kVectorInput));
  set = make_set(VectorStage::kHalfPlaneGrid, kTiny, 12, 0);
  set.records[1].values[1] = (std::int64_t{1} << (kTiny.lane_bits() - 1)) - 1;
  set.records[1].values[2] = 1;
  EXPECT_TRUE(refused(set, ErrorCode::kVectorInput));
  set.records.clear();
  EXPECT_TRUE(refused(set, ErrorCode::kVectorsEmpty));
}

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
        "tie.edge.N", "tie.vertex0.owned", "tie.vertex1.lost", "cull.none.cw"}) {
    EXPECT_EQ(names.count(name) + names.count("tie.shared.NE"), 1u) << name;
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
  config.samples = 1;
  config.guard_bits = 3;
  exhaust(config, {{4, 4, Cull::kNone}});
  config = {.subpixel_bits = 1, .viewport_bits = 3, .guard_bits = 0, .grid_log2 = 3};
  exhaust(config, {{8, 3, Cull::kNone}});
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
