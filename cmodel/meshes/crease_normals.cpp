// SPDX-License-Identifier: Apache-2.0
#include "crease_normals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

namespace halfspace {
namespace {

constexpr float kCreaseCosine = 0.40673664307580F;  // of 66 degrees
constexpr std::size_t kMostDirections = 256;
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

glm::vec3 unit_of(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 1e-12 ? glm::vec3(v / length) : glm::vec3(0.0F);
}

bool before(const glm::vec3& a, const glm::vec3& b) {
  if (a.x != b.x) return a.x < b.x;
  return a.y != b.y ? a.y < b.y : a.z < b.z;
}

// One of the 8 x 8 fields of one of a cube's 6 sides.
std::size_t field_of(const glm::vec3& unit) {
  std::array<float, 3> size{std::abs(unit.x), std::abs(unit.y), std::abs(unit.z)};
  const auto axis =
      static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
  const auto at = [&](std::size_t other) {
    const float along = unit[static_cast<int>(other)] / size[axis];  // -1..1
    return static_cast<std::size_t>(std::clamp(4.0F * (along + 1.0F), 0.0F, 7.0F));
  };
  const std::size_t side = 2 * axis + (unit[static_cast<int>(axis)] < 0.0F ? 1 : 0);
  return (side * 8 + at((axis + 1) % 3)) * 8 + at((axis + 2) % 3);
}

}  // namespace

void CreaseNormals::find_directions(const std::vector<glm::vec3>& faces) {
  order_.resize(faces.size());
  std::iota(order_.begin(), order_.end(), 0U);
  std::sort(order_.begin(), order_.end(), [&faces](std::uint32_t a, std::uint32_t b) {
    return faces[a] == faces[b] ? a < b : before(faces[a], faces[b]);
  });
  directions_.clear();
  direction_.assign(faces.size(), kNone);
  for (const std::uint32_t face : order_) {
    if (faces[face] == glm::vec3(0.0F)) continue;
    if (directions_.empty() || directions_.back().unit != faces[face]) {
      directions_.push_back({faces[face], glm::dvec3(0.0)});
    }
    directions_.back().sum += glm::dvec3(faces[face]);
    direction_[face] = static_cast<std::uint32_t>(directions_.size() - 1);
  }
}

void CreaseNormals::gather_directions() {
  std::array<std::uint32_t, 6 * 8 * 8> place;
  place.fill(kNone);
  std::vector<Direction> gathered;
  std::vector<std::uint32_t> moved;
  for (const Direction& direction : directions_) {
    std::uint32_t& at = place[field_of(direction.unit)];
    if (at == kNone) {
      at = static_cast<std::uint32_t>(gathered.size());
      gathered.push_back({glm::vec3(0.0F), glm::dvec3(0.0)});
    }
    gathered[at].sum += direction.sum;
    moved.push_back(at);
  }
  for (Direction& direction : gathered) direction.unit = unit_of(direction.sum);
  for (std::uint32_t& at : direction_) at = at == kNone ? kNone : moved[at];
  directions_.swap(gathered);
}

void CreaseNormals::sum_directions() {
  for (Direction& direction : directions_) {
    glm::dvec3 sum(0.0);
    for (const Direction& other : directions_) {
      if (&other == &direction || glm::dot(direction.unit, other.unit) >= kCreaseCosine) {
        sum += other.sum;
      }
    }
    direction.normal = unit_of(sum);
  }
}

const std::vector<glm::vec3>& CreaseNormals::at_point(const std::vector<glm::vec3>& faces) {
  find_directions(faces);
  if (directions_.size() > kMostDirections) gather_directions();
  sum_directions();
  out_.resize(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const std::uint32_t at = direction_[i] != kNone ? direction_[i] : 0;
    out_[i] = directions_.empty() ? glm::vec3(0.0F) : directions_[at].normal;
  }
  return out_;
}

}  // namespace halfspace
