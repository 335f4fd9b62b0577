// SPDX-License-Identifier: Apache-2.0
#include "io/trace_formats.hpp"

#include <gtest/gtest.h>
#include <unistd.h>
#include <zlib.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "io/output_file.hpp"
#include "rtl/rtl_configs.hpp"
#include "rtl/rtl_trace.hpp"
#include "vectors/generators.hpp"

namespace halfspace {
namespace {

struct Case {
  const char* name;
  Config config;
  Stalls stalls;
  FrameState frame;
  std::vector<Triangle> triangles;
};

Case make_case(const char* name, const Config& config, double stall, std::uint64_t seed,
               int triangles) {
  const int side = std::min(config.max_size(), 200);
  Case made{name, config, Stalls(stall, seed), {side, side, Cull::kBack}, {}};
  Random random(seed);
  for (int i = 0; i < triangles; ++i) {
    const Shape shape = kShapes[static_cast<std::size_t>(i) % kShapes.size()];
    // Triangles over everything now and then: levels fill up and wait.
    made.triangles.push_back(
        random_triangle(random, i % 40 == 0 ? Shape::kInFrame : shape, made.frame, config));
  }
  return made;
}

std::vector<Case> cases() {
  return {make_case("tiny", kTiny, 0.3, 11, 60),
          make_case("tiny without stalls", kTiny, 0, 12, 60),
          make_case("full", kFull, 0.3, 13, 120),
          make_case("full with long stalls", kFull, 0.9, 14, 60),
          make_case("msaa4", kMsaa4, 0.3, 15, 60),
          make_case("interval3", kTestInterval3, 0.5, 16, 60),
          make_case("one_level", kTestOneLevel, 0.5, 17, 60)};
}

TraceLog model_log(const Case& c) { return trace_model(c.triangles, c.frame, c.config, c.stalls); }

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

std::filesystem::path scratch(const std::string& name) {
  return std::filesystem::temp_directory_path() /
         ("halfspace_trace_" + std::to_string(::getpid()) + "_" + name);
}

std::string bytes_of(const TraceLog& log, const std::string& name) {
  const std::filesystem::path path = scratch(name);
  OutputFile file(path.string());
  write_trace(file, log);
  file.commit();
  std::string bytes = read_file(path.string());
  std::filesystem::remove(path);
  return bytes;
}

std::string gunzip(const std::string& bytes) {
  const std::filesystem::path path = scratch("unpack.gz");
  OutputFile out(path.string());
  out.write(bytes);
  out.commit();
  std::string text;
  gzFile file = gzopen(path.c_str(), "rb");
  std::array<char, 4096> buffer;
  for (int got = 0; (got = gzread(file, buffer.data(), buffer.size())) > 0;) {
    text.append(buffer.data(), static_cast<std::size_t>(got));
  }
  EXPECT_EQ(gzclose(file), Z_OK);
  std::filesystem::remove(path);
  return text;
}

TEST(Trace, ModelAndRtlLeaveTheSameBytes) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    RtlRasterizer rtl(c.config, false, "rtl");
    const TraceLog from_rtl = trace_rtl(rtl, c.triangles, c.frame, c.stalls);
    const TraceLog from_model = model_log(c);
    ASSERT_GT(from_model.link(from_model.links() - 1).size(), 10u);
    for (const char* name : {"a.kanata.gz", "a.json"}) {
      EXPECT_TRUE(bytes_of(from_model, name) == bytes_of(from_rtl, name)) << name;
    }
  }
}

TEST(Trace, ChromeSlicesOfATrackNeverOverlap) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const nlohmann::json json = nlohmann::json::parse(bytes_of(model_log(c), "b.json"));
    std::map<int, std::string> names;
    std::map<int, std::uint64_t> ends;
    std::uint64_t slices = 0;
    std::uint64_t waited = 0;
    for (const nlohmann::json& event : json.at("traceEvents")) {
      const int track = event.at("tid");
      if (event.at("name") == "thread_name") names[track] = event.at("args").at("name");
      if (event.at("ph") != "X") continue;
      ASSERT_TRUE(names.contains(track));
      const std::uint64_t from = event.at("ts");
      const std::uint64_t length = event.at("dur");
      ASSERT_GE(length, 1u);
      ASSERT_GE(from, ends[track]) << names[track] << ": " << event.at("name");
      ends[track] = from + length;
      waited += event.at("args").at("waited").get<std::uint64_t>();
      ++slices;
    }
    EXPECT_EQ(names.size(), static_cast<std::size_t>(3 + 2 * (c.config.levels() - 1)));
    EXPECT_GT(slices, 100u);
    EXPECT_GT(waited, 0u);
  }
}

// One operation at a time, from its lines: stages follow each other, nothing is open at the end.
struct Operation {
  std::map<std::string, std::string> open;  // by lane
  std::vector<std::string> stages;
  int retired = 0;
  int flushed = 0;
};

