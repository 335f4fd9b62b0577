// SPDX-License-Identifier: Apache-2.0
//
// Vector types and the few operations that are not Highway's, for one instruction set.
#if defined(HALFSPACE_SIMD_COMMON_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HALFSPACE_SIMD_COMMON_INL
#undef HALFSPACE_SIMD_COMMON_INL
#else
#define HALFSPACE_SIMD_COMMON_INL
#endif

#include <hwy/highway.h>

#include <bit>
#include <cstring>

#include "../common/targets.hpp"
#include "coverage_kernel.hpp"
#include "setup_batch.hpp"

HWY_BEFORE_NAMESPACE();
namespace halfspace::simd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using DI = hn::ScalableTag<std::int32_t>;
using DU = hn::ScalableTag<std::uint32_t>;
using DF = hn::ScalableTag<float>;
using DD = hn::ScalableTag<double>;
using D64 = hn::ScalableTag<std::uint64_t>;
using D8 = hn::ScalableTag<std::uint8_t>;
using DHalf = hn::Rebind<std::int32_t, DD>;     // as many int32 as doubles in a vector
using DPlace = hn::Rebind<std::uint32_t, D64>;  // as many places as masks
using VI = hn::Vec<DI>;
using VF = hn::Vec<DF>;
using VD = hn::Vec<DD>;
using V64 = hn::Vec<D64>;
using VPlace = hn::Vec<DPlace>;

inline constexpr std::size_t kLanes = hn::MaxLanes(DI());
inline constexpr std::size_t kWideLanes = hn::MaxLanes(DD());
static_assert(kBatch % kLanes == 0 && kLanes <= 16);

// Towards zero, for values that fit or whose lane does not matter: no repair of overflow.
HWY_INLINE VI to_int(VF v) {
#if HALFSPACE_AVX512
  return VI{_mm512_cvttps_epi32(v.raw)};
#elif HALFSPACE_AVX2
  return VI{_mm256_cvttps_epi32(v.raw)};
#elif HALFSPACE_SSE
  return VI{_mm_cvttps_epi32(v.raw)};
#else
  return hn::ConvertTo(DI(), v);
#endif
}

HWY_INLINE hn::Vec<DHalf> to_int(VD v) {
#if HALFSPACE_AVX512
  return hn::Vec<DHalf>{_mm512_cvttpd_epi32(v.raw)};
#elif HALFSPACE_AVX2
  return hn::Vec<DHalf>{_mm256_cvttpd_epi32(v.raw)};
#elif HALFSPACE_SSE
  return hn::Vec<DHalf>{_mm_cvttpd_epi32(v.raw)};
#else
  return hn::DemoteTo(DHalf(), v);
#endif
}

// Where records go; the buffer's pointers in registers.
struct Cursor {
  explicit Cursor(RecordBuffer& buffer)
      : masks(buffer.mask(0)),
        stride(buffer.stride()),
        place(buffer.place.data()),
        count(buffer.count) {}
  // Where the next record's mask of sample m goes.
  HWY_INLINE std::uint64_t* mask(std::size_t m) const { return masks + m * stride + count; }

  std::uint64_t* masks;
  std::size_t stride;
  std::uint32_t* place;
  std::size_t count;
};

#if HALFSPACE_AVX2
// For each set of four lanes, the lanes that stay, moved to the front.
struct CompactTable {
  alignas(32) std::uint32_t mask[16][8];
  alignas(16) std::uint8_t place[16][16];
  constexpr CompactTable() : mask{}, place{} {
    for (unsigned set = 0; set < 16; ++set) {
      unsigned to = 0;
      for (unsigned from = 0; from < 4; ++from) {
        if ((set >> from & 1u) == 0) continue;
        mask[set][2 * to] = 2 * from;
        mask[set][2 * to + 1] = 2 * from + 1;
        for (unsigned byte = 0; byte < 4; ++byte) {
          place[set][4 * to + byte] = static_cast<std::uint8_t>(4 * from + byte);
        }
        ++to;
      }
    }
  }
};
inline constexpr CompactTable kCompact;
#endif

// Appends the lanes that cover anything in any sample; stores whole vectors.
template <bool kOne>
HWY_INLINE void emit(Cursor& cursor, std::size_t samples, const V64* masks, VPlace places) {
  V64 any = masks[0];
  if (!kOne) {
    for (std::size_t m = 1; m < samples; ++m) any = hn::Or(any, masks[m]);
  }
  const std::size_t count = kOne ? 1 : samples;
#if HALFSPACE_AVX512
  const __mmask8 live = _mm512_test_epi64_mask(any.raw, any.raw);
  for (std::size_t m = 0; m < count; ++m) {
    _mm512_storeu_si512(cursor.mask(m), _mm512_maskz_compress_epi64(live, masks[m].raw));
  }
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(cursor.place + cursor.count),
                      _mm256_maskz_compress_epi32(live, places.raw));
  cursor.count += static_cast<std::size_t>(_mm_popcnt_u32(live));
