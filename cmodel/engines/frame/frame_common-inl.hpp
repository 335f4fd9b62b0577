// SPDX-License-Identifier: Apache-2.0
//
// What the depth and colour kernels share: lanes of a tile in vectors, masks as bits.
#if defined(HALFSPACE_SIMD_FRAME_COMMON_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HALFSPACE_SIMD_FRAME_COMMON_INL
#undef HALFSPACE_SIMD_FRAME_COMMON_INL
#else
#define HALFSPACE_SIMD_FRAME_COMMON_INL
#endif

#include "../coverage/vectors-inl.hpp"
#include "frame_kernel.hpp"
#include "frame_planes.hpp"

HWY_BEFORE_NAMESPACE();
namespace halfspace::simd::HWY_NAMESPACE {

inline constexpr std::uint64_t kAllLanes = (std::uint64_t{1} << kLanes) - 1;

// Column and row of the first lanes of a tile, for both grids, and the bit of each lane.
struct LaneTable {
  alignas(64) std::int32_t i[2][16], j[2][16];
  alignas(64) std::int32_t bit[16];
  constexpr LaneTable() : i{}, j{}, bit{} {
    for (int lane = 0; lane < 16; ++lane) {
      for (int grid = 0; grid < 2; ++grid) {
        i[grid][lane] = lane & ((4 << grid) - 1);
        j[grid][lane] = lane >> (2 + grid);
      }
      bit[lane] = 1 << lane;
    }
  }
};
inline constexpr LaneTable kLaneTable;

// Lanes whose bit is set, and back.
HWY_INLINE hn::Mask<DI> mask_of(std::uint64_t bits) {
#if HALFSPACE_AVX512
  return hn::Mask<DI>{static_cast<__mmask16>(bits)};
#else
  const DI d;
  const VI bit = hn::Load(d, kLaneTable.bit);
  return hn::Eq(hn::And(hn::Set(d, static_cast<std::int32_t>(bits)), bit), bit);
#endif
}

HWY_INLINE std::uint64_t bits_of(hn::Mask<DI> mask) {
#if HALFSPACE_AVX512
  return mask.raw;
#elif HALFSPACE_AVX2
  return static_cast<std::uint64_t>(_mm256_movemask_ps(_mm256_castsi256_ps(mask.raw)));
#elif HALFSPACE_SSE
  return static_cast<std::uint64_t>(_mm_movemask_ps(_mm_castsi128_ps(mask.raw)));
#else
  const DI d;
  alignas(16) std::int32_t lane[kLanes];
  hn::Store(hn::VecFromMask(d, mask), d, lane);
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < kLanes; ++i) bits |= std::uint64_t{lane[i] != 0} << i;
  return bits;
#endif
}

// The first lane of the first vector that holds a set bit.
HWY_INLINE std::size_t first_vector(std::uint64_t bits) {
  return static_cast<std::size_t>(std::countr_zero(bits)) & ~(kLanes - 1);
}

// dx i + dy j of the lanes of a tile's first vector, and of the first lane of another.
template <int kGridLog2>
HWY_INLINE VI plane_step(std::uint32_t dx, std::uint32_t dy) {
  const DI d;
  return hn::Add(
      hn::Mul(hn::Load(d, kLaneTable.i[kGridLog2 - 2]), hn::Set(d, static_cast<std::int32_t>(dx))),
      hn::Mul(hn::Load(d, kLaneTable.j[kGridLog2 - 2]), hn::Set(d, static_cast<std::int32_t>(dy))));
}

template <int kGridLog2>
HWY_INLINE std::uint32_t lane_offset(std::size_t lane, std::uint32_t dx, std::uint32_t dy) {
  const auto at = static_cast<std::uint32_t>(lane);
  return dx * (at & ((1u << kGridLog2) - 1)) + dy * (at >> kGridLog2);
}

}  // namespace halfspace::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
