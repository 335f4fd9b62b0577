// SPDX-License-Identifier: Apache-2.0
//
// Triangle setup, first half: boxes, areas and sides of a vector of triangles.
#if defined(HALFSPACE_SIMD_GROUP_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HALFSPACE_SIMD_GROUP_INL
#undef HALFSPACE_SIMD_GROUP_INL
#else
#define HALFSPACE_SIMD_GROUP_INL
#endif

#include "vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace halfspace::simd::HWY_NAMESPACE {

static_assert(sizeof(Triangle) == 28 && sizeof(Point) == 8);

// One group of triangles on its way through setup. Lengths in 2^-f px.
struct Group {
  VI x[3], y[3];  // vertices
  VI a[3], b[3];  // edge i to i + 1, as submitted
  VI x_min, y_min, x_max, y_max;
  VI x_first, y_first, x_last, y_last;  // the sample box, px
  VI area;                              // its sign is the doubled area's
  hn::Mask<DI> left[3], right[3];       // which side of the triangle an edge bounds
  hn::Mask<DI> narrow;                  // takes the float path
  hn::Mask<DI> drawn;
};

// The 16 bytes at `byte` of every fourth triangle, one triangle per 128-bit block.
HWY_INLINE VI load_blocks(const Triangle* t, std::size_t byte) {
  const auto at = [t, byte](std::size_t i) {
    return reinterpret_cast<const std::int32_t*>(reinterpret_cast<const char*>(t + i) + byte);
  };
#if HALFSPACE_AVX512
  const auto load = [at](std::size_t i) HWY_ATTR {
    return _mm_loadu_si128(reinterpret_cast<const __m128i*>(at(i)));
  };
  __m512i v = _mm512_castsi128_si512(load(0));
  v = _mm512_inserti32x4(v, load(4), 1);
  v = _mm512_inserti32x4(v, load(8), 2);
  return VI{_mm512_inserti32x4(v, load(12), 3)};
#elif HALFSPACE_AVX2
  const auto load = [at](std::size_t i) HWY_ATTR {
    return _mm_loadu_si128(reinterpret_cast<const __m128i*>(at(i)));
  };
  return VI{_mm256_inserti128_si256(_mm256_castsi128_si256(load(0)), load(4), 1)};
#else
  return hn::LoadU(DI(), at(0));
#endif
}

// Triangles t[0] .. t[kLanes - 1], transposed.
HWY_INLINE void load_vertices(const Triangle* t, Group& g) {
  const DI d;
  const hn::ScalableTag<std::int64_t> d2;
  VI row[4];
  for (std::size_t i = 0; i < 4; ++i) row[i] = load_blocks(t + i, 0);  // x0 y0 x1 y1
  const auto xy0 = hn::BitCast(d2, hn::InterleaveLower(d, row[0], row[1]));
  const auto xy0b = hn::BitCast(d2, hn::InterleaveLower(d, row[2], row[3]));
  const auto xy1 = hn::BitCast(d2, hn::InterleaveUpper(d, row[0], row[1]));
  const auto xy1b = hn::BitCast(d2, hn::InterleaveUpper(d, row[2], row[3]));
  g.x[0] = hn::BitCast(d, hn::InterleaveLower(d2, xy0, xy0b));
  g.y[0] = hn::BitCast(d, hn::InterleaveUpper(d2, xy0, xy0b));
  g.x[1] = hn::BitCast(d, hn::InterleaveLower(d2, xy1, xy1b));
  g.y[1] = hn::BitCast(d, hn::InterleaveUpper(d2, xy1, xy1b));
  for (std::size_t i = 0; i < 4; ++i) row[i] = load_blocks(t + i, 12);  // y1 x2 y2 tag
  const auto x2 = hn::BitCast(d2, hn::InterleaveLower(d, row[0], row[1]));
  const auto x2b = hn::BitCast(d2, hn::InterleaveLower(d, row[2], row[3]));
  const auto y2 = hn::BitCast(d2, hn::InterleaveUpper(d, row[0], row[1]));
  const auto y2b = hn::BitCast(d2, hn::InterleaveUpper(d, row[2], row[3]));
  g.x[2] = hn::BitCast(d, hn::InterleaveUpper(d2, x2, x2b));
  g.y[2] = hn::BitCast(d, hn::InterleaveLower(d2, y2, y2b));
}

