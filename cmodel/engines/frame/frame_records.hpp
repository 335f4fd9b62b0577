// SPDX-License-Identifier: Apache-2.0
//
// What passes between the steps of the frame engine. Page: docs/03_design/frame_engine.md.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "../../config.hpp"
#include "../../depth.hpp"
#include "../../packets.hpp"

namespace halfspace {

// A projected vertex: what GeometryStage makes of it before it knows the triangle.
struct alignas(32) VertexRecord {
  Point point;                // S.s px
  double inverse_w = 0;       // real; for a triangle packed already, its inverse_w
  std::int32_t depth = 0;     // units
  std::uint16_t outside = 0;  // bits 0..6: planes, 7..10: sides of the frame, 15: not finite
  std::uint16_t unused = 0;
  std::uint64_t value = kNoValues;  // red, green, blue: a field each, less kValueLeast

  std::int32_t value_of(std::size_t n) const {
    return static_cast<std::int32_t>(value >> (kFieldBits * n) & kField) + kValueLeast;
  }
  void set_value(std::size_t n, std::int32_t to) {
    const std::size_t shift = kFieldBits * n;
    value = (value & ~(kField << shift)) | static_cast<std::uint64_t>(to - kValueLeast) << shift;
  }

  static constexpr std::size_t kFieldBits = 21;
  static constexpr std::uint64_t kField = (1u << kFieldBits) - 1;
  // 0 in each field.
  static constexpr std::uint64_t kNoValues =
      std::uint64_t{-kValueLeast} *
      (1 + (std::uint64_t{1} << kFieldBits) + (std::uint64_t{1} << (2 * kFieldBits)));
};
static_assert(sizeof(VertexRecord) == 32);
inline constexpr std::uint16_t kOutsidePlanes = 0x7f;
inline constexpr std::uint16_t kNotFinite = 0x8000;

// One quantity over the frame, modulo 2^64: (origin + dx x + dy y) >> F are the units, modulo 2^32,
// at the centre of pixel (x, y) when it is a tile's first; lane (i, j) adds lane_dx i + lane_dy j.
struct FramePlane {
  std::uint64_t origin = 0;
  std::uint64_t dx = 0;
  std::uint64_t dy = 0;
  std::uint32_t lane_dx = 0;
  std::uint32_t lane_dy = 0;
};

// The planes of red, green, blue and 1/w of one triangle, in this order; as FramePlane, with the
// units of the lanes' steps in the low halves. Colours are less their level.
inline constexpr std::size_t kShades = 4;
struct alignas(32) ShadePlanes {
  std::array<std::uint64_t, kShades> origin{};
  std::array<std::uint64_t, kShades> dx{};
  std::array<std::uint64_t, kShades> dy{};
  std::array<std::uint64_t, kShades> lane_dx{};
  std::array<std::uint64_t, kShades> lane_dy{};
  std::uint32_t level = kNoLevels;  // red lowest, then green, blue, and 255

  static constexpr std::uint32_t kNoLevels = 0xff000000;
};

// A triangle that covers a sample, before its planes. The first vertex is first_vertex(), the way
// it winds is as submitted.
struct FrameTriangle {
  std::array<const VertexRecord*, 3> vertex{};
};
inline FrameTriangle frame_triangle(const VertexRecord* a, const VertexRecord* b,
                                    const VertexRecord* c) {
  switch (first_vertex({a->point, b->point, c->point})) {
    case 0: return {{a, b, c}};
    case 1: return {{b, c, a}};
    default: return {{c, a, b}};
  }
}

// A tile of a triangle with a sample that passed the depth test.
struct PassedTile {
  // Of a new tile's first entry, from the bucket kernel: its pixels are still to be cleared.
  static constexpr std::uint32_t kFresh = 0x80000000u;

  std::uint32_t place = 0;     // tile row << 16 | tile column, with kFresh or without
  std::uint32_t triangle = 0;  // index of the FrameTriangle, later of its ShadePlanes
  std::uint64_t passed = 0;    // lanes with any sample that passed
};

// Coverage of some triangles as the depth kernel reads it.
struct FrameTiles {
  std::size_t count = 0;                                 // records
  const std::uint32_t* place = nullptr;                  // RecordPlace::word
  std::array<const std::uint64_t*, kMaxSamples> mask{};  // as CoverageChunk::plane
  const std::uint32_t* triangle = nullptr;               // [record]: index of the FrameTriangle
  const FramePlane* depth = nullptr;                     // [triangle]
  const std::uint32_t* depth_delta = nullptr;            // [triangle * samples + m]; samples > 1
};

// A tile of a triangle, ready for the depth test.
struct alignas(32) BinRecord {
  std::uint64_t covered = 0;   // lanes
  std::uint32_t base = 0;      // of the depth plane at lane 0, units
  std::uint32_t lane_dx = 0;   // FramePlane's
  std::uint32_t lane_dy = 0;   // FramePlane's
  std::uint32_t triangle = 0;  // index of the FrameTriangle
};

// A tile with its records: from the end of the tile before to `end`, in triangle order.
struct BinTile {
  std::uint32_t place = 0;  // tile row << 16 | tile column
  std::uint32_t end = 0;
};

// Some tiles of a piece.
struct BinRange {
  const BinTile* tiles = nullptr;
  std::size_t count = 0;               // of tiles
  std::size_t begin = 0;               // where the first one's records begin
  const BinRecord* records = nullptr;  // of all tiles
};

// What a configuration makes constant, for the kernels.
struct FrameConstants {
  Config config;
  FrameState frame;
  DepthFunction depth_function = DepthFunction::kLess;
  std::uint32_t clear = 0;  // depth of a new tile
  bool scissored = false;
  Box scissor;             // when scissored
  int f = 8;               // position_bits()
  int gradient_bits = 16;  // F
  int samples = 1;
  int colors = 3;       // attributes that are colours, 0..3
  bool packed = false;  // inverse_w is the triangle's already
};

// Work counted by the kernels, as RasterStats.
struct FrameCounts {
  std::uint64_t tiles = 0;
  std::uint64_t samples = 0;
  std::uint64_t fragments = 0;
  std::uint64_t shaded = 0;
};

// What the depth kernel leaves for the colour kernel. The masks of each sample only when there is
// more than one: covered[i * samples + m] and passed[i * samples + m] of tile i.
struct PassedTiles {
  std::size_t count = 0;
  std::vector<PassedTile> tile;
  std::vector<std::uint64_t> covered;
  std::vector<std::uint64_t> passed;
  std::vector<std::uint64_t> won;  // of the bucket kernel: lanes that passed, by record of a tile
  std::vector<std::uint32_t> shaded;  // of the colour kernel: triangles with a tile, once each
  std::vector<std::uint32_t> slot;    // of the colour kernel: [triangle]: its index there plus 1
  std::vector<ShadePlanes> planes;    // of those
  std::vector<std::uint64_t> deltas;  // [planes][sample][shade]; samples > 1

  // Room for `more` further tiles.
  void reserve(std::size_t more, std::size_t samples) {
    if (count + more <= tile.size()) return;
    const std::size_t size = 2 * (count + more);
    tile.resize(size);
    if (samples > 1) {
      covered.resize(size * samples);
      passed.resize(size * samples);
    }
  }
};

}  // namespace halfspace
