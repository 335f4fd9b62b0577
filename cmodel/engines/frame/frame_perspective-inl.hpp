// SPDX-License-Identifier: Apache-2.0
//
// perspective() of shading.hpp for a vector of fragments: the same bits.
#if defined(HALFSPACE_SIMD_FRAME_PERSPECTIVE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HALFSPACE_SIMD_FRAME_PERSPECTIVE_INL
#undef HALFSPACE_SIMD_FRAME_PERSPECTIVE_INL
#else
#define HALFSPACE_SIMD_FRAME_PERSPECTIVE_INL
#endif

#include "frame_common-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace halfspace::simd::HWY_NAMESPACE {

using VU = hn::Vec<DU>;

using D16 = hn::Repartition<std::uint16_t, DU>;

// What a configuration makes constant.
struct Divider {
  int odd_shift;     // 31 - R
  VF numerator;      // 2^(2R)
  VU numerator_low;  // the same modulo 2^32
  VU scale;          // 2^(16-R) in both halves
};

HWY_INLINE Divider divider(const FrameConstants& c) {
  const int R = c.config.reciprocal_bits;
  const std::uint64_t numerator = std::uint64_t{1} << (2 * R);
  return {31 - R, hn::Set(DF(), static_cast<float>(numerator)),
          hn::Set(DU(), static_cast<std::uint32_t>(numerator)),
          hn::Set(DU(), std::uint32_t{0x10001} << (16 - R))};
}

// Rounded half to even, for values that fit.
HWY_INLINE VU nearest(VF v) {
#if HALFSPACE_AVX512
  return VU{_mm512_cvtps_epi32(v.raw)};
#elif HALFSPACE_AVX2
  return VU{_mm256_cvtps_epi32(v.raw)};
#elif HALFSPACE_SSE
  return VU{_mm_cvtps_epi32(v.raw)};
#else
  return hn::BitCast(DU(), hn::NearestInt(v));
#endif
}

// How far a vector of values above 0 is shifted so that bit 31 is set.
struct Normalizer {
#if HALFSPACE_AVX512 || HALFSPACE_AVX2
  VU up;
  HWY_INLINE VU operator()(VU v) const { return hn::Shl(v, up); }
#else
  VU factor;  // no shift by lane: 2^up
  HWY_INLINE VU operator()(VU v) const { return hn::Mul(v, factor); }
#endif
  // The upper half in the lower one. The upper half is anything.
  HWY_INLINE VU top(VU v) const {
#if HALFSPACE_AVX512
    return VU{_mm512_rolv_epi32(v.raw, _mm512_add_epi32(up.raw, _mm512_set1_epi32(16)))};
#else
    return hn::ShiftRight<16>((*this)(v));
#endif
  }
};

HWY_INLINE Normalizer normalizer(VI u) {
#if HALFSPACE_AVX512
  const VF cut{_mm512_cvt_roundepi32_ps(u.raw, _MM_FROUND_TO_ZERO | _MM_FROUND_NO_EXC)};
  return {hn::Sub(hn::Set(DU(), 127 + 31), hn::ShiftRight<23>(hn::BitCast(DU(), cut)))};
#else
  // The exponent of a float; with the bit below the first cleared, rounding stays below 2^(e + 1).
  const VI top = hn::AndNot(hn::ShiftRight<1>(u), u);
  const VU exponent = hn::ShiftRight<23>(hn::BitCast(DU(), hn::ConvertTo(DF(), top)));
  const VU up = hn::Sub(hn::Set(DU(), 127 + 31), exponent);
#if HALFSPACE_AVX2
  return {up};
#else
  // 2^up as a float, cut to an integer by halves: up may be 31.
  const VU half = hn::ShiftLeft<23>(hn::Add(up, hn::Set(DU(), 126)));
  const VU power = nearest(hn::BitCast(DF(), half));
  const VU one = hn::Set(DU(), 1);
  return {hn::Max(hn::Add(power, power), one)};
#endif
#endif
}

// reciprocal() of the mantissa (odd - 1) / 2: the quotient of floats, rounded, is the floor or one
// more.
HWY_INLINE VU reciprocal(const Divider& divide, VU odd) {
  const VF quotient = hn::Div(divide.numerator, hn::ConvertTo(DF(), hn::BitCast(DI(), odd)));
  const VU guess = nearest(quotient);
  const VU rest = hn::Sub(divide.numerator_low, hn::Mul(guess, odd));
  return hn::Sub(guess, hn::ShiftRight<31>(rest));
}

// The divider set up for one value of 1/w per lane.
struct Divisor {
  VI u;
  Normalizer normalize;
  VU reciprocal;
};

