// SPDX-License-Identifier: Apache-2.0
//
// Only in builds that have CGAL.
#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>
#include <span>

#include "fit.hpp"
#include "oracle/oracle.hpp"
#include "rasterizer.hpp"
#include "scene/progress.hpp"

namespace halfspace {
namespace {

// A pixel near an edge, and the samples of it that the real-valued triangle owns.
struct Probe {
  std::int32_t x;
  std::int32_t y;
  std::uint32_t samples;
};

// Where snapping may change the answer. A vertex moves by less than a pixel in x and in y, so the
// samples that change lie within sqrt(2) px of the real triangle's outline: two convex sets whose
// corners are that close differ nowhere else.
constexpr double kReach = 2.0;

struct Interval {
  int first;
  int last;
};

// Pixels of row y within kReach of the edge from a to b, one direction at a time: no fewer.
Interval near_edge(oracle::Vec a, oracle::Vec b, int y, int width) {
  if (a.y > b.y) std::swap(a, b);
  const double low = std::max(a.y, y - kReach);
  const double high = std::min(b.y, y + 1 + kReach);
  if (low > high) return {0, -1};
  const auto at = [&](double row) {
    return a.x + (b.x - a.x) * std::clamp((row - a.y) / (b.y - a.y), 0.0, 1.0);
  };
  const bool flat = a.y == b.y;
  const double one = flat ? a.x : at(low);
  const double other = flat ? b.x : at(high);
  const double left = std::min(one, other);
  const double right = std::max(one, other);
  const double last = width - 1;
  return {static_cast<int>(std::clamp(std::floor(left - kReach - 1), 0.0, last + 1)),
          static_cast<int>(std::clamp(std::ceil(right + kReach), -1.0, last))};
}

oracle::Corners corners(const RealTriangle& triangle) {
  oracle::Corners out;
  for (std::size_t i = 0; i < 3; ++i) out[i] = {triangle.vertex[i].x, triangle.vertex[i].y};
  return out;
}

// Calls visit(x, y) for every pixel of the frame near the outline, each once.
template <class Visit>
void near_outline(const oracle::Corners& t, const FrameState& frame, Visit&& visit) {
  const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
  const auto row = [&](double y) {
    return static_cast<int>(std::clamp(y, -1.0, static_cast<double>(frame.height)));
  };
  for (int y = std::max(row(std::floor(top - kReach)), 0);
       y <= std::min(row(std::ceil(bottom + kReach)), frame.height - 1); ++y) {
    std::array<Interval, 3> parts{near_edge(t[0], t[1], y, frame.width),
                                  near_edge(t[1], t[2], y, frame.width),
                                  near_edge(t[2], t[0], y, frame.width)};
    std::sort(parts.begin(), parts.end(),
              [](const Interval& a, const Interval& b) { return a.first < b.first; });
    int next = 0;
    for (const Interval& part : parts) {
      for (int x = std::max(part.first, next); x <= part.last; ++x) visit(x, y);
      next = std::max(next, part.last + 1);
    }
  }
}

// The measured triangles of one view and their probes.
struct Probes {
  std::vector<Probe> probe;
  std::vector<std::size_t> first;  // by index of the submitted triangle; one more than there are
  std::vector<bool> measured;
  std::uint64_t count = 0;  // of measured triangles
};

std::uint64_t outline_pixels(const FitView& view) {
  std::uint64_t sum = 0;
  view.scene->real(view.index, [&](const RealTriangle& triangle) {
    near_outline(corners(triangle), view.frame, [&sum](int, int) { ++sum; });
  });
  return sum;
}

Probes make_probes(const FitView& view, std::uint64_t stride, int samples) {
  Probes out;
  const std::uint64_t count = view.scene->triangles(view.index);
  out.first.assign(count + 1, 0);
  out.measured.assign(count, false);
  std::uint64_t done = 0;  // triangles whose `first` is known
  view.scene->real(view.index, [&](const RealTriangle& triangle) {
    if (!triangle.whole || triangle.index % stride != 0) return;
    while (done <= triangle.index) out.first[done++] = out.probe.size();
    out.measured[triangle.index] = true;
    ++out.count;
    const oracle::Corners real = corners(triangle);
    near_outline(real, view.frame, [&](int x, int y) {
      out.probe.push_back(
          {x, y, oracle::pixel_mask(real, x, y, oracle::standard_samples(samples))});
    });
  });
  while (done <= count) out.first[done++] = out.probe.size();
  return out;
}

// The snapped pieces of one submitted triangle, as the model covers them.
class Covered {
 public:
  explicit Covered(const Config& config) : config_(config) {}

