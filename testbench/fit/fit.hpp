// SPDX-License-Identifier: Apache-2.0
//
// The smallest configuration that is right for given views. What each part promises, and why:
// docs/02_use/fit.md; the argument for the widths: docs/03_design/config.md.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "area_model.hpp"
#include "config.hpp"
#include "scene/scene.hpp"

namespace halfspace {

// One picture to be right for: a frame of a scene.
struct FitView {
  std::shared_ptr<const Scene> scene;
  std::size_t index = 0;
  std::string name;   // for people: the file, the case or the camera's number
  std::string place;  // for error messages: the file
  FrameState frame;
};

// A frame's state for the view; cull as asked for.
FrameState view_frame(const FitView& view, Cull cull);

// Every frame of the scene. Sizes need not fit any configuration yet.
std::vector<FitView> fit_views(std::shared_ptr<const Scene> scene, const std::string& path,
                               Cull cull);

// --- Ranges ---

// What the snapped vertices of all views need, exactly: maxima over every submitted triangle.
struct FitRanges {
  int viewport_bits = 3;
  int guard_bits = 0;       // the least that cuts no triangle at its sides
  bool cut_anyway = false;  // no guard band is wide enough: triangles are cut as `full` cuts them
  std::int64_t extent = 0;  // greatest |difference| of two vertices in x or in y, subpixels
  int extent_bits = 0;
  int tag_bits = 1;
  std::uint64_t triangles = 0;  // of all views
  std::string widest;           // the view and triangle that attain the extent
};

// With the subpixel bits and the snap mode of `base`. Throws Error(kFitLimit) when a frame is
// larger than any configuration's. Cost: one pass of geometry per guard band tried, at most 16.
FitRanges fit_ranges(const std::vector<FitView>& views, const Config& base);

// base with the ranges put in.
Config with_ranges(Config base, const FitRanges& ranges);

// --- Accuracy ---

// How a choice of bits does against real arithmetic.
struct AccuracyPoint {
  int bits = 0;
  double error = 0;  // coverage: ppm; attributes: levels of 255
};

struct CoverageError {
  std::uint64_t covered = 0;  // samples of the real-valued triangles
  std::uint64_t missing = 0;  // covered there, not by the snapped triangle
  std::uint64_t extra = 0;
  double ppm() const;  // (missing + extra) / covered
};

// The model's coverage of the snapped triangles, 0..12 subpixel bits, against CGAL's exact
// predicates on the vertices as they were before snapping; triangle by triangle, so that what one
// loses and its neighbour gains counts twice. Triangles cut at near or far are left out.
struct CoverageCurve {
  std::array<CoverageError, 13> error;
  std::uint64_t triangles = 0;  // measured: at most `budget` pixels next to edges, evenly chosen
  std::uint64_t of = 0;         // in all
};
// Only in a build with CGAL; fit() throws Error(kFitOracle) in others.
CoverageCurve coverage_curve(const std::vector<FitView>& views, const Config& base,
                             std::uint64_t budget);

// The same of one view for any configurations of as many samples; what does not depend on them is
// worked out once. Only in a build with CGAL.
using CoverageMeter = std::function<CoverageError(const Config&)>;
CoverageMeter coverage_meter(const FitView& view, int samples, std::uint64_t budget);

// One curve for each of the bits that interpolation has, the others at their most.
struct AttributeCurves {
  std::vector<AccuracyPoint> inverse_w;   // 12..30
  std::vector<AccuracyPoint> gradient;    // 0..20
  std::vector<AccuracyPoint> reciprocal;  // 6..16
  std::uint64_t fragments = 0;            // measured
};

// The greatest error of an attribute, in levels of 255, at the pixel centres covered by the
// snapped triangles, against perspective interpolation in double precision between the snapped
// vertices. Half a level is the rounding to 8 bits.
AttributeCurves attribute_curves(const std::vector<FitView>& views, const Config& base,
                                 std::uint64_t budget);
double attribute_error(const std::vector<FitView>& views, const Config& config,
                       std::uint64_t budget);

// --- Shape ---

// --throughput: pixels per clock over all views, or frames per second at a clock rate for the
// slowest.
struct FitTarget {
  double pixels_per_clock = 0;
  double frames_per_second = 0;
  double megahertz = 0;
};
// "2.5px/clk" or "60fps@100MHz". Throws Error(kUsage).
FitTarget parse_target(const std::string& text);

// One choice of grid and setup interval.
struct FitShape {
  int grid_log2 = 3;
  int setup_interval = 1;
  std::uint64_t clocks = 0;  // of level cycle, all views, no stalls
  std::uint64_t worst_clocks = 0;
  std::uint64_t fragments = 0;
  AreaEstimate area;
  bool meets = true;
  double pixels_per_clock() const;
};

// All four shapes of the configuration, least estimated area first.
std::vector<FitShape> fit_shapes(const std::vector<FitView>& views, const Config& config,
                                 const std::optional<FitTarget>& target);

// --- FIFOs ---

// One FIFO of two entries, over all views, without stalls.
struct FifoUse {
  int level = 0;                  // of the pyramid, 0 the root; the last one is coverage
  std::uint64_t packets = 0;      // that went through
  std::uint64_t waited = 0;       // of those, into the second entry, behind another
  std::uint64_t both_clocks = 0;  // in which both entries held a packet
};
// The FIFOs of a configuration, root first, as level cycle fills them.
struct FifoUses {
  std::vector<FifoUse> fifo;
  std::uint64_t clocks = 0;  // of all views
};
// Measured, not fitted: docs/02_use/fit.md says why. Cost: every view once at level cycle.
FifoUses fifo_uses(const std::vector<FitView>& views, const Config& config);

// --- All of it ---

struct FitOptions {
  Config base;  // samples, attributes, snap mode, depth bits; subpixel bits when not chosen
  std::optional<double> max_error;            // ppm of covered samples
  std::optional<double> max_attribute_error;  // levels of 255
  std::optional<FitTarget> target;
  bool curves = false;               // measure the curves even when no limit asks for them
  std::uint64_t budget = 4'000'000;  // pixels next to edges, and fragments / 40, to measure
};

struct FitResult {
  Config config;
  Config reference;  // `full` with the same subpixel bits, samples and, if need be, viewport
  FitRanges ranges;
  std::optional<CoverageCurve> coverage;
  std::optional<AttributeCurves> attributes;
  double attribute_error = 0;             // of the configuration; 0 when not measured
  std::vector<FitShape> shapes;           // least area first
  std::size_t shape = 0;                  // the chosen one
  std::uint64_t samples_covered = 0;      // by the reference, all views
  std::uint64_t samples_different = 0;    // pixels' hit counts, summed: 0, or fit stops
  std::uint64_t triangles_no_sample = 0;  // of all views: they cover no sample
  std::uint64_t views_empty = 0;          // views without a covered sample: fewer than all
  std::optional<FifoUses> fifos;          // with `curves`
};

// Throws Error(kScene) when no view has a covered sample, Error(kFitLimit) when no configuration
// keeps the limits, Error(kFitOracle) without CGAL, and Error(kInternal) when the result does not
// draw what the reference draws.
FitResult fit(const std::vector<FitView>& views, const FitOptions& options);

}  // namespace halfspace
