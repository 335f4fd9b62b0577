// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <stdexcept>

#include "cycle_model.hpp"
#include "engines/coverage/coverage_engine.hpp"
#include "engines/cycle/cycle_engine.hpp"
#include "engines/frame/frame_engine.hpp"
#include "interpolation_bound.hpp"
#include "io/error.hpp"
#include "rasterizer.hpp"
#include "rtl/cosim.hpp"
#include "soak.hpp"
#ifdef HALFSPACE_HAS_ORACLE
#include <cmath>

#include "oracle/oracle.hpp"
#endif

namespace halfspace {
namespace {

using Triangles = std::span<const ShadedTriangle>;
using Tiles = std::vector<CoverageTile>;

std::vector<Triangle> positions(Triangles shaded) {
  std::vector<Triangle> out;
  for (const ShadedTriangle& one : shaded) out.push_back(one.triangle);
  return out;
}

void in_raster_order(Tiles& tiles) {
  std::sort(tiles.begin(), tiles.end(), [](const CoverageTile& a, const CoverageTile& b) {
    return a.y != b.y ? a.y < b.y : a.x < b.x;
  });
}

Tiles stages(const Triangle& triangle, const SoakPoint& point) {
  Tiles out;
  RasterStats unused;
  rasterize(triangle, point.frame, point.config, unused,
            [&](const CoverageTile& tile) { out.push_back(tile); });
  in_raster_order(out);
  return out;
}

std::string check_engines(Triangles shaded, const SoakPoint& point) {
  const std::vector<Triangle> triangles = positions(shaded);
  std::vector<Tiles> want;
  for (const Triangle& triangle : triangles) want.push_back(stages(triangle, point));
  for (const std::string_view isa : coverage_isas()) {
    std::vector<Tiles> got(triangles.size());
    CoverageEngine engine(point.frame, point.config, isa);
    engine.cover(triangles, [&](const CoverageChunk& chunk) {
      for (std::size_t i = 0; i < chunk.triangle.size(); ++i) {
        const std::size_t t = chunk.triangle[i];
        for_each_tile(chunk, i, triangles[t].tag,
                      [&](const CoverageTile& tile) { got[t].push_back(tile); });
        in_raster_order(got[t]);
      }
    });
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      if (got[t] != want[t]) {
        return fmt::format("{} covers {} tiles of triangle {} unlike the stages' {}", isa,
                           got[t].size(), t, want[t].size());
      }
    }
  }
  return {};
}

// In both, the depth buffer of one triangle is that of the next.
std::string check_frame(Triangles shaded, const SoakPoint& point) {
  const Rgb background{9, 80, 200};
  Rasterizer plain(point.frame, point.config, DepthFunction::kLess, background);
  for (const ShadedTriangle& one : shaded) plain.draw(one);
  const Image want = plain.framebuffer().resolve();
  for (const std::string_view isa : coverage_isas()) {
    FrameOptions options;
    options.background = background;
    options.isa = isa;
    options.count_hits = true;
    FrameEngine fast(point.frame, point.config, options);
    fast.draw(shaded);
    if (fast.hits() != plain.hit_count().count()) return fmt::format("{} hits otherwise", isa);
    const Image got = fast.framebuffer().resolve();
    for (std::size_t i = 0; i < want.pixel.size(); ++i) {
      if (got.pixel[i] == want.pixel[i]) continue;
      const auto width = static_cast<std::size_t>(point.frame.width);
      return fmt::format("{} draws pixel ({}, {}) in another colour than the stages", isa,
                         i % width, i / width);
    }
  }
  return {};
}

// Every tile with its clock.
struct Clocked {
  static constexpr bool kWantsSetup = false;
  static constexpr bool kWantsNodes = false;
  std::vector<std::pair<std::uint64_t, CoverageTile>> tiles;
  std::vector<std::uint64_t> accepts;
  void accepted(Timing::Clock clock) { accepts.push_back(static_cast<std::uint64_t>(clock)); }
  void setup(Timing::Clock, const SetupTriangle&) const {}
  void node(int, Timing::Clock, const Node&) const {}
  void tile(Timing::Clock clock, const CoverageTile& tile) {
    tiles.emplace_back(static_cast<std::uint64_t>(clock), tile);
  }
  bool operator==(const Clocked&) const = default;
};

std::string check_cycle(Triangles shaded, const SoakPoint& point) {
  const std::vector<Triangle> triangles = positions(shaded);
  const Stalls stalls(point.stall, point.seed);
  Clocked want;
  CycleModel model(point.frame, point.config, stalls);
  for (const Triangle& triangle : triangles) model.draw(triangle, want);
  for (const std::string_view isa : cycle_isas()) {
    Clocked got;
    CycleEngine engine(point.frame, point.config, stalls, isa);
    engine.draw(triangles, got);
    if (engine.clocks() != model.clocks() || !(got == want)) {
      return fmt::format("{} takes {} clocks and {} tiles, the model {} and {}, or others", isa,
                         engine.clocks(), got.tiles.size(), model.clocks(), want.tiles.size());
    }
  }
  return {};
}

#ifdef HALFSPACE_HAS_ORACLE
// The samples of each pixel of the frame, row by row.
std::vector<std::uint32_t> pixel_masks(const Tiles& tiles, const SoakPoint& point) {
  const Config& config = point.config;
  std::vector<std::uint32_t> out(static_cast<std::size_t>(point.frame.width * point.frame.height));
  for (const CoverageTile& tile : tiles) {
    for (int lane = 0; lane < config.lanes(); ++lane) {
      const int x = tile.x + (lane & (config.grid() - 1));
      const int y = tile.y + (lane >> config.grid_log2);
      for (int m = 0; m < config.samples; ++m) {
        if ((tile.mask[static_cast<std::size_t>(m)] >> lane & 1) == 0) continue;
        if (x >= point.frame.width || y >= point.frame.height) return {};
        out[static_cast<std::size_t>(y * point.frame.width + x)] |= 1u << m;
      }
    }
  }
  return out;
}

std::string check_oracle(Triangles shaded, const SoakPoint& point) {
  const auto samples = oracle::standard_samples(point.config.samples);
  for (std::size_t t = 0; t < shaded.size(); ++t) {
    oracle::Corners corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point p = shaded[t].triangle.vertex[i];
      corners[i] = {std::ldexp(p.x, -point.config.subpixel_bits),
                    std::ldexp(p.y, -point.config.subpixel_bits)};
    }
    const std::vector<std::uint32_t> masks = pixel_masks(stages(shaded[t].triangle, point), point);
    if (masks.empty()) return fmt::format("triangle {} covers a sample outside the frame", t);
    std::size_t at = 0;
    for (int y = 0; y < point.frame.height; ++y) {
      for (int x = 0; x < point.frame.width; ++x, ++at) {
        const std::uint32_t want = oracle::pixel_mask(corners, x, y, samples);
        if (masks[at] != want) {
          return fmt::format("pixel ({}, {}) of triangle {}: stages {:#x}, oracle {:#x}", x, y, t,
                             masks[at], want);
        }
      }
    }
  }
  return {};
}
#endif

