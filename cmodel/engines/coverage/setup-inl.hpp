// SPDX-License-Identifier: Apache-2.0
//
// Triangle setup, second half: crossings, rows and windows of a vector of triangles.
// docs/03_design/coverage_engine.md has the formulas.
#if defined(HALFSPACE_SIMD_SETUP_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HALFSPACE_SIMD_SETUP_INL
#undef HALFSPACE_SIMD_SETUP_INL
#else
#define HALFSPACE_SIMD_SETUP_INL
#endif

#include "group-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace halfspace::simd::HWY_NAMESPACE {

// Slopes and bases in double, for the lanes that need them and their neighbours.
template <bool kOne>
HWY_INLINE void wide_edges(const KernelFrame& frame, const Group& g, std::size_t lane,
                           SetupBatch& out) {
  const DD d;
  const DHalf dh;
  const DI di;
  alignas(64) std::int32_t x[3][kLanes], y[3][kLanes], a[3][kLanes], b[3][kLanes], side[3][kLanes];
  for (std::size_t i = 0; i < 3; ++i) {
    hn::Store(g.x[i], di, x[i]);
    hn::Store(g.y[i], di, y[i]);
    hn::Store(g.a[i], di, a[i]);
    hn::Store(g.b[i], di, b[i]);
    const VI left = hn::VecFromMask(di, g.left[i]);
    hn::Store(hn::Sub(hn::VecFromMask(di, g.right[i]), left), di, side[i]);
  }
  const double per_pixel = 1.0 / static_cast<double>(1 << frame.f);
  const auto fraction = hn::Set(dh, (1 << frame.f) - 1);
  const VD zero = hn::Zero(d);
  for (std::size_t at = 0; at < kLanes; at += kWideLanes) {
    VD da[3], db[3], whole[3], fx[3], fy[3], inverse[3], slope[3];
    hn::Mask<DD> left[3], right[3];
    for (std::size_t i = 0; i < 3; ++i) {
      const auto xi = hn::Load(dh, x[i] + at);
      const auto yi = hn::Load(dh, y[i] + at);
      const VD s = hn::PromoteTo(d, hn::Load(dh, side[i] + at));
      left[i] = hn::Gt(s, zero);
      right[i] = hn::Lt(s, zero);
      da[i] = hn::PromoteTo(d, hn::Load(dh, a[i] + at));
      db[i] = hn::PromoteTo(d, hn::Load(dh, b[i] + at));
      // E = whole 2^f + A (u - fx) + B (v - fy): every product and sum below 2^53.
      const VD px = hn::PromoteTo(d, hn::ShiftRightSame(xi, frame.f));
      const VD py = hn::PromoteTo(d, hn::ShiftRightSame(yi, frame.f));
      whole[i] = hn::Neg(hn::Add(hn::Mul(da[i], px), hn::Mul(db[i], py)));
      fx[i] = hn::PromoteTo(d, hn::And(xi, fraction));
      fy[i] = hn::PromoteTo(d, hn::And(yi, fraction));
      inverse[i] = hn::Div(hn::Set(d, -1.0), da[i]);
      slope[i] = hn::Mul(db[i], inverse[i]);
    }
    VD chosen[kSides];
    choose_sides(left, right, slope, chosen);
    for (std::size_t e = 0; e < kSides; ++e) {
      hn::Store(chosen[e], d, out.wide_slope[e] + lane + at);
    }
    const std::size_t samples = kOne ? 1 : static_cast<std::size_t>(frame.samples);
    for (std::size_t m = 0; m < samples; ++m) {
      VD base[3];
      for (std::size_t i = 0; i < 3; ++i) {
        const VD u = hn::Sub(hn::Set(d, frame.u[m]), fx[i]);
        const VD v = hn::Sub(hn::Set(d, frame.v[m]), fy[i]);
        const VD bias = hn::IfThenElseZero(hn::Lt(da[i], zero), hn::Set(d, -1.0));
        const VD part = hn::Add(hn::Add(hn::Mul(da[i], u), hn::Mul(db[i], v)), bias);
        const VD c = hn::Add(whole[i], hn::Floor(hn::Mul(part, hn::Set(d, per_pixel))));
        base[i] = hn::Mul(hn::Add(hn::Sub(c, da[i]), hn::Set(d, 0.5)), inverse[i]);
      }
      choose_sides(left, right, base, chosen);
      for (std::size_t e = 0; e < kSides; ++e) {
        hn::Store(chosen[e], d, out.wide_base[m][e] + lane + at);
      }
    }
  }
}

