// SPDX-License-Identifier: Apache-2.0
//
// How wrong a picture is. The truth comes from the oracle's exact predicates, found row by row so
// that a mesh of a megapixel takes well under a second; tests/metrics_test.cpp holds it to the
// oracle's own pixel by pixel answer.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "oracle.hpp"

namespace halfspace::oracle {

// The pixels looked at: x_first..x_first + width - 1, likewise y. Coordinates below 2^20.
struct Window {
  int width = 0;
  int height = 0;
  int x_first = 0;
  int y_first = 0;
};

// How many triangles own the centre of each pixel, row by row from the top: covered(), summed.
// Any finite vertices. Cost: a few exact predicates per edge and row, one store per hit.
std::vector<std::uint32_t> exact_hits(std::span<const Corners> triangles, const Window& window);

// The same for polygons by the odd number of crossings, each a list of rings. A centre on an edge
// counts as moved right and down by an infinitesimal, as in side().
using Rings = std::vector<std::vector<Vec>>;
std::vector<std::uint32_t> exact_hits(std::span<const Rings> polygons, const Window& window);

// Two pictures of hit counts compared.
struct HitErrors {
  std::uint64_t covered = 0;  // pixels with a hit in the true picture
  std::uint64_t wrong = 0;    // pixels with another number of hits: gaps + doubles
  std::uint64_t gaps = 0;     // with too few
  std::uint64_t doubles = 0;  // with too many
  HitErrors& operator+=(const HitErrors& other);
  // Wrong pixels per million covered; of an empty picture 0, or infinity when anything was drawn.
  double ppm() const;
};

// Of equal size.
HitErrors compare_hits(std::span<const std::uint32_t> hits, std::span<const std::uint32_t> exact);

// A vertex for attributes: position px, w, and one attribute.
struct AttributeVertex {
  Vec position;
  double w = 1;
  double value = 0;
};
using AttributeFacet = std::array<AttributeVertex, 3>;

// The attribute at a point by the definition, in long double (64-bit significand): barycentric
// weights from areas, over w when `perspective`. The triangle must have an area.
long double attribute_at(const AttributeFacet& facet, Vec point, bool perspective);

// Least upper bound and root mean square of |error|, in the attribute's LSB.
struct ErrorSummary {
  std::uint64_t count = 0;
  std::uint64_t not_finite = 0;  // NaN or infinite, not part of the sums
  double greatest = 0;
  double sum_of_squares = 0;
  void add(double error);
  double rms() const;
};

}  // namespace halfspace::oracle
