// SPDX-License-Identifier: Apache-2.0
#include "suite_shapes.hpp"

namespace halfspace::lab {
namespace {

std::vector<SuiteCase> offsets() {
  std::vector<SuiteCase> cases;
  const auto mesh = jittered_mesh(871, 256, 16, 1, kShapeGrid);
  for (const int offset : {0, 1024, 4096, 15800, 32000}) {
    cases.push_back(area_case("at " + std::to_string(offset) + " px",
                              facets_of(mesh, offset, offset), {256, 256, offset, offset}));
  }
  return cases;
}

// Cells of a quarter of the legal range: the frame sees four of them meet.
std::vector<SuiteCase> guard_band() {
  std::vector<SuiteCase> cases;
  for (const int reach : {1024, 8192, 16384}) {
    const auto mesh = jittered_mesh(872, 2 * reach, reach / 2, 1, kShapeGrid);
    cases.push_back(area_case("vertices at +-" + std::to_string(reach) + " px",
                              facets_of(mesh, -reach + 100, -reach + 100), {256, 256}));
  }
  return cases;
}

// A quad as large as the frame, and a fan of slivers across it: values of the order of its area.
std::vector<SuiteCase> large() {
  std::vector<Facet> quad;
  add_quad(quad, {0.25, 0.5}, {2047.75, 0.25}, {2047.5, 2047.75}, {0.5, 2047.5});
  return {area_case("2048 px quad, its far corner", quad, {256, 256, 1792, 1792}),
          area_case("2048 px quad, its near corner", quad, {256, 256})};
}

// Edges and lines of many steps: whatever a step rounds adds up.
SuiteCase long_case(int length) {
  std::vector<Facet> out;
  const double rows = length - 0.75;
  Random random(873);
  double left = 1.25;
  double foot = 1.25;
  std::vector<methods::Segment> segments;
  for (int n = 0; n < 6; ++n) {
    const double right = left + on_grid(3 + static_cast<double>(random.in(0, 2000)) / 256);
    const double next = foot + on_grid(5 + static_cast<double>(random.in(0, 2000)) / 256);
    add_quad(out, {left, 0.5}, {right, 0.25}, {next, rows}, {foot, rows});
    segments.push_back({{left, 0.5}, {next, rows}});
    segments.push_back({{left, 0.75}, {left + on_grid(0.37 * n + 1), rows}});
    left = right;
    foot = next;
  }
  SuiteCase one = area_case(std::to_string(length) + " rows", out, {96, length});
  one.kinds = kAreaKinds | kLineKinds;
  one.drawing.segments = std::move(segments);
  return one;
}

std::vector<SuiteCase> long_runs() { return {long_case(256), long_case(2048), long_case(8192)}; }

// Lines of every direction, some exactly between two pixels.
std::vector<SuiteCase> line_ties() {
  SuiteCase one;
  one.name = "a bundle of lines";
  one.kinds = kLineKinds;
  one.window = {256, 256};
  one.drawing.view.width = 256;
  one.drawing.view.height = 256;
  Random random(874);
  for (int n = 0; n < 64; ++n) {
    const auto end = [&random](std::int64_t step) {
      return static_cast<double>(step * random.in(0, 256 * 256 / step)) / 256;
    };
    const std::int64_t step = n % 2 == 0 ? 1 : 128;
    one.drawing.segments.push_back({{end(step), end(step)}, {end(step), end(step)}});
  }
  return {one};
}

// Vertices that are not multiples of anything: what snapping costs.
std::vector<SuiteCase> off_grid() {
  return {area_case("8 px cells", separate(875, 8, 32, 0), {256, 256}),
          area_case("32 px cells", separate(876, 32, 8, 0), {256, 256})};
}

}  // namespace

void add_distance_suites(std::vector<Suite>& list) {
  list.push_back({"offsets", "the same mesh up to 32,000 px from the origin",
                  "C = x0 y1 - x1 y0 cancels: a float has no digits left for the fraction",
                  Judge::kHits, true, offsets});
  list.push_back({"guard_band", "vertices up to 16,384 px outside the frame",
                  "products as wide as they come: int32 wraps, floats round", Judge::kHits, true,
                  guard_band});
  list.push_back({"large", "a 2048 px quad", "edge values of 38 bits: int32 wraps without a word",
                  Judge::kHits, true, large});
  list.push_back({"long_runs", "edges and lines of 256 to 8192 steps",
                  "a slope of F fraction bits drifts by its rounding at every step", Judge::kHits,
                  true, long_runs});
  list.push_back({"line_ties", "lines in all directions",
                  "a line between two pixels: rounding half up, down or not at all", Judge::kHits,
                  true, line_ties});
  list.push_back({"off_grid", "vertices that are on no grid",
                  "fixed point snaps first: its error is the subpixel's, halved by every bit",
                  Judge::kHits, false, off_grid});
}

}  // namespace halfspace::lab
