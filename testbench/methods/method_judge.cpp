// SPDX-License-Identifier: Apache-2.0
#include "method_judge.hpp"

#include <algorithm>
#include <cmath>

#include "vectors/generators.hpp"
#include "vectors/reproducers.hpp"

namespace halfspace::methods {
namespace {

// The box of some positions with two pixels around it.
oracle::Window window_around(const oracle::Corners& t) {
  const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
  const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
  const int x = static_cast<int>(std::floor(left)) - 2, y = static_cast<int>(std::floor(top)) - 2;
  return {static_cast<int>(std::ceil(right)) + 2 - x, static_cast<int>(std::ceil(bottom)) + 2 - y,
          x, y};
}

oracle::Corners snapped_corners(const Facet& f) {
  oracle::Corners out;
  for (std::size_t i = 0; i < 3; ++i) {
    out[i] = {std::nearbyint(f[i].x * 256) / 256, std::nearbyint(f[i].y * 256) / 256};
  }
  return out;
}

}  // namespace

std::vector<Facet> facets_of(std::span<const oracle::Corners> triangles) {
  std::vector<Facet> facets;
  for (const oracle::Corners& t : triangles) {
    Facet& f = facets.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) f[i].x = t[i].x, f[i].y = t[i].y;
  }
  return facets;
}

Canvas drawn(const Method& method, std::span<const oracle::Corners> triangles,
             const oracle::Window& window, std::uint64_t budget) {
  Canvas canvas(window.width, window.height, window.x_first, window.y_first, budget);
  draw(method, drawing_of(facets_of(triangles), window.width, window.height), canvas);
  return canvas;
}

oracle::HitErrors hit_errors(const Method& method, std::span<const oracle::Corners> triangles,
                             const oracle::Window& window) {
  return oracle::compare_hits(drawn(method, triangles, window).hits(),
                              oracle::exact_hits(triangles, window));
}

oracle::HitErrors hit_errors_alone(const Method& method,
                                   std::span<const oracle::Corners> triangles) {
  oracle::HitErrors sum;
  for (const oracle::Corners& t : triangles) {
    sum += hit_errors(method, std::span(&t, 1), window_around(t));
  }
  return sum;
}

oracle::ErrorSummary attribute_errors(const Method& method, std::span<const Facet> facets,
                                      bool perspective) {
  oracle::ErrorSummary sum;
  for (const Facet& f : facets) {
    const oracle::Corners corners = snapped_corners(f);
    const oracle::Window window = window_around(corners);
    Canvas canvas(window.width, window.height, window.x_first, window.y_first);
    canvas.keep_attributes();
    std::get<DrawFacet>(method.draw)(f, canvas);
    oracle::AttributeFacet truth;
    for (std::size_t i = 0; i < 3; ++i) truth[i] = {corners[i], f[i].w, f[i].color[0]};
    for (int y = canvas.y_first(); y <= canvas.y_last(); ++y) {
      for (int x = canvas.x_first(); x <= canvas.x_last(); ++x) {
        const std::size_t i = canvas.index(x, y);
        if (canvas.hits()[i] == 0) continue;
        const auto exact = oracle::attribute_at(truth, {x + 0.5, y + 0.5}, perspective);
        sum.add(static_cast<double>(canvas.color()[i][0] - exact));
      }
    }
  }
  return sum;
}

std::vector<Facet> shaded_triangles(std::uint64_t seed, int count) {
  Random random(seed);
  std::vector<Facet> facets = facets_of(oracle::random_triangles(seed + 1, count, 8, 60));
  for (Facet& f : facets) {
    for (Vertex& v : f) {
      v.w = 1 + static_cast<double>(random.in(0, 15 << 16)) / (1 << 16);
      v.color[0] = static_cast<double>(random.in(0, 255));
    }
  }
  return facets;
}

}  // namespace halfspace::methods
