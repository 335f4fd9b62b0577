// SPDX-License-Identifier: Apache-2.0
//
// The planes of many triangles: eight at a time, a triangle per 64-bit lane, where vectors are that
// wide; one after another elsewhere.
#if defined(HALFSPACE_SIMD_FRAME_PLANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HALFSPACE_SIMD_FRAME_PLANES_INL
#undef HALFSPACE_SIMD_FRAME_PLANES_INL
#else
#define HALFSPACE_SIMD_FRAME_PLANES_INL
#endif

#include "frame_gradient-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace halfspace::simd::HWY_NAMESPACE {

#if HALFSPACE_AVX512

inline constexpr std::size_t kEight = 8;

// Eight vertex records, word by word.
struct EightRecords {
  __m512i point;      // x in the low half, y in the high half
  __m512i inverse_w;  // double
  __m512i depth;      // in the low half
  __m512i value;      // VertexRecord's
};

HWY_INLINE EightRecords load_vertices(const FrameTriangle* triangle, std::size_t vertex) {
  const auto load = [&](std::size_t i) HWY_ATTR {
    const auto at = [&](std::size_t k) HWY_ATTR {
      return _mm256_load_si256(reinterpret_cast<const __m256i*>(triangle[k].vertex[vertex]));
    };
    return _mm512_inserti64x4(_mm512_castsi256_si512(at(i)), at(i + 4), 1);
  };
  const __m512i a = load(0), b = load(1), c = load(2), d = load(3);
  const __m512i even_ab = _mm512_unpacklo_epi64(a, b), odd_ab = _mm512_unpackhi_epi64(a, b);
  const __m512i even_cd = _mm512_unpacklo_epi64(c, d), odd_cd = _mm512_unpackhi_epi64(c, d);
  const __m512i low = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13);
  const __m512i high = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
  return {_mm512_permutex2var_epi64(even_ab, low, even_cd),
          _mm512_permutex2var_epi64(odd_ab, low, odd_cd),
          _mm512_permutex2var_epi64(even_ab, high, even_cd),
          _mm512_permutex2var_epi64(odd_ab, high, odd_cd)};
}

// FrameEdges of eight triangles.
struct EightEdges {
  __m512i a0, b0, a2, b2, x, y;
  __m512i reciprocal;          // r: AreaReciprocal::factor is 2 r + 1
  __m512i shift, left, right;  // as QuadEdges
};

// floor(2^64 / (2 m + 1)) for m of 32 bits, the top one set: the quotient of doubles, rounded, is
// the floor or one more, and the remainder says which.
HWY_INLINE __m512i eight_reciprocals(__m512i mantissa) {
  const __m512i divisor = _mm512_add_epi64(_mm512_slli_epi64(mantissa, 1), _mm512_set1_epi64(1));
  const __m512d q = _mm512_div_pd(_mm512_set1_pd(0x1p64), _mm512_cvtepi64_pd(divisor));
  const __m512d rounder = _mm512_set1_pd(kRounder);
  const __m512i g = _mm512_sub_epi64(_mm512_castpd_si512(_mm512_add_pd(q, rounder)),
                                     _mm512_castpd_si512(rounder));
  const __m512i rest = _mm512_sub_epi64(_mm512_setzero_si512(), _mm512_mullo_epi64(g, divisor));
  return _mm512_sub_epi64(g, _mm512_srli_epi64(rest, 63));
}

