// SPDX-License-Identifier: Apache-2.0
//
// A triangle of any size, eight rows at a time, in double.
#if defined(HALFSPACE_SIMD_STRIP_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HALFSPACE_SIMD_STRIP_INL
#undef HALFSPACE_SIMD_STRIP_INL
#else
#define HALFSPACE_SIMD_STRIP_INL
#endif

#include "vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace halfspace::simd::HWY_NAMESPACE {

inline constexpr double kRow[8] = {0, 1, 2, 3, 4, 5, 6, 7};
inline constexpr double kStripRow[8] = {0, 8, 16, 24, 32, 40, 48, 56};
inline constexpr std::uint32_t kTileIndex[8] = {0, 1, 2, 3, 4, 5, 6, 7};

// The four sides of one triangle.
struct Sides {
  VD slope[kSides];
  VD base[kSides];
};

HWY_INLINE Sides load_sides(const SetupBatch& batch, std::size_t m, std::size_t lane) {
  const DD d;
  Sides sides;
  for (std::size_t e = 0; e < kSides; ++e) {
    sides.slope[e] = hn::Set(d, batch.wide_slope[e][lane]);
    sides.base[e] = hn::Set(d, batch.wide_base[m][e][lane]);
  }
  return sides;
}

HWY_INLINE VD crossing(const Sides& sides, std::size_t e, VD y) {
  return hn::MulAdd(sides.slope[e], y, sides.base[e]);
}

// Tile columns of up to kWideLanes strips: `first` to `last` may be touched, `full` of them from
// `full_first` on are covered by every sample of every row.
struct StripRanges {
  alignas(64) std::int32_t first[8], last[8], full_first[8], full[8];
};

// Strips y, y + 8, ... Between a strip's first and last row in the box every side is monotone, so
// its extremes are there; the greater of two lines is least at or above the greater of their
// leasts.
template <bool kOne>
HWY_INLINE void strip_ranges(const SetupBatch& batch, std::size_t samples, std::size_t lane,
                             std::int32_t y, std::int32_t full_y_first, std::int32_t full_y_last,
                             StripRanges& out) {
  const DD d;
  const DHalf dh;
  const VD x_first = hn::Set(d, batch.x_first[lane]);
  const VD x_end = hn::Set(d, batch.x_last[lane] + 1);
  const VD strip = hn::Add(hn::LoadU(d, kStripRow), hn::Set(d, y));
  const VD strip_last = hn::Add(strip, hn::Set(d, 7.0));
  const VD top = hn::Max(strip, hn::Set(d, batch.y_first[lane]));
  const VD bottom = hn::Min(strip_last, hn::Set(d, batch.y_last[lane]));
  VD left_least = x_end;
  VD left_greatest = x_first;
  VD right_least = x_end;
  VD right_greatest = x_first;
  const std::size_t count = kOne ? 1 : samples;
  for (std::size_t m = 0; m < count; ++m) {
    const Sides sides = load_sides(batch, m, lane);
    VD least[kSides], greatest[kSides];
    for (std::size_t e = 0; e < kSides; ++e) {
      const VD t = crossing(sides, e, top);
      const VD b = crossing(sides, e, bottom);
      least[e] = hn::Min(t, b);
      greatest[e] = hn::Max(t, b);
    }
    left_least = hn::Min(left_least, hn::Max(least[0], least[1]));
    left_greatest = hn::Max(left_greatest, hn::Max(greatest[0], greatest[1]));
    right_least = hn::Min(right_least, hn::Min(least[2], least[3]));
    right_greatest = hn::Max(right_greatest, hn::Min(greatest[2], greatest[3]));
  }
  const auto first = hn::ShiftRight<3>(to_int(hn::Max(left_least, x_first)));
  const auto last =
      hn::ShiftRight<3>(hn::Sub(to_int(hn::Min(right_greatest, x_end)), hn::Set(dh, 1)));
  const auto full_first =
      hn::ShiftRight<3>(hn::Add(to_int(hn::Min(left_greatest, x_end)), hn::Set(dh, 7)));
  const auto full_end = hn::ShiftRight<3>(to_int(hn::Max(right_least, x_first)));
  const VD whole = hn::IfThenElseZero(
      hn::And(hn::Ge(strip, hn::Set(d, full_y_first)), hn::Le(strip_last, hn::Set(d, full_y_last))),
      hn::Set(d, 65536.0));
  const auto full = hn::Min(hn::Sub(full_end, full_first), to_int(whole));
  hn::Store(first, dh, out.first);
  hn::Store(last, dh, out.last);
  hn::Store(full_first, dh, out.full_first);
  hn::Store(hn::Max(full, hn::Zero(dh)), dh, out.full);
}

// Rounds eight rows down to columns.
HWY_INLINE Rows to_rows(const VD (&v)[8 / kWideLanes]) {
#if HALFSPACE_AVX512
  return {to_int(v[0])};
#elif HALFSPACE_AVX2
  return {to_int(v[0]), to_int(v[1])};
#else
  const hn::Full128<std::int32_t> d;
  return {hn::Combine(d, to_int(v[1]), to_int(v[0])), hn::Combine(d, to_int(v[3]), to_int(v[2]))};
#endif
}

struct Span {
  Rows left, right;
};

