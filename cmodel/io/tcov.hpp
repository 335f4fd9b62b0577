// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "../config.hpp"
#include "../packets.hpp"
#include "output_file.hpp"

namespace halfspace {

// One case of a TCOV file: triangles in 1/256 px and the hit count of each pixel. Format:
// docs/02_use/tcov.md.
struct TcovCase {
  int id = 0;
  std::string tag;
  int width = 0;
  int height = 0;
  int line = 0;                                        // where the case starts, for messages
  std::vector<std::array<std::int64_t, 6>> triangles;  // x0 y0 x1 y1 x2 y2, S.8 px
  std::vector<std::uint8_t> hits;                      // width * height; as stored in the file
  std::uint32_t crc = 0;                               // CRC-32 of `hits`, as stored
  std::uint64_t sum = 0;                               // sum of `hits`, as stored
};

inline constexpr int kTcovFractionBits = 8;  // of a file's coordinates

// Frames up to this side are read; larger ones are taken for damage.
inline constexpr int kTcovMaxSize = 1 << 15;

// What is read of a TCOV file.
struct TcovReading {
  int max_size = kTcovMaxSize;  // pixels a side; Error(kSize) at the header of a greater case
  bool hits = true;             // false: TcovCase::hits stays empty, and takes no memory
};

// Throws Error(kFileRead), or Error(kTcovBroken) with the line. Spans may be absent (nspan 0). When
// a case has spans, its CRC must fit unless it is 0 (checked). Memory: a file of headers alone may
// ask for kTcovMaxPixels in all; Error(kScene) beyond.
std::vector<TcovCase> read_tcov(const std::string& path, const TcovReading& reading = {});
inline constexpr std::uint64_t kTcovMaxPixels = std::uint64_t{1} << 30;

// Writes hits, CRC and sum of each case; its triangles too. Throws Error(kFileWrite).
void write_tcov(OutputFile& file, const std::vector<TcovCase>& cases);

// The case's triangles in the configuration's subpixels.
struct TcovTriangles {
  std::vector<Triangle> triangles;
  std::uint64_t resnapped = 0;  // coordinates that were not multiples of 2^-subpixel_bits
};

// Coordinates finer than the configuration's subpixels are snapped by its mode and counted. Throws
// Error(kTcovRange) naming case, triangle and value when one is beyond the configuration's range,
// Error(kFitRange) when a triangle is wider than it was fitted to, and Error(kSize) when the frame
// is too large for it. place: the file's name.
TcovTriangles tcov_triangles(const TcovCase& tcov, const Config& config, const std::string& place);

// CRC-32 (zlib's polynomial) of bytes that follow those whose CRC is `before`.
std::uint32_t crc32_of(const std::vector<std::uint8_t>& bytes, std::uint32_t before = 0);
std::uint32_t crc32_of(std::string_view bytes, std::uint32_t before = 0);

}  // namespace halfspace
