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
  VI clear, top;
  int down, up;         // units are shifted down, and up again for more depth bits than they have
  std::uint32_t round;  // half of what is shifted out
  hn::Mask<DI> passes[3];  // less, equal, greater
};

HWY_INLINE DepthTest depth_constants(const FrameConstants& c) {
  const DI d;
  const int down = HWY_MAX(kPlaneBits - c.config.depth_bits, 0);
  const int up = HWY_MAX(c.config.depth_bits - kPlaneBits, 0);
  const auto most = static_cast<std::int32_t>(c.config.depth_max());
  const auto lets = [&](int compared) HWY_ATTR {
    return mask_of((passing(c.depth_function) >> compared & 1) != 0 ? kAllLanes : 0);
  };
  return {hn::Set(d, static_cast<std::int32_t>(c.clear)),
          hn::Set(d, up > 0 ? 1 << kPlaneBits : most),
          down,
          up,
          down > 0 ? std::uint32_t{1} << (down - 1) : 0,
          {lets(0), lets(1), lets(2)}};
}

// The function is `less` and depths are positive in 32 bits with sign: a comparison is all.
inline bool only_less(const FrameConstants& c) {
  return c.depth_function == DepthFunction::kLess && c.config.depth_bits <= kPlaneBits;
}

// Depths of a vector of lanes from the plane there with the rounding added.
template <bool kLess>
HWY_INLINE VI depth_of(const DepthTest& test, VI units) {
  const DI d;
  const VI least = hn::Max(hn::ShiftRightSame(units, test.down), hn::Zero(d));
  if (kLess) return least;  // what is above the top wins over no depth, cut or not
  const VI cut = hn::Min(least, test.top);
  // 1.0 is one more than fits: all ones.
  return hn::Sub(hn::ShiftLeftSame(cut, test.up), hn::ShiftRight<kPlaneBits>(cut));
}

// Lanes where a depth wins over an old one.
template <bool kLess>
HWY_INLINE hn::Mask<DI> wins_over(const DepthTest& test, VI depth, VI old) {
  if (kLess) return hn::Lt(depth, old);
  const VI sign = hn::Set(DI(), INT32_MIN);  // depths have none
  const VI a = hn::Xor(depth, sign), b = hn::Xor(old, sign);
  return hn::Or(
      hn::Or(hn::And(hn::Lt(a, b), test.passes[0]), hn::And(hn::Eq(a, b), test.passes[1])),
      hn::And(hn::Gt(a, b), test.passes[2]));
}

// The depth test of a vector of lanes: `bits` are covered, `units` the plane there with the
// rounding added. Returns those that passed; their depths are stored.
template <bool kLess>
HWY_INLINE std::uint64_t test_vector(const DepthTest& test, VI units, std::uint64_t bits,
                                     std::uint32_t* stored) {
  const DI d;
  auto* HWY_RESTRICT at = reinterpret_cast<std::int32_t*>(stored);
  const VI depth = depth_of<kLess>(test, units);
  const VI old = hn::Load(d, at);
  const auto wins = hn::And(wins_over<kLess>(test, depth, old), mask_of(bits));
  hn::Store(hn::IfThenElse(wins, depth, old), d, at);
  return bits_of(wins);
}

// One sample plane of one tile, as depth_test(). base: at lane 0, with the rounding added.
template <int kGridLog2, bool kLess>
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
    passed |= test_vector<kLess>(test, units, bits, stored + lane) << lane;
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
  const FrameConstants* constants;
  FrameCounts counts;

  HWY_INLINE void point_into(PassedTiles& out) {
    tile = out.tile.data();
    covered = out.covered.data();
    passed = out.passed.data();
  }
};

