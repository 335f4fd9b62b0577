// SPDX-License-Identifier: Apache-2.0
//
// The TCOV format, and the set of cases rendered by a real driver: level bit and level coverage
// against its pixels.
#include "io/tcov.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "engines/coverage/coverage_walk.hpp"
#include "io/error.hpp"

namespace halfspace {
namespace {

const std::string kPublic = std::string(HALFSPACE_TEST_DIR) + "/data/public.tcov";

long wrong_pixels(const TcovCase& tcov, const Config& config, bool batch) {
  HitCount hits(tcov.width, tcov.height);
  RasterStats stats;
  const FrameState frame{tcov.width, tcov.height, Cull::kNone};
  for (const Triangle& t : tcov_triangles(tcov, config, "").triangles) {
    const auto add = [&](const CoverageTile& tile) { hits.add(tile, config); };
    if (batch) {
      cover(t, frame, config, stats, add);
    } else {
      rasterize(t, frame, config, stats, add);
    }
  }
  long wrong = 0;
  for (std::size_t i = 0; i < tcov.hits.size(); ++i) wrong += hits.count()[i] != tcov.hits[i];
  return wrong;
}

TEST(Driver, EveryPixelEqualAtLevelBit) {
  const std::vector<TcovCase> cases = read_tcov(kPublic);
  ASSERT_EQ(cases.size(), 320u);
  for (const TcovCase& tcov : cases) EXPECT_EQ(wrong_pixels(tcov, kFull, false), 0) << tcov.id;
}

TEST(Driver, EveryPixelEqualAtLevelCoverage) {
  for (const TcovCase& tcov : read_tcov(kPublic)) {
    EXPECT_EQ(wrong_pixels(tcov, kFull, true), 0) << tcov.id;
  }
}

// Any configuration with 8 subpixel bits and one sample must agree with the driver.
TEST(Driver, EveryPixelEqualInOtherConfigurations) {
  Config small = kFull;
  small.grid_log2 = 2;
  Config fine = kD3d;
  fine.subpixel_bits = 12;
  for (const TcovCase& tcov : read_tcov(kPublic)) {
    for (const Config& config : {kD3d, small, fine}) {
      EXPECT_EQ(wrong_pixels(tcov, config, false), 0) << tcov.id;
      EXPECT_EQ(wrong_pixels(tcov, config, true), 0) << tcov.id;
    }
  }
}

// The check bites: fewer subpixel bits must differ from the driver.
TEST(Driver, CoarserSnappingIsNoticed) {
  Config coarse = kFull;
  coarse.subpixel_bits = 6;
  long wrong = 0;
  for (const TcovCase& tcov : read_tcov(kPublic)) wrong += wrong_pixels(tcov, coarse, false);
  EXPECT_GT(wrong, 0);
}

class TcovFile : public testing::Test {
 protected:
  void SetUp() override {
    path_ =
        (std::filesystem::temp_directory_path() / ("halfspace_tcov_" + std::to_string(::getpid())))
            .string();
  }
  void TearDown() override { std::filesystem::remove(path_); }

  // The error's code and text, or 0 when the file is read.
  int code_of(const std::string& text, const TcovReading& reading = {}) {
    std::ofstream(path_) << text;
    try {
      read_tcov(path_, reading);
    } catch (const Error& error) {
      message_ = error.what();
      return static_cast<int>(error.code());
    }
    return 0;
  }

