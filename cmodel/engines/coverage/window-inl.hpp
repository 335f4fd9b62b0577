// SPDX-License-Identifier: Apache-2.0
//
// One window of a narrow triangle: 32 px wide, 16 rows with AVX-512, 8 rows otherwise.
#if defined(HALFSPACE_SIMD_WINDOW_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HALFSPACE_SIMD_WINDOW_INL
#undef HALFSPACE_SIMD_WINDOW_INL
#else
#define HALFSPACE_SIMD_WINDOW_INL
#endif

#include "vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace halfspace::simd::HWY_NAMESPACE {

inline constexpr int kWindowRowsLog2 = HALFSPACE_AVX512 ? 4 : 3;
inline constexpr std::uint32_t kWindowRows = 1u << kWindowRowsLog2;

// Rows of a block as floats, and the places of its first four columns of tiles, row by row.
struct WindowTable {
  alignas(64) float row[64];
  alignas(64) std::uint32_t place[32];
  constexpr WindowTable() : row{}, place{} {
    for (unsigned i = 0; i < 64; ++i) row[i] = static_cast<float>(i);
    for (unsigned i = 0; i < 32; ++i) place[i] = (i >> 2) << 16 | (i & 3);
  }
};
inline constexpr WindowTable kWindow;

// left and right of the rows `y`, in columns of the window, not yet rounded; below 0 is 0.
struct Crossings {
  VF left, right;
};
HWY_INLINE Crossings crossings(const SetupBatch& batch, std::size_t m, std::size_t lane,
                               std::size_t column, VF y) {
  const DF d;
  VF at[kSides];
  for (std::size_t e = 0; e < kSides; ++e) {
    at[e] = hn::MulAdd(hn::Set(d, batch.slope[e][lane]), y, hn::Set(d, batch.base[m][e][column]));
  }
  const VF zero = hn::Zero(d);
  return {hn::Max(hn::Max(at[0], at[1]), zero), hn::Max(hn::Min(at[2], at[3]), zero)};
}

#if HALFSPACE_AVX512
// Bytes of 16 rows of 32 columns to eight tiles.
struct TileOrder {
  alignas(64) std::uint8_t byte[64];   // of the whole vector
  alignas(64) std::uint8_t block[64];  // of each 128-bit block: four rows by four bytes
  alignas(64) std::uint32_t word[16];  // after that, words of the whole vector
  constexpr TileOrder() : byte{}, block{}, word{} {
    for (unsigned tile = 0; tile < 8; ++tile) {
      for (unsigned j = 0; j < 8; ++j) {
        byte[8 * tile + j] = static_cast<std::uint8_t>(4 * (8 * (tile / 4) + j) + tile % 4);
      }
      word[2 * tile] = 4 * (2 * (tile / 4)) + tile % 4;
      word[2 * tile + 1] = word[2 * tile] + 4;
    }
    for (unsigned i = 0; i < 64; ++i) {
      block[i] = static_cast<std::uint8_t>(4 * (i & 3) + (i >> 2 & 3));
    }
  }
};
inline constexpr TileOrder kTileOrder;

HWY_INLINE __m512i to_tiles(__m512i rows) {
#if HALFSPACE_VBMI
  return _mm512_permutexvar_epi8(_mm512_load_si512(kTileOrder.byte), rows);
#else
  return _mm512_permutexvar_epi32(_mm512_load_si512(kTileOrder.word),
                                  _mm512_shuffle_epi8(rows, _mm512_load_si512(kTileOrder.block)));
#endif
}
#elif HALFSPACE_AVX2
HWY_INLINE __m256i to_tiles(__m256i rows) {
  const __m256i block = _mm256_setr_epi8(0, 4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15, 0, 4,
                                         8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15);
  return _mm256_permutevar8x32_epi32(_mm256_shuffle_epi8(rows, block),
                                     _mm256_setr_epi32(0, 4, 1, 5, 2, 6, 3, 7));
}
#endif

// One work item.
template <bool kOne>
HWY_INLINE void window(const SetupBatch& batch, std::size_t samples, const WorkItem& item,
                       Cursor& cursor) {
  const DF df;
  const DPlace dp;
  const std::size_t lane = item.lane;
  const std::size_t column = item.column;
  const std::size_t row = item.row;
  const auto corner = hn::Set(dp, batch.corner[column]);
  const std::uint32_t* HWY_RESTRICT place = kWindow.place + row / 2;
  const std::size_t count = kOne ? 1 : samples;
#if HALFSPACE_AVX512 || HALFSPACE_AVX2
  const VF y = hn::Load(df, kWindow.row + row);
  const auto ones = hn::Set(DU(), ~0u);
  const auto inside = hn::Set(DU(), batch.columns[column]);
  V64 masks[kOne ? 1 : kMaxSamples] = {hn::Zero(D64())};
  for (std::size_t m = 0; m < count; ++m) {
    // Columns from `left` up to but without `right`; a shift by 32 or more leaves nothing.
    const Crossings c = crossings(batch, m, lane, column, y);
    const auto left = hn::Shl(ones, hn::BitCast(DU(), to_int(c.left)));
    const auto right = hn::Shl(ones, hn::BitCast(DU(), to_int(c.right)));
    const auto* rows = reinterpret_cast<const std::uint8_t*>(&batch.rows[m][lane]) + row / 8;
#if HALFSPACE_AVX512
    std::uint16_t live;
    std::memcpy(&live, rows, sizeof live);
    // left & ~right & inside
    masks[m] =
        V64{to_tiles(_mm512_maskz_ternarylogic_epi32(live, left.raw, right.raw, inside.raw, 0x20))};
#else
    const auto bits = hn::And(hn::AndNot(right, left), inside);
    masks[m] = hn::And(V64{to_tiles(bits.raw)}, hn::Set(D64(), kRows.byte[*rows]));
#endif
  }
  emit<kOne>(cursor, samples, masks, hn::Add(corner, hn::Load(dp, place)));
#else
  // Bytes of columns, then two tiles at a time. `end` keeps columns within 16 bits.
  const VF end = hn::Set(df, batch.column_end[column]);
  std::uint64_t left[kOne ? 1 : kMaxSamples], right[kOne ? 1 : kMaxSamples];
  for (std::size_t m = 0; m < count; ++m) {
    const Crossings low = crossings(batch, m, lane, column, hn::Load(df, kWindow.row + row));
    const Crossings high = crossings(batch, m, lane, column, hn::Load(df, kWindow.row + row + 4));
    const std::uint64_t rows = kRows.byte[batch.rows[m][lane] >> row & 0xff];
    left[m] = row_bytes({to_int(hn::Min(low.left, end)), to_int(hn::Min(high.left, end))}, 0);
    right[m] =
        row_bytes({to_int(hn::Min(low.right, end)), to_int(hn::Min(high.right, end))}, 0) & rows;
  }
  for (std::size_t tile = 0; tile < 4; tile += hn::MaxLanes(D64())) {
    V64 masks[kOne ? 1 : kMaxSamples] = {hn::Zero(D64())};
    for (std::size_t m = 0; m < count; ++m) masks[m] = tile_masks(left[m], right[m], tile);
    emit<kOne>(cursor, samples, masks, hn::Add(corner, hn::Load(dp, place + tile)));
  }
#endif
}

}  // namespace halfspace::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
