// SPDX-License-Identifier: Apache-2.0
//
// Colours of the lanes that passed the depth test.
#if defined(HALFSPACE_SIMD_FRAME_SHADE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HALFSPACE_SIMD_FRAME_SHADE_INL
#undef HALFSPACE_SIMD_FRAME_SHADE_INL
#else
#define HALFSPACE_SIMD_FRAME_SHADE_INL
#endif

#include "frame_pixels-inl.hpp"
#include "frame_samples-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace halfspace::simd::HWY_NAMESPACE {

// A triangle's values and level at the lanes of a tile that it has, in place of what is there.
template <int kGridLog2, std::size_t kVectors>
HWY_INLINE void add_values(const FrameConstants& c, const ShadePlanes& planes, std::uint32_t place,
                           std::uint64_t lanes, VI (&value)[kVectors][kShades],
                           VU (&level)[kVectors]) {
  const DI d;
  VQuad quad[kShades / kQuadLanes];
  tile_bases<kGridLog2>(c, planes, place, quad);
#if HALFSPACE_AVX512
  // Every vector of the tile, as in bin_depths().
  const __m512i bases = _mm512_castsi256_si512(quad[0].raw);
  for (std::size_t n = 0; n < kShades; ++n) {
    const auto dx = static_cast<std::uint32_t>(planes.lane_dx[n]);
    const auto dy = static_cast<std::uint32_t>(planes.lane_dy[n]);
    const VI base{_mm512_permutexvar_epi32(_mm512_set1_epi32(static_cast<int>(2 * n)), bases)};
    VI at = hn::Add(plane_step<kGridLog2>(dx, dy), base);
    const VI down = hn::Set(d, static_cast<std::int32_t>(dy * (kLanes >> kGridLog2)));
    for (std::size_t v = 0; v < kVectors; ++v) {
      const auto here = static_cast<__mmask16>(lanes >> (v * kLanes));
      value[v][n] = VI{_mm512_mask_mov_epi32(value[v][n].raw, here, at.raw)};
      at = hn::Add(at, down);
    }
  }
  for (std::size_t v = 0; v < kVectors; ++v) {
    const auto here = static_cast<__mmask16>(lanes >> (v * kLanes));
    level[v] = VU{_mm512_mask_set1_epi32(level[v].raw, here, static_cast<int>(planes.level))};
  }
#else
  alignas(32) std::uint64_t base[kShades];
  for (std::size_t at = 0; at < kShades; at += kQuadLanes) {
    hn::Store(quad[at / kQuadLanes], DQuad(), base + at);
  }
  VI step[kShades];
  for (std::size_t n = 0; n < kShades; ++n) {
    const auto dx = static_cast<std::uint32_t>(planes.lane_dx[n]);
    const auto dy = static_cast<std::uint32_t>(planes.lane_dy[n]);
    const auto at = static_cast<std::uint32_t>(base[n]);
    step[n] = hn::Add(plane_step<kGridLog2>(dx, dy), hn::Set(d, static_cast<std::int32_t>(at)));
  }
  while (lanes != 0) {
    const std::size_t lane = first_vector(lanes);
    const auto here = mask_of(lanes >> lane & kAllLanes);
    lanes &= ~(kAllLanes << lane);
    for (std::size_t n = 0; n < kShades; ++n) {
      const auto dx = static_cast<std::uint32_t>(planes.lane_dx[n]);
      const auto dy = static_cast<std::uint32_t>(planes.lane_dy[n]);
      const std::uint32_t down = lane_offset<kGridLog2>(lane, dx, dy);
      VI& to = value[lane / kLanes][n];
      to = hn::IfThenElse(here, hn::Add(step[n], hn::Set(d, static_cast<std::int32_t>(down))), to);
    }
    VU& to = level[lane / kLanes];
    to = hn::IfThenElse(hn::RebindMask(DU(), here), hn::Set(DU(), planes.level), to);
  }
#endif
}

