// SPDX-License-Identifier: Apache-2.0
//
// half_plane_grid for three edges at once, from a table A i + B j that every level shares.
#if defined(HALFSPACE_CYCLE_GRID_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HALFSPACE_CYCLE_GRID_INL
#undef HALFSPACE_CYCLE_GRID_INL
#else
#define HALFSPACE_CYCLE_GRID_INL
#endif

#include <hwy/highway.h>

#include "../common/targets.hpp"
#include "cycle_kernel.hpp"

HWY_BEFORE_NAMESPACE();
namespace halfspace::cycle::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using DI = hn::ScalableTag<std::int32_t>;
using VI = hn::Vec<DI>;
inline constexpr std::size_t kLanes = hn::MaxLanes(DI());
static_assert(64 % kLanes == 0);

// Lane numbers: column and row.
struct LaneTable {
  alignas(64) std::int32_t column[64];
  alignas(64) std::int32_t row[64];
  alignas(64) std::uint32_t place[64];  // to add to the place of the node's first tile
  constexpr LaneTable() : column{}, row{}, place{} {
    for (int i = 0; i < 64; ++i) {
      column[i] = i & 7;
      row[i] = i >> 3;
      place[i] = static_cast<std::uint32_t>((i >> 3) << 16 | (i & 7));
    }
  }
};
inline constexpr LaneTable kLane;

// Bit i: lane i is negative.
HWY_INLINE std::uint64_t negative(VI v) {
#if HALFSPACE_AVX512
  return _mm512_movepi32_mask(v.raw);
#elif HALFSPACE_AVX2
  return static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps(v.raw)));
#elif HALFSPACE_SSE
  return static_cast<unsigned>(_mm_movemask_ps(_mm_castsi128_ps(v.raw)));
#else
  std::int32_t lane[kLanes];
  hn::StoreU(v, DI(), lane);
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < kLanes; ++i) bits |= std::uint64_t{lane[i] < 0} << i;
  return bits;
#endif
}

struct alignas(64) Table {
  std::int32_t lane[3][64];  // [edge][j 8 + i] = A i + B j
};

HWY_INLINE void make_table(const std::int32_t (&a)[3], const std::int32_t (&b)[3], Table& table) {
  const DI d;
  for (std::size_t k = 0; k < 3; ++k) {
    const VI va = hn::Set(d, a[k]);
    const VI vb = hn::Set(d, b[k]);
    constexpr std::size_t kStart = kLanes < 8 ? 8 : kLanes;  // whole rows
    for (std::size_t v = 0; v < kStart; v += kLanes) {
      VI lanes = hn::Add(hn::Mul(va, hn::Load(d, kLane.column + v)),
                         hn::Mul(vb, hn::Load(d, kLane.row + v)));
      const VI step =
          hn::Set(d, static_cast<std::int32_t>(static_cast<std::uint32_t>(b[k]) * (kStart / 8)));
      for (std::size_t at = v; at < 64; at += kStart) {
        hn::Store(lanes, d, table.lane[k] + at);
        lanes = hn::Add(lanes, step);
      }
    }
  }
}

// Lanes in which all three edges are non-negative.
HWY_INLINE std::uint64_t grid_mask(const std::int32_t (&edge)[3][64], std::int32_t base0,
                                   std::int32_t base1, std::int32_t base2) {
  const DI d;
  const VI b0 = hn::Set(d, base0);
  const VI b1 = hn::Set(d, base1);
  const VI b2 = hn::Set(d, base2);
#if HALFSPACE_AVX512
  __mmask16 bits[4];
  for (std::size_t v = 0; v < 4; ++v) {
    const VI s0 = hn::Add(hn::Load(d, edge[0] + 16 * v), b0);
    const VI s1 = hn::Add(hn::Load(d, edge[1] + 16 * v), b1);
    const VI s2 = hn::Add(hn::Load(d, edge[2] + 16 * v), b2);
    bits[v] = _mm512_movepi32_mask(hn::Or3(s0, s1, s2).raw);
  }
  return ~static_cast<std::uint64_t>(
      _mm512_kunpackd(_mm512_kunpackw(bits[3], bits[2]), _mm512_kunpackw(bits[1], bits[0])));
#else
  std::uint64_t bits = 0;
  for (std::size_t v = 0; v < 64; v += kLanes) {
    const VI s0 = hn::Add(hn::Load(d, edge[0] + v), b0);
    const VI s1 = hn::Add(hn::Load(d, edge[1] + v), b1);
    const VI s2 = hn::Add(hn::Load(d, edge[2] + v), b2);
    bits |= negative(hn::Or(hn::Or(s0, s1), s2)) << v;
  }
  return ~bits;
#endif
}

// Lanes of the box, columns x0 .. x1 and rows y0 .. y1 of the grid, cut to it; empty when outside.
HWY_INLINE std::uint64_t range_mask(int x0, int y0, int x1, int y1) {
  x0 = std::max(x0, 0);
  y0 = std::max(y0, 0);
  x1 = std::min(x1, 7);
  y1 = std::min(y1, 7);
  if (x0 > x1 || y0 > y1) return 0;
  const std::uint64_t columns = 0xffu >> (7 - x1) & 0xffu << x0 & 0xffu;
  const std::uint64_t rows = (~std::uint64_t{0} >> (56 - 8 * y1)) & (~std::uint64_t{0} << (8 * y0));
  return columns * 0x0101010101010101u & rows;
}

}  // namespace halfspace::cycle::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
