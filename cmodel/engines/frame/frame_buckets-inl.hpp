// SPDX-License-Identifier: Apache-2.0
//
// The depth test of one sample, tile by tile: a tile's depths are read and written once for all of
// its triangles.
#if defined(HALFSPACE_SIMD_FRAME_BUCKETS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HALFSPACE_SIMD_FRAME_BUCKETS_INL
#undef HALFSPACE_SIMD_FRAME_BUCKETS_INL
#else
#define HALFSPACE_SIMD_FRAME_BUCKETS_INL
#endif

#include "frame_depth-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace halfspace::simd::HWY_NAMESPACE {

// Tests records[0] .. records[count - 1] in order against one tile, in the lanes that are open.
// won[r]: lanes that passed.
// Depths stay in registers where they fit: a record then takes every vector of the tile, covered or
// not, because skipping one costs more than testing it.
template <int kGridLog2, bool kLess>
HWY_INLINE void bin_depths(const DepthTest& test, const BinRecord* HWY_RESTRICT records,
                           std::size_t count, std::uint64_t open, bool is_new,
                           std::uint32_t* HWY_RESTRICT stored, std::uint64_t* HWY_RESTRICT won) {
  constexpr std::size_t kVectors = (std::size_t{1} << (2 * kGridLog2)) / kLanes;
#if HALFSPACE_AVX512
  const DI d;
  auto* HWY_RESTRICT at = reinterpret_cast<std::int32_t*>(stored);
  VI depth[kVectors];
  for (std::size_t v = 0; v < kVectors; ++v) {
    depth[v] = is_new ? test.clear : hn::Load(d, at + v * kLanes);
  }
  for (std::size_t r = 0; r < count; ++r) {
    const BinRecord& record = records[r];
    const std::uint32_t base = record.base + test.round;
    const VI first = hn::Add(plane_step<kGridLog2>(record.lane_dx, record.lane_dy),
                             hn::Set(d, static_cast<std::int32_t>(base)));
    std::uint64_t passed = 0;
    for (std::size_t v = 0; v < kVectors; ++v) {
      const std::size_t lane = v * kLanes;
      const std::uint32_t down = lane_offset<kGridLog2>(lane, record.lane_dx, record.lane_dy);
      const VI units = hn::Add(first, hn::Set(d, static_cast<std::int32_t>(down)));
      const VI z = depth_of<kLess>(test, units);
      const auto covered = static_cast<__mmask16>((record.covered & open) >> lane);
      const auto wins = static_cast<__mmask16>(covered & wins_over<kLess>(test, z, depth[v]).raw);
      depth[v] = VI{_mm512_mask_mov_epi32(depth[v].raw, wins, z.raw)};
      passed |= std::uint64_t{wins} << lane;
    }
    won[r] = passed;
  }
  for (std::size_t v = 0; v < kVectors; ++v) hn::Store(depth[v], d, at + v * kLanes);
#else
  const DI d;
  for (std::size_t v = 0; is_new && v < kVectors; ++v) {
    hn::Store(test.clear, d, reinterpret_cast<std::int32_t*>(stored) + v * kLanes);
  }
  for (std::size_t r = 0; r < count; ++r) {
    const BinRecord& record = records[r];
    won[r] = test_tile<kGridLog2, kLess>(test, record.lane_dx, record.lane_dy,
                                         record.base + test.round, record.covered & open, stored);
  }
#endif
}

// Fetches the depths of a tile that is needed kAhead tiles later.
inline constexpr std::size_t kAhead = 6;
HWY_INLINE void fetch_ahead(const BinRange& buckets, std::size_t t,
                            const FrameStore::Tiles& memory) {
  if (t + kAhead >= buckets.count) return;
  const std::uint32_t place = buckets.tiles[t + kAhead].place;
  const std::uint32_t* const row = memory.rows[place >> 16];
  if (row == nullptr) return;
  const std::uint32_t* const at = row + (place & 0xffff) * memory.tile_words;
  for (std::size_t word = 0; word < memory.tile_words; word += 16) __builtin_prefetch(at + word, 1);
}

// Counts the records of a tile that the scissor covers, and true: none of it is drawn.
HWY_INLINE bool is_hidden(const BinRecord* records, std::size_t count, std::uint64_t open,
                          std::uint64_t& fragments) {
  std::uint64_t any = 0, covered = 0;
  for (std::size_t r = 0; r < count; ++r) {
    any |= records[r].covered & open;
    covered += static_cast<std::uint64_t>(std::popcount(records[r].covered));
  }
  if (any != 0) return false;
  fragments += covered;
  return true;
}

template <int kGridLog2, bool kLess>
HWY_NOINLINE void bin_tiles(const FrameConstants& c, const BinRange& range, FrameStore& store,
                            PassedTiles& out, FrameCounts& counts) {
  const DepthTest test = depth_constants(c);
  const BinRange buckets = range;
  FrameStore::Tiles memory = store.tiles();
  std::size_t begin = buckets.begin;
  const std::size_t total = buckets.count == 0 ? 0 : buckets.tiles[buckets.count - 1].end - begin;
  out.reserve(total + 1, 1);
  if (out.won.size() < total) out.won.resize(2 * total);
  std::uint64_t* const won = out.won.data();
  PassedTile* const passed = out.tile.data();
  std::size_t found = out.count;
  std::uint64_t fragments = 0;
  std::uint64_t shaded = 0;
  for (std::size_t t = 0; t < buckets.count; ++t) {
    const std::uint32_t place = buckets.tiles[t].place;
    fetch_ahead(buckets, t, memory);
    const BinRecord* const records = buckets.records + begin;
    const std::size_t count = buckets.tiles[t].end - begin;
    begin += count;
    const std::uint64_t open_here = open_lanes(c, place);
    if (~open_here != 0 && is_hidden(records, count, open_here, fragments)) continue;
    bool is_new = false;
    std::uint32_t* const stored = memory.tile(place & 0xffff, place >> 16, is_new);
    bin_depths<kGridLog2, kLess>(test, records, count, open_here, is_new, stored, won);
    const std::size_t first = found;
    std::uint64_t open = ~std::uint64_t{0};  // pixels that no later record has
    for (std::size_t r = count; r-- > 0;) {
      const std::uint64_t last = won[r] & open;
      open &= ~last;
      fragments += static_cast<std::uint64_t>(std::popcount(records[r].covered));
      shaded += static_cast<std::uint64_t>(std::popcount(won[r]));
      passed[found] = {place, records[r].triangle, last};
      found += last != 0;
    }
    if (!is_new) continue;
    passed[first].place = place | PassedTile::kFresh;
    if (found == first) store.clear_pixels(place & 0xffff, place >> 16);
  }
  out.count = found;
  counts.tiles += total;
  counts.samples += fragments;
  counts.fragments += fragments;
  counts.shaded += shaded;
}

void Buckets(const FrameConstants& c, const BinRange& buckets, FrameStore& store, PassedTiles& out,
             FrameCounts& counts) {
  if (c.config.grid_log2 == 3) {
    only_less(c) ? bin_tiles<3, true>(c, buckets, store, out, counts)
                 : bin_tiles<3, false>(c, buckets, store, out, counts);
  } else {
    only_less(c) ? bin_tiles<2, true>(c, buckets, store, out, counts)
                 : bin_tiles<2, false>(c, buckets, store, out, counts);
  }
}

}  // namespace halfspace::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
