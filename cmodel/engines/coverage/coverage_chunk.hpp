// SPDX-License-Identifier: Apache-2.0
//
// What level coverage hands out: records of covered tiles, many triangles at a time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "../../packets.hpp"

namespace halfspace {

// One record's place: bit 31 says that the record is a run, bits 16..30 are the tile's row and bits
// 0..15 its column, both in tiles of Config::grid() px.
//
// A tile record holds one mask per sample, at least one bit set. A run record stands for `length`
// tiles from that place to the right, every sample of every one of them covered; mask plane 0 holds
// the length, the other planes hold nothing.
struct RecordPlace {
  std::uint32_t word = 0;
  constexpr bool is_run() const { return (word >> 31) != 0; }
  constexpr std::uint32_t tile_x() const { return word & 0xffff; }
  constexpr std::uint32_t tile_y() const { return word >> 16 & 0x7fff; }
};
inline constexpr std::uint32_t kRunFlag = 0x80000000u;

// A view of records, in triangle order. Valid until the engine continues.
//
// triangle[i] is the index, in the span given to the engine, of the i-th triangle that was not
// dropped by setup; its records are end[i - 1] .. end[i] - 1 (0 for i = 0), perhaps none. No
// triangle is split over two chunks. Within a triangle no pixel is in two records; their order is
// the engine's.
struct CoverageChunk {
  std::span<const std::uint32_t> triangle;
  std::span<const std::uint32_t> end;
  std::span<const std::uint32_t> place;                   // RecordPlace::word
  std::array<const std::uint64_t*, kMaxSamples> plane{};  // plane[m][record]: mask of sample m
  int samples = 1;
  int grid_log2 = 3;

  std::size_t records() const { return place.size(); }
  std::size_t begin_of(std::size_t i) const { return i == 0 ? 0 : end[i - 1]; }
};

// Where a kernel writes records. Vectors are longer than `count` says: kernels store whole vectors.
struct RecordBuffer {
  static constexpr std::size_t kSlack = 64;  // records a kernel may write past the last

  explicit RecordBuffer(int sample_count) : samples(sample_count) { reserve(1 << 13); }

  // Room for `records` records and slack. Pointers into the vectors are stale afterwards.
  void reserve(std::size_t records);
  void reserve_triangles(std::size_t triangles);
  std::size_t capacity() const { return place.size() - kSlack; }
  // mask(m)[record]: mask of sample m; planes are stride() apart.
  std::uint64_t* mask(std::size_t m) { return masks.data() + m * stride(); }
  const std::uint64_t* mask(std::size_t m) const { return masks.data() + m * stride(); }
  std::size_t stride() const { return place.size(); }
  void clear() { count = triangle_count = 0; }
  CoverageChunk chunk(int grid_log2) const;

  int samples;
  std::size_t count = 0;           // records
  std::size_t triangle_count = 0;  // entries of triangle and end
  std::vector<std::uint64_t> masks;
  std::vector<std::uint32_t> place;
  std::vector<std::uint32_t> triangle;
  std::vector<std::uint32_t> end;
};

// Calls tile(const CoverageTile&) for every tile of the i-th triangle of a chunk, runs unrolled.
template <class Tile>
void for_each_tile(const CoverageChunk& chunk, std::size_t i, std::uint32_t tag, Tile&& tile) {
  const std::uint64_t all = chunk.grid_log2 == 3 ? ~std::uint64_t{0} : 0xffff;
  for (std::size_t r = chunk.begin_of(i); r < chunk.end[i]; ++r) {
    const RecordPlace place{chunk.place[r]};
    CoverageTile out{static_cast<std::int32_t>(place.tile_x() << chunk.grid_log2),
                     static_cast<std::int32_t>(place.tile_y() << chunk.grid_log2),
                     {},
                     tag};
    const auto samples = static_cast<std::size_t>(chunk.samples);
    const std::uint64_t length = place.is_run() ? chunk.plane[0][r] : 1;
    for (std::size_t m = 0; m < samples; ++m) {
      out.mask[m] = place.is_run() ? all : chunk.plane[m][r];
    }
    for (std::uint64_t k = 0; k < length; ++k) {
      tile(static_cast<const CoverageTile&>(out));
      out.x += 1 << chunk.grid_log2;
    }
  }
}

}  // namespace halfspace