// Slopes and bases in float, from edge values at the block's first sample.
template <bool kOne>
HWY_INLINE void narrow_edges(const KernelFrame& frame, const Group& g, const VI (&e)[3],
                             std::size_t lane, SetupBatch& out) {
  const DI d;
  const DF df;
  VF inverse[3], slope[3], chosen[kSides];
  hn::Mask<DF> left[3], right[3];
  for (std::size_t i = 0; i < 3; ++i) {
    inverse[i] = hn::Div(hn::Set(df, -1.0f), hn::ConvertTo(df, g.a[i]));
    slope[i] = hn::Mul(hn::ConvertTo(df, g.b[i]), inverse[i]);
    left[i] = hn::RebindMask(df, g.left[i]);
    right[i] = hn::RebindMask(df, g.right[i]);
  }
  choose_sides(left, right, slope, chosen);
  for (std::size_t s = 0; s < kSides; ++s) hn::Store(chosen[s], df, out.slope[s] + lane);
  const std::size_t samples = kOne ? 1 : static_cast<std::size_t>(frame.samples);
  for (std::size_t m = 0; m < samples; ++m) {
    VF base[3];
    for (std::size_t i = 0; i < 3; ++i) {
      VI at = hn::Add(e[i], hn::BroadcastSignBit(g.a[i]));
      if (!kOne) {
        at = hn::Add(at, hn::Mul(g.a[i], hn::Set(d, frame.u[m] - frame.u[0])));
        at = hn::Add(at, hn::Mul(g.b[i], hn::Set(d, frame.v[m] - frame.v[0])));
      }
      const VI n = hn::Sub(hn::ShiftRightSame(at, frame.f), g.a[i]);
      base[i] = hn::Mul(hn::Add(hn::ConvertTo(df, n), hn::Set(df, 0.5f)), inverse[i]);
    }
    choose_sides(left, right, base, chosen);
    for (std::size_t s = 0; s < kSides; ++s) hn::Store(chosen[s], df, out.base[m][s] + lane);
  }
}

// Bits first .. last of 64, no bit when last < first; -64 < first, last < 64.
HWY_INLINE void store_bits(VI first, VI last, std::uint64_t* to) {
  const DI d;
#if HALFSPACE_AVX512 || HALFSPACE_AVX2
  const hn::Rebind<std::int32_t, D64> dh;
  const hn::RebindToSigned<D64> ds;
  const V64 all = hn::Set(D64(), ~std::uint64_t{0});
  const VI gone = hn::Sub(hn::Set(d, 63), last);  // shifted out; all when 64 or more
  const auto low =
      hn::And(hn::Shl(all, hn::BitCast(D64(), hn::PromoteTo(ds, hn::LowerHalf(dh, first)))),
              hn::Shr(all, hn::BitCast(D64(), hn::PromoteTo(ds, hn::LowerHalf(dh, gone)))));
  const auto high =
      hn::And(hn::Shl(all, hn::BitCast(D64(), hn::PromoteTo(ds, hn::UpperHalf(dh, first)))),
              hn::Shr(all, hn::BitCast(D64(), hn::PromoteTo(ds, hn::UpperHalf(dh, gone)))));
  hn::Store(low, D64(), to);
  hn::Store(high, D64(), to + hn::MaxLanes(D64()));
#else
  const std::uint64_t all = ~std::uint64_t{0};
  alignas(16) std::int32_t from[kLanes], until[kLanes];
  hn::Store(first, d, from);
  hn::Store(last, d, until);
  for (std::size_t i = 0; i < kLanes; ++i) {
    const std::uint64_t bits = (all << (from[i] & 63)) & (all >> (63 - (until[i] & 63)));
    to[i] = until[i] < from[i] ? 0 : bits;
  }
#endif
}

// The box, and the rows of each sample.
template <bool kOne>
HWY_INLINE void store_boxes(const KernelFrame& frame, const Group& g, VI y_block, std::size_t lane,
                            SetupBatch& out) {
  const DI d;
  const bool wide = !hn::AllTrue(d, g.narrow);
  if (wide) {
    hn::Store(g.x_first, d, out.x_first + lane);
    hn::Store(g.y_first, d, out.y_first + lane);
    hn::Store(g.x_last, d, out.x_last + lane);
    hn::Store(g.y_last, d, out.y_last + lane);
    hn::Store(y_block, d, out.y_block + lane);
  }
  const std::size_t samples = kOne ? 1 : static_cast<std::size_t>(frame.samples);
  const std::int32_t up = (1 << frame.f) - 1;
  for (std::size_t m = 0; m < samples; ++m) {
    VI first = g.y_first;
    VI last = g.y_last;
    if (!kOne) {
      first = hn::ShiftRightSame(hn::Add(g.y_min, hn::Set(d, up - frame.v[m])), frame.f);
      last = hn::ShiftRightSame(hn::Sub(g.y_max, hn::Set(d, 1 + frame.v[m])), frame.f);
      first = hn::Max(first, hn::Zero(d));
      last = hn::Min(last, hn::Set(d, frame.height - 1));
    }
    if (wide) {
      hn::Store(first, d, out.row_first[m] + lane);
      hn::Store(last, d, out.row_last[m] + lane);
    }
    store_bits(hn::Sub(first, y_block), hn::Sub(last, y_block), out.rows[m] + lane);
  }
}

