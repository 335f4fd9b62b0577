// SPDX-License-Identifier: Apache-2.0
#include "geometry.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "fixed.hpp"
#include "polygon_pieces.hpp"
#include "uncut_plane.hpp"

namespace halfspace {
namespace {

bool representable(const glm::dvec4& p) {
  // Written so that a NaN fails.
  return std::abs(p.x) <= kMaxMagnitude && std::abs(p.y) <= kMaxMagnitude &&
         std::abs(p.z) <= kMaxMagnitude && std::abs(p.w) <= kMaxMagnitude;
}

// value rounded half up, 0..maximum; NaN gives 0.
std::uint32_t round_clamped(double value, double maximum) {
  return value > 0.0 ? static_cast<std::uint32_t>(std::min(value, maximum) + 0.5) : 0U;
}

}  // namespace

std::int64_t snap(double px, const Config& config) {
  constexpr double kFar = 1099511627776.0;  // 2^40: in subpixels still an exact int64
  const double value =
      std::clamp(px, -kFar, kFar) * static_cast<double>(std::int64_t{1} << config.subpixel_bits);
  const auto whole = static_cast<std::int64_t>(value);  // towards zero
  // Exact: value and whole share their leading bits. In (-1, 1), with value's sign.
  const double rest = std::abs(value - static_cast<double>(whole));
  // Arithmetic on the outcome of comparisons: a branch on a coordinate's fraction is a coin toss.
  const std::int64_t away = 1 - 2 * static_cast<std::int64_t>(value < 0.0);
  const auto over = static_cast<std::int64_t>(rest > 0.5);
  const auto tie = static_cast<std::int64_t>(rest == 0.5);
  switch (config.snap) {
    case SnapMode::kNearestEven: return whole + away * (over | (tie & whole & 1));
    case SnapMode::kHalfAway: return whole + away * (over | tie);
    case SnapMode::kTruncate: break;
  }
  return whole;
}

GeometryStats& GeometryStats::operator+=(const GeometryStats& other) {
  triangles_in += other.triangles_in;
  dropped_not_finite += other.dropped_not_finite;
  outside += other.outside;
  clipped += other.clipped;
  beyond_sides += other.beyond_sides;
  triangles_out += other.triangles_out;
  return *this;
}

GeometryStage::GeometryStage(const FrameState& frame, const Config& config)
    : config_(config),
      volume_(clip_volume(frame, config)),
      half_width_(frame.width / 2.0),
      half_height_(frame.height / 2.0),
      depth_scale_(
          std::ldexp(std::ldexp(1.0, config.depth_bits) - 1.0, kPlaneBits - config.depth_bits - 1)),
      tag_mask_(0xffffffffU >> (32 - config.tag_bits)) {
  HS_CHECK(frame.width >= 1 && frame.width <= config.max_size());
  HS_CHECK(frame.height >= 1 && frame.height <= config.max_size());
}

// Bits 0..6: outside that plane of the volume. Bits 7..10: outside that side of the frame.
unsigned GeometryStage::outside_planes(const glm::dvec4& p) const {
  unsigned mask = 0;
  for (unsigned i = 0; i < kClipPlanes; ++i) {
    mask |= static_cast<unsigned>(plane_distance(volume_[i], p) < 0.0) << i;
  }
  mask |= static_cast<unsigned>(p.x < -p.w) << 7 | static_cast<unsigned>(p.x > p.w) << 8;
  return mask | static_cast<unsigned>(p.y < -p.w) << 9 | static_cast<unsigned>(p.y > p.w) << 10;
}

bool GeometryStage::beyond_sides(const ClipPolygon& polygon) const {
  for (int i = 0; i < polygon.count; ++i) {
    for (std::size_t plane = kDepthPlanes; plane < kClipPlanes; ++plane) {
      const ClipVertex& vertex = polygon.vertex[static_cast<std::size_t>(i)];
      if (plane_distance(volume_[plane], vertex.position) < 0.0) return true;
    }
  }
  return false;
}

GeometryStage::Projected GeometryStage::project(const ClipVertex& vertex) const {
  const glm::dvec4& p = vertex.position;
  const glm::dvec2 window = window_position(p, half_width_, half_height_);
  const std::int64_t x = snap(window.x, config_);
  const std::int64_t y = snap(window.y, config_);
  // Clipping leaves an excess of some units in the last place of a double, which rounding to
  // subpixels removes: nothing is saturated.
  HS_CHECK(x >= config_.coordinate_min() && x <= config_.coordinate_max());
  HS_CHECK(y >= config_.coordinate_min() && y <= config_.coordinate_max());
  Projected out;
  out.point = {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
  out.inverse_w = 1.0 / p.w;
  out.attributes.depth = static_cast<std::int32_t>(
      round_clamped((p.z / p.w + 1.0) * depth_scale_, 2.0 * depth_scale_));
  for (std::size_t i = 0; i < static_cast<std::size_t>(config_.attributes); ++i) {
    constexpr double kUnit = 1 << kAttributeFractionBits;
    out.attributes.value[i] =
        static_cast<std::int32_t>(round_clamped(vertex.attribute[i] * kUnit, 255.0 * kUnit));
  }
  return out;
}

// The values that the uncut triangle's plane has at the snapped points. False, and nothing changed,
// when a value does not fit: then the triangle is thinner than about a subpixel across.
bool GeometryStage::take_plane(const UncutPlane& plane, std::span<Projected> polygon) const {
  std::array<Projected, std::tuple_size_v<decltype(ClipPolygon::vertex)>> moved;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const UncutPlane::Values values = plane.at(polygon[i].point, config_.attributes);
    moved[i].point = polygon[i].point;
    moved[i].inverse_w = values.inverse_w;
    bool holds = values.inverse_w > 0.0 && std::isfinite(values.inverse_w);
    const auto rounded = [&holds](double value, std::int32_t least, std::int32_t most) {
      const double nearest = std::floor(value + 0.5);
      const bool fits = nearest >= least && nearest <= most;  // false for a NaN
      holds = holds && fits;
      return fits ? static_cast<std::int32_t>(nearest) : 0;
    };
    moved[i].attributes.depth = rounded(values.depth * 2.0 * depth_scale_, kDepthLeast, kDepthMost);
    for (std::size_t n = 0; n < static_cast<std::size_t>(config_.attributes); ++n) {
      moved[i].attributes.value[n] =
          rounded(std::ldexp(values.attribute[n], kAttributeFractionBits), kValueLeast, kValueMost);
    }
    if (!holds) return false;
  }
  std::copy_n(moved.begin(), polygon.size(), polygon.begin());
  return true;
}

void GeometryStage::emit(const Projected& a, const Projected& b, const Projected& c,
                         std::uint32_t tag, std::vector<ShadedTriangle>& out) {
  const std::array<const Projected*, 3> vertices{&a, &b, &c};
  int exponent = 0;  // of the greatest 1/w: in [2^(exponent - 1), 2^exponent)
  std::frexp(std::max({a.inverse_w, b.inverse_w, c.inverse_w}), &exponent);
  const double scale = std::ldexp(1.0, config_.inverse_w_bits - exponent);
  const double maximum = static_cast<double>((1U << config_.inverse_w_bits) - 1U);

  ShadedTriangle& triangle = out.emplace_back();
  triangle.triangle.tag = tag & tag_mask_;
  for (std::size_t i = 0; i < 3; ++i) {
    triangle.triangle.vertex[i] = vertices[i]->point;
    triangle.attributes[i] = vertices[i]->attributes;
    triangle.attributes[i].inverse_w =
        std::max(1U, round_clamped(vertices[i]->inverse_w * scale, maximum));
  }
  ++stats_.triangles_out;
}

// Snapping can dent or fold the polygon: see polygon_pieces().
void GeometryStage::emit_polygon(const ClipPolygon& polygon, const UncutPlane& plane,
                                 std::uint32_t tag, std::vector<ShadedTriangle>& out) {
  std::array<Projected, std::tuple_size_v<decltype(polygon.vertex)>> projected;
  std::array<Point, std::tuple_size_v<decltype(polygon.vertex)>> ring;
  const auto count = static_cast<std::size_t>(polygon.count);
  const auto before = [](const Projected& a, const Projected& b) { return key(a) < key(b); };
  for (std::size_t i = 0; i < count; ++i) {
    projected[i] = project(polygon.vertex[i]);
    ring[i] = projected[i].point;
  }
  if (!take_plane(plane, std::span(projected).first(count))) {
    // Of vertices at one point the values of one, whichever comes first.
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < count; ++j) {
        if (ring[i] == ring[j]) projected[i] = std::min(projected[i], projected[j], before);
      }
    }
  }
  const Pieces pieces = polygon_pieces(std::span(ring).first(count));
  for (const Piece& piece : pieces.all()) {
    emit(projected[piece[0]], projected[piece[1]], projected[piece[2]], tag, out);
  }
}