HWY_INLINE EightEdges eight_edges(const EightRecords (&v)[3], const FrameConstants& c) {
  const auto x = [&](std::size_t i)
                     HWY_ATTR { return _mm512_srai_epi64(_mm512_slli_epi64(v[i].point, 32), 32); };
  const auto y = [&](std::size_t i) HWY_ATTR { return _mm512_srai_epi64(v[i].point, 32); };
  EightEdges e;
  e.a0 = _mm512_sub_epi64(y(0), y(1));
  e.b0 = _mm512_sub_epi64(x(1), x(0));
  e.a2 = _mm512_sub_epi64(y(2), y(0));
  e.b2 = _mm512_sub_epi64(x(0), x(2));
  __m512i area = _mm512_sub_epi64(_mm512_mul_epi32(e.a2, e.b0), _mm512_mul_epi32(e.a0, e.b2));
  const __m512i flip = _mm512_srai_epi64(area, 63);
  for (__m512i* value : {&e.a0, &e.b0, &e.a2, &e.b2, &area}) {
    *value = _mm512_sub_epi64(_mm512_xor_si512(*value, flip), flip);
  }
  // Leading zeros by a double's exponent, 1023 for 1.
  const __m512d real = _mm512_cvt_roundepi64_pd(area, _MM_FROUND_TO_ZERO | _MM_FROUND_NO_EXC);
  const __m512i exponent = _mm512_srli_epi64(_mm512_castpd_si512(real), 52);
  const __m512i zeros = _mm512_sub_epi64(_mm512_set1_epi64(1023 + 63), exponent);
  const __m512i mantissa = _mm512_srli_epi64(_mm512_sllv_epi64(area, zeros), 32);
  e.reciprocal = eight_reciprocals(mantissa);
  const int fraction = c.config.subpixel_bits + c.gradient_bits;
  e.shift = _mm512_sub_epi64(_mm512_set1_epi64(96 - fraction), zeros);
  const __m512i above = _mm512_sub_epi64(e.shift, _mm512_set1_epi64(32));
  e.right = _mm512_max_epi64(above, _mm512_setzero_si512());
  e.left = _mm512_sub_epi64(e.right, above);
  const __m128i up = _mm_cvtsi32_si128(c.f - c.config.subpixel_bits);
  const __m512i half = _mm512_set1_epi64(std::int64_t{1} << (c.f - 1));
  e.x = _mm512_sub_epi64(half, _mm512_sll_epi64(x(0), up));
  e.y = _mm512_sub_epi64(half, _mm512_sll_epi64(y(0), up));
  return e;
}

// gradient() of d1 s1 + d2 s2, as for one triangle.
HWY_INLINE __m512i eight_gradients(__m512i d1, __m512i s1, __m512i d2, __m512i s2,
                                   const EightEdges& e) {
  const __m512i low = _mm512_set1_epi64(0xffffffff);
  const __m512i n = _mm512_add_epi64(_mm512_mul_epi32(d1, s1), _mm512_mul_epi32(d2, s2));
  const __m512i a = _mm512_mul_epu32(n, e.reciprocal);
  const __m512i b = _mm512_add_epi64(_mm512_mul_epi32(_mm512_srli_epi64(n, 32), e.reciprocal),
                                     _mm512_andnot_si512(low, n));
  const __m512i a_low = _mm512_and_si512(a, low);
  const __m512i rest = _mm512_add_epi64(_mm512_add_epi64(a_low, a_low), n);
  const __m512i sum = _mm512_add_epi64(b, _mm512_srli_epi64(a, 32));
  const __m512i high = _mm512_add_epi64(_mm512_add_epi64(sum, sum), _mm512_srai_epi64(rest, 32));
  return _mm512_add_epi64(_mm512_srav_epi64(_mm512_sllv_epi64(high, e.left), e.right),
                          _mm512_srlv_epi64(_mm512_and_si512(rest, low), e.shift));
}

// FramePlane of eight triangles.
struct EightPlanes {
  __m512i origin, dx, dy, lane_dx, lane_dy;
};

// The planes through v0, v0 + d1, v0 + d2 at the vertices.
HWY_INLINE EightPlanes eight_planes(__m512i v0, __m512i v1, __m512i v2, const EightEdges& e,
                                    const FrameConstants& c) {
  const int F = c.gradient_bits;
  const __m128i by_F = _mm_cvtsi32_si128(F);
  const __m512i half = _mm512_set1_epi64(F > 0 ? std::int64_t{1} << (F - 1) : 0);
  const __m512i d1 = _mm512_sub_epi64(v1, v0);
  const __m512i d2 = _mm512_sub_epi64(v2, v0);
  EightPlanes out;
  out.dx = eight_gradients(d1, e.a2, d2, e.a0, e);
  out.dy = eight_gradients(d1, e.b2, d2, e.b0, e);
  const __m512i move =
      _mm512_add_epi64(_mm512_mullo_epi64(out.dx, e.x), _mm512_mullo_epi64(out.dy, e.y));
  out.origin =
      _mm512_add_epi64(_mm512_sll_epi64(v0, by_F), _mm512_srl_epi64(move, _mm_cvtsi32_si128(c.f)));
  out.lane_dx = _mm512_srl_epi64(_mm512_add_epi64(out.dx, half), by_F);
  out.lane_dy = _mm512_srl_epi64(_mm512_add_epi64(out.dy, half), by_F);
  return out;
}

