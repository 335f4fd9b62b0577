// SPDX-License-Identifier: Apache-2.0
//
// Tiles to lines of pixels, one sample.
#if defined(HALFSPACE_SIMD_FRAME_RESOLVE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HALFSPACE_SIMD_FRAME_RESOLVE_INL
#undef HALFSPACE_SIMD_FRAME_RESOLVE_INL
#else
#define HALFSPACE_SIMD_FRAME_RESOLVE_INL
#endif

#include "../coverage/vectors-inl.hpp"
#include "frame_kernel.hpp"

HWY_BEFORE_NAMESPACE();
namespace halfspace::simd::HWY_NAMESPACE {

// kStream: whole cache lines are written past the caches.
template <bool kStream>
HWY_INLINE void fill_pixels(std::uint32_t* to, std::size_t count, std::uint32_t value) {
  constexpr std::size_t kLine = 16;  // pixels
  const DU d;
  const auto pixel = hn::Set(d, value);
  if (count < kLine) {
    for (std::size_t i = 0; i < count; ++i) to[i] = value;
    return;
  }
  std::size_t i = 0;
  if (kStream && count >= 8 * kLine) {
    for (std::size_t k = 0; k < kLine; k += kLanes) hn::StoreU(pixel, d, to + k);
    i = (kLine - (reinterpret_cast<std::uintptr_t>(to) / 4 & (kLine - 1))) & (kLine - 1);
    for (; i + kLine <= count; i += kLine) {
      for (std::size_t k = 0; k < kLine; k += kLanes) hn::Stream(pixel, d, to + i + k);
    }
  }
  for (; i + kLanes <= count; i += kLanes) hn::StoreU(pixel, d, to + i);
  hn::StoreU(pixel, d, to + count - kLanes);
}

// Whole tiles first .. last - 1 of a row, all of them drawn to.
HWY_INLINE void copy_tiles(const StoreRow& row, std::size_t first, std::size_t last,
                           std::uint32_t* HWY_RESTRICT to) {
  const hn::CappedTag<std::uint32_t, 8> d;
  constexpr std::size_t n = hn::MaxLanes(d);
  const std::size_t grid = row.grid;
  for (std::size_t y = 0; y < row.lines; ++y) {
    const std::uint32_t* HWY_RESTRICT from = row.colors + first * row.tile_words + y * grid;
    std::uint32_t* HWY_RESTRICT line = to + y * row.width + first * grid;
    if (grid == 8) {
      for (std::size_t t = first; t < last; ++t, from += row.tile_words, line += 8) {
        for (std::size_t i = 0; i < 8; i += n) hn::StoreU(hn::Load(d, from + i), d, line + i);
      }
    } else {
      const hn::Full128<std::uint32_t> d4;
      for (std::size_t t = first; t < last; ++t, from += row.tile_words, line += 4) {
        hn::StoreU(hn::Load(d4, from), d4, line);
      }
    }
  }
}

// Whole runs of tiles that nothing was drawn to at once: most of a large frame is background.
template <bool kStream>
HWY_NOINLINE void resolve_tiles(const StoreRow& row, std::uint32_t* HWY_RESTRICT to) {
  const std::size_t whole = row.width / row.grid;  // columns that do not reach over the edge
  std::size_t column = 0;
  while (column < row.columns) {
    const std::size_t dead = column;
    while (column < row.columns && row.live[column] == 0) ++column;
    const std::size_t until = HWY_MIN(column * row.grid, row.width);
    for (std::size_t y = 0; y < row.lines && dead < column; ++y) {
      fill_pixels<kStream>(to + y * row.width + dead * row.grid, until - dead * row.grid,
                           row.background);
    }
    const std::size_t first = column;
    while (column < whole && row.live[column] != 0) ++column;
    if (first < column) copy_tiles(row, first, column, to);
    if (column < whole || column == row.columns || row.live[column] == 0) continue;
    for (std::size_t y = 0; y < row.lines; ++y) {
      for (std::size_t x = column * row.grid; x < row.width; ++x) {
        to[y * row.width + x] =
            row.colors[column * row.tile_words + y * row.grid + x - column * row.grid];
      }
    }
    ++column;
  }
}

void Resolve(const StoreRow& row, bool stream, std::uint32_t* to) {
  stream ? resolve_tiles<true>(row, to) : resolve_tiles<false>(row, to);
}

}  // namespace halfspace::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
