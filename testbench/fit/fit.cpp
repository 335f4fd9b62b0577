// SPDX-License-Identifier: Apache-2.0
#include "fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "hit_count.hpp"
#include "io/error.hpp"
#include "rasterizer.hpp"

namespace halfspace {
namespace {

#ifdef HALFSPACE_HAS_ORACLE
constexpr bool kHasOracle = true;
#else
constexpr bool kHasOracle = false;
#endif

CoverageCurve measured_coverage(const std::vector<FitView>& views, const Config& base,
                                std::uint64_t budget) {
  if constexpr (kHasOracle) {
    return coverage_curve(views, base, budget);
  } else {
    throw Error(ErrorCode::kFitOracle, "--max-error",
                "this build has no oracle (install libcgal-dev and configure again)");
  }
}

int choose_subpixels(const CoverageCurve& curve, double limit) {
  double least = 1e9;
  for (std::size_t s = 0; s < curve.error.size(); ++s) {
    if (curve.error[s].ppm() <= limit) return static_cast<int>(s);
    least = std::min(least, curve.error[s].ppm());
  }
  throw Error(ErrorCode::kFitLimit, "--max-error",
              fmt::format("{} ppm is below the {:.0f} ppm that the best of 0..12 subpixel bits "
                          "leaves",
                          limit, least));
}

// The fewest bits that keep the limit; all there are when none does.
int fewest(const std::vector<AccuracyPoint>& curve, double limit) {
  for (const AccuracyPoint& point : curve) {
    if (point.error <= limit) return point.bits;
  }
  return curve.back().bits;
}

// Bits of interpolation: each the fewest by itself, then more of all until they do together.
void choose_attributes(const std::vector<FitView>& views, double limit, std::uint64_t budget,
                       FitResult& result) {
  const AttributeCurves& curves = *result.attributes;
  Config& config = result.config;
  config.inverse_w_bits = fewest(curves.inverse_w, limit);
  config.gradient_bits = fewest(curves.gradient, limit);
  config.reciprocal_bits = fewest(curves.reciprocal, limit);
  for (;;) {
    result.attribute_error = attribute_error(views, config, budget);
    if (result.attribute_error <= limit) return;
    const Config before = config;
    config.inverse_w_bits = std::min(config.inverse_w_bits + 1, curves.inverse_w.back().bits);
    config.gradient_bits = std::min(config.gradient_bits + 1, curves.gradient.back().bits);
    config.reciprocal_bits = std::min(config.reciprocal_bits + 1, curves.reciprocal.back().bits);
    if (config == before) {
      throw Error(ErrorCode::kFitLimit, "--max-attribute-error",
                  fmt::format("{} levels is below the {:.3f} that all bits leave", limit,
                              result.attribute_error));
    }
  }
}

std::size_t choose_shape(const std::vector<FitShape>& shapes) {
  const auto meets = [](const FitShape& shape) { return shape.meets; };
  const auto found = std::find_if(shapes.begin(), shapes.end(), meets);
  if (found != shapes.end()) return static_cast<std::size_t>(found - shapes.begin());
  const auto& best = *std::min_element(
      shapes.begin(), shapes.end(),
      [](const FitShape& a, const FitShape& b) { return a.worst_clocks < b.worst_clocks; });
  throw Error(ErrorCode::kFitLimit, "--throughput",
              fmt::format("the fastest shape makes {:.2f} px/clk, and {} clocks for the slowest "
                          "view",
                          best.pixels_per_clock(), best.worst_clocks));
}

// Draws every view with the result and with the reference; counts what differs.
void compare_with_reference(const std::vector<FitView>& views, FitResult& result) {
  for (const FitView& view : views) {
    std::uint64_t seen = 0;  // submitted triangles that cover a sample, in the last run
    const auto hits_of = [&](const Config& config, RasterStats& stats) {
      std::uint32_t last = 0;
      seen = 0;
      HitCount hits(view.frame.width, view.frame.height);
      RunStats unused;
      view.scene->draw(view.index, view.frame, config, unused, [&](const ShadedTriangle& shaded) {
        const std::uint64_t before = stats.tiles_covered;
        rasterize(shaded.triangle, view.frame, config, stats,
                  [&](const CoverageTile& tile) { hits.add(tile, config); });
        if (stats.tiles_covered == before) return;
        if (seen == 0 || shaded.triangle.tag != last) ++seen;
        last = shaded.triangle.tag;
      });
      return hits.count();
    };
    RasterStats fitted, reference;
    const std::vector<std::uint8_t> want = hits_of(result.reference, reference);
    const std::vector<std::uint8_t> got = hits_of(result.config, fitted);
    for (std::size_t i = 0; i < got.size(); ++i) {
      result.samples_different += static_cast<std::uint64_t>(std::abs(got[i] - want[i]));
    }
    result.samples_covered += reference.samples_covered;
    result.triangles_no_sample += view.scene->triangles(view.index) - seen;
    if (fitted.samples_covered != reference.samples_covered) ++result.samples_different;
  }
  if (result.samples_different != 0) {
    throw Error(ErrorCode::kInternal, "fit",
                fmt::format("the fitted configuration covers {} samples differently",
                            result.samples_different));
  }
}

// `full` as the result is judged by: whatever is no saving is the result's.
Config reference_of(const Config& config, const FitRanges& ranges) {
  Config reference = kFull;
  reference.subpixel_bits = config.subpixel_bits;
  reference.samples = config.samples;
  reference.snap = config.snap;
  reference.viewport_bits = std::max(kFull.viewport_bits, ranges.viewport_bits);
  reference.guard_bits = std::max(kFull.guard_bits, ranges.guard_bits);
  return reference;
}

bool covers_a_sample(const FitView& view, const Config& config) {
  RasterStats stats;
  RunStats unused;
  view.scene->draw(view.index, view.frame, config, unused, [&](const ShadedTriangle& shaded) {
    if (stats.tiles_covered != 0) return;
    rasterize(shaded.triangle, view.frame, config, stats, [](const CoverageTile&) {});
  });
  return stats.tiles_covered != 0;
}

// A view without a covered sample constrains nothing. Refuses a scene that has only such views.
std::uint64_t count_empty(const std::vector<FitView>& views, const Config& config) {
  const auto empty =
      static_cast<std::size_t>(std::count_if(views.begin(), views.end(), [&](const FitView& view) {
        return !covers_a_sample(view, config);
      }));
  if (empty == views.size()) {
    throw Error(ErrorCode::kScene, views.front().place,
                views.size() == 1 ? "no triangle covers a sample of the frame: nothing to fit to"
                                  : fmt::format("no triangle covers a sample in any of the {} "
                                                "views: nothing to fit to",
                                                views.size()));
  }
  return empty;
}

}  // namespace

double CoverageError::ppm() const {
  if (covered == 0) return missing + extra == 0 ? 0.0 : 1e6;
  return 1e6 * static_cast<double>(missing + extra) / static_cast<double>(covered);
}

FitResult fit(const std::vector<FitView>& views, const FitOptions& options) {
  FitResult result;
  result.config = options.base;
  Config wide = options.base;
  const FitRanges first = fit_ranges(views, options.base);
  result.views_empty = count_empty(views, reference_of(options.base, first));
  wide.viewport_bits = first.viewport_bits;
  if (options.max_error || (options.curves && kHasOracle)) {
    result.coverage = measured_coverage(views, wide, options.budget);
    if (options.max_error) {
      result.config.subpixel_bits = choose_subpixels(*result.coverage, *options.max_error);
    }
  }
  result.ranges = fit_ranges(views, result.config);
  result.config = with_ranges(result.config, result.ranges);

  const std::uint64_t fragments = std::max<std::uint64_t>(1, options.budget / 40);
  if (result.config.attributes > 0 && (options.max_attribute_error || options.curves)) {
    result.attributes = attribute_curves(views, result.config, fragments);
    if (options.max_attribute_error) {
      choose_attributes(views, *options.max_attribute_error, fragments, result);
    } else {
      result.attribute_error = attribute_error(views, result.config, fragments);
    }
  }
  result.shapes = fit_shapes(views, result.config, options.target);
  result.shape = choose_shape(result.shapes);
  result.config.grid_log2 = result.shapes[result.shape].grid_log2;
  result.config.setup_interval = result.shapes[result.shape].setup_interval;

  if (options.curves) result.fifos = fifo_uses(views, result.config);

  result.reference = reference_of(result.config, result.ranges);
  compare_with_reference(views, result);
  return result;
}

}  // namespace halfspace