// The second column of windows, for groups that have one.
template <bool kOne>
HWY_INLINE void second_column(const KernelFrame& frame, VI last, std::size_t lane,
                              SetupBatch& out) {
  const DI d;
  const DU du;
  const DF df;
  const std::size_t samples = kOne ? 1 : static_cast<std::size_t>(frame.samples);
  const VF width = hn::Set(df, static_cast<float>(kWindowWidth));
  for (std::size_t m = 0; m < samples; ++m) {
    for (std::size_t s = 0; s < kSides; ++s) {
      hn::Store(hn::Sub(hn::Load(df, out.base[m][s] + lane), width), df,
                out.base[m][s] + kBatch + lane);
    }
  }
  hn::Store(hn::Add(hn::Load(du, out.corner + lane), hn::Set(du, kWindowWidth / 8)), du,
            out.corner + kBatch + lane);
#if HALFSPACE_AVX512 || HALFSPACE_AVX2
  const VI gone = hn::Max(hn::Sub(hn::Set(d, 63), last), hn::Zero(d));
  hn::Store(hn::Shr(hn::Set(du, ~0u), hn::BitCast(du, gone)), du, out.columns + kBatch + lane);
#else
  const VF end = hn::ConvertTo(df, hn::Add(last, hn::Set(d, 1)));
  hn::Store(hn::Sub(end, width), df, out.column_end + kBatch + lane);
#endif
}

// The windows of the block.
template <bool kOne>
HWY_INLINE void store_windows(const KernelFrame& frame, const Group& g, VI x_block, VI y_block,
                              int window_rows_log2, std::size_t lane, SetupBatch& out) {
  const DI d;
  const DU du;
  const VI corner = hn::Or(hn::ShiftLeft<13>(y_block), hn::ShiftRight<3>(x_block));
  hn::Store(hn::BitCast(du, corner), du, out.corner + lane);
  const VI last = hn::Sub(g.x_last, x_block);
#if HALFSPACE_AVX512 || HALFSPACE_AVX2
  const auto all = hn::Set(du, ~0u);
  const VI gone = hn::Max(hn::Sub(hn::Set(d, 31), last), hn::Zero(d));
  hn::Store(hn::Shr(all, hn::BitCast(du, gone)), du, out.columns + lane);
#else
  const DF df;
  const VF end = hn::ConvertTo(df, hn::Add(last, hn::Set(d, 1)));
  const VF width = hn::Set(df, static_cast<float>(kWindowWidth));
  hn::Store(hn::Min(end, width), df, out.column_end + lane);
#endif
  const VI one = hn::Set(d, 1);
  const VI across = hn::ShiftRight<5>(last);  // columns of windows, minus 1
  if (!hn::AllTrue(d, hn::Lt(across, hn::Set(d, 1)))) second_column<kOne>(frame, last, lane, out);
  const VI down = hn::Add(hn::ShiftRightSame(hn::Sub(g.y_last, y_block), window_rows_log2), one);
  const VI windows = hn::IfThenElse(hn::Gt(across, hn::Zero(d)), hn::Add(down, down), down);
  const VI work = hn::IfThenElseZero(g.drawn, hn::IfThenElse(g.narrow, windows, one));
  const VI kind = hn::IfThenElseZero(g.drawn, hn::IfThenElse(g.narrow, across, hn::Set(d, 2)));
  hn::Store(hn::BitCast(du, work), du, out.windows + lane);
  hn::Store(hn::BitCast(du, kind), du, out.kind + lane);
}

// Sets up triangles t[0] .. t[kLanes - 1] in lanes `lane` on.
template <bool kOne>
HWY_INLINE void setup_group(const KernelFrame& frame, const Triangle* t, int window_rows_log2,
                            std::size_t lane, VI& lowest, VI& highest, KernelCounts& counts,
                            SetupBatch& out) {
  const DI d;
  Group g;
  load_vertices(t, g);
  box_setup(frame, g, lowest, highest);
  const VI x_block = hn::And(g.x_first, hn::Set(d, ~7));
  const VI y_block = hn::And(g.y_first, hn::Set(d, ~7));
  // Edge values at sample 0 of the block's first pixel; meant only for narrow lanes.
  const VI x = hn::Add(hn::ShiftLeftSame(x_block, frame.f), hn::Set(d, frame.u[0]));
  const VI y = hn::Add(hn::ShiftLeftSame(y_block, frame.f), hn::Set(d, frame.v[0]));
  VI e[3];
  for (std::size_t i = 0; i < 3; ++i) {
    e[i] = hn::Add(hn::Mul(g.a[i], hn::Sub(x, g.x[i])), hn::Mul(g.b[i], hn::Sub(y, g.y[i])));
  }
  orient(frame, e, g, counts);
  narrow_edges<kOne>(frame, g, e, lane, out);
  if (!hn::AllTrue(d, g.narrow)) wide_edges<kOne>(frame, g, lane, out);
  store_boxes<kOne>(frame, g, y_block, lane, out);
  store_windows<kOne>(frame, g, x_block, y_block, window_rows_log2, lane, out);
}

}  // namespace halfspace::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
