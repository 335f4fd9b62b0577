// SPDX-License-Identifier: Apache-2.0
//
// The four planes that colour a triangle, together: one quantity per 64-bit lane.
#if defined(HALFSPACE_SIMD_FRAME_GRADIENT_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HALFSPACE_SIMD_FRAME_GRADIENT_INL
#undef HALFSPACE_SIMD_FRAME_GRADIENT_INL
#else
#define HALFSPACE_SIMD_FRAME_GRADIENT_INL
#endif

#include "frame_common-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace halfspace::simd::HWY_NAMESPACE {

using DQuad = hn::CappedTag<std::uint64_t, kShades>;
using DQuadS = hn::RebindToSigned<DQuad>;
using DQuadD = hn::RebindToFloat<DQuad>;
using VQuad = hn::Vec<DQuad>;
inline constexpr std::size_t kQuadLanes = hn::MaxLanes(DQuad());

// Product of the low halves.
HWY_INLINE VQuad mul_low(VQuad a, VQuad b) {
  const hn::Repartition<std::uint32_t, DQuad> d;
  return hn::MulEven(hn::BitCast(d, a), hn::BitCast(d, b));
}
HWY_INLINE VQuad mul_signed(VQuad a, VQuad b) {
  const hn::Repartition<std::int32_t, DQuad> d;
  return hn::BitCast(DQuad(), hn::MulEven(hn::BitCast(d, a), hn::BitCast(d, b)));
}

// a b modulo 2^64, b below 2^32.
HWY_INLINE VQuad mul_small(VQuad a, VQuad b) {
  return hn::Add(mul_low(a, b), hn::ShiftLeft<32>(mul_low(hn::ShiftRight<32>(a), b)));
}

// a b modulo 2^64.
HWY_INLINE VQuad mul_wide(VQuad a, VQuad b) {
#if HALFSPACE_AVX512
  return VQuad{_mm256_mullo_epi64(a.raw, b.raw)};
#else
  const VQuad cross = hn::Add(mul_low(hn::ShiftRight<32>(a), b), mul_low(a, hn::ShiftRight<32>(b)));
  return hn::Add(mul_low(a, b), hn::ShiftLeft<32>(cross));
#endif
}

// A triangle's constants in all lanes.
struct QuadEdges {
  VQuad area;
  hn::Vec<DQuadD> scale;
  int shift;
};

// guessed_gradient() of d1 s1 + d2 s2, both factors of a product in 32 bits with sign. `wild`
// gathers the greatest quotients.
HWY_INLINE VQuad gradient(VQuad d1, std::int64_t s1, VQuad d2, std::int64_t s2, const QuadEdges& e,
                          hn::Vec<DQuadD>& wild) {
  const DQuad d;
  const DQuadD dd;
  const VQuad n = hn::Add(mul_signed(d1, hn::Set(d, static_cast<std::uint64_t>(s1))),
                          mul_signed(d2, hn::Set(d, static_cast<std::uint64_t>(s2))));
  const auto q = hn::Mul(hn::ConvertTo(dd, hn::BitCast(DQuadS(), n)), e.scale);
  wild = hn::Max(wild, hn::Abs(q));
  const auto rounder = hn::Set(dd, kRounder);
  const VQuad g = hn::Sub(hn::BitCast(d, hn::Add(q, rounder)), hn::BitCast(d, rounder));
  const VQuad rest = hn::Sub(hn::ShiftLeftSame(n, e.shift), mul_wide(g, e.area));
  return hn::Sub(g, hn::ShiftRight<63>(rest));
}

// Four values of a vertex, red, green, blue and 0, in as many vectors as they fill.
struct QuadValues {
  VQuad part[kShades / kQuadLanes];
};

HWY_INLINE QuadValues load_values(const VertexRecord& vertex) {
#if HALFSPACE_AVX512 || HALFSPACE_AVX2
  const auto* from = reinterpret_cast<const __m128i*>(vertex.value.data());
  return {{VQuad{_mm256_cvtepu16_epi64(_mm_loadl_epi64(from))}}};
#else
  const DQuad d;
  alignas(16)
      const std::uint64_t value[kShades] = {vertex.value[0], vertex.value[1], vertex.value[2], 0};
  QuadValues out;
  for (std::size_t i = 0; i < kShades; i += kQuadLanes) {
    out.part[i / kQuadLanes] = hn::Load(d, value + i);
  }
  return out;
#endif
}

// 1 in place of a vertex's 0: 1/w over 1.
inline constexpr std::uint64_t kOne[kShades] = {0, 0, 0, 65536};

// Attributes over w and 1/w, units: over_w() of interpolation.cpp.
HWY_INLINE VQuad units_over_w(VQuad value, std::size_t at, std::uint32_t inverse_w) {
  const DQuad d;
  const VQuad product =
      mul_low(hn::Or(value, hn::LoadU(d, kOne + at)), hn::Set(d, std::uint64_t{inverse_w}));
  return hn::ShiftRight<16>(hn::Add(product, hn::Set(d, std::uint64_t{1} << 15)));
}

// The planes of red, green, blue and 1/w.
HWY_INLINE void triangle_planes(const FrameConstants& c, const FrameTriangle& triangle,
                                ShadePlanes& out) {
  const DQuad d;
  const DQuadD dd;
  const FrameEdges e = frame_edges(triangle, c);
  const std::array<std::uint32_t, 3> inverse_w = packed_inverse_w(triangle, c);
  const int up = kPlaneBits - c.config.inverse_w_bits;
  QuadValues value[3];
  for (std::size_t i = 0; i < 3; ++i) value[i] = load_values(*triangle.vertex[i]);
  const QuadEdges quad{hn::Set(d, static_cast<std::uint64_t>(e.area)), hn::Set(dd, e.scale),
                       c.config.subpixel_bits + c.gradient_bits};
  const int F = c.gradient_bits;
  const VQuad half = hn::Set(d, F > 0 ? std::uint64_t{1} << (F - 1) : 0);
  const VQuad x = hn::Set(d, static_cast<std::uint64_t>(e.x));
  const VQuad y = hn::Set(d, static_cast<std::uint64_t>(e.y));
  auto wild = hn::Zero(dd);
  for (std::size_t at = 0; at < kShades; at += kQuadLanes) {
    const auto units = [&](std::size_t i) HWY_ATTR {
      return units_over_w(value[i].part[at / kQuadLanes], at, inverse_w[i] << up);
    };
    const VQuad v0 = units(0);
    const VQuad d1 = hn::Sub(units(1), v0);
    const VQuad d2 = hn::Sub(units(2), v0);
    const VQuad dx = gradient(d1, e.a2, d2, e.a0, quad, wild);
    const VQuad dy = gradient(d1, e.b2, d2, e.b0, quad, wild);
    const VQuad move = hn::Add(mul_wide(dx, x), mul_wide(dy, y));
    hn::Store(hn::Add(hn::ShiftLeftSame(v0, F), hn::ShiftRightSame(move, c.f)), d, &out.origin[at]);
    hn::Store(dx, d, &out.dx[at]);
    hn::Store(dy, d, &out.dy[at]);
    hn::Store(hn::ShiftRightSame(hn::Add(dx, half), F), d, &out.lane_dx[at]);
    hn::Store(hn::ShiftRightSame(hn::Add(dy, half), F), d, &out.lane_dy[at]);
  }
  if (!hn::AllTrue(dd, hn::Lt(wild, hn::Set(dd, kGuessLimit)))) {
    out = plain_shade_planes(triangle, c);
  }
}

}  // namespace halfspace::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
