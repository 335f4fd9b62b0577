// SPDX-License-Identifier: Apache-2.0
//
// The depth test of one tile after another, as many pixels at a time as a vector holds.
#if defined(HALFSPACE_SIMD_FRAME_DEPTH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HALFSPACE_SIMD_FRAME_DEPTH_INL
#undef HALFSPACE_SIMD_FRAME_DEPTH_INL
#else
#define HALFSPACE_SIMD_FRAME_DEPTH_INL
#endif

#include "frame_common-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace halfspace::simd::HWY_NAMESPACE {

// What a frame makes constant.
struct DepthTest {
  VI far, bias;
  int shift;
  std::uint32_t round;
};

HWY_INLINE DepthTest depth_constants(const FrameConstants& c) {
  const DI d;
  // A depth wins when it is below what is stored plus this.
  const std::int32_t bias = c.depth_function == DepthFunction::kLess        ? 0
                            : c.depth_function == DepthFunction::kLessEqual ? 1
                                                                            : 1 << 30;
  const int shift = kPlaneBits - c.config.depth_bits;
  return {hn::Set(d, static_cast<std::int32_t>(c.far)), hn::Set(d, bias), shift,
          std::uint32_t{1} << (shift - 1)};
}

// Depths of a vector of lanes from the plane there with the rounding added.
HWY_INLINE VI depth_of(const DepthTest& test, VI units) {
  const DI d;
  return hn::Min(hn::Max(hn::ShiftRightSame(units, test.shift), hn::Zero(d)), test.far);
}

// The depth test of a vector of lanes: `bits` are covered, `units` the plane there with the
// rounding added. Returns those that passed; their depths are stored.
HWY_INLINE std::uint64_t test_vector(const DepthTest& test, VI units, std::uint64_t bits,
                                     std::uint32_t* stored) {
  const DI d;
  auto* HWY_RESTRICT at = reinterpret_cast<std::int32_t*>(stored);
  const VI depth = depth_of(test, units);
  const VI old = hn::Load(d, at);
  const auto wins = hn::And(hn::Lt(depth, hn::Add(old, test.bias)), mask_of(bits));
  hn::Store(hn::IfThenElse(wins, depth, old), d, at);
  return bits_of(wins);
}

// One sample plane of one tile, as depth_test(). base: at lane 0, with the rounding added.
template <int kGridLog2>
HWY_INLINE std::uint64_t test_tile(const DepthTest& test, std::uint32_t lane_dx,
                                   std::uint32_t lane_dy, std::uint32_t base, std::uint64_t covered,
                                   std::uint32_t* HWY_RESTRICT stored) {
  const DI d;
  const VI step = plane_step<kGridLog2>(lane_dx, lane_dy);
  std::uint64_t passed = 0;
  while (covered != 0) {
    const std::size_t lane = first_vector(covered);
    const std::uint64_t bits = covered >> lane & kAllLanes;
    covered &= ~(kAllLanes << lane);
    const std::uint32_t at = base + lane_offset<kGridLog2>(lane, lane_dx, lane_dy);
    const VI units = hn::Add(step, hn::Set(d, static_cast<std::int32_t>(at)));
    passed |= test_vector(test, units, bits, stored + lane) << lane;
  }
  return passed;
}

// What the loop over records keeps in registers: stores to tiles alias none of it.
struct DepthLoop {
  FrameTiles tiles;
  FrameStore::Tiles memory;
  PassedTile* tile;
  std::uint64_t* covered;
  std::uint64_t* passed;
  std::size_t count;
  std::size_t samples;
  int gradient_bits;
  FrameCounts counts;

  HWY_INLINE void point_into(PassedTiles& out) {
    tile = out.tile.data();
    covered = out.covered.data();
    passed = out.passed.data();
  }
};