// All samples of one tile of one triangle; appends it when any lane passed.
template <int kGridLog2, bool kOne, bool kLess>
HWY_INLINE void depth_tile(const DepthTest& test, std::size_t record, std::uint32_t word,
                           const std::uint64_t* mask, DepthLoop& loop) {
  const std::uint32_t triangle = loop.tiles.triangle[record];
  const FramePlane& plane = loop.tiles.depth[triangle];
  const std::uint32_t column = word & 0xffff;
  const std::uint32_t row = word >> 16;
  const std::uint64_t sum = plane.origin + plane.dx * (std::uint64_t{column} << kGridLog2) +
                            plane.dy * (std::uint64_t{row} << kGridLog2);
  const std::uint32_t base =
      static_cast<std::uint32_t>(sum >> loop.constants->gradient_bits) + test.round;
  constexpr std::size_t kTile = std::size_t{1} << (2 * kGridLog2);
  ++loop.counts.tiles;
  std::uint64_t any = mask[0];
  for (std::size_t m = 1; !kOne && m < loop.samples; ++m) any |= mask[m];
  loop.counts.fragments += static_cast<std::uint64_t>(std::popcount(any));
  const std::uint64_t open = open_lanes(*loop.constants, word);
  std::uint32_t* stored = (any & open) == 0 ? nullptr : loop.memory.tile(column, row);
  std::uint64_t passed = 0;
  if (kOne) {
    if (stored == nullptr) return;
    passed = test_tile<kGridLog2, kLess>(test, plane.lane_dx, plane.lane_dy, base, mask[0] & open,
                                         stored);
  } else {
    for (std::size_t m = 0; m < loop.samples; ++m) {
      loop.counts.samples += static_cast<std::uint64_t>(std::popcount(mask[m]));
      if (stored == nullptr) continue;
      const std::uint32_t delta = loop.tiles.depth_delta[triangle * loop.samples + m];
      const std::uint64_t won = test_tile<kGridLog2, kLess>(
          test, plane.lane_dx, plane.lane_dy, base + delta, mask[m] & open, stored + m * kTile);
      loop.covered[loop.count * loop.samples + m] = mask[m];
      loop.passed[loop.count * loop.samples + m] = won;
      passed |= won;
    }
  }
  loop.counts.shaded += static_cast<std::uint64_t>(std::popcount(passed));
  loop.tile[loop.count] = {word, triangle, passed};
  loop.count += passed != 0;
}

template <int kGridLog2, bool kOne, bool kLess>
HWY_NOINLINE void depth_records(const FrameConstants& frame, const FrameTiles& tiles,
                                const RecordOrder& records, FrameStore& store, PassedTiles& out,
                                FrameCounts& counts) {
  const FrameConstants c = frame;  // nothing aliases it
  const DepthTest test = depth_constants(c);
  const RecordOrder order = records;
  const auto samples = static_cast<std::size_t>(c.samples);
  out.reserve(order.count + 1, samples);
  DepthLoop loop{tiles, store.tiles(), nullptr, nullptr, nullptr, out.count, samples, &c, {}};
  loop.point_into(out);
  std::uint64_t mask[kMaxSamples];
  constexpr std::uint64_t kFull = kGridLog2 == 3 ? ~std::uint64_t{0} : 0xffff;
  for (std::size_t k = 0; k < order.count; ++k) {
    const std::size_t record = order.at(k);
    const std::uint32_t word = loop.tiles.place[record];
    if (word >> 31 == 0) {
      for (std::size_t m = 0; m < (kOne ? 1 : samples); ++m) mask[m] = loop.tiles.mask[m][record];
      depth_tile<kGridLog2, kOne, kLess>(test, record, word, mask, loop);
      continue;
    }
    const std::uint64_t length = loop.tiles.mask[0][record];
    out.count = loop.count;
    out.reserve(order.count - k + length, samples);
    loop.point_into(out);
    for (std::size_t m = 0; m < samples; ++m) mask[m] = kFull;
    for (std::uint32_t i = 0; i < length; ++i) {
      depth_tile<kGridLog2, kOne, kLess>(test, record, (word & ~kRunFlag) + i, mask, loop);
    }
  }
  out.count = loop.count;
  counts.tiles += loop.counts.tiles;
  counts.samples += kOne ? loop.counts.fragments : loop.counts.samples;
  counts.fragments += loop.counts.fragments;
  counts.shaded += loop.counts.shaded;
}

template <int kGridLog2, bool kLess>
HWY_INLINE void depth_of_grid(const FrameConstants& c, const FrameTiles& tiles,
                              const RecordOrder& order, FrameStore& store, PassedTiles& out,
                              FrameCounts& counts) {
  c.samples == 1 ? depth_records<kGridLog2, true, kLess>(c, tiles, order, store, out, counts)
                 : depth_records<kGridLog2, false, kLess>(c, tiles, order, store, out, counts);
}

void Depth(const FrameConstants& c, const FrameTiles& tiles, const RecordOrder& order,
           FrameStore& store, PassedTiles& out, FrameCounts& counts) {
  if (c.config.grid_log2 == 3) {
    only_less(c) ? depth_of_grid<3, true>(c, tiles, order, store, out, counts)
                 : depth_of_grid<3, false>(c, tiles, order, store, out, counts);
  } else {
    only_less(c) ? depth_of_grid<2, true>(c, tiles, order, store, out, counts)
                 : depth_of_grid<2, false>(c, tiles, order, store, out, counts);
  }
}

}  // namespace halfspace::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
