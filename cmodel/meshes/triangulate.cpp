// SPDX-License-Identifier: Apache-2.0
#include "triangulate.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace halfspace {
namespace {

// Twice the area of a triangle, positive when it is counter-clockwise.
double area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Newell's: of any polygon, flat or not.
glm::dvec3 normal_of(std::span<const std::uint32_t> polygon,
                     const std::vector<glm::dvec3>& positions) {
  const glm::dvec3 origin = positions[polygon[0]];
  glm::dvec3 normal(0.0);
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    normal += glm::cross(positions[polygon[i]] - origin, positions[polygon[i + 1]] - origin);
  }
  return normal;
}

}  // namespace

std::span<const Triangulator::Cut> Triangulator::cut(std::span<const std::uint32_t> polygon,
                                                     const std::vector<glm::dvec3>& positions) {
  cuts_.clear();
  const auto count = static_cast<std::uint32_t>(polygon.size());
  if (count == 3) {
    cuts_.push_back({0, 1, 2});
    return cuts_;
  }
  // Seen along the axis that the plane faces most.
  const glm::dvec3 normal = normal_of(polygon, positions);
  const glm::dvec3 size = glm::abs(normal);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const int right = normal[axis] < 0.0 ? (axis + 2) % 3 : (axis + 1) % 3;
  const int up = 3 - axis - right;
  flat_.clear();
  const glm::dvec3 origin = positions[polygon[0]];
  for (const std::uint32_t vertex : polygon) {
    const glm::dvec3 p = positions[vertex] - origin;
    flat_.emplace_back(p[right], p[up]);
  }
  if (count == 4) {
    cut_quadrangle();
  } else if (!cut_fan()) {
    cut_ears();
  }
  return cuts_;
}

void Triangulator::cut_quadrangle() {
  std::uint32_t start = 0;
  for (std::uint32_t i = 0; i < 4; ++i) {
    if (area(flat_[(i + 3) % 4], flat_[i], flat_[(i + 1) % 4]) < 0.0) start = i;
  }
  cuts_.push_back({start, (start + 1) % 4, (start + 2) % 4});
  cuts_.push_back({start, (start + 2) % 4, (start + 3) % 4});
}

// Of triangles that all have an area: one without would leave a corner in the middle of an edge.
bool Triangulator::cut_fan() {
  const auto count = static_cast<std::uint32_t>(flat_.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t after = (i + 1) % count;
    if (!(area(flat_[i], flat_[after], flat_[(i + 2) % count]) > 0.0)) return false;
    const bool at_start = i == 0 || after == 0;
    if (!at_start && !(area(flat_[0], flat_[i], flat_[after]) > 0.0)) return false;
  }
  for (std::uint32_t i = 1; i + 1 < count; ++i) cuts_.push_back({0, i, i + 1});
  return true;
}

// No corner of the rest of the polygon lies in the triangle of a corner and its neighbours.
bool Triangulator::is_ear(std::uint32_t corner, bool convex_only) const {
  const glm::dvec2 &a = flat_[previous_[corner]], &b = flat_[corner], &c = flat_[next_[corner]];
  const double size = area(a, b, c);
  if (convex_only ? !(size > 0.0) : size < 0.0) return false;
  const glm::dvec2 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
  const auto first =
      std::lower_bound(reflex_.begin(), reflex_.end(), low.x,
                       [this](std::uint32_t other, double x) { return flat_[other].x < x; });
  for (auto other = first; other != reflex_.end() && flat_[*other].x <= high.x; ++other) {
    const glm::dvec2& p = flat_[*other];
    if (gone_[*other] || p.y < low.y || p.y > high.y) continue;
    if (p == a || p == b || p == c) continue;  // where the outline touches itself
    if (area(a, b, p) >= 0.0 && area(b, c, p) >= 0.0 && area(c, a, p) >= 0.0) return false;
  }
  return true;
}

void Triangulator::unlink(std::uint32_t corner) {
  cuts_.push_back({previous_[corner], corner, next_[corner]});
  next_[previous_[corner]] = next_[corner];
  previous_[next_[corner]] = previous_[corner];
  gone_[corner] = true;
}

void Triangulator::cut_ears() {
  const auto count = static_cast<std::uint32_t>(flat_.size());
  next_.resize(count);
  previous_.resize(count);
  gone_.assign(count, false);
  reflex_.clear();
  waiting_.clear();
  for (std::uint32_t i = 0; i < count; ++i) {
    next_[i] = (i + 1) % count;
    previous_[i] = (i + count - 1) % count;
    // A convex corner stays one while ears are cut, and in an ear there is always a reflex one.
    if (!(area(flat_[previous_[i]], flat_[i], flat_[next_[i]]) > 0.0)) reflex_.push_back(i);
  }
  std::sort(reflex_.begin(), reflex_.end(),
            [this](std::uint32_t a, std::uint32_t b) { return flat_[a].x < flat_[b].x; });
  bool convex_only = true, cut_one = true;
  std::size_t at = waiting_.size();
  std::uint32_t live = 0;
  for (std::uint32_t left = count; left > 3;) {
    if (at == waiting_.size()) {
      // After a round without an ear corners in a line, then, where an outline crosses itself, any.
      const bool any = !cut_one && !convex_only;
      convex_only = cut_one || any;
      while (gone_[live]) live = next_[live];
      if (any) {
        unlink(live);
        --left;
      }
      while (gone_[live]) live = next_[live];
      waiting_.clear();
      for (std::uint32_t i = 0, corner = live; i < left; ++i, corner = next_[corner]) {
        waiting_.push_back(corner);
      }
      at = 0;
      cut_one = false;
      continue;
    }
    const std::uint32_t corner = waiting_[at++];
    if (gone_[corner] || !is_ear(corner, convex_only)) continue;
    unlink(corner);
    --left;
    cut_one = true;
    waiting_.insert(waiting_.end(), {previous_[corner], next_[corner]});
  }
  while (gone_[live]) live = next_[live];
  cuts_.push_back({previous_[live], live, next_[live]});
}

}  // namespace halfspace