// Planes of the triangles that passed anywhere, once each; PassedTile::triangle becomes their
// index.
HWY_INLINE void shade_planes(const FrameConstants& c, const FrameTriangle* triangles,
                             PassedTiles& passed) {
  const auto samples = static_cast<std::size_t>(c.samples);
  if (passed.shaded.size() <= passed.slot.size()) passed.shaded.resize(passed.slot.size() + 1);
  // Without a branch: whether a tile is its triangle's first is a coin toss.
  std::uint32_t found = 0;
  PassedTile* const tiles = passed.tile.data();
  std::uint32_t* const shaded = passed.shaded.data();
  std::uint32_t* const slot = passed.slot.data();
  for (std::size_t k = 0; k < passed.count; ++k) {
    const std::uint32_t triangle = tiles[k].triangle;
    shaded[found] = triangle;
    found += slot[triangle] == 0;
    slot[triangle] = slot[triangle] == 0 ? found : slot[triangle];
    tiles[k].triangle = slot[triangle] - 1;
  }
  for (std::size_t i = 0; i < found; ++i) slot[shaded[i]] = 0;
  if (passed.planes.size() < found) passed.planes.resize(2 * std::size_t{found});
  if (samples > 1 && passed.deltas.size() < found * samples * kShades) {
    passed.deltas.resize(2 * found * samples * kShades);
  }
  listed_planes(c, triangles, shaded, found, passed.planes.data());
  for (std::size_t i = 0; samples > 1 && i < found; ++i) {
    for (std::size_t m = 0; m < samples; ++m) {
      for (std::size_t n = 0; n < kShades; ++n) {
        passed.deltas[(i * samples + m) * kShades + n] =
            frame_delta(passed.planes[i].dx[n], passed.planes[i].dy[n], static_cast<int>(m), c);
      }
    }
  }
}

// A vector of colours into the picture, in the lanes of `bits`. The others keep what they have; in
// a fresh tile that is the background.
template <int kGridLog2>
HWY_INLINE void put_colors(VU color, std::uint64_t bits, bool fresh, VU background,
                           std::uint32_t* to, std::size_t stride) {
  const VU old = fresh ? background : load_pixels<kGridLog2>(DU(), to, stride);
  const auto mask = hn::RebindMask(DU(), mask_of(bits));
  store_pixels<kGridLog2>(DU(), hn::IfThenElse(mask, color, old), to, stride);
}

// Fetches the pixels of a tile that is needed some entries later.
template <int kGridLog2>
HWY_INLINE void fetch_pixels(const PassedTile* at, const PassedTile* end,
                             const FrameStore::Tiles& memory) {
  constexpr std::ptrdiff_t kEntriesAhead = 8;
  if (end - at <= kEntriesAhead) return;
  const std::uint32_t place = at[kEntriesAhead].place & ~PassedTile::kFresh;
  const std::uint32_t* line = memory.pixels(place & 0xffff, place >> 16);
  for (std::size_t y = 0; y < std::size_t{1} << kGridLog2; ++y, line += memory.stride) {
    __builtin_prefetch(line, 1);
  }
}

