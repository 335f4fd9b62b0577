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

// What a configuration makes constant.
struct Divider {
  int mantissa_shift;  // 32 - R
  int result_shift;    // R + 7
  VF numerator;        // 2^(2R)
  VU numerator_low;    // the same modulo 2^32
  VU round;            // half of 2^result_shift
};

HWY_INLINE Divider divider(const FrameConstants& c) {
  const int R = c.config.reciprocal_bits;
  const std::uint64_t numerator = std::uint64_t{1} << (2 * R);
  return {32 - R, R + 7, hn::Set(DF(), static_cast<float>(numerator)),
          hn::Set(DU(), static_cast<std::uint32_t>(numerator)),
          hn::Set(DU(), std::uint32_t{1} << (R + 6))};
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

// reciprocal() of a mantissa: the quotient of floats, rounded, is the floor or one more.
HWY_INLINE VU reciprocal(const Divider& divide, VU mantissa) {
  const VU odd = hn::Add(hn::Add(mantissa, mantissa), hn::Set(DU(), 1));
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
  const VU mantissa = hn::ShiftRightSame(normalize(hn::BitCast(DU(), u)), divide.mantissa_shift);
  return {u, normalize, reciprocal(divide, mantissa)};
}

// perspective(attribute, inverse_w): 0..255.
HWY_INLINE VU over(const Divider& divide, const Divisor& by, VI attribute) {
  const VI p = hn::Min(hn::Max(attribute, hn::Zero(DI())), by.u);
  const VU numerator = hn::ShiftRight<16>(by.normalize(hn::BitCast(DU(), p)));
  // Below 2^31 + 2^22: docs/03_design/frame_engine.md.
  const VU product = hn::Add(hn::Mul(numerator, by.reciprocal), divide.round);
  return hn::Min(hn::ShiftRightSame(product, divide.result_shift), hn::Set(DU(), 255));
}

void Divide(const FrameConstants& c, Division* divisions, std::size_t count) {
  const Divider divide = divider(c);
  alignas(64) std::int32_t attribute[kLanes], inverse_w[kLanes];
  alignas(64) std::uint32_t reciprocal[kLanes], value[kLanes];
  for (std::size_t first = 0; first < count; first += kLanes) {
    const std::size_t lanes = HWY_MIN(kLanes, count - first);
    for (std::size_t i = 0; i < kLanes; ++i) {
      attribute[i] = divisions[first + (i < lanes ? i : 0)].attribute;
      inverse_w[i] = divisions[first + (i < lanes ? i : 0)].inverse_w;
    }
    const Divisor by = divisor(divide, hn::Load(DI(), inverse_w));
    hn::Store(by.reciprocal, DU(), reciprocal);
    hn::Store(over(divide, by, hn::Load(DI(), attribute)), DU(), value);
    for (std::size_t i = 0; i < lanes; ++i) {
      divisions[first + i].reciprocal = reciprocal[i];
      divisions[first + i].value = value[i];
    }
  }
}

}  // namespace halfspace::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
