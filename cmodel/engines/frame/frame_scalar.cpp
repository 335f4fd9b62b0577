// SPDX-License-Identifier: Apache-2.0
//
// The frame engine's kernels for any machine, through the plain stages' own functions.
#include <cmath>

#include "../../fixed.hpp"
#include "../../interpolation.hpp"
#include "../../shading.hpp"
#include "../coverage/coverage_chunk.hpp"
#include "frame_kernel.hpp"
#include "frame_planes.hpp"

namespace halfspace::simd {
namespace {

// round_clamped() of geometry.cpp.
std::uint32_t rounded(double value, double maximum) {
  return value > 0.0 ? static_cast<std::uint32_t>(std::min(value, maximum) + 0.5) : 0u;
}

std::uint16_t outside_bits(const ProjectConstants& c, const glm::dvec4& p) {
  unsigned bits = 0;
  for (unsigned i = 0; i < kClipPlanes; ++i) {
    const ClipPlane& plane = c.volume[i];
    const double bound = plane.axis == 3 ? plane.limit : plane.limit * p.w;
    bits |= static_cast<unsigned>(plane.sign * (bound - p[plane.axis]) < 0.0) << i;
  }
  bits |= static_cast<unsigned>(p.x < -p.w) << 7 | static_cast<unsigned>(p.x > p.w) << 8;
  bits |= static_cast<unsigned>(p.y < -p.w) << 9 | static_cast<unsigned>(p.y > p.w) << 10;
  for (int axis = 0; axis < 4; ++axis) {
    if (!(std::abs(p[axis]) <= kMaxMagnitude)) bits |= kNotFinite;
  }
  return static_cast<std::uint16_t>(bits);
}

TilePlane plane_at(const FramePlane& plane, std::uint32_t word, const FrameConstants& c) {
  const auto g = static_cast<unsigned>(c.config.grid_log2);
  const std::uint64_t x = std::uint64_t{word & 0xffff} << g;
  const std::uint64_t y = std::uint64_t{word >> 16} << g;
  const std::uint64_t sum = plane.origin + plane.dx * x + plane.dy * y;
  return {static_cast<std::uint32_t>(sum >> c.gradient_bits), plane.lane_dx, plane.lane_dy};
}

// As Rasterizer: -1 is the pixel's centre.
int shading_sample(const std::uint64_t* covered, int lane, int samples) {
  int first = -1;
  bool all = true;
  for (int m = samples - 1; m >= 0; --m) {
    const bool here = (covered[m] >> lane & 1) != 0;
    if (here) first = m;
    all = all && here;
  }
  return all ? -1 : first;
}

}  // namespace

void project_scalar(const ProjectConstants& constants, const VertexSource& source,
                    std::size_t first, std::size_t count, VertexRecord* out) {
  Config config;
  config.snap = constants.snap;
  config.subpixel_bits = std::ilogb(constants.subpixels);
  for (std::size_t i = first; i < first + count; ++i) {
    const ClipVertex vertex = source.vertex(i);
    const glm::dvec4& p = vertex.position;
    VertexRecord& to = out[i];
    to = {};
    to.outside = outside_bits(constants, p);
    if ((to.outside & (kOutsidePlanes | kNotFinite)) != 0) continue;
    const std::int64_t x = snap((p.x / p.w + 1.0) * constants.half_width, config);
    const std::int64_t y = snap((1.0 - p.y / p.w) * constants.half_height, config);
    to.point = {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
    to.inverse_w = 1.0 / p.w;
    to.depth = static_cast<std::int32_t>(
        rounded((p.z / p.w + 1.0) * constants.depth_scale, 2.0 * constants.depth_scale));
    for (std::size_t n = 0; n < static_cast<std::size_t>(constants.colors); ++n) {
      constexpr double kUnit = 1 << kAttributeFractionBits;
      to.set_value(n,
                   static_cast<std::int32_t>(rounded(vertex.attribute[n] * kUnit, 255.0 * kUnit)));
    }
  }
}

std::uint32_t highest_scalar(const std::uint32_t* index, std::size_t count) {
  return count == 0 ? 0 : *std::max_element(index, index + count);
}

void planes_scalar(const FrameConstants& constants, const FrameTriangle* triangles,
                   std::size_t count, FramePlane* out) {
  for (std::size_t i = 0; i < count; ++i) out[i] = plain_depth_plane(triangles[i], constants);
}

void depth_scalar(const FrameConstants& constants, const FrameTiles& tiles,
                  const RecordOrder& order, FrameStore& store, PassedTiles& passed,
                  FrameCounts& counts) {
  const auto samples = static_cast<std::size_t>(constants.samples);
  const auto lanes = static_cast<std::size_t>(constants.config.lanes());
  const std::uint64_t all = lanes == 64 ? ~std::uint64_t{0} : 0xffff;
  for (std::size_t k = 0; k < order.count; ++k) {
    const std::size_t record = order.at(k);
    const RecordPlace place{tiles.place[record]};
    const std::uint64_t length = place.is_run() ? tiles.mask[0][record] : 1;
    passed.reserve(length, samples);
    for (std::uint32_t i = 0; i < length; ++i) {
      const std::uint32_t word = (place.word & ~kRunFlag) + i;
      const std::uint32_t triangle = tiles.triangle[record];
      const TilePlane plane = plane_at(tiles.depth[triangle], word, constants);
      const std::uint64_t open = open_lanes(constants, word);
      std::uint32_t* stored = nullptr;  // a tile that the scissor covers is not touched
      std::uint64_t any = 0;
      std::uint64_t any_covered = 0;
      for (std::size_t m = 0; m < samples; ++m) {
        const std::uint64_t covered = place.is_run() ? all : tiles.mask[m][record];
        TilePlane at = plane;
        if (samples > 1) at.base += tiles.depth_delta[triangle * samples + m];
        any_covered |= covered;
        counts.samples += static_cast<std::uint64_t>(std::popcount(covered));
        if (samples > 1) {
          passed.covered[passed.count * samples + m] = covered;
          passed.passed[passed.count * samples + m] = 0;
        }
        if ((covered & open) == 0) continue;
        if (stored == nullptr) stored = store.tile(word & 0xffff, word >> 16);
        DepthTile depth{};
        std::copy_n(stored + m * lanes, lanes, depth.begin());
        const GridMask won =
            depth_test(covered & open, at, constants.depth_function, depth, constants.config);
        std::copy_n(depth.begin(), lanes, stored + m * lanes);
        if (samples > 1) passed.passed[passed.count * samples + m] = won;
        any |= won;
      }
      ++counts.tiles;
      counts.fragments += static_cast<std::uint64_t>(std::popcount(any_covered));
      counts.shaded += static_cast<std::uint64_t>(std::popcount(any));
      passed.tile[passed.count] = {word, triangle, any};
      passed.count += any != 0;
    }
  }
}

void shade_scalar(const FrameConstants& constants, const FrameTriangle* triangles,
                  FrameStore& store, PassedTiles& passed) {
  const auto samples = static_cast<std::size_t>(constants.samples);
  const auto lanes = static_cast<std::size_t>(constants.config.lanes());
  const int grid = constants.config.grid();
  const FrameStore::Tiles memory = store.tiles();
  ShadePlanes planes;
  std::uint32_t ready = ~0u;
  for (std::size_t k = 0; k < passed.count; ++k) {
    const PassedTile& tile = passed.tile[k];
    if (tile.triangle != ready) {
      ready = tile.triangle;
      planes = plain_shade_planes(triangles[ready], constants);
    }
    const std::uint32_t column = tile.place & 0xffff, row = tile.place >> 16;
    std::uint32_t* const pixels = memory.pixels(column, row);
    std::uint32_t* const stored = memory.at(column, row) + samples * lanes;  // samples > 1
    for (std::uint64_t rest = tile.passed; rest != 0; rest &= rest - 1) {
      const int lane = std::countr_zero(rest);
      const int sample =
          samples == 1 ? -1 : shading_sample(&passed.covered[k * samples], lane, constants.samples);
      const auto at = [&](std::size_t n) {
        const FramePlane plane{planes.origin[n], planes.dx[n], planes.dy[n],
                               static_cast<std::uint32_t>(planes.lane_dx[n]),
                               static_cast<std::uint32_t>(planes.lane_dy[n])};
        TilePlane moved = plane_at(plane, tile.place, constants);
        if (sample >= 0) moved.base += frame_delta(plane.dx, plane.dy, sample, constants);
        return moved.at(lane & (grid - 1), lane >> constants.config.grid_log2);
      };
      std::uint32_t color = 0xff000000u;
      for (std::size_t n = 0; n < 3; ++n) {
        const auto level = static_cast<std::uint8_t>(planes.level >> (8 * n));
        color |= std::uint32_t{perspective(at(n), at(3), level, constants.config)} << (8 * n);
      }
      if (samples == 1) {
        const int x = lane & (grid - 1), y = lane >> constants.config.grid_log2;
        pixels[static_cast<std::size_t>(y) * memory.stride + static_cast<std::size_t>(x)] = color;
        continue;
      }
      for (std::size_t m = 0; m < samples; ++m) {
        const std::uint64_t mask = passed.passed[k * samples + m];
        if ((mask >> lane & 1) != 0) stored[m * lanes + static_cast<std::size_t>(lane)] = color;
      }
    }
  }
}

void shade_planes_scalar(const FrameConstants& constants, const FrameTriangle* triangles,
                         std::size_t count, ShadePlanes* out) {
  for (std::size_t i = 0; i < count; ++i) out[i] = plain_shade_planes(triangles[i], constants);
}

void divide_scalar(const FrameConstants& constants, Division* divisions, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    Division& d = divisions[i];
    const auto u = static_cast<std::uint32_t>(std::max(d.inverse_w, 1));
    const std::uint32_t top = u << std::countl_zero(u);
    d.reciprocal = reciprocal(top >> (32 - constants.config.reciprocal_bits), constants.config);
    d.value = perspective(d.attribute, d.inverse_w, 0, constants.config);
  }
}

}  // namespace halfspace::simd