// A tile that one triangle has: its values never leave the registers.
template <int kGridLog2>
HWY_INLINE void shade_alone(const FrameConstants& c, const Divider& divide,
                            const ShadePlanes& planes, std::uint32_t place, std::uint64_t lanes,
                            bool fresh, VU background, const TilePixels& pixels) {
  constexpr std::size_t kVectors = (std::size_t{1} << (2 * kGridLog2)) / kLanes;
  const DI d;
  VQuad quad[kShades / kQuadLanes];
  tile_bases<kGridLog2>(c, planes, place, quad);
  alignas(32) std::uint64_t base[kShades];
  for (std::size_t at = 0; at < kShades; at += kQuadLanes) {
    hn::Store(quad[at / kQuadLanes], DQuad(), base + at);
  }
  VI first[kShades];
  std::uint32_t dx[kShades], dy[kShades];
  for (std::size_t n = 0; n < kShades; ++n) {
    dx[n] = static_cast<std::uint32_t>(planes.lane_dx[n]);
    dy[n] = static_cast<std::uint32_t>(planes.lane_dy[n]);
    first[n] = hn::Add(plane_step<kGridLog2>(dx[n], dy[n]),
                       hn::Set(d, static_cast<std::int32_t>(static_cast<std::uint32_t>(base[n]))));
  }
  const VU level = hn::Set(DU(), planes.level);
  for (std::size_t v = 0; v < kVectors; ++v) {
    const std::uint64_t bits = lanes >> (v * kLanes) & kAllLanes;
    if (bits == 0 && !fresh) continue;
    VI value[kShades];
    for (std::size_t n = 0; n < kShades; ++n) {
      const std::uint32_t down = lane_offset<kGridLog2>(v * kLanes, dx[n], dy[n]);
      value[n] = hn::Add(first[n], hn::Set(d, static_cast<std::int32_t>(down)));
    }
    put_colors<kGridLog2>(divided(divide, value, level), bits, fresh, background,
                          pixels.at<kGridLog2>(v * kLanes), pixels.stride);
  }
}

// One sample: the lanes of a tile get their values triangle by triangle, and are divided together.
template <int kGridLog2>
HWY_NOINLINE void shade_tiles(const FrameConstants& frame, FrameStore& store,
                              const PassedTiles& passed) {
  const FrameConstants c = frame;  // nothing aliases it
  const Divider divide = divider(c);
  constexpr std::size_t kTile = std::size_t{1} << (2 * kGridLog2);
  constexpr std::size_t kVectors = kTile / kLanes;
  const PassedTile* at = passed.tile.data();
  const PassedTile* const end = at + passed.count;
  const ShadePlanes* const planes = passed.planes.data();
  const FrameStore::Tiles memory = store.tiles();
  const VU background = hn::Set(DU(), store.background());
  while (at != end) {
    const bool fresh = (at->place & PassedTile::kFresh) != 0;
    const std::uint32_t place = at->place & ~PassedTile::kFresh;
    const TilePixels pixels{memory.pixels(place & 0xffff, place >> 16), memory.stride};
    fetch_pixels<kGridLog2>(at, end, memory);
    if (at + 1 == end || at[1].place != place) {
      shade_alone<kGridLog2>(c, divide, planes[at->triangle], place, at->passed, fresh, background,
                             pixels);
      ++at;
      continue;
    }
    std::uint64_t any = 0;
    VI value[kVectors][kShades];
    VU level[kVectors];
    for (std::size_t v = 0; v < kVectors; ++v) {
      for (VI& shade : value[v]) shade = hn::Zero(DI());
      level[v] = hn::Zero(DU());
    }
    do {
      any |= at->passed;
      add_values<kGridLog2>(c, planes[at->triangle], place, at->passed, value, level);
      ++at;
    } while (at != end && at->place == place);
    for (std::size_t v = 0; v < kVectors; ++v) {
      const std::uint64_t bits = any >> (v * kLanes) & kAllLanes;
      if (bits == 0 && !fresh) continue;
      put_colors<kGridLog2>(divided(divide, value[v], level[v]), bits, fresh, background,
                            pixels.at<kGridLog2>(v * kLanes), pixels.stride);
    }
  }
}

void Shade(const FrameConstants& c, const FrameTriangle* triangles, FrameStore& store,
           PassedTiles& passed) {
  shade_planes(c, triangles, passed);
  if (c.config.grid_log2 == 3) {
    c.samples == 1 ? shade_tiles<3>(c, store, passed) : shade_samples<3>(c, store, passed);
  } else {
    c.samples == 1 ? shade_tiles<2>(c, store, passed) : shade_samples<2>(c, store, passed);
  }
}

}  // namespace halfspace::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