// All samples of one tile of one triangle; appends it when any lane passed.
template <int kGridLog2, bool kOne>
HWY_INLINE void depth_tile(const DepthTest& test, std::size_t record, std::uint32_t word,
                           const std::uint64_t* mask, DepthLoop& loop) {
  const std::uint32_t triangle = loop.tiles.triangle[record];
  const FramePlane& plane = loop.tiles.depth[triangle];
  const std::uint32_t column = word & 0xffff;
  const std::uint32_t row = word >> 16;
  const std::uint64_t sum = plane.origin + plane.dx * (std::uint64_t{column} << kGridLog2) +
                            plane.dy * (std::uint64_t{row} << kGridLog2);
  const std::uint32_t base = static_cast<std::uint32_t>(sum >> loop.gradient_bits) + test.round;
  std::uint32_t* stored = loop.memory.tile(column, row);
  constexpr std::size_t kTile = std::size_t{1} << (2 * kGridLog2);
  ++loop.counts.tiles;
  std::uint64_t passed = 0;
  if (kOne) {
    loop.counts.fragments += static_cast<std::uint64_t>(std::popcount(mask[0]));
    passed = test_tile<kGridLog2>(test, plane.lane_dx, plane.lane_dy, base, mask[0], stored);
  } else {
    std::uint64_t any = 0;
    for (std::size_t m = 0; m < loop.samples; ++m) {
      const std::uint32_t delta = loop.tiles.depth_delta[triangle * loop.samples + m];
      const std::uint64_t won = test_tile<kGridLog2>(test, plane.lane_dx, plane.lane_dy,
                                                     base + delta, mask[m], stored + m * kTile);
      loop.covered[loop.count * loop.samples + m] = mask[m];
      loop.passed[loop.count * loop.samples + m] = won;
      passed |= won;
      any |= mask[m];
      loop.counts.samples += static_cast<std::uint64_t>(std::popcount(mask[m]));
    }
    loop.counts.fragments += static_cast<std::uint64_t>(std::popcount(any));
  }
  loop.counts.shaded += static_cast<std::uint64_t>(std::popcount(passed));
  loop.tile[loop.count] = {word, triangle, passed};
  loop.count += passed != 0;
}

template <int kGridLog2, bool kOne>
HWY_NOINLINE void depth_records(const FrameConstants& c, const FrameTiles& tiles,
                                const RecordOrder& records, FrameStore& store, PassedTiles& out,
                                FrameCounts& counts) {
  const DepthTest test = depth_constants(c);
  const RecordOrder order = records;
  const auto samples = static_cast<std::size_t>(c.samples);
  out.reserve(order.count + 1, samples);
  DepthLoop loop{tiles,     store.tiles(), nullptr,         nullptr, nullptr,
                 out.count, samples,       c.gradient_bits, {}};
  loop.point_into(out);
  std::uint64_t mask[kMaxSamples];
  constexpr std::uint64_t kFull = kGridLog2 == 3 ? ~std::uint64_t{0} : 0xffff;
  for (std::size_t k = 0; k < order.count; ++k) {
    const std::size_t record = order.at(k);
    const std::uint32_t word = loop.tiles.place[record];
    if (word >> 31 == 0) {
      for (std::size_t m = 0; m < (kOne ? 1 : samples); ++m) mask[m] = loop.tiles.mask[m][record];
      depth_tile<kGridLog2, kOne>(test, record, word, mask, loop);
      continue;
    }
    const std::uint64_t length = loop.tiles.mask[0][record];
    out.count = loop.count;
    out.reserve(order.count - k + length, samples);
    loop.point_into(out);
    for (std::size_t m = 0; m < samples; ++m) mask[m] = kFull;
    for (std::uint32_t i = 0; i < length; ++i) {
      depth_tile<kGridLog2, kOne>(test, record, (word & ~kRunFlag) + i, mask, loop);
    }
  }
  out.count = loop.count;
  counts.tiles += loop.counts.tiles;
  counts.samples += kOne ? loop.counts.fragments : loop.counts.samples;
  counts.fragments += loop.counts.fragments;
  counts.shaded += loop.counts.shaded;
}

void Depth(const FrameConstants& c, const FrameTiles& tiles, const RecordOrder& order,
           FrameStore& store, PassedTiles& out, FrameCounts& counts) {
  if (c.config.grid_log2 == 3) {
    c.samples == 1 ? depth_records<3, true>(c, tiles, order, store, out, counts)
                   : depth_records<3, false>(c, tiles, order, store, out, counts);
  } else {
    c.samples == 1 ? depth_records<2, true>(c, tiles, order, store, out, counts)
                   : depth_records<2, false>(c, tiles, order, store, out, counts);
  }
}

}  // namespace halfspace::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
