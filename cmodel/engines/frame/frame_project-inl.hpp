// SPDX-License-Identifier: Apache-2.0
//
// GeometryStage up to the projected vertex, a vertex per 64-bit lane. Double precision in the same
// order of operations, so the same bits.
#if defined(HALFSPACE_SIMD_FRAME_PROJECT_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HALFSPACE_SIMD_FRAME_PROJECT_INL
#undef HALFSPACE_SIMD_FRAME_PROJECT_INL
#else
#define HALFSPACE_SIMD_FRAME_PROJECT_INL
#endif

#include "frame_gradient-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace halfspace::simd::HWY_NAMESPACE {

// Vertices in clip space.
struct ClipLanes {
  VD position[4];
  VD color[3];
};

using DHalfF = hn::Rebind<float, DD>;

HWY_INLINE ClipLanes load_mesh(const VertexSource& source, const float* position,
                               const float* color) {
  const DD d;
  const DHalfF df;
  hn::Vec<DHalfF> p[3], c[3];
  hn::LoadInterleaved3(df, position, p[0], p[1], p[2]);
  hn::LoadInterleaved3(df, color, c[0], c[1], c[2]);
  VD v[3];
  ClipLanes out;
  for (std::size_t i = 0; i < 3; ++i) {
    v[i] = hn::PromoteTo(d, p[i]);
    out.color[i] = hn::PromoteTo(d, c[i]);
  }
  for (int row = 0; row < 4; ++row) {
    const auto m = [&](int column) HWY_ATTR { return hn::Set(d, source.matrix[column][row]); };
    out.position[row] = hn::Add(hn::Add(hn::Mul(m(0), v[0]), hn::Mul(m(1), v[1])),
                                hn::Add(hn::Mul(m(2), v[2]), m(3)));
  }
  return out;
}

HWY_INLINE ClipLanes load_clip(const ClipVertex* vertex, std::size_t count) {
  const DD d;
  alignas(64) double lanes[7][kWideLanes];
  for (std::size_t i = 0; i < kWideLanes; ++i) {
    const ClipVertex& from = vertex[i < count ? i : 0];
    for (int axis = 0; axis < 4; ++axis) lanes[axis][i] = from.position[axis];
    for (std::size_t n = 0; n < 3; ++n) lanes[4 + n][i] = from.attribute[n];
  }
  ClipLanes out;
  for (std::size_t axis = 0; axis < 4; ++axis) out.position[axis] = hn::Load(d, lanes[axis]);
  for (std::size_t n = 0; n < 3; ++n) out.color[n] = hn::Load(d, lanes[4 + n]);
  return out;
}

// VertexRecord::outside.
HWY_INLINE V64 outside_bits(const ProjectConstants& c, const VD (&p)[4]) {
  const DD d;
  const VD w = p[3];
  const VD minus_w = hn::Neg(w);
  hn::Mask<DD> side[12];
  for (std::size_t i = 0; i < kClipPlanes; ++i) {
    const ClipPlane& plane = c.volume[i];
    const VD limit = hn::Set(d, plane.limit);
    const VD bound = plane.axis == 3 ? limit : hn::Mul(limit, w);
    const VD value = p[plane.axis];
    side[i] = plane.sign > 0 ? hn::Lt(bound, value) : hn::Gt(bound, value);
  }
  side[7] = hn::Lt(p[0], minus_w);
  side[8] = hn::Gt(p[0], w);
  side[9] = hn::Lt(p[1], minus_w);
  side[10] = hn::Gt(p[1], w);
  const VD most = hn::Set(d, kMaxMagnitude);
  auto finite = hn::Le(hn::Abs(p[0]), most);
  for (std::size_t i = 1; i < 4; ++i) finite = hn::And(finite, hn::Le(hn::Abs(p[i]), most));
  side[11] = hn::Not(finite);
  auto any = side[0];
  for (std::size_t i = 1; i < 12; ++i) any = hn::Or(any, side[i]);
  const D64 d64;
  V64 bits = hn::Zero(d64);
  if (hn::AllFalse(d, any)) return bits;
  for (std::size_t i = 0; i < 12; ++i) {
    const std::uint64_t bit = i == 11 ? kNotFinite : std::uint64_t{1} << i;
    bits = hn::Or(bits, hn::IfThenElseZero(hn::RebindMask(d64, side[i]), hn::Set(d64, bit)));
  }
  return bits;
}