  void clear() {
    tiles_.clear();
    samples_ = 0;
  }
  void add(const Triangle& triangle, const FrameState& frame) {
    RasterStats counts;
    rasterize(triangle, frame, config_, counts,
              [this](const CoverageTile& tile) { tiles_.push_back(tile); });
    samples_ += counts.samples_covered;
  }
  // After the last piece.
  void sort() { std::sort(tiles_.begin(), tiles_.end(), before); }

  std::uint64_t samples() const { return samples_; }
  std::uint32_t at(int x, int y) const {
    CoverageTile place;
    place.x = x & -config_.grid();
    place.y = y & -config_.grid();
    const int lane = ((y - place.y) << config_.grid_log2) + x - place.x;
    const auto [first, last] = std::equal_range(tiles_.begin(), tiles_.end(), place, before);
    std::uint32_t mask = 0;
    for (auto tile = first; tile != last; ++tile) {
      for (int m = 0; m < config_.samples; ++m) {
        const auto bit = tile->mask[static_cast<std::size_t>(m)] >> lane & 1;
        mask |= static_cast<std::uint32_t>(bit) << m;
      }
    }
    return mask;
  }

 private:
  static bool before(const CoverageTile& a, const CoverageTile& b) {
    return a.y != b.y ? a.y < b.y : a.x < b.x;
  }

  Config config_;
  std::vector<CoverageTile> tiles_;
  std::uint64_t samples_ = 0;
};

void compare(const Covered& covered, std::span<const Probe> probes, CoverageError& error) {
  std::uint64_t missing = 0, extra = 0;
  for (const Probe& probe : probes) {
    const std::uint32_t snapped = covered.at(probe.x, probe.y);
    missing += static_cast<std::uint64_t>(std::popcount(probe.samples & ~snapped));
    extra += static_cast<std::uint64_t>(std::popcount(snapped & ~probe.samples));
  }
  error.missing += missing;
  error.extra += extra;
  error.covered += covered.samples() + missing - extra;
}

void measure(const FitView& view, const Probes& probes, const Config& config,
             CoverageError& error) {
  Covered covered(config);  // of triangle `owner`
  std::uint64_t owner = 0;
  std::uint64_t compared = 0;  // submitted triangles
  const auto compare_until = [&](std::uint64_t end) {
    for (; compared < end; ++compared) {
      if (compared != owner) covered.clear();
      if (!probes.measured[compared]) continue;
      covered.sort();
      const std::size_t first = probes.first[compared];
      compare(covered, std::span(probes.probe).subspan(first, probes.first[compared + 1] - first),
              error);
    }
  };
  RunStats unused;
  view.scene->draw(view.index, view.frame, config, unused, [&](const ShadedTriangle& triangle) {
    const std::uint64_t tag = triangle.triangle.tag;
    if (tag != owner) {
      compare_until(tag);
      covered.clear();
      owner = tag;
    }
    if (probes.measured[tag]) covered.add(triangle.triangle, view.frame);
  });
  compare_until(probes.measured.size());
}

// With what coverage does not depend on as wide as it gets.
Config measured_config(Config config) {
  config.guard_bits = 16;
  config.extent_bits = 0;
  config.tag_bits = 32;
  config.grid_log2 = 3;
  return config;
}

}  // namespace

CoverageMeter coverage_meter(const FitView& view, int samples, std::uint64_t budget) {
  const std::uint64_t stride = 1 + outline_pixels(view) / budget;
  const auto probes = std::make_shared<const Probes>(make_probes(view, stride, samples));
  return [view, probes](const Config& config) {
    CoverageError error;
    measure(view, *probes, measured_config(config), error);
    return error;
  };
}

CoverageCurve coverage_curve(const std::vector<FitView>& views, const Config& base,
                             std::uint64_t budget) {
  CoverageCurve curve;
  std::uint64_t pixels = 0;
  for (const FitView& view : views) pixels += outline_pixels(view);
  const std::uint64_t stride = 1 + pixels / budget;
  Progress progress("measuring coverage", views.size() * curve.error.size());
  for (const FitView& view : views) {
    const Probes probes = make_probes(view, stride, base.samples);
    curve.triangles += probes.count;
    curve.of += probes.measured.size();
    for (std::size_t s = 0; s < curve.error.size(); ++s) {
      Config config = base;
      config.subpixel_bits = static_cast<int>(s);
      measure(view, probes, measured_config(config), curve.error[s]);
      progress.advance();
    }
  }
  return curve;
}

}  // namespace halfspace
