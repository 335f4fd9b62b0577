// SPDX-License-Identifier: Apache-2.0
#include "geometry.hpp"

#include <algorithm>
#include <cmath>

#include "fixed.hpp"

namespace halfspace {
namespace {

double plane_bound(const ClipPlane& plane, const glm::dvec4& position) {
  return plane.axis == 3 ? plane.limit : plane.limit * position.w;
}

double plane_distance(const ClipPlane& plane, const glm::dvec4& position) {
  return plane.sign * (plane_bound(plane, position) - position[plane.axis]);
}

// Where the edge meets the plane. Both weights are positive, so w, positive from the first plane
// on, suffers no cancellation, and limits that both ends keep are kept to a few units in the last
// place. The last step makes the limit of this plane hold exactly.
ClipVertex cut(const ClipPlane& plane, const ClipVertex& inside, double inside_distance,
               const ClipVertex& outside, double outside_distance) {
  const double span = inside_distance - outside_distance;
  const double to_outside = inside_distance / span;
  const double to_inside = -outside_distance / span;
  ClipVertex vertex;
  vertex.position = to_inside * inside.position + to_outside * outside.position;
  for (std::size_t i = 0; i < kMaxAttributes; ++i) {
    vertex.attribute[i] = to_inside * inside.attribute[i] + to_outside * outside.attribute[i];
  }
  vertex.position[plane.axis] = plane_bound(plane, vertex.position);
  return vertex;
}

void clip_plane(const ClipPlane& plane, const ClipPolygon& in, ClipPolygon& out) {
  out.count = 0;
  const auto append = [&out](const ClipVertex& vertex) {
    HS_CHECK(out.count < static_cast<int>(out.vertex.size()));
    out.vertex[static_cast<std::size_t>(out.count++)] = vertex;
  };
  for (int i = 0; i < in.count; ++i) {
    const ClipVertex& from = in.vertex[static_cast<std::size_t>(i)];
    const ClipVertex& to = in.vertex[static_cast<std::size_t>(i + 1 < in.count ? i + 1 : 0)];
    const double from_distance = plane_distance(plane, from.position);
    const double to_distance = plane_distance(plane, to.position);
    if (from_distance >= 0.0) append(from);
    // Always from the inside to the outside; an inside vertex on the plane is its own cut point.
    if (from_distance > 0.0 && to_distance < 0.0) {
      append(cut(plane, from, from_distance, to, to_distance));
    } else if (from_distance < 0.0 && to_distance > 0.0) {
      append(cut(plane, to, to_distance, from, from_distance));
    }
  }
}

bool representable(const glm::dvec4& p) {
  // Written so that a NaN fails.
  return std::abs(p.x) <= kMaxMagnitude && std::abs(p.y) <= kMaxMagnitude &&
         std::abs(p.z) <= kMaxMagnitude && std::abs(p.w) <= kMaxMagnitude;
}

// The doubled area, subpixels^2.
std::int64_t doubled_area(const Point& a, const Point& b, const Point& c) {
  return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) -
         (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
}

// value rounded half up, 0..maximum; NaN gives 0.
std::uint32_t round_clamped(double value, double maximum) {
  return value > 0.0 ? static_cast<std::uint32_t>(std::min(value, maximum) + 0.5) : 0U;
}

}  // namespace

ClipVolume clip_volume(const FrameState& frame, const Config& config) {
  double left = -1.0, right = 1.0, bottom = -1.0, top = 1.0;
  if (config.has_guard_band()) {
    // Window x = (x/w + 1) width / 2 and y = (1 - y/w) height / 2, both within +-limit.
    const double limit =
        std::ldexp(static_cast<double>(config.coordinate_max()), -config.subpixel_bits);
    right = 2.0 * limit / frame.width - 1.0;
    left = -2.0 * limit / frame.width - 1.0;
    top = 1.0 + 2.0 * limit / frame.height;
    bottom = 1.0 - 2.0 * limit / frame.height;
  }
  return {{{3, kMinW, -1.0},
           {2, -1.0, -1.0},
           {2, 1.0, 1.0},
           {0, left, -1.0},
           {0, right, 1.0},
           {1, bottom, -1.0},
           {1, top, 1.0}}};
}

ClipPolygon clip(const std::array<ClipVertex, 3>& triangle, std::span<const ClipPlane> planes) {
  ClipPolygon polygon;
  std::copy(triangle.begin(), triangle.end(), polygon.vertex.begin());
  polygon.count = 3;
  ClipPolygon next;
  for (const ClipPlane& plane : planes) {
    clip_plane(plane, polygon, next);
    std::swap(polygon, next);
    if (polygon.count < 3) return {};
  }
  return polygon;
}

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
          std::ldexp((std::ldexp(1.0, config.depth_bits) - 1.0) / 2.0, kDepthFractionBits)),
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
  out.attributes.depth = round_clamped((p.z / p.w + 1.0) * depth_scale_, 2.0 * depth_scale_);
  for (std::size_t i = 0; i < static_cast<std::size_t>(config_.attributes); ++i) {
    constexpr double kUnit = 1 << kAttributeFractionBits;
    out.attributes.value[i] =
        static_cast<std::uint16_t>(round_clamped(vertex.attribute[i] * kUnit, 255.0 * kUnit));
  }
  return out;
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

// Snapping can dent a convex polygon by a fraction of a subpixel. A fan whose pieces all face the
// same way covers every point once; a dent at one vertex leaves the fan around that vertex.
void GeometryStage::emit_polygon(const ClipPolygon& polygon, std::uint32_t tag,
                                 std::vector<ShadedTriangle>& out) {
  std::array<Projected, std::tuple_size_v<decltype(polygon.vertex)>> projected;
  const auto count = static_cast<std::size_t>(polygon.count);
  for (std::size_t i = 0; i < count; ++i) projected[i] = project(polygon.vertex[i]);
  const auto at = [&](std::size_t i) -> const Projected& { return projected[i % count]; };
  const auto piece_area = [&](std::size_t apex, std::size_t i) {
    return doubled_area(at(apex).point, at(apex + i).point, at(apex + i + 1).point);
  };

  std::size_t apex = 0;
  for (std::size_t candidate = 0; candidate < count; ++candidate) {
    bool positive = false, negative = false;
    for (std::size_t i = 1; i + 1 < count; ++i) {
      positive = positive || piece_area(candidate, i) > 0;
      negative = negative || piece_area(candidate, i) < 0;
    }
    if (positive && negative) continue;
    apex = candidate;
    break;
  }
  for (std::size_t i = 1; i + 1 < count; ++i) {
    if (piece_area(apex, i) != 0) emit(at(apex), at(apex + i), at(apex + i + 1), tag, out);
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
  emit_polygon(polygon, tag, out);
}

}  // namespace halfspace
