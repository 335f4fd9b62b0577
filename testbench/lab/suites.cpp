// SPDX-License-Identifier: Apache-2.0
#include "suites.hpp"

#include <cmath>
#include <numeric>

#include "fixed.hpp"

namespace halfspace::lab {
namespace {

using methods::InputKind;

// Unchanged when bits is negative.
oracle::Vec vec(methods::Position p, int bits) {
  if (bits < 0) return {p.x, p.y};
  const auto round = [bits](double v) {
    return std::ldexp(std::nearbyint(std::ldexp(v, bits)), -bits);
  };
  return {round(p.x), round(p.y)};
}

std::vector<oracle::Corners> corners_of(const SuiteCase& one, int bits) {
  std::vector<oracle::Corners> out;
  for (const methods::Facet& f : one.drawing.facets) {
    out.push_back(
        {vec(f[0].position(), bits), vec(f[1].position(), bits), vec(f[2].position(), bits)});
  }
  return out;
}

std::vector<oracle::Rings> rings_of(const SuiteCase& one, int bits) {
  std::vector<oracle::Rings> out;
  for (const methods::Polygon& polygon : one.drawing.polygons) {
    oracle::Rings rings;
    for (const auto& ring : polygon.rings) {
      rings.emplace_back();
      for (const methods::Position p : ring) rings.back().push_back(vec(p, bits));
    }
    out.push_back(std::move(rings));
  }
  return out;
}

// One pixel per step along the longer axis, between the ends: the one that holds the line there.
// Ends are multiples of 1/256 px, so the quotient's floor is exact.
void add_line(const methods::Segment& s, int bits, const oracle::Window& w,
              std::vector<std::uint32_t>& hits) {
  using Wide = __int128;
  const oracle::Vec from = vec(s.from, bits);
  const oracle::Vec to = vec(s.to, bits);
  const bool steep = std::abs(to.y - from.y) > std::abs(to.x - from.x);
  Wide u0 = std::llround((steep ? from.y : from.x) * 256);
  Wide v0 = std::llround((steep ? from.x : from.y) * 256);
  Wide u1 = std::llround((steep ? to.y : to.x) * 256);
  Wide v1 = std::llround((steep ? to.x : to.y) * 256);
  if (u1 < u0) {
    std::swap(u0, u1);
    std::swap(v0, v1);
  }
  for (Wide u = floor_div(u0 - 128 + 255, 256); u * 256 + 128 <= u1; ++u) {
    const Wide across = u1 == u0 ? v0 : v0 + floor_div((v1 - v0) * (u * 256 + 128 - u0), u1 - u0);
    // floor of a sum of whole 1/256 px and a floored part is the floor of the sum.
    const auto v = static_cast<int>(floor_div(across, 256));
    const int x = (steep ? v : static_cast<int>(u)) - w.x_first;
    const int y = (steep ? static_cast<int>(u) : v) - w.y_first;
    if (x < 0 || y < 0 || x >= w.width || y >= w.height) continue;
    ++hits[static_cast<std::size_t>(y) * static_cast<std::size_t>(w.width) +
           static_cast<std::size_t>(x)];
  }
}

}  // namespace

const std::vector<Suite>& suites() {
  static const std::vector<Suite> list = [] {
    std::vector<Suite> all;
    add_edge_suites(all);
    add_distance_suites(all);
    add_attribute_suites(all);
    return all;
  }();
  return list;
}

std::vector<std::uint32_t> true_hits_snapped(const SuiteCase& one, InputKind kind, int bits) {
  if (one.hits) return one.hits();
  if (kind == InputKind::kPolygons) return oracle::exact_hits(rings_of(one, bits), one.window);
  if (kind != InputKind::kLines) return oracle::exact_hits(corners_of(one, bits), one.window);
  std::vector<std::uint32_t> hits(static_cast<std::size_t>(one.window.width) *
                                  static_cast<std::size_t>(one.window.height));
  for (const methods::Segment& s : one.drawing.segments) add_line(s, bits, one.window, hits);
  return hits;
}

std::vector<std::uint32_t> true_hits(const SuiteCase& one, InputKind kind) {
  return true_hits_snapped(one, kind, -1);
}

std::vector<int> true_owners(const SuiteCase& one) {
  const std::vector<oracle::Corners> corners = corners_of(one, -1);
  std::vector<int> owner(
      static_cast<std::size_t>(one.window.width) * static_cast<std::size_t>(one.window.height), -1);
  for (std::size_t n = 0; n < corners.size(); ++n) {
    const auto hits = oracle::exact_hits(std::span(&corners[n], 1), one.window);
    for (std::size_t i = 0; i < hits.size(); ++i) {
      if (hits[i] != 0) owner[i] = static_cast<int>(n);
    }
  }
  return owner;
}

}  // namespace halfspace::lab
