// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "fit.hpp"
#include "interpolation.hpp"
#include "rasterizer.hpp"
#include "samples.hpp"
#include "scene/progress.hpp"
#include "shading.hpp"

namespace halfspace {
namespace {

constexpr int kMostInverseW = 30, kMostGradient = 20, kMostReciprocal = 16;

// One triangle whose attributes are measured, with some of its tiles.
struct Measured {
  std::size_t view = 0;
  RealTriangle real;
  Triangle snapped;
  SetupTriangle setup;
  std::vector<CoverageTile> tiles;
};

using VertexSet = std::array<VertexAttributes, 3>;

std::uint64_t fragments_of(const CoverageTile& tile) {
  return static_cast<std::uint64_t>(std::popcount(tile.mask[0]));
}

// Triangles of all views, evenly chosen so that about `budget` fragments are measured.
class Sample {
 public:
  Sample(const std::vector<FitView>& views, const Config& config, std::uint64_t budget)
      : views_(views), config_(config) {
    for (std::size_t v = 0; v < views.size(); ++v) collect(v);
    std::uint64_t all = 0;
    for (const Measured& m : measured_) {
      for (const CoverageTile& tile : m.tiles) all += fragments_of(tile);
    }
    const std::uint64_t stride = 1 + all / budget;
    std::uint64_t number = 0;
    for (Measured& m : measured_) {
      std::erase_if(m.tiles, [&](const CoverageTile&) { return number++ % stride != 0; });
    }
    std::erase_if(measured_, [](const Measured& m) { return m.tiles.empty(); });
    for (const Measured& m : measured_) {
      for (const CoverageTile& tile : m.tiles) fragments_ += fragments_of(tile);
    }
  }

  std::uint64_t fragments() const { return fragments_; }

  // The attributes of measured triangles as geometry packs them for `bits` of 1/w.
  std::vector<VertexSet> pack(int bits) const {
    Config config = config_;
    config.inverse_w_bits = bits;
    config.tag_bits = 32;
    std::vector<VertexSet> out(measured_.size());
    std::size_t next = 0;
    for (std::size_t v = 0; v < views_.size(); ++v) {
      RunStats unused;
      views_[v].scene->draw(views_[v].index, views_[v].frame, config, unused,
                            [&](const ShadedTriangle& triangle) {
                              if (next == measured_.size() || measured_[next].view != v) return;
                              if (measured_[next].real.index == triangle.triangle.tag) {
                                out[next++] = triangle.attributes;
                              }
                            });
    }
    return out;
  }

  double worst(const std::vector<VertexSet>& attributes, const Config& config) const {
    double error = 0;
    for (std::size_t i = 0; i < measured_.size(); ++i) {
      error = std::max(error, worst_of(measured_[i], attributes[i], config));
    }
    return error;
  }

 private:
  void collect(std::size_t v);
  static double worst_of(const Measured& m, const VertexSet& attributes, const Config& config);

  const std::vector<FitView>& views_;
  Config config_;
  std::vector<Measured> measured_;
  std::uint64_t fragments_ = 0;
};

void Sample::collect(std::size_t v) {
  const FitView& view = views_[v];
  std::vector<RealTriangle> real;
  view.scene->real(view.index, [&](const RealTriangle& triangle) {
    if (triangle.whole) real.push_back(triangle);
  });
  Config config = config_;
  config.tag_bits = 32;
  std::size_t next = 0;
  RunStats unused;
  view.scene->draw(view.index, view.frame, config, unused, [&](const ShadedTriangle& triangle) {
    while (next < real.size() && real[next].index < triangle.triangle.tag) ++next;
    if (next == real.size() || real[next].index != triangle.triangle.tag) return;
    Measured m{v, real[next], triangle.triangle, {}, {}};
    RasterStats counts;
    rasterize(
        triangle.triangle, view.frame, config, counts,
        [&](const SetupTriangle& setup) { m.setup = setup; }, [](const Node&, int, bool) {},
        [&](const CoverageTile& tile) { m.tiles.push_back(tile); });
    if (!m.tiles.empty()) measured_.push_back(std::move(m));
  });
}

// Perspective interpolation between the snapped vertices, in double precision.
class Truth {
 public:
  explicit Truth(const Measured& m, const Config& config) : m_(m) {
    for (std::size_t i = 0; i < 3; ++i) {
      x_[i] = std::ldexp(m.snapped.vertex[i].x, -config.subpixel_bits);
      y_[i] = std::ldexp(m.snapped.vertex[i].y, -config.subpixel_bits);
    }
    area_ = cross(1, 2, x_[0], y_[0]);
  }
  // At a position in px, attribute n, 0..255.
  double at(double x, double y, std::size_t n) const {
    const std::array<double, 3> part{cross(1, 2, x, y) / area_, cross(2, 0, x, y) / area_,
                                     cross(0, 1, x, y) / area_};
    double over_w = 0, one_over_w = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const RealVertex& vertex = m_.real.vertex[i];
      const double weight = part[i] * vertex.inverse_w;
      over_w += weight * std::clamp(vertex.attribute[n], 0.0, 255.0);
      one_over_w += weight;
    }
    return over_w / one_over_w;
  }

