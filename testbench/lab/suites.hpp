// SPDX-License-Identifier: Apache-2.0
//
// The inputs that break methods: named suites of generated cases, each with its reason and its
// truth. Same cases on every machine. Page: docs/02_use/stability.md.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "methods/method.hpp"
#include "oracle/metrics.hpp"

namespace halfspace::lab {

// What is compared with the truth.
enum class Judge {
  kHits,       // hits per pixel
  kAttribute,  // colour of covered pixels, wrong when off by more than kAttributeBound
  kDepth,      // which of two surfaces shows
  kOrder       // the picture of the same triangles in another order
};

// Levels of 255. The design's documented bound is below it (docs/03_design/interpolation.md).
inline constexpr double kAttributeBound = 1.0;

// Kinds of input that a case has, as bits 1 << InputKind.
inline constexpr unsigned kTriangleKinds = 1u << 0;
inline constexpr unsigned kPolygonKinds = 1u << 1;
inline constexpr unsigned kLineKinds = 1u << 2;
inline constexpr unsigned kClipKinds = 1u << 3;
inline constexpr unsigned kWorldKinds = 1u << 4;
inline constexpr unsigned kAreaKinds = kTriangleKinds | kPolygonKinds | kClipKinds | kWorldKinds;

struct SuiteCase {
  std::string name;
  unsigned kinds = kAreaKinds;
  methods::Drawing drawing;
  methods::Drawing shuffled;  // kOrder
  oracle::Window window;
  // Hits per pixel, row by row; for kAttribute and kDepth the pixels to look at are those with one
  // hit and more. Empty: found from the drawing's primitives by the oracle.
  std::function<std::vector<std::uint32_t>()> hits;
};

struct Suite {
  std::string name;
  std::string title;   // what it is
  std::string reason;  // which methods it breaks, and why
  Judge judge = Judge::kHits;
  bool exact = true;  // a method with Method::exact must have nothing wrong
  std::function<std::vector<SuiteCase>()> make;
  bool degenerate = false;  // kHits: attributes are looked at too, for NaN
};

const std::vector<Suite>& suites();

// Who contributes: one function a file.
void add_edge_suites(std::vector<Suite>& list);       // ties, slivers, scan lines
void add_distance_suites(std::vector<Suite>& list);   // far away, long, large
void add_attribute_suites(std::vector<Suite>& list);  // depth, attributes, order, clipping

// The truth of a case for one kind of input.
std::vector<std::uint32_t> true_hits(const SuiteCase& one, methods::InputKind kind);
// The same with vertices snapped to 2^-bits px first, halves to even.
std::vector<std::uint32_t> true_hits_snapped(const SuiteCase& one, methods::InputKind kind,
                                             int bits);

// Which triangle owns each pixel (the last of several); -1: none.
std::vector<int> true_owners(const SuiteCase& one);

}  // namespace halfspace::lab