TEST(Trace, KanataOperationsStartStepAndRetireOnce) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const TraceLog log = model_log(c);
    const std::string text = gunzip(bytes_of(log, "c.kanata.gz"));
    EXPECT_EQ(text, kanata_trace(log));
    const std::vector<std::string> lines = split(text, '\n');
    ASSERT_GT(lines.size(), 100u);
    ASSERT_EQ(lines[0], "Kanata\t0004");
    ASSERT_EQ(lines[1], "C=\t0");
    std::vector<Operation> operations;
    std::uint64_t clock = 0;
    std::size_t waits = 0;
    for (std::size_t i = 2; i < lines.size(); ++i) {
      SCOPED_TRACE(lines[i]);
      const std::vector<std::string> word = split(lines[i], '\t');
      ASSERT_GE(word.size(), 2u);
      if (word[0] == "C") {
        ASSERT_GT(std::stoull(word[1]), 0u);
        clock += std::stoull(word[1]);
        continue;
      }
      const std::size_t id = std::stoull(word[1]);
      if (word[0] == "I") {
        ASSERT_EQ(id, operations.size());
        operations.emplace_back();
        continue;
      }
      ASSERT_LT(id, operations.size());
      Operation& operation = operations[id];
      ASSERT_EQ(operation.retired, 0);
      if (word[0] == "S") {
        ASSERT_FALSE(operation.open.contains(word[2]));
        operation.open[word[2]] = word[3];
        if (word[2] == "0") operation.stages.push_back(word[3]);
        waits += word[2] == "1" ? 1 : 0;
      } else if (word[0] == "E") {
        ASSERT_EQ(operation.open[word[2]], word[3]);
        operation.open.erase(word[2]);
      } else if (word[0] == "R") {
        ASSERT_TRUE(operation.open.empty());
        ++operation.retired;
        operation.flushed += word[3] == "1" ? 1 : 0;
      } else {
        ASSERT_EQ(word[0], "L");
      }
    }
    const std::size_t tiles = log.link(log.links() - 2).size();
    ASSERT_EQ(operations.size(), c.triangles.size() + tiles);
    EXPECT_GT(waits, 0u);
    EXPECT_GE(clock, log.link(log.links() - 1).back().clock);
    std::size_t retired = 0;
    std::size_t finished_tiles = 0;
    for (const Operation& operation : operations) {
      retired += static_cast<std::size_t>(operation.retired);
      const bool tile = operation.stages.back() == "C";
      finished_tiles += tile && operation.flushed == 0 ? 1 : 0;
      if (!tile) continue;
      EXPECT_EQ(operation.stages.size(),
                static_cast<std::size_t>(std::max(c.config.levels() - 1, 1)));
    }
    EXPECT_EQ(retired, operations.size());
    EXPECT_EQ(finished_tiles, log.link(log.links() - 1).size());
  }
}

// Offered, then taken: what stands between is what the sink says and nothing else.
TEST(Trace, TilesWaitForTheSinkAlone) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const std::vector<std::vector<TracePacket>> packets = trace_packets(model_log(c));
    for (const TracePacket& tile : packets.back()) {
      ASSERT_EQ(tile.clock, c.stalls.next_ready(tile.offered));
    }
  }
}

TEST(Trace, CountsTheTrianglesBeyondTheTag) {
  Config config = kTestInterval3;
  config.tag_bits = 4;
  Case c = make_case("few tags", config, 0.3, 18, 200);
  c.frame.cull = Cull::kNone;
  const std::vector<std::vector<TracePacket>> packets = trace_packets(model_log(c));
  std::uint64_t before = 0;
  for (const TracePacket& tile : packets.back()) {
    EXPECT_GE(tile.triangle, before);
    before = tile.triangle;
  }
  EXPECT_GT(before, 100u);
}

TEST(Trace, RefusesALogThatDoesNotFitTogether) {
  const Case c = make_case("tiny", kTiny, 0, 19, 20);
  TraceLog log = model_log(c);
  log.tile(1'000'000, 3, {.x = 500, .y = 500, .mask = {1}, .tag = 3});
  EXPECT_ANY_THROW(kanata_trace(log));
  EXPECT_ANY_THROW(chrome_trace(log));
}

TEST(Trace, KnowsItsFilesByExtension) {
  EXPECT_TRUE(is_trace_file("out/a.json"));
  EXPECT_TRUE(is_trace_file("a.kanata.gz"));
  EXPECT_FALSE(is_trace_file("a.gz"));
  EXPECT_FALSE(is_trace_file("waves.fst"));
  EXPECT_EQ(model_trace_path("out/a.kanata.gz"), "out/a.model.kanata.gz");
  EXPECT_EQ(model_trace_path("a.json"), "a.model.json");
}

}  // namespace
}  // namespace halfspace