std::string check_interpolation(Triangles shaded, const SoakPoint& point) {
  for (std::size_t t = 0; t < shaded.size(); ++t) {
    const std::string text = interpolation_fault(shaded[t], point.frame, point.config);
    if (!text.empty()) return fmt::format("triangle {}: {}", t, text);
  }
  return {};
}

std::string check_rtl(Triangles shaded, const SoakPoint& point) {
  static std::unique_ptr<RtlRasterizer> rtl;  // the last configuration's
  if (!rtl || rtl->config() != point.config) {
    rtl.reset();
    rtl = std::make_unique<RtlRasterizer>(point.config, false, "rtl");
  }
  const CosimOptions options{
      .stalls = Stalls(point.stall, point.seed), .trace = {}, .progress = {}};
  try {
    const CosimResult result = cosim(*rtl, positions(shaded), point.frame, point.config, options);
    return result.mismatch ? result.mismatch->line() : std::string();
  } catch (const Error&) {
    throw;
  } catch (const std::runtime_error& error) {  // an assertion of the RTL
    rtl.reset();
    return error.what();
  }
}

}  // namespace

const std::vector<SoakCheck>& soak_checks() {
  static const std::vector<SoakCheck> all{
      {"engines", check_engines},
      {"frame", check_frame},
      {"cycle", check_cycle},
#ifdef HALFSPACE_HAS_ORACLE
      {"oracle", check_oracle},
#endif
      {"interpolation", check_interpolation},
      {"rtl", check_rtl},
  };
  return all;
}

}  // namespace halfspace