// snap(): px to subpixels, in the low 32 bits of each lane; meant only for values in range.
HWY_INLINE V64 snapped(const ProjectConstants& c, VD px) {
  const DD d;
  VD value = hn::Mul(px, hn::Set(d, c.subpixels));
  if (c.snap != SnapMode::kNearestEven) {
    const VD whole = hn::Trunc(value);
    const VD rest = hn::Abs(hn::Sub(value, whole));
    const VD away = hn::IfThenElseZero(hn::Ge(rest, hn::Set(d, 0.5)), hn::Set(d, 1.0));
    value = c.snap == SnapMode::kTruncate ? whole : hn::Add(whole, hn::CopySign(away, value));
  }
  const VD rounder = hn::Set(d, kRounder);  // the sum is rounded half to even
  return hn::BitCast(D64(), hn::Add(value, rounder));
}

// round_clamped(): value rounded half up, 0..maximum; NaN gives 0.
HWY_INLINE V64 rounded(VD value, double maximum) {
  const DD d;
  const VD cut =
      hn::IfThenElseZero(hn::Gt(value, hn::Zero(d)), hn::Min(value, hn::Set(d, maximum)));
  const auto whole = to_int(hn::Add(cut, hn::Set(d, 0.5)));
  return hn::BitCast(D64(), hn::PromoteTo(hn::RebindToSigned<D64>(), whole));
}

HWY_INLINE void store_records(V64 (&word)[4], VertexRecord* out) {
  auto* HWY_RESTRICT to = reinterpret_cast<std::uint64_t*>(out);
  hn::StoreInterleaved4(word[0], word[1], word[2], word[3], D64(), to);
}

HWY_INLINE void project_lanes(const ProjectConstants& c, const ClipLanes& lanes,
                              VertexRecord* out) {
  const DD d;
  const D64 d64;
  const VD* p = lanes.position;
  const VD one = hn::Set(d, 1.0);
  const VD x = hn::Mul(hn::Add(hn::Div(p[0], p[3]), one), hn::Set(d, c.half_width));
  const VD y = hn::Mul(hn::Sub(one, hn::Div(p[1], p[3])), hn::Set(d, c.half_height));
  const VD z = hn::Mul(hn::Add(hn::Div(p[2], p[3]), one), hn::Set(d, c.depth_scale));
  const V64 low = hn::Set(d64, 0xffffffffu);
  V64 word[4];
  word[0] = hn::Or(hn::And(snapped(c, x), low), hn::ShiftLeft<32>(snapped(c, y)));
  word[1] = hn::BitCast(d64, hn::Div(one, p[3]));
  word[2] = hn::Or(hn::And(rounded(z, 2.0 * c.depth_scale), low),
                   hn::ShiftLeft<32>(outside_bits(c, lanes.position)));
  word[3] = hn::Set(d64, VertexRecord::kNoValues);
  constexpr double kUnit = 1 << kAttributeFractionBits;
  for (int n = 0; n < c.colors; ++n) {
    const V64 value = rounded(hn::Mul(lanes.color[n], hn::Set(d, kUnit)), 255.0 * kUnit);
    word[3] =
        hn::Add(word[3], hn::ShiftLeftSame(value, n * static_cast<int>(VertexRecord::kFieldBits)));
  }
  store_records(word, out);
}

std::uint32_t Highest(const std::uint32_t* index, std::size_t count) {
  const DU d;
  auto highest = hn::Zero(d);
  std::size_t i = 0;
  for (; i + kLanes <= count; i += kLanes) highest = hn::Max(highest, hn::LoadU(d, index + i));
  std::uint32_t most = hn::GetLane(hn::MaxOfLanes(d, highest));
  for (; i < count; ++i) most = HWY_MAX(most, index[i]);
  return most;
}

void Project(const ProjectConstants& constants, const VertexSource& source, std::size_t first,
             std::size_t count, VertexRecord* out) {
  if (!source.clip.empty()) {
    for (std::size_t i = 0; i < count; i += kWideLanes) {
      project_lanes(constants, load_clip(source.clip.data() + first + i, count - i),
                    out + first + i);
    }
    return;
  }
  const glm::vec3* position = source.position.data() + first;
  const glm::vec3* color = source.color.data() + first;
  std::size_t i = 0;
  for (; i + kWideLanes <= count; i += kWideLanes) {
    project_lanes(constants, load_mesh(source, &position[i].x, &color[i].x), out + first + i);
  }
  if (i == count) return;
  glm::vec3 last[2][kWideLanes];
  for (std::size_t lane = 0; lane < kWideLanes; ++lane) {
    const std::size_t from = i + lane < count ? i + lane : count - 1;
    last[0][lane] = position[from];
    last[1][lane] = color[from];
  }
  project_lanes(constants, load_mesh(source, &last[0][0].x, &last[1][0].x), out + first + i);
}

}  // namespace halfspace::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
