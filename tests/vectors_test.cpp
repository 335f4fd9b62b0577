// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/error.hpp"
#include "vectors/packets_of.hpp"
#include "vectors/stimulus.hpp"
#include "vectors/vector_builder.hpp"
#include "vectors/vectors_format.hpp"
#include "vectors/vectors_meta.hpp"

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

TEST(Vectors, CheckFindsALostAndAnAddedOutputAtTheEnd) {
  const VectorSet set = make_set(VectorStage::kHalfPlaneGrid, kTiny, 12, 0);
  ASSERT_EQ(set.records.back().kind, RecordKind::kOut);
  VectorSet lost = set, added = set;
  lost.records.pop_back();
  added.records.push_back(set.records.back());
  const auto gone = check_vectors(lost), more = check_vectors(added);
  ASSERT_TRUE(gone && more);
  EXPECT_EQ(gone->record, lost.records.size());
  EXPECT_EQ(more->record, set.records.size());
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
  set.meta.config.extent_bits = 2;  // edges of less than 4 px
  EXPECT_TRUE(refused(set, ErrorCode::kVectorInput));
  for (const VectorStage stage : {VectorStage::kTileTraversal, VectorStage::kCoverage}) {
    set = make_set(stage, kTiny, 12, 0);
    set.meta.config.extent_bits = 2;
    EXPECT_TRUE(refused(set, ErrorCode::kVectorInput)) << stage_name(stage);
  }
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

// Every place of a file of vectors where JSON stands.
TEST(Vectors, JsonIsBoundedInDepthAndRange) {
  const VectorSet set = make_set(VectorStage::kTriangleSetup, kTiny, 12, 0);
  const std::string deep = std::string(80000, '[') + std::string(80000, ']');
  const auto broken = [](auto&& read) {
    try {
      read();
    } catch (const Error& error) {
      return error.code() == ErrorCode::kVectorsBroken;
    }
    return false;
  };
  for (const std::string& bad : {deep, std::string("1e999")}) {
    for (const char* key : {"\"layout\":", "\"config\":", "\"seed\":"}) {
      std::string csv = vectors_to_csv(set), lines = vectors_to_json_lines(set);
      for (std::string* text : {&csv, &lines}) text->insert(text->find(key), "\"x\":" + bad + ",");
      EXPECT_TRUE(broken([&] { vectors_from_csv(csv, "x"); })) << key;
      EXPECT_TRUE(broken([&] { vectors_from_json_lines(lines, "x"); })) << key;
    }
    std::string lines = vectors_to_json_lines(set);
    lines.replace(lines.find("\"stall\":") + 8, 1, bad);
    EXPECT_TRUE(broken([&] { vectors_from_json_lines(lines, "x"); }));
    EXPECT_TRUE(broken([&] { parse_vector_meta(bad, "x"); }));
  }
}

// Clocks are a file's word until the model has said its own.
TEST(Vectors, ClocksOfADamagedFileTakeNoMemory) {
  VectorSet set = make_set(VectorStage::kRasterizer, kTiny, 12, 1u << 30);
  const std::string manifest = vector_meta_json(set).dump();
  HexFiles files = vectors_to_hex(set);
  ASSERT_NO_THROW(vectors_from_hex(files, manifest, "x"));
  VectorSet damaged = set;
  damaged.records[0].values[kRunClocks] = 0xffffffff;
  EXPECT_THROW(vectors_to_hex(damaged), Error) << "more than a ready pattern may take";
  // The same line of the run, bit by bit: without stalls there is no pattern to write.
  damaged.records[0].values[kRunStall] = 0;
  const std::string all_clocks = vectors_to_hex(damaged).run;
  const std::string digits = "0123456789abcdef";
  for (std::size_t i = 0; files.run[i] != '\n'; ++i) {
    files.run[i] = digits[digits.find(files.run[i]) | digits.find(all_clocks[i])];
  }
  try {
    vectors_from_hex(files, manifest, "x");
    ADD_FAILURE() << "read";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kVectorsBroken) << error.what();
  }
}

}  // namespace
}  // namespace halfspace
