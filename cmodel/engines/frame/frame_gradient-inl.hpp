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
  VQuad reciprocal;  // r: AreaReciprocal::factor is 2 r + 1
  int shift;         // of the product
  int left, right;   // of its part from bit 32 on: one of them is 0
};

// v >> by with the sign, which there is no instruction for.
HWY_INLINE VQuad shift_signed(VQuad v, int by) {
  const DQuad d;
  constexpr std::uint64_t kSign = std::uint64_t{1} << 63;
  return hn::Sub(hn::ShiftRightSame(hn::Add(v, hn::Set(d, kSign)), by), hn::Set(d, kSign >> by));
}

// gradient() of d1 s1 + d2 s2, all factors in 32 bits with sign.
HWY_INLINE VQuad gradient(VQuad d1, std::int64_t s1, VQuad d2, std::int64_t s2,
                          const QuadEdges& e) {
  const DQuad d;
  const VQuad low = hn::Set(d, std::uint64_t{0xffffffff});
  const VQuad n = hn::Add(mul_signed(d1, hn::Set(d, static_cast<std::uint64_t>(s1))),
                          mul_signed(d2, hn::Set(d, static_cast<std::uint64_t>(s2))));
  // n (2 r + 1) in two parts; r counts as negative in a product with sign, hence n's high half.
  const VQuad a = mul_low(n, e.reciprocal);
  const VQuad b = hn::Add(mul_signed(hn::ShiftRight<32>(n), e.reciprocal), hn::AndNot(low, n));
  const VQuad a_low = hn::And(a, low);
  const VQuad rest = hn::Add(hn::Add(a_low, a_low), n);
  const VQuad sum = hn::Add(b, hn::ShiftRight<32>(a));
  const VQuad high = hn::Add(hn::Add(sum, sum), shift_signed(rest, 32));
  return hn::Add(shift_signed(hn::ShiftLeftSame(high, e.left), e.right),
                 hn::ShiftRightSame(hn::And(rest, low), HWY_MIN(e.shift, 63)));
}

// The fields of a vertex, red, green, blue and 0, in as many vectors as they fill.
struct QuadValues {
  VQuad part[kShades / kQuadLanes];
};

HWY_INLINE QuadValues load_values(const VertexRecord& vertex) {
  constexpr int kBits = static_cast<int>(VertexRecord::kFieldBits);
#if HALFSPACE_AVX512 || HALFSPACE_AVX2
  const __m256i fields = _mm256_srlv_epi64(_mm256_set1_epi64x(static_cast<long long>(vertex.value)),
                                           _mm256_setr_epi64x(0, kBits, 2 * kBits, 3 * kBits));
  return {{VQuad{
      _mm256_and_si256(fields, _mm256_set1_epi64x(static_cast<long long>(VertexRecord::kField)))}}};
#else
  const DQuad d;
  alignas(16) std::uint64_t value[kShades];
  for (std::size_t i = 0; i < kShades; ++i) {
    value[i] = vertex.value >> (kBits * static_cast<int>(i)) & VertexRecord::kField;
  }
  QuadValues out;
  for (std::size_t i = 0; i < kShades; i += kQuadLanes) {
    out.part[i / kQuadLanes] = hn::Load(d, value + i);
  }
  return out;
#endif
}

// The fields of a whole level, of the greatest level, and what leaves 1 in the place of 1/w.
inline constexpr std::uint64_t kLevelZero = std::uint64_t{-kValueLeast};
inline constexpr std::uint64_t kLevelMost = kLevelZero + (255 << kAttributeFractionBits);
inline constexpr std::uint64_t kOne[kShades] = {0, 0, 0, 65536 + kLevelZero};

// level_of() of three fields, as a field.
HWY_INLINE VQuad quad_level(VQuad a, VQuad b, VQuad c) {
  const DQuad d;
  const hn::Repartition<std::int32_t, DQuad> narrow;  // the high halves are 0
  const auto wide = [&](VQuad v) HWY_ATTR { return hn::BitCast(narrow, v); };
  const auto least = hn::Min(wide(a), hn::Min(wide(b), wide(c)));
  const auto cut =
      hn::Min(hn::Max(least, wide(hn::Set(d, kLevelZero))), wide(hn::Set(d, kLevelMost)));
  return hn::And(hn::BitCast(d, cut), hn::Set(d, ~std::uint64_t{255}));
}