#elif HALFSPACE_AVX2
  const __m256i dead = _mm256_cmpeq_epi64(any.raw, _mm256_setzero_si256());
  const auto live = static_cast<unsigned>(_mm256_movemask_pd(_mm256_castsi256_pd(dead))) ^ 15u;
  const __m256i order = _mm256_load_si256(reinterpret_cast<const __m256i*>(kCompact.mask[live]));
  for (std::size_t m = 0; m < count; ++m) {
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(cursor.mask(m)),
                        _mm256_permutevar8x32_epi32(masks[m].raw, order));
  }
  const __m128i bytes = _mm_load_si128(reinterpret_cast<const __m128i*>(kCompact.place[live]));
  _mm_storeu_si128(reinterpret_cast<__m128i*>(cursor.place + cursor.count),
                   _mm_shuffle_epi8(places.raw, bytes));
  cursor.count += static_cast<std::size_t>(_mm_popcnt_u32(live));
#else
  constexpr std::size_t n = hn::MaxLanes(D64());
  alignas(16) std::uint64_t mask[kOne ? 1 : kMaxSamples][n];
  alignas(16) std::uint64_t live[n];
  alignas(16) std::uint32_t place[4];
  for (std::size_t m = 0; m < count; ++m) hn::Store(masks[m], D64(), mask[m]);
  hn::Store(any, D64(), live);
  hn::Store(places, DPlace(), place);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t m = 0; m < count; ++m) *cursor.mask(m) = mask[m][i];
    cursor.place[cursor.count] = place[i];
    cursor.count += (kOne ? mask[0][i] : live[i]) != 0;
  }
#endif
}

// Bit 8 j + i of lane t: column 8 t + i lies in [left, right) of row j; byte j of `left` and
// `right` are row j's.
struct ByteTable {
  alignas(64) std::uint8_t column[64];  // 8 t in all bytes of lane t
  alignas(16) std::uint8_t from[16];    // columns i >= index
  constexpr ByteTable() : column{}, from{} {
    for (unsigned i = 0; i < 64; ++i) column[i] = static_cast<std::uint8_t>(i & ~7u);
    for (unsigned i = 0; i < 8; ++i) from[i] = static_cast<std::uint8_t>(0xff << i);
  }
};
inline constexpr ByteTable kBytes;

HWY_INLINE V64 tile_masks(std::uint64_t left, std::uint64_t right, std::size_t first_lane = 0) {
  const D8 d;
  const auto column = hn::LoadU(d, kBytes.column + 8 * first_lane);
  const auto from = hn::LoadDup128(d, kBytes.from);
  const auto eight = hn::Set(d, 8);
  const auto l = hn::SaturatedSub(hn::BitCast(d, hn::Set(D64(), left)), column);
  const auto r = hn::SaturatedSub(hn::BitCast(d, hn::Set(D64(), right)), column);
  return hn::BitCast(D64(), hn::AndNot(hn::TableLookupBytes(from, hn::Min(r, eight)),
                                       hn::TableLookupBytes(from, hn::Min(l, eight))));
}

// Eight rows of columns.
#if HALFSPACE_AVX512
struct Rows {
  hn::Vec256<std::int32_t> all;
};
#else
struct Rows {
  hn::Vec128<std::int32_t> low, high;
};
#endif

// Columns relative to `base` as bytes, row 0 lowest, saturated to 0..255; columns are < 2^16.
HWY_INLINE std::uint64_t row_bytes(const Rows& rows, std::int32_t base) {
#if HALFSPACE_AVX512
  const __m256i relative = _mm256_max_epi32(_mm256_sub_epi32(rows.all.raw, _mm256_set1_epi32(base)),
                                            _mm256_setzero_si256());
  return static_cast<std::uint64_t>(_mm_cvtsi128_si64(_mm256_cvtusepi32_epi8(relative)));
#elif HALFSPACE_AVX2 || HALFSPACE_SSE
  // The two packs saturate, below as well as above.
  const __m128i from = _mm_set1_epi32(base);
  const __m128i words =
      _mm_packs_epi32(_mm_sub_epi32(rows.low.raw, from), _mm_sub_epi32(rows.high.raw, from));
  return static_cast<std::uint64_t>(_mm_cvtsi128_si64(_mm_packus_epi16(words, words)));
#else
  alignas(16) std::int32_t value[8];
  const hn::Full128<std::int32_t> d;
  hn::Store(rows.low, d, value);
  hn::Store(rows.high, d, value + 4);
  std::uint64_t bytes = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    const std::int32_t relative = value[i] - base;
    bytes |= static_cast<std::uint64_t>(relative < 0     ? 0
                                        : relative > 255 ? 255
                                                         : relative)
             << (8 * i);
  }
  return bytes;
#endif
}

// All ones in byte j when bit j of `rows` is set.
struct RowTable {
  std::uint64_t byte[256];
  constexpr RowTable() : byte{} {
    for (unsigned rows = 0; rows < 256; ++rows) {
      for (unsigned j = 0; j < 8; ++j) {
        if ((rows >> j & 1u) != 0) byte[rows] |= std::uint64_t{0xff} << (8 * j);
      }
    }
  }
};
inline constexpr RowTable kRows;

}  // namespace halfspace::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