 private:
  double cross(std::size_t i, std::size_t j, double x, double y) const {
    return (x_[i] - x) * (y_[j] - y) - (x_[j] - x) * (y_[i] - y);
  }
  const Measured& m_;
  std::array<double, 3> x_, y_;
  double area_;
};

double Sample::worst_of(const Measured& m, const VertexSet& attributes, const Config& config) {
  const InterpolationSetup planes =
      interpolation_setup(m.setup, m.snapped, attributes, config.attributes, config);
  const Truth truth(m, config);
  const SamplePosition offset = sample_positions(config.samples)[0];
  const auto value = [&](const Plane& plane, const CoverageTile& tile, int i, int j) {
    const TilePlane at = tile_plane(plane, planes.origin, tile.x, tile.y, config);
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(at.at(i, j)) +
                                     sample_delta(plane, 0, config));
  };
  double worst = 0;
  for (const CoverageTile& tile : m.tiles) {
    for (GridMask rest = tile.mask[0]; rest != 0; rest &= rest - 1) {
      const int lane = std::countr_zero(rest);
      const int i = lane & (config.grid() - 1);
      const int j = lane >> config.grid_log2;
      const std::int32_t inverse_w = value(planes.inverse_w, tile, i, j);
      for (std::size_t n = 0; n < static_cast<std::size_t>(config.attributes); ++n) {
        const int got =
            perspective(value(planes.attribute[n], tile, i, j), inverse_w, planes.level[n], config);
        const double real = truth.at(tile.x + i + offset.x / 16.0, tile.y + j + offset.y / 16.0, n);
        worst = std::max(worst, std::abs(got - real));
      }
    }
  }
  return worst;
}

Config at_most(Config config) {
  config.inverse_w_bits = kMostInverseW;
  config.gradient_bits = kMostGradient;
  config.reciprocal_bits = kMostReciprocal;
  return config;
}

}  // namespace

AttributeCurves attribute_curves(const std::vector<FitView>& views, const Config& base,
                                 std::uint64_t budget) {
  const Sample sample(views, base, budget);
  AttributeCurves out;
  out.fragments = sample.fragments();
  Progress progress("measuring attributes", 51);
  for (int bits = 12; bits <= kMostInverseW; ++bits) {
    Config config = at_most(base);
    config.inverse_w_bits = bits;
    out.inverse_w.push_back({bits, sample.worst(sample.pack(bits), config)});
    progress.advance();
  }
  const std::vector<VertexSet> attributes = sample.pack(kMostInverseW);
  for (int bits = 0; bits <= kMostGradient; ++bits) {
    Config config = at_most(base);
    config.gradient_bits = bits;
    out.gradient.push_back({bits, sample.worst(attributes, config)});
    progress.advance();
  }
  for (int bits = 6; bits <= kMostReciprocal; ++bits) {
    Config config = at_most(base);
    config.reciprocal_bits = bits;
    out.reciprocal.push_back({bits, sample.worst(attributes, config)});
    progress.advance();
  }
  return out;
}

double attribute_error(const std::vector<FitView>& views, const Config& config,
                       std::uint64_t budget) {
  const Sample sample(views, config, budget);
  return sample.worst(sample.pack(config.inverse_w_bits), config);
}

}  // namespace halfspace