HWY_INLINE void eight_depth_planes(const FrameConstants& c, const FrameTriangle* triangles,
                                   FramePlane* HWY_RESTRICT out) {
  const EightRecords v[3] = {load_vertices(triangles, 0), load_vertices(triangles, 1),
                             load_vertices(triangles, 2)};
  const __m512i low = _mm512_set1_epi64(0xffffffff);
  const auto value = [&](std::size_t i) HWY_ATTR {
    return _mm512_srai_epi64(_mm512_slli_epi64(v[i].depth, 32), 32);
  };
  const EightPlanes plane = eight_planes(value(0), value(1), value(2), eight_edges(v, c), c);
  const __m512i lanes =
      _mm512_or_si512(_mm512_and_si512(plane.lane_dx, low), _mm512_slli_epi64(plane.lane_dy, 32));
  static_assert(sizeof(FramePlane) == 32);
  hn::StoreInterleaved4(V64{plane.origin}, V64{plane.dx}, V64{plane.dy}, V64{lanes}, D64(),
                        reinterpret_cast<std::uint64_t*>(out));
}

// packed_inverse_w() of eight triangles, in units of the planes.
HWY_INLINE void eight_inverse_w(const EightRecords (&v)[3], const FrameConstants& c,
                                __m512i (&units)[3]) {
  __m512d w[3];
  for (std::size_t i = 0; i < 3; ++i) w[i] = _mm512_castsi512_pd(v[i].inverse_w);
  __m512d scale = _mm512_set1_pd(1);
  if (!c.packed) {
    const __m512d greatest = _mm512_max_pd(_mm512_max_pd(w[0], w[1]), w[2]);
    const __m512i exponent = _mm512_srli_epi64(_mm512_castpd_si512(greatest), 52);
    const __m512i bias = _mm512_set1_epi64(2045 + c.config.inverse_w_bits);
    scale = _mm512_castsi512_pd(_mm512_slli_epi64(_mm512_sub_epi64(bias, exponent), 52));
  }
  const __m512d most = _mm512_set1_pd(static_cast<double>((1u << c.config.inverse_w_bits) - 1u));
  const __m128i up = _mm_cvtsi32_si128(kPlaneBits - c.config.inverse_w_bits);
  for (std::size_t i = 0; i < 3; ++i) {
    const __m512d cut = _mm512_min_pd(_mm512_mul_pd(w[i], scale), most);
    const __m512i whole = _mm512_cvttpd_epi64(_mm512_add_pd(cut, _mm512_set1_pd(0.5)));
    units[i] = _mm512_sll_epi64(_mm512_max_epi64(whole, _mm512_set1_epi64(1)), up);
  }
}

// One word of the four shades of eight triangles, to the same place of eight ShadePlanes.
HWY_INLINE void store_shades(const __m512i (&shade)[kShades], __m256i* out) {
  constexpr std::size_t kStep = sizeof(ShadePlanes) / sizeof(__m256i);
  const __m512i first = _mm512_setr_epi64(0, 1, 8, 9, 2, 3, 10, 11);
  const __m512i second = _mm512_setr_epi64(4, 5, 12, 13, 6, 7, 14, 15);
  const __m512i even[2] = {_mm512_unpacklo_epi64(shade[0], shade[1]),
                           _mm512_unpacklo_epi64(shade[2], shade[3])};
  const __m512i odd[2] = {_mm512_unpackhi_epi64(shade[0], shade[1]),
                          _mm512_unpackhi_epi64(shade[2], shade[3])};
  const auto store = [&](__m512i both, std::size_t i) HWY_ATTR {
    _mm256_store_si256(out + i * kStep, _mm512_castsi512_si256(both));
    _mm256_store_si256(out + (i + 2) * kStep, _mm512_extracti64x4_epi64(both, 1));
  };
  store(_mm512_permutex2var_epi64(even[0], first, even[1]), 0);
  store(_mm512_permutex2var_epi64(odd[0], first, odd[1]), 1);
  store(_mm512_permutex2var_epi64(even[0], second, even[1]), 4);
  store(_mm512_permutex2var_epi64(odd[0], second, odd[1]), 5);
}