// Attributes over w and 1/w, units: over_w() of interpolation.cpp. A value may be negative, and
// there is no shift of 64 bits that keeps the sign: the sum is made positive before.
HWY_INLINE VQuad units_over_w(VQuad value, std::uint32_t inverse_w) {
  const DQuad d;
  constexpr std::uint64_t kHalf = std::uint64_t{1} << 15, kPositive = std::uint64_t{1} << 62;
  const VQuad product = mul_signed(value, hn::Set(d, std::uint64_t{inverse_w}));
  return hn::Sub(hn::ShiftRight<16>(hn::Add(product, hn::Set(d, kPositive + kHalf))),
                 hn::Set(d, kPositive >> 16));
}

// The planes of red, green, blue and 1/w.
HWY_INLINE void triangle_planes(const FrameConstants& c, const FrameTriangle& triangle,
                                ShadePlanes& out) {
  const DQuad d;
  const FrameEdges e = frame_edges(triangle, c);
  const std::array<std::uint32_t, 3> inverse_w = packed_inverse_w(triangle, c);
  const int up = kPlaneBits - c.config.inverse_w_bits;
  QuadValues value[3];
  for (std::size_t i = 0; i < 3; ++i) value[i] = load_values(*triangle.vertex[i]);
  const AreaReciprocal r = frame_reciprocal(e, c);
  const QuadEdges quad{hn::Set(d, r.factor >> 1), r.shift, HWY_MAX(32 - r.shift, 0),
                       HWY_MAX(r.shift - 32, 0)};
  const int F = c.gradient_bits;
  const VQuad half = hn::Set(d, F > 0 ? std::uint64_t{1} << (F - 1) : 0);
  const VQuad x = hn::Set(d, static_cast<std::uint64_t>(e.x));
  const VQuad y = hn::Set(d, static_cast<std::uint64_t>(e.y));
  alignas(32) std::uint64_t levels[kShades];
  for (std::size_t at = 0; at < kShades; at += kQuadLanes) {
    const auto field = [&](std::size_t i) HWY_ATTR { return value[i].part[at / kQuadLanes]; };
    const VQuad level = quad_level(field(0), field(1), field(2));
    hn::Store(level, d, levels + at);
    const VQuad zero = hn::Sub(level, hn::LoadU(d, kOne + at));
    const auto units = [&](std::size_t i) HWY_ATTR {
      return units_over_w(hn::Sub(field(i), zero), inverse_w[i] << up);
    };
    const VQuad v0 = units(0);
    const VQuad d1 = hn::Sub(units(1), v0);
    const VQuad d2 = hn::Sub(units(2), v0);
    const VQuad dx = gradient(d1, e.a2, d2, e.a0, quad);
    const VQuad dy = gradient(d1, e.b2, d2, e.b0, quad);
    const VQuad move = hn::Add(mul_wide(dx, x), mul_wide(dy, y));
    hn::Store(hn::Add(hn::ShiftLeftSame(v0, F), hn::ShiftRightSame(move, c.f)), d, &out.origin[at]);
    hn::Store(dx, d, &out.dx[at]);
    hn::Store(dy, d, &out.dy[at]);
    hn::Store(hn::ShiftRightSame(hn::Add(dx, half), F), d, &out.lane_dx[at]);
    hn::Store(hn::ShiftRightSame(hn::Add(dy, half), F), d, &out.lane_dy[at]);
  }
  out.level = ShadePlanes::kNoLevels;
  for (std::size_t n = 0; n < 3; ++n) {
    out.level |= static_cast<std::uint32_t>((levels[n] - kLevelZero) >> kAttributeFractionBits)
                 << (8 * n);
  }
}

}  // namespace halfspace::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
