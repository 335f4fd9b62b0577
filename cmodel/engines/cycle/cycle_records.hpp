// SPDX-License-Identifier: Apache-2.0
//
// What the cycle engine hands out: packets and their clocks, many triangles at a time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "../../packets.hpp"
#include "../../triangle_setup.hpp"

namespace halfspace {

// One triangle's part of a chunk. Its tiles are those from the end of the one before to `tile_end`,
// its nodes likewise. A triangle that is split over chunks is in each of them.
struct CycleTriangle {
  std::uint32_t index = 0;  // in the span given to the engine
  SetupOutcome outcome = SetupOutcome::kDrawn;
  bool continued = false;      // its first part was in the chunk before
  std::uint64_t accepted = 0;  // clock at which it enters setup
  std::uint64_t entered = 0;   // clock at which it leaves setup for level 0, when drawn
  std::uint32_t tile_end = 0;
  std::uint32_t node_end = 0;
};

// A node that enters `level` at `clock`, before the chunk's tile `tile`.
struct CycleNode {
  std::uint64_t clock = 0;
  std::uint32_t tile = 0;
  std::int32_t level = 0;
  Node node;
};

// Row and column of a tile, in tiles: row in the upper, column in the lower 16 bits.
constexpr std::uint32_t cycle_place(std::int32_t x, std::int32_t y, int grid_log2) {
  return static_cast<std::uint32_t>(y >> grid_log2) << 16 |
         static_cast<std::uint32_t>(x >> grid_log2);
}

// A view of packets in the order of the hardware. Valid until the engine continues.
struct CycleChunk {
  std::span<const CycleTriangle> triangle;
  std::span<const std::uint64_t> clock;                   // of each tile
  std::span<const std::uint32_t> place;                   // cycle_place()
  std::array<const std::uint64_t*, kMaxSamples> plane{};  // plane[m][tile]: mask of sample m
  std::span<const CycleNode> node;                        // empty when nobody wants them
  int samples = 1;
  int grid_log2 = 3;

  std::int32_t x(std::size_t tile) const {
    return static_cast<std::int32_t>(place[tile] & 0xffff) << grid_log2;
  }
  std::int32_t y(std::size_t tile) const {
    return static_cast<std::int32_t>(place[tile] >> 16) << grid_log2;
  }
};

// Where they are collected. Fixed size: 64 tiles always fit after make_room().
struct CycleBuffer {
  static constexpr std::size_t kTiles = 1 << 13;
  static constexpr std::size_t kSlack = 64;
  static constexpr std::size_t kTriangles = 1 << 12;
  static constexpr std::size_t kBatch = 64;  // triangles that fit after make_room()
  static constexpr std::size_t kStride = kTiles + kSlack;

  explicit CycleBuffer(int sample_count)
      : samples(sample_count),
        clock(kStride),
        place(kStride),
        masks(kStride * static_cast<std::size_t>(sample_count)),
        triangle(kTriangles + kBatch) {}

  CycleChunk chunk(int grid_log2) const {
    CycleChunk out;
    out.triangle = {triangle.data(), triangles};
    out.clock = {clock.data(), tiles};
    out.place = {place.data(), tiles};
    for (std::size_t m = 0; m < static_cast<std::size_t>(samples); ++m) {
      out.plane[m] = masks.data() + m * kStride;
    }
    out.node = node;
    out.samples = samples;
    out.grid_log2 = grid_log2;
    return out;
  }
  bool full() const { return tiles > kTiles - kSlack || triangles >= kTriangles; }
  void clear() {
    tiles = triangles = 0;
    node.clear();
  }
  // Opens a triangle's part. Its tile_end and node_end are written by close().
  CycleTriangle& open(std::uint32_t index, std::uint64_t accepted) {
    CycleTriangle& out = triangle[triangles++];
    out = {index, SetupOutcome::kDrawn, false, accepted, 0, 0, 0};
    return out;
  }
  void close() {
    triangle[triangles - 1].tile_end = static_cast<std::uint32_t>(tiles);
    triangle[triangles - 1].node_end = static_cast<std::uint32_t>(node.size());
  }

  int samples;
  std::size_t tiles = 0;
  std::size_t triangles = 0;
  std::vector<std::uint64_t> clock;
  std::vector<std::uint32_t> place;
  std::vector<std::uint64_t> masks;
  std::vector<CycleTriangle> triangle;
  std::vector<CycleNode> node;
};

}  // namespace halfspace