// The columns of rows y .. y + 7, cut to the box's.
HWY_INLINE Span strip_span(const SetupBatch& batch, const Sides& sides, std::size_t lane,
                           std::int32_t y) {
  const DD d;
  const VD x_first = hn::Set(d, batch.x_first[lane]);
  const VD x_end = hn::Set(d, batch.x_last[lane] + 1);
  VD left[8 / kWideLanes], right[8 / kWideLanes];
  for (std::size_t i = 0; i < 8 / kWideLanes; ++i) {
    const VD row = hn::Add(hn::LoadU(d, kRow + i * kWideLanes), hn::Set(d, y));
    const VD l = hn::Max(crossing(sides, 0, row), crossing(sides, 1, row));
    const VD r = hn::Min(crossing(sides, 2, row), crossing(sides, 3, row));
    left[i] = hn::Max(hn::Min(l, x_end), x_first);
    right[i] = hn::Max(hn::Min(r, x_end), x_first);
  }
  return {to_rows(left), to_rows(right)};
}

// The rows y .. y + 7 that lie in first .. last, as bytes.
HWY_INLINE std::uint64_t rows_between(std::int32_t y, std::int32_t first, std::int32_t last) {
  const int skip = first <= y ? 0 : first >= y + 8 ? 8 : first - y;
  const int keep = last >= y + 7 ? 8 : last < y ? 0 : last - y + 1;
  return kRows.byte[(0xffu << skip) & 0xffu & ((1u << keep) - 1u)];
}

// One strip: its partial tiles, in columns from which the run of full tiles is cut out, then the
// run. The caller has made room.
template <bool kOne>
HWY_INLINE void strip(const SetupBatch& batch, std::size_t samples, const Sides& side0,
                      std::size_t lane, std::int32_t y, std::int32_t first, std::int32_t last,
                      std::int32_t full_first, std::int32_t full, Cursor& cursor) {
  const std::size_t count = kOne ? 1 : samples;
  Span span[kOne ? 1 : kMaxSamples];
  std::uint64_t rows[kOne ? 1 : kMaxSamples];
  for (std::size_t m = 0; m < count; ++m) {
    span[m] = strip_span(batch, kOne ? side0 : load_sides(batch, m, lane), lane, y);
    rows[m] = rows_between(y, batch.row_first[m][lane], batch.row_last[m][lane]);
  }
  const DPlace dp;
  const auto index = hn::LoadU(dp, kTileIndex);
  const std::uint32_t corner = static_cast<std::uint32_t>(y) << 13;
  const auto gap = hn::Set(dp, static_cast<std::uint32_t>(full));
  const auto gap_from = hn::Set(hn::RebindToSigned<DPlace>(), full == 0 ? 65536 : full_first);
  constexpr std::int32_t step = hn::MaxLanes(D64());
  for (std::int32_t t = first; t <= last - full; t += step) {
    V64 masks[kOne ? 1 : kMaxSamples] = {hn::Zero(D64())};
    for (std::size_t m = 0; m < count; ++m) {
      masks[m] = tile_masks(row_bytes(span[m].left, 8 * t),
                            row_bytes(span[m].right, 8 * (t + full)) & rows[m]);
    }
    const auto column = hn::Add(index, hn::Set(dp, static_cast<std::uint32_t>(t)));
    const auto skipped = hn::IfThenElse(
        hn::RebindMask(dp, hn::Lt(hn::BitCast(hn::RebindToSigned<DPlace>(), column), gap_from)),
        column, hn::Add(column, gap));
    emit<kOne>(cursor, samples, masks, hn::Add(skipped, hn::Set(dp, corner)));
  }
  *cursor.mask(0) = static_cast<std::uint64_t>(full);
  if (!kOne) {
    for (std::size_t m = 1; m < samples; ++m) *cursor.mask(m) = 0;
  }
  cursor.place[cursor.count] = kRunFlag | corner | static_cast<std::uint32_t>(full_first);
  cursor.count += full > 0;
}

// All strips of the triangle in `lane`.
template <bool kOne>
HWY_NOINLINE void strips(const SetupBatch& batch, std::size_t samples, std::size_t lane,
                         RecordBuffer& buffer) {
  std::int32_t full_y_first = batch.row_first[0][lane];
  std::int32_t full_y_last = batch.row_last[0][lane];
  for (std::size_t m = 1; m < samples; ++m) {
    full_y_first = HWY_MAX(full_y_first, batch.row_first[m][lane]);
    full_y_last = HWY_MIN(full_y_last, batch.row_last[m][lane]);
  }
  // A strip emits at most the tiles of its box and one run.
  const auto wide =
      static_cast<std::size_t>((batch.x_last[lane] >> 3) - (batch.x_first[lane] >> 3));
  const std::size_t most = kWideLanes * (wide + 2);
  const Sides side0 = load_sides(batch, 0, lane);
  const std::int32_t y_last = batch.y_last[lane];
  Cursor cursor(buffer);
  StripRanges ranges;
  for (std::int32_t y = batch.y_block[lane]; y <= y_last;
       y += 8 * static_cast<std::int32_t>(kWideLanes)) {
    if (cursor.count + most > buffer.capacity()) {
      buffer.count = cursor.count;
      buffer.reserve(cursor.count + most);
      cursor = Cursor(buffer);
    }
    strip_ranges<kOne>(batch, samples, lane, y, full_y_first, full_y_last, ranges);
    const std::int32_t left = (y_last - y) / 8 + 1;
    for (std::int32_t i = 0; i < HWY_MIN(left, static_cast<std::int32_t>(kWideLanes)); ++i) {
      strip<kOne>(batch, samples, side0, lane, y + 8 * i, ranges.first[i], ranges.last[i],
                  ranges.full_first[i], ranges.full[i], cursor);
    }
  }
  buffer.count = cursor.count;
}

}  // namespace halfspace::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
