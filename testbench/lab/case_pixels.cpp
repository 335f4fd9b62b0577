// SPDX-License-Identifier: Apache-2.0
#include "case_pixels.hpp"

#include <algorithm>
#include <cmath>

namespace halfspace::lab {
namespace {

using methods::Canvas;
using methods::Method;

constexpr std::uint64_t kSteps = 4'000'000'000;  // per case, as Canvas counts them

Canvas canvas_for(const SuiteCase& one, bool attributes) {
  Canvas canvas(one.window.width, one.window.height, one.window.x_first, one.window.y_first,
                kSteps);
  if (attributes) canvas.keep_attributes();
  return canvas;
}

// The centre of pixel i of the window.
oracle::Vec centre(const SuiteCase& one, std::size_t i) {
  const auto w = static_cast<std::size_t>(one.window.width);
  return {one.window.x_first + static_cast<double>(i % w) + 0.5,
          one.window.y_first + static_cast<double>(i / w) + 0.5};
}

Wrong judge_hits(std::uint32_t found, std::uint32_t truth) {
  return found < truth ? Wrong::kGap : found > truth ? Wrong::kExtra : Wrong::kNo;
}

// The greatest error of the three channels of a pixel; infinite when one is not finite.
double color_error(const methods::Facet& f, const methods::Color& found, oracle::Vec at) {
  double worst = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    oracle::AttributeFacet facet;
    for (std::size_t k = 0; k < 3; ++k) facet[k] = {{f[k].x, f[k].y}, f[k].w, f[k].color[c]};
    const long double truth = oracle::attribute_at(facet, at, true);
    const double error = std::abs(static_cast<double>(found[c] - truth));
    if (!std::isfinite(error)) return INFINITY;
    worst = std::max(worst, error);
  }
  return worst;
}

std::uint64_t not_finite(const Canvas& canvas) {
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < canvas.hits().size(); ++i) {
    if (canvas.hits()[i] == 0) continue;
    bool finite = std::isfinite(canvas.depth()[i]);
    for (const double level : canvas.color()[i]) finite = finite && std::isfinite(level);
    count += finite ? 0u : 1u;
  }
  return count;
}

void judge_attribute(const SuiteCase& one, const Canvas& canvas, CasePixels& out) {
  const std::vector<int> owners = true_owners(one);
  for (std::size_t i = 0; i < owners.size(); ++i) {
    if (owners[i] < 0 || canvas.hits()[i] == 0) continue;
    ++out.result.covered;
    const methods::Facet& f = one.drawing.facets[static_cast<std::size_t>(owners[i])];
    const double error = color_error(f, canvas.color()[i], centre(one, i));
    if (std::isfinite(error)) out.result.greatest = std::max(out.result.greatest, error);
    if (error > kAttributeBound) out.wrong[i] = Wrong::kValue;
  }
}

// The level of the nearer surface at each pixel, by depth in long double; -1 where none is.
std::vector<double> nearest_levels(const SuiteCase& one) {
  std::vector<double> level(
      static_cast<std::size_t>(one.window.width) * static_cast<std::size_t>(one.window.height), -1);
  std::vector<long double> depth(level.size(), 2);
  for (const methods::Facet& f : one.drawing.facets) {
    const oracle::Corners corners{{{f[0].x, f[0].y}, {f[1].x, f[1].y}, {f[2].x, f[2].y}}};
    const auto hits = oracle::exact_hits(std::span(&corners, 1), one.window);
    oracle::AttributeFacet z;
    for (std::size_t k = 0; k < 3; ++k) z[k] = {{f[k].x, f[k].y}, 1, f[k].z};
    for (std::size_t i = 0; i < hits.size(); ++i) {
      if (hits[i] == 0) continue;
      const long double here = oracle::attribute_at(z, centre(one, i), false);
      if (here >= depth[i]) continue;
      depth[i] = here;
      level[i] = f[0].color[0];
    }
  }
  return level;
}

void judge_depth(const SuiteCase& one, const Canvas& canvas, CasePixels& out) {
  const std::vector<double> truth = nearest_levels(one);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth[i] < 0) continue;
    ++out.result.covered;
    const double found = canvas.color()[i][0];
    // The surfaces' levels are 128 apart.
    if (!(std::abs(found - truth[i]) < 64)) out.wrong[i] = Wrong::kValue;
  }
}

void judge_order(const Method& method, const SuiteCase& one, const Canvas& canvas,
                 CasePixels& out) {
  Canvas other = canvas_for(one, method.attributes);
  methods::draw(method, one.shuffled, other);
  for (std::size_t i = 0; i < out.truth.size(); ++i) {
    // Without attributes: where two triangles draw one pixel, the order decides which shows.
    const bool differs = method.attributes ? canvas.color()[i] != other.color()[i]
                                           : canvas.hits()[i] > std::max(out.truth[i], 1u);
    if (differs || canvas.hits()[i] != other.hits()[i]) out.wrong[i] = Wrong::kValue;
  }
}

}  // namespace

double CaseResult::ppm() const {
  if (hung || crashed) return 1e6;
  if (covered == 0) return wrong == 0 ? 0.0 : 1e6;
  return 1e6 * static_cast<double>(wrong) / static_cast<double>(covered);
}

CasePixels case_pixels(const Method& method, const Suite& suite, const SuiteCase& one,
                       int snapped_bits) {
  CasePixels out;
  const bool keeps = method.attributes && (suite.judge != Judge::kHits || suite.degenerate);
  Canvas canvas = canvas_for(one, keeps);
  methods::draw(method, one.drawing, canvas);
  out.result.hung = canvas.exhausted();
  out.truth = true_hits_snapped(one, method.input(), snapped_bits);
  out.wrong.assign(out.truth.size(), Wrong::kNo);
  const bool by_hits = suite.judge == Judge::kHits;
  if (canvas.wants_attributes()) out.result.not_finite = not_finite(canvas);
  if (suite.judge == Judge::kAttribute) judge_attribute(one, canvas, out);
  if (suite.judge == Judge::kDepth) judge_depth(one, canvas, out);
  if (suite.judge == Judge::kOrder) judge_order(method, one, canvas, out);
  for (std::size_t i = 0; i < out.truth.size(); ++i) {
    if (by_hits) out.wrong[i] = judge_hits(canvas.hits()[i], out.truth[i]);
    if (by_hits || suite.judge == Judge::kOrder) out.result.covered += out.truth[i] != 0 ? 1u : 0u;
    out.result.wrong += out.wrong[i] != Wrong::kNo ? 1u : 0u;
    out.result.gaps += out.wrong[i] == Wrong::kGap ? 1u : 0u;
    out.result.doubles += out.wrong[i] == Wrong::kExtra ? 1u : 0u;
  }
  return out;
}

}  // namespace halfspace::lab