// level_of() of three fields.
HWY_INLINE __m512i eight_level(__m512i a, __m512i b, __m512i c) {
  const __m512i least = _mm512_min_epi64(a, _mm512_min_epi64(b, c));
  const __m512i above = _mm512_add_epi64(least, _mm512_set1_epi64(kValueLeast));
  const __m512i level = _mm512_srai_epi64(above, kAttributeFractionBits);
  return _mm512_min_epi64(_mm512_max_epi64(level, _mm512_setzero_si512()), _mm512_set1_epi64(255));
}

// triangle[0] .. triangle[7] need not be neighbours: they are copies.
HWY_INLINE void eight_shade_planes(const FrameConstants& c, const FrameTriangle* triangles,
                                   ShadePlanes* HWY_RESTRICT out) {
  const EightRecords v[3] = {load_vertices(triangles, 0), load_vertices(triangles, 1),
                             load_vertices(triangles, 2)};
  const EightEdges e = eight_edges(v, c);
  __m512i inverse_w[3];
  eight_inverse_w(v, c, inverse_w);
  __m512i word[5][kShades];
  __m512i levels = _mm512_set1_epi64(ShadePlanes::kNoLevels);
  for (unsigned n = 0; n < kShades; ++n) {
    const auto field = [&](std::size_t i) HWY_ATTR {
      return _mm512_and_si512(_mm512_srli_epi64(v[i].value, VertexRecord::kFieldBits * n),
                              _mm512_set1_epi64(static_cast<long long>(VertexRecord::kField)));
    };
    const __m512i level = eight_level(field(0), field(1), field(2));
    if (n < 3) levels = _mm512_or_si512(levels, _mm512_slli_epi64(level, 8 * n));
    const __m512i zero = _mm512_add_epi64(_mm512_slli_epi64(level, kAttributeFractionBits),
                                          _mm512_set1_epi64(-kValueLeast));
    // units_over_w(); 1/w itself for the last.
    const auto units = [&](std::size_t i) HWY_ATTR {
      if (n == 3) return inverse_w[i];
      const __m512i value = _mm512_sub_epi64(field(i), zero);
      const __m512i product = _mm512_mul_epi32(value, inverse_w[i]);
      return _mm512_srai_epi64(_mm512_add_epi64(product, _mm512_set1_epi64(1 << 15)), 16);
    };
    const EightPlanes plane = eight_planes(units(0), units(1), units(2), e, c);
    word[0][n] = plane.origin;
    word[1][n] = plane.dx;
    word[2][n] = plane.dy;
    word[3][n] = plane.lane_dx;
    word[4][n] = plane.lane_dy;
  }
  for (std::size_t i = 0; i < 5; ++i) store_shades(word[i], reinterpret_cast<__m256i*>(out) + i);
  alignas(64) std::uint64_t level[kEight];
  _mm512_store_si512(level, levels);
  for (std::size_t i = 0; i < kEight; ++i) out[i].level = static_cast<std::uint32_t>(level[i]);
}

#endif  // HALFSPACE_AVX512

void Planes(const FrameConstants& c, const FrameTriangle* triangles, std::size_t count,
            FramePlane* HWY_RESTRICT out) {
  const FrameConstants constants = c;  // nothing aliases it
  std::size_t i = 0;
#if HALFSPACE_AVX512
  for (; i + kEight <= count; i += kEight) eight_depth_planes(constants, triangles + i, out + i);
#endif
  for (; i < count; ++i) out[i] = depth_plane(triangles[i], constants);
}

// Colour planes of the triangles listed[0] .. listed[count - 1].
HWY_INLINE void listed_planes(const FrameConstants& c, const FrameTriangle* triangles,
                              const std::uint32_t* listed, std::size_t count, ShadePlanes* out) {
  const FrameConstants constants = c;  // nothing aliases it
  std::size_t i = 0;
#if HALFSPACE_AVX512
  for (; i + kEight <= count; i += kEight) {
    FrameTriangle eight[kEight];
    for (std::size_t k = 0; k < kEight; ++k) eight[k] = triangles[listed[i + k]];
    eight_shade_planes(constants, eight, out + i);
  }
#endif
  for (; i < count; ++i) triangle_planes(constants, triangles[listed[i]], out[i]);
}

void ShadeOnly(const FrameConstants& c, const FrameTriangle* triangles, std::size_t count,
               ShadePlanes* out) {
  std::vector<std::uint32_t> all(count);
  std::iota(all.begin(), all.end(), 0u);
  listed_planes(c, triangles, all.data(), count, out);
}

}  // namespace halfspace::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
