// SPDX-License-Identifier: Apache-2.0
#include "oracle.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace halfspace::oracle {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalPoint = Kernel::Point_2;

CgalPoint point(Vec v) { return CgalPoint(v.x, v.y); }

constexpr std::array<Vec, 1> kOne{{{0.5, 0.5}}};
constexpr std::array<Vec, 2> kTwo{{{0.75, 0.75}, {0.25, 0.25}}};
constexpr std::array<Vec, 4> kFour{
    {{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}}};
constexpr std::array<Vec, 8> kEight{{{0.5625, 0.3125},
                                     {0.4375, 0.6875},
                                     {0.8125, 0.5625},
                                     {0.3125, 0.1875},
                                     {0.1875, 0.8125},
                                     {0.0625, 0.4375},
                                     {0.6875, 0.9375},
                                     {0.9375, 0.0625}}};
constexpr std::array<Vec, 16> kSixteen{{{0.5625, 0.5625},
                                        {0.4375, 0.3125},
                                        {0.3125, 0.625},
                                        {0.75, 0.4375},
                                        {0.1875, 0.375},
                                        {0.625, 0.8125},
                                        {0.8125, 0.6875},
                                        {0.6875, 0.1875},
                                        {0.375, 0.875},
                                        {0.5, 0.0625},
                                        {0.25, 0.125},
                                        {0.125, 0.75},
                                        {0.0, 0.5},
                                        {0.9375, 0.25},
                                        {0.875, 0.9375},
                                        {0.0625, 0.0}}};

}  // namespace

std::span<const Vec> standard_samples(int samples) {
  if (samples == 1) return kOne;
  if (samples == 2) return kTwo;
  if (samples == 4) return kFour;
  if (samples == 8) return kEight;
  if (samples == 16) return kSixteen;
  return {};
}

int turn(Vec a, Vec b, Vec c) {
  return static_cast<int>(CGAL::orientation(point(a), point(b), point(c)));
}

double cross(Vec a, Vec b, Vec p) {
  using Exact = CGAL::Exact_rational;
  const Exact x(a.x), y(a.y);
  return CGAL::to_double((Exact(b.x) - x) * (Exact(p.y) - y) - (Exact(b.y) - y) * (Exact(p.x) - x));
}

int side(Vec a, Vec b, Vec p) {
  const int here = turn(a, b, p);
  if (here != 0) return here;
  // The line passes through p. Orientation is linear in the point, so a step of any length from p
  // has the sign of an infinitesimal one: first the step right, then, along a horizontal line,
  // down.
  const int right = turn(a, b, {p.x + 1, p.y});
  return right != 0 ? right : turn(a, b, {p.x, p.y + 1});
}

bool strictly_between(Vec a, Vec b, Vec p) {
  return turn(a, b, p) == 0 &&
         CGAL::collinear_are_strictly_ordered_along_line(point(a), point(p), point(b));
}

bool covered(const Corners& triangle, Vec sample) {
  const auto& [a, b, c] = triangle;
  // The moved sample lies on no edge, so it is inside exactly when it is on the same side of all
  // three. Without area the three edges run along one line, not all the same way.
  const int first = side(a, b, sample);
  return first != 0 && side(b, c, sample) == first && side(c, a, sample) == first;
}

std::uint32_t pixel_mask(const Corners& triangle, int x, int y, std::span<const Vec> samples) {
  std::uint32_t mask = 0;
  for (std::size_t m = 0; m < samples.size(); ++m) {
    if (covered(triangle, {x + samples[m].x, y + samples[m].y})) mask |= 1u << m;
  }
  return mask;
}

std::vector<std::uint8_t> hit_count(std::span<const Corners> triangles, int width, int height,
                                    std::span<const Vec> samples) {
  std::vector<std::uint8_t> count(static_cast<std::size_t>(width) *
                                  static_cast<std::size_t>(height));
  // Least and greatest pixel of a range of coordinates, two pixels wide of it, in the frame.
  const auto first = [](double least, int size) {
    return static_cast<int>(std::clamp(std::floor(least) - 2, 0.0, static_cast<double>(size)));
  };
  const auto last = [](double greatest, int size) {
    return static_cast<int>(std::clamp(std::ceil(greatest) + 2, -1.0, size - 1.0));
  };
  for (const Corners& t : triangles) {
    const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
    const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
    for (int y = first(top, height); y <= last(bottom, height); ++y) {
      for (int x = first(left, width); x <= last(right, width); ++x) {
        if (pixel_mask(t, x, y, samples) == 0) continue;
        std::uint8_t& pixel = count[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                    static_cast<std::size_t>(x)];
        if (pixel != 255) ++pixel;
      }
    }
  }
  return count;
}

}  // namespace halfspace::oracle