// Bounding box, sample box, slopes.
HWY_INLINE void box_setup(const KernelFrame& frame, Group& g, VI& lowest, VI& highest) {
  const DI d;
  g.x_min = hn::Min(hn::Min(g.x[0], g.x[1]), g.x[2]);
  g.y_min = hn::Min(hn::Min(g.y[0], g.y[1]), g.y[2]);
  g.x_max = hn::Max(hn::Max(g.x[0], g.x[1]), g.x[2]);
  g.y_max = hn::Max(hn::Max(g.y[0], g.y[1]), g.y[2]);
  lowest = hn::Min(lowest, hn::Min(g.x_min, g.y_min));
  highest = hn::Max(highest, hn::Max(g.x_max, g.y_max));
  if (frame.up != 0) {
    for (std::size_t i = 0; i < 3; ++i) {
      g.x[i] = hn::ShiftLeftSame(g.x[i], frame.up);
      g.y[i] = hn::ShiftLeftSame(g.y[i], frame.up);
    }
    g.x_min = hn::ShiftLeftSame(g.x_min, frame.up);
    g.y_min = hn::ShiftLeftSame(g.y_min, frame.up);
    g.x_max = hn::ShiftLeftSame(g.x_max, frame.up);
    g.y_max = hn::ShiftLeftSame(g.y_max, frame.up);
  }
  const int f = frame.f;
  const std::int32_t up = (1 << f) - 1;
  const VI zero = hn::Zero(d);
  g.x_first = hn::ShiftRightSame(hn::Add(g.x_min, hn::Set(d, up - frame.u_high)), f);
  g.y_first = hn::ShiftRightSame(hn::Add(g.y_min, hn::Set(d, up - frame.v_high)), f);
  g.x_last = hn::ShiftRightSame(hn::Sub(g.x_max, hn::Set(d, 1 + frame.u_low)), f);
  g.y_last = hn::ShiftRightSame(hn::Sub(g.y_max, hn::Set(d, 1 + frame.v_low)), f);
  g.x_first = hn::Max(g.x_first, zero);
  g.y_first = hn::Max(g.y_first, zero);
  g.x_last = hn::Min(g.x_last, hn::Set(d, frame.width - 1));
  g.y_last = hn::Min(g.y_last, hn::Set(d, frame.height - 1));
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    g.a[i] = hn::Sub(g.y[i], g.y[j]);
    g.b[i] = hn::Sub(g.x[j], g.x[i]);
  }
  const VI extent = hn::Max(hn::Sub(g.x_max, g.x_min), hn::Sub(g.y_max, g.y_min));
  g.narrow = hn::Lt(extent, hn::Set(d, frame.window_extent + 1));
}

// The sign of the doubled area where int32 does not hold it. Exact: each delta is split at bit 15,
// products are below 2^46, and rounding a sum keeps its sign.
HWY_INLINE void wide_area(Group& g) {
  const DD d;
  const DHalf dh;
  const DI di;
  alignas(64) std::int32_t a[2][kLanes], b[2][kLanes], sign[kLanes];
  for (std::size_t i = 0; i < 2; ++i) {
    hn::Store(g.a[i], di, a[i]);
    hn::Store(g.b[i], di, b[i]);
  }
  for (std::size_t at = 0; at < kLanes; at += kWideLanes) {
    const auto a1 = hn::Load(dh, a[1] + at);
    const auto b1 = hn::Load(dh, b[1] + at);
    const auto low = hn::Set(dh, 0x7fff);
    const VD a0 = hn::PromoteTo(d, hn::Load(dh, a[0] + at));
    const VD b0 = hn::PromoteTo(d, hn::Load(dh, b[0] + at));
    // area2 = b0 (-a1) - (-a0) b1
    const VD upper = hn::Sub(hn::Mul(a0, hn::PromoteTo(d, hn::ShiftRight<15>(b1))),
                             hn::Mul(b0, hn::PromoteTo(d, hn::ShiftRight<15>(a1))));
    const VD lower = hn::Sub(hn::Mul(a0, hn::PromoteTo(d, hn::And(b1, low))),
                             hn::Mul(b0, hn::PromoteTo(d, hn::And(a1, low))));
    const VD area = hn::Add(hn::Mul(upper, hn::Set(d, 32768.0)), lower);
    const VD one = hn::Set(d, 1.0);
    hn::Store(to_int(hn::Max(hn::Min(area, one), hn::Neg(one))), dh, sign + at);
  }
  g.area = hn::IfThenElse(g.narrow, g.area, hn::Load(di, sign));
}

// Chooses the four sides of each triangle from a value of its three edges.
template <class M, class V>
HWY_INLINE void choose_sides(const M (&left)[3], const M (&right)[3], const V (&edge)[3],
                             V (&side)[kSides]) {
  side[0] = hn::IfThenElse(left[0], edge[0], hn::IfThenElse(left[1], edge[1], edge[2]));
  side[1] = hn::IfThenElse(left[2], edge[2], hn::IfThenElse(left[1], edge[1], edge[0]));
  side[2] = hn::IfThenElse(right[0], edge[0], hn::IfThenElse(right[1], edge[1], edge[2]));
  side[3] = hn::IfThenElse(right[2], edge[2], hn::IfThenElse(right[1], edge[1], edge[0]));
}

// Area, sides, and the reasons to drop a triangle. e: edge values at the block's first sample.
HWY_INLINE void orient(const KernelFrame& frame, const VI (&e)[3], Group& g, KernelCounts& counts) {
  const DI d;
  const VI zero = hn::Zero(d);
  g.area = hn::Add(hn::Add(e[0], e[1]), e[2]);
  if (!hn::AllTrue(d, g.narrow)) wide_area(g);
  const VI flip = hn::BroadcastSignBit(g.area);
  for (std::size_t i = 0; i < 3; ++i) {
    const VI a = hn::Sub(hn::Xor(g.a[i], flip), flip);
    g.left[i] = hn::Gt(a, zero);
    g.right[i] = hn::Lt(a, zero);
  }
  const auto flat = hn::Eq(g.area, zero);
  auto drawn = hn::Not(flat);
  counts.zero_area += hn::CountTrue(d, flat);
  if (frame.cull != Cull::kNone) {
    const auto culled = frame.cull == Cull::kFront ? hn::Lt(g.area, zero) : hn::Gt(g.area, zero);
    counts.culled += hn::CountTrue(d, culled);
    drawn = hn::And(drawn, hn::Not(culled));
  }
  const auto outside = hn::Or(hn::Gt(g.x_first, g.x_last), hn::Gt(g.y_first, g.y_last));
  counts.no_sample += hn::CountTrue(d, hn::And(drawn, outside));
  g.drawn = hn::AndNot(outside, drawn);
}

}  // namespace halfspace::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
