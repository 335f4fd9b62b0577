// SPDX-License-Identifier: Apache-2.0
//
// Colours of the lanes that passed the depth test, several samples per pixel.
#if defined(HALFSPACE_SIMD_FRAME_SAMPLES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HALFSPACE_SIMD_FRAME_SAMPLES_INL
#undef HALFSPACE_SIMD_FRAME_SAMPLES_INL
#else
#define HALFSPACE_SIMD_FRAME_SAMPLES_INL
#endif

#include "frame_perspective-inl.hpp"
#include "frame_planes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace halfspace::simd::HWY_NAMESPACE {

// The planes' units at lane 0 of a tile, in the low halves.
template <int kGridLog2>
HWY_INLINE void tile_bases(const FrameConstants& c, const ShadePlanes& planes, std::uint32_t place,
                           VQuad (&base)[kShades / kQuadLanes]) {
  const DQuad d;
  const auto x = hn::Set(d, std::uint64_t{place & 0xffff} << kGridLog2);
  const auto y = hn::Set(d, std::uint64_t{place >> 16} << kGridLog2);
  for (std::size_t at = 0; at < kShades; at += kQuadLanes) {
    const auto sum = hn::Add(hn::Load(d, &planes.origin[at]),
                             hn::Add(mul_small(hn::Load(d, &planes.dx[at]), x),
                                     mul_small(hn::Load(d, &planes.dy[at]), y)));
    base[at / kQuadLanes] = hn::ShiftRightSame(sum, c.gradient_bits);
  }
}

// Colours as the store keeps them.
HWY_INLINE VU divided(const Divider& divide, const VI (&value)[kShades], VU level) {
  return divided(divide, divisor(divide, value[3]), value, level);
}

// One tile on its way through the colour kernel.
struct ShadeTile {
  std::uint32_t base[kShades];     // at lane 0
  std::uint32_t lane_dx[kShades];  // a lane to the right, a lane down
  std::uint32_t lane_dy[kShades];
  VI step[kShades];              // of the lanes of the first vector
  std::uint32_t level;           // ShadePlanes'
  const std::uint64_t* covered;  // of each sample, when there are several
  const std::uint64_t* passed;
  const std::uint64_t* deltas;  // [sample][shade]
};

template <int kGridLog2>
HWY_INLINE void start_tile(const FrameConstants& c, const ShadePlanes& planes, std::uint32_t place,
                           ShadeTile& tile) {
  VQuad quad[kShades / kQuadLanes];
  tile_bases<kGridLog2>(c, planes, place, quad);
  alignas(32) std::uint64_t base[kShades];
  for (std::size_t at = 0; at < kShades; at += kQuadLanes) {
    hn::Store(quad[at / kQuadLanes], DQuad(), base + at);
  }
  for (std::size_t n = 0; n < kShades; ++n) {
    tile.base[n] = static_cast<std::uint32_t>(base[n]);
    tile.lane_dx[n] = static_cast<std::uint32_t>(planes.lane_dx[n]);
    tile.lane_dy[n] = static_cast<std::uint32_t>(planes.lane_dy[n]);
    tile.step[n] = plane_step<kGridLog2>(tile.lane_dx[n], tile.lane_dy[n]);
  }
  tile.level = planes.level;
}

// Moves each lane from the pixel's centre to its first covered sample, where a sample is missing.
HWY_INLINE void move_to_samples(const FrameConstants& c, const ShadeTile& tile, std::size_t lane,
                                VI (&value)[kShades]) {
  const DI d;
  const auto samples = static_cast<std::size_t>(c.samples);
  std::uint64_t full = kAllLanes;
  for (std::size_t m = 0; m < samples; ++m) full &= tile.covered[m] >> lane;
  if (full == kAllLanes) return;
  VI delta[kShades];
  for (std::size_t n = 0; n < kShades; ++n) delta[n] = hn::Zero(d);
  for (std::size_t m = samples; m-- > 0;) {
    const auto here = mask_of(tile.covered[m] >> lane & ~full & kAllLanes);
    for (std::size_t n = 0; n < kShades; ++n) {
      const auto by = static_cast<std::int32_t>(tile.deltas[m * kShades + n]);
      delta[n] = hn::IfThenElse(here, hn::Set(d, by), delta[n]);
    }
  }
  for (std::size_t n = 0; n < kShades; ++n) value[n] = hn::Add(value[n], delta[n]);
}

// The colours of the vector at `lane`.
template <int kGridLog2>
HWY_INLINE VU shade_vector(const FrameConstants& c, const Divider& divide, const ShadeTile& tile,
                           std::size_t lane) {
  const DI d;
  VI value[kShades];
  for (std::size_t n = 0; n < kShades; ++n) {
    const std::uint32_t at =
        tile.base[n] + lane_offset<kGridLog2>(lane, tile.lane_dx[n], tile.lane_dy[n]);
    value[n] = hn::Add(tile.step[n], hn::Set(d, static_cast<std::int32_t>(at)));
  }
  move_to_samples(c, tile, lane, value);
  return divided(divide, value, hn::Set(DU(), tile.level));
}

HWY_INLINE void store_colors(VU color, std::uint64_t bits, std::uint32_t* HWY_RESTRICT at) {
  const DU d;
  const auto mask = hn::RebindMask(d, mask_of(bits));
  hn::Store(hn::IfThenElse(mask, color, hn::Load(d, at)), d, at);
}

// The colours of one tile.
template <int kGridLog2>
HWY_INLINE void shade_tile(const FrameConstants& c, const Divider& divide, const ShadeTile& tile,
                           std::uint64_t any, std::uint32_t* HWY_RESTRICT stored) {
  constexpr std::size_t kTile = std::size_t{1} << (2 * kGridLog2);
  while (any != 0) {
    const std::size_t lane = first_vector(any);
    const VU color = shade_vector<kGridLog2>(c, divide, tile, lane);
    for (std::size_t m = 0; m < static_cast<std::size_t>(c.samples); ++m) {
      const std::uint64_t bits = tile.passed[m] >> lane & kAllLanes;
      if (bits != 0) store_colors(color, bits, stored + m * kTile + lane);
    }
    any &= ~(kAllLanes << lane);
  }
}

// The tiles in order, by triangles whose planes are made.
template <int kGridLog2>
HWY_NOINLINE void shade_samples(const FrameConstants& frame, FrameStore& store,
                                PassedTiles& passed) {
  const FrameConstants c = frame;  // nothing aliases it
  const Divider divide = divider(c);
  constexpr std::size_t kTile = std::size_t{1} << (2 * kGridLog2);
  const auto samples = static_cast<std::size_t>(c.samples);
  ShadeTile tile;
  const std::size_t count = passed.count;
  const PassedTile* const tiles = passed.tile.data();
  const ShadePlanes* const planes = passed.planes.data();
  FrameStore::Tiles memory = store.tiles();
  for (std::size_t k = 0; k < count; ++k) {
    const PassedTile& at = tiles[k];
    start_tile<kGridLog2>(c, planes[at.triangle], at.place, tile);
    tile.covered = passed.covered.data() + k * samples;
    tile.passed = passed.passed.data() + k * samples;
    tile.deltas = passed.deltas.data() + at.triangle * samples * kShades;
    std::uint32_t* stored = memory.at(at.place & 0xffff, at.place >> 16) + samples * kTile;
    shade_tile<kGridLog2>(c, divide, tile, at.passed, stored);
  }
}

}  // namespace halfspace::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