  std::string path_;
  std::string message_;
};

TEST_F(TcovFile, RoundTripKeepsEverything) {
  const std::vector<TcovCase> before = read_tcov(kPublic);
  OutputFile file(path_);
  write_tcov(file, before);
  file.commit();
  const std::vector<TcovCase> after = read_tcov(path_);
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(after[i].triangles, before[i].triangles);
    EXPECT_EQ(after[i].hits, before[i].hits);
    EXPECT_EQ(after[i].crc, before[i].crc);
    EXPECT_EQ(after[i].sum, before[i].sum);
    EXPECT_EQ(after[i].tag, before[i].tag);
  }
}

TEST_F(TcovFile, DamageIsNamedWithItsLine) {
  const int broken = static_cast<int>(ErrorCode::kTcovBroken);
  EXPECT_EQ(code_of(""), broken);
  EXPECT_EQ(code_of("TCOV 2 0"), broken);
  EXPECT_EQ(code_of("hello"), broken);
  EXPECT_EQ(code_of("TCOV 1 1\ncase 0 t 8 8 1 0 0 0\n100000 200000 3 4 5"), broken);
  EXPECT_NE(message_.find(":3:"), std::string::npos) << message_;
  EXPECT_EQ(code_of("TCOV 1 1\ncase 0 t 0 8 0 0 0 0"), broken);
  EXPECT_EQ(code_of("TCOV 1 1\ncase 0 t 8 8 0 1 0 0\n60 10 1"), broken);
  EXPECT_EQ(code_of("TCOV 1 1\ncase 0 t 8 8 0 1 deadbeef 0\n0 10 1"), broken);
  EXPECT_EQ(code_of("TCOV 1 1\ncase 0 t 8 8 1 0 0 0\n1 2 3 4 5 six"), broken);
  EXPECT_EQ(code_of("TCOV 1 1\ncase 0 t 8 8 999999999 0 0 0\n"), broken);
  EXPECT_EQ(code_of("TCOV 1 1\ncase 0 t 8 8 0 0 0 0\nmore"), broken);
  EXPECT_EQ(code_of("TCOV 1 1\ncase 0 t 8 8 1 0 0 0\n1 2 3 4 5 99999999999999999999"), broken);
  EXPECT_EQ(code_of("TCOV 1 1\ncase 0 t 8 8 1 0 0 0\n1 2 3 4 5 6\n"), 0) << message_;
}

// Without the pictures the CRC is computed from the spans alone.
TEST_F(TcovFile, SpansFitTheirCrcWhetherThePictureIsKeptOrNot) {
  const std::string before = "TCOV 1 1\ncase 0 t 300 200 0 3 ";
  const std::string after = " 0\n7 1 3 1000 4097 255 0 50000 1\n";
  std::vector<std::uint8_t> hits(300 * 200);
  std::fill_n(hits.begin() + 7, 1, 3);
  std::fill_n(hits.begin() + 1008, 4097, 255);
  std::fill_n(hits.begin() + 5105, 50000, 1);
  for (const bool keep : {false, true}) {
    const TcovReading reading{.max_size = 300, .hits = keep};
    EXPECT_EQ(code_of(before + fmt::format("{:08x}", crc32_of(hits)) + after, reading), 0);
    EXPECT_EQ(read_tcov(path_, reading).front().hits.empty(), !keep);
    EXPECT_EQ(code_of(before + fmt::format("{:08x}", crc32_of(hits) ^ 1u) + after, reading),
              static_cast<int>(ErrorCode::kTcovBroken));
  }
}

TEST_F(TcovFile, HeadersTakeNoMemoryThatTheyMayNot) {
  const std::string three =
      "TCOV 1 3\ncase 0 t 32768 32768 0 0 0 0\ncase 1 t 32768 32768 0 0 0 0\n"
      "case 2 t 32768 32768 0 0 0 0\n";
  EXPECT_EQ(code_of(three, {.max_size = 4096, .hits = true}), static_cast<int>(ErrorCode::kSize));
  EXPECT_NE(message_.find(":2: case 0: 32768x32768"), std::string::npos) << message_;
  EXPECT_EQ(code_of(three), static_cast<int>(ErrorCode::kScene));
  EXPECT_NE(message_.find(":3: case 1"), std::string::npos) << message_;
  EXPECT_EQ(code_of(three, {.max_size = kTcovMaxSize, .hits = false}), 0);
}

TEST_F(TcovFile, TrianglesBeyondTheConfigurationAreRefused) {
  std::ofstream(path_) << "TCOV 1 1\ncase 0 t 8 8 1 0 0 0\n0 0 100 0 0 2097152\n";
  const TcovCase tcov = read_tcov(path_).front();
  EXPECT_THROW(tcov_triangles(tcov, kFull, path_), Error);  // 8192 px is one past the last
  EXPECT_NO_THROW(tcov_triangles(tcov, kD3d, path_));
  EXPECT_THROW(tcov_triangles(tcov, kTiny, path_), Error);
}

}  // namespace
}  // namespace halfspace