void GeometryStage::process(const std::array<ClipVertex, 3>& triangle, std::uint32_t tag,
                            std::vector<ShadedTriangle>& out) {
  ++stats_.triangles_in;
  unsigned any = 0, all = ~0U;
  for (const ClipVertex& vertex : triangle) {
    if (!representable(vertex.position)) {
      ++stats_.dropped_not_finite;
      return;
    }
    const unsigned mask = outside_planes(vertex.position);
    any |= mask;
    all &= mask;
  }
  if (all != 0) {
    ++stats_.outside;
    return;
  }
  if ((any & ((1U << kClipPlanes) - 1U)) == 0) {
    emit(project(triangle[0]), project(triangle[1]), project(triangle[2]), tag, out);
    return;
  }
  // All planes, even those that no vertex is outside of: an edge is then cut alike in both its
  // triangles whatever their third vertices are.
  const std::span planes(volume_);
  const ClipPolygon front = clip(triangle, planes.first(kDepthPlanes));
  stats_.beyond_sides += beyond_sides(front) ? 1U : 0U;
  const ClipPolygon polygon = clip(triangle, planes);
  if (polygon.count < 3) {
    ++stats_.outside;
    return;
  }
  ++stats_.clipped;
  const double subpixels = static_cast<double>(std::int64_t{1} << config_.subpixel_bits);
  const UncutPlane plane(triangle, half_width_ * subpixels, half_height_ * subpixels);
  emit_polygon(polygon, plane, tag, out);
}

}  // namespace halfspace
