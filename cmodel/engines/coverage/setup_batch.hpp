// SPDX-License-Identifier: Apache-2.0
//
// What setup leaves for the window and strip kernels: structure of arrays, one lane per triangle.
#pragma once

#include <cstddef>
#include <cstdint>

#include "../../packets.hpp"

namespace halfspace::simd {

inline constexpr std::size_t kBatch = 64;  // triangles set up at a time

// A triangle is the pixels from max(left0, left1) to min(right0, right1) - 1 of each row. Two of
// the four are the same edge, or three when an edge is flat (flat edges only limit rows).
inline constexpr std::size_t kSides = 4;  // left0, left1, right0, right1

// A narrow triangle lies in a block of 64x64 px, from the corner of its first tile; windows are 32
// columns wide, so a block has two columns of them. Values of the second follow those of the first.
inline constexpr std::size_t kColumns = 2 * kBatch;
inline constexpr std::size_t kWindowWidth = 32;

// Work for the kernels, in triangle order: one window, or one triangle in strips. A vector of
// these is handled as 32-bit words, lane lowest.
struct WorkItem {
  std::uint8_t lane;
  std::uint8_t column;  // lane, or kBatch + lane in the second column of windows
  std::uint8_t row;     // first row of the window in the block
  std::uint8_t what;
};
enum What : std::uint8_t { kWindowItem = 0, kStripItem = 1, kEndOfWork = 2 };

struct alignas(64) SetupBatch {
  // Crossing of side e at row y of the block, in columns of the window: slope y + base (float).
  float slope[kSides][kBatch];
  float base[kMaxSamples][kSides][kColumns];
  // Crossing at row y of the frame, in columns of the frame (double).
  double wide_slope[kSides][kBatch];
  double wide_base[kMaxSamples][kSides][kBatch];

  // The box of all samples, in the frame.
  std::int32_t x_first[kBatch], y_first[kBatch], x_last[kBatch], y_last[kBatch];
  std::int32_t y_block[kBatch];     // the block's first row
  std::uint32_t corner[kColumns];   // place of the window column's first tile
  std::uint32_t columns[kColumns];  // bits of a window up to the box's last column
  float column_end[kColumns];       // or their number
  // Rows that may hold a covered sample m, in the frame. The box's for one sample.
  std::int32_t row_first[kMaxSamples][kBatch], row_last[kMaxSamples][kBatch];
  std::uint64_t rows[kMaxSamples][kBatch];  // the same as bits of the block

  std::uint32_t windows[kBatch];  // work items, 0 for a dropped triangle
  std::uint32_t kind[kBatch];     // columns of windows minus 1, or 2 for a strip triangle
  std::uint32_t end[kBatch];      // records at the end of each triangle

  WorkItem work[16 * kBatch + 17];
};

}  // namespace halfspace::simd
