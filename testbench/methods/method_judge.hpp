// SPDX-License-Identifier: Apache-2.0
//
// A method of the gallery before the oracle: what it got wrong, in pixels and in levels of colour.
#pragma once

#include <span>
#include <vector>

#include "method.hpp"
#include "oracle/metrics.hpp"

namespace halfspace::methods {

// The oracle's triangles as a method takes them: depth 1/2, w 1, black.
std::vector<Facet> facets_of(std::span<const oracle::Corners> triangles);

// A canvas of the window with all triangles drawn, or as many as the budget allows.
Canvas drawn(const Method& method, std::span<const oracle::Corners> triangles,
             const oracle::Window& window, std::uint64_t budget = kNoLimit);

// Hits against the oracle's on the same vertices, not snapped.
oracle::HitErrors hit_errors(const Method& method, std::span<const oracle::Corners> triangles,
                             const oracle::Window& window);

// The same, each triangle alone on a canvas around it: who owns a pixel counts, not only how many.
oracle::HitErrors hit_errors_alone(const Method& method,
                                   std::span<const oracle::Corners> triangles);

// The first attribute's error at every pixel drawn, each triangle alone, in levels (LSB of 8 bits),
// against the definition on vertices snapped to 1/256 px. Facets must have an area.
oracle::ErrorSummary attribute_errors(const Method& method, std::span<const Facet> facets,
                                      bool perspective);

// Triangles of up to 8 px with w of 1..16 and whole levels of red, 0..255.
std::vector<Facet> shaded_triangles(std::uint64_t seed, int count);

}  // namespace halfspace::methods
