// SPDX-License-Identifier: Apache-2.0
//
// Soak runs: drawn configurations x drawn triangles, everything against what it must equal, until
// the first difference. docs/02_use/many_machines.md.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "config.hpp"
#include "packets.hpp"
#include "shard.hpp"
#include "vectors/generators.hpp"

namespace halfspace {

// One drawn configuration, with the frame its triangles are drawn into.
struct SoakPoint {
  std::uint64_t number = 0;
  Config config;
  FrameState frame;
  double stall = 0;  // of `rtl` and `cycle`
  std::uint64_t seed = 0;
};

// Compares two sides on the triangles; what differs first, in a line. Empty: nothing does.
struct SoakCheck {
  std::string name;
  std::function<std::string(std::span<const ShadedTriangle>, const SoakPoint&)> difference;
};

// engines: coverage engines of every instruction set against the stages. frame: frame
// engines of every instruction set against the stages, depth and colour. cycle: cycle engines of
// every instruction set against the cycle model under stalls. oracle: the stages against exact
// predicates. interpolation: depth and attributes against exact rationals, within the bound that
// docs/03_design/interpolation.md proves. rtl: the RTL against the cycle model under stalls.
const std::vector<SoakCheck>& soak_checks();

struct SoakSpecification {
  std::string path;
  std::uint64_t seed = 1;
  std::uint64_t configurations = 200;
  std::uint64_t triangles = 1000;  // for each configuration
  int size = 32;                   // the largest frame, px a side
  double stall = 0.3;
  std::vector<Shape> shapes;
  std::vector<SoakCheck> checks;
};
// Throws Error(kSpecification).
SoakSpecification read_soak(const std::string& path);

// From the whole legal space, every field each as likely as any of its values.
SoakPoint draw_point(const SoakSpecification& specification, std::uint64_t number);
// The point's triangle of that number; its tag is the number's low bits.
ShadedTriangle draw_soak_triangle(const SoakSpecification& specification, const SoakPoint& point,
                                  std::uint64_t number);

struct SoakDifference {
  std::string check;
  std::uint64_t point = 0;
  std::string text;                       // of the triangles below
  std::vector<ShadedTriangle> triangles;  // minimised
};
struct SoakOutcome {
  std::uint64_t points = 0;
  std::uint64_t triangles = 0;
  std::optional<SoakDifference> difference;
};
// The points k with k mod N = I. Throws Error.
SoakOutcome run_soak(const SoakSpecification& specification, const Shard& shard);

// Fewer triangles with smaller coordinates for which `fails` is still true; it is for `triangles`.
// Every change tried is legal for the configuration.
using Fails = std::function<bool(std::span<const ShadedTriangle>)>;
std::vector<ShadedTriangle> shrink(std::vector<ShadedTriangle> triangles, const Config& config,
                                   const Fails& fails);

// "0,0,5,0,0,7,1" for each triangle, with ';' between them: vertices in subpixels. The last
// number is its tag, on which its attributes depend.
std::string triangles_text(std::span<const ShadedTriangle> triangles);
// Throws Error(kUsage).
std::vector<ShadedTriangle> parse_triangles(const SoakSpecification& specification,
                                            const SoakPoint& point, const std::string& text);

}  // namespace halfspace