HWY_INLINE Divisor divisor(const Divider& divide, VI inverse_w) {
  const VI u = hn::Max(inverse_w, hn::Set(DI(), 1));
  const Normalizer normalize = normalizer(u);
  const VU top = hn::ShiftRightSame(normalize(hn::BitCast(DU(), u)), divide.odd_shift);
  return {u, normalize, reciprocal(divide, hn::Or(top, hn::Set(DU(), 1)))};
}

// Bytes of 16-bit quotients, each at most 255: those of `low`, then the lower one of `high`; the
// fourth is anything.
HWY_INLINE VU bytes_of(VU low, VU high) {
#if HALFSPACE_AVX512 || HALFSPACE_AVX2 || HALFSPACE_SSE
  alignas(16) static constexpr std::uint8_t kOrder[16] = {0, 1, 8,  9,  2, 3, 10, 11,
                                                          4, 5, 12, 13, 6, 7, 14, 15};
#if HALFSPACE_AVX512
  const VU packed{_mm512_packus_epi16(low.raw, high.raw)};
#elif HALFSPACE_AVX2
  const VU packed{_mm256_packus_epi16(low.raw, high.raw)};
#else
  const VU packed{_mm_packus_epi16(low.raw, high.raw)};
#endif
  const hn::Repartition<std::uint8_t, DU> d8;
  return hn::BitCast(DU(),
                     hn::TableLookupBytes(hn::BitCast(d8, packed), hn::LoadDup128(d8, kOrder)));
#else
  const D16 d16;
  const auto most = hn::Set(d16, 255);
  const VU red_green = hn::BitCast(DU(), hn::Min(hn::BitCast(d16, low), most));
  const VU blue = hn::BitCast(DU(), hn::Min(hn::BitCast(d16, high), most));
  const VU green = hn::And(hn::ShiftRight<8>(red_green), hn::Set(DU(), 0xff00));
  return hn::Or(hn::Or(hn::And(red_green, hn::Set(DU(), 0xff)), green), hn::ShiftLeft<16>(blue));
#endif
}

// perspective() of red, green and blue over 1/w, which is value[3]: a byte each, red lowest. Level:
// the channels' levels, and 255 above them.
HWY_INLINE VU divided(const Divider& divide, const Divisor& by, const VI (&value)[4], VU level) {
  const D16 d16;
  const auto cut = [&](VI attribute) HWY_ATTR {
    return hn::BitCast(DU(), hn::Min(hn::Max(attribute, hn::Zero(DI())), by.u));
  };
  // Two numerators a lane, and r 2^(16-R) beside itself. The products are below 2^31 + 2^26, and
  // what is added to their upper halves is half of 2^7: docs/03_design/frame_engine.md.
  const auto factor = hn::BitCast(d16, hn::Mul(by.reciprocal, divide.scale));
  const auto red = hn::BitCast(d16, by.normalize.top(cut(value[0])));
  const auto green = hn::BitCast(d16, by.normalize(cut(value[1])));
  const auto blue = hn::BitCast(d16, by.normalize.top(cut(value[2])));
  const auto quotient = [&](hn::Vec<D16> numerator) HWY_ATTR {
    const auto product = hn::MulHigh(numerator, factor);
    return hn::BitCast(DU(), hn::ShiftRight<7>(hn::Add(product, hn::Set(d16, 64))));
  };
  const VU color = bytes_of(quotient(hn::OddEven(green, red)), quotient(blue));
  const hn::Repartition<std::uint8_t, DU> d8;
  return hn::BitCast(DU(), hn::SaturatedAdd(hn::BitCast(d8, color), hn::BitCast(d8, level)));
}

// Each division in one of the three channels.
void Divide(const FrameConstants& c, Division* divisions, std::size_t count) {
  const Divider divide = divider(c);
  alignas(64) std::int32_t attribute[kLanes], inverse_w[kLanes];
  alignas(64) std::uint32_t reciprocal[kLanes], color[kLanes];
  for (std::size_t first = 0; first < count; first += kLanes) {
    const std::size_t lanes = HWY_MIN(kLanes, count - first);
    for (std::size_t i = 0; i < kLanes; ++i) {
      attribute[i] = divisions[first + (i < lanes ? i : 0)].attribute;
      inverse_w[i] = divisions[first + (i < lanes ? i : 0)].inverse_w;
    }
    const VI over = hn::Load(DI(), inverse_w);
    const Divisor by = divisor(divide, over);
    hn::Store(by.reciprocal, DU(), reciprocal);
    const VI same = hn::Load(DI(), attribute);
    hn::Store(divided(divide, by, {same, same, same, over}, hn::Set(DU(), 0)), DU(), color);
    for (std::size_t i = 0; i < lanes; ++i) {
      divisions[first + i].reciprocal = reciprocal[i];
      divisions[first + i].value = color[i] >> (8 * (i % 3)) & 255;
    }
  }
}

}  // namespace halfspace::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
