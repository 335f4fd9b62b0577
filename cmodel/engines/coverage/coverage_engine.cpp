// SPDX-License-Identifier: Apache-2.0
#include "coverage_engine.hpp"

#include <bit>

#include "../../fixed.hpp"
#include "../../samples.hpp"
#include "../common/isas.hpp"

namespace halfspace {
namespace {

simd::KernelFrame kernel_frame(const FrameState& frame, const Config& config) {
  HS_CHECK(validate(config).empty());
  HS_CHECK(double_is_exact(config));
  HS_CHECK(frame.width >= 1 && frame.width <= config.max_size());
  HS_CHECK(frame.height >= 1 && frame.height <= config.max_size());
  simd::KernelFrame out;
  out.config = config;
  out.config.grid_log2 = 3;  // kernels know 8x8 tiles only
  out.state = frame;
  out.f = config.position_bits();
  out.up = out.f - config.subpixel_bits;
  out.samples = config.samples;
  out.width = frame.width;
  out.height = frame.height;
  out.cull = frame.cull;
  out.window_extent = float_extent(config) << out.f;
  out.coordinate_min = static_cast<std::int32_t>(config.coordinate_min());
  out.coordinate_max = static_cast<std::int32_t>(config.coordinate_max());
  const auto position = [&out](int sixteenths) { return (sixteenths << out.f) >> 4; };
  const auto positions = sample_positions(config.samples);
  for (std::size_t m = 0; m < positions.size(); ++m) {
    out.u[m] = position(positions[m].x);
    out.v[m] = position(positions[m].y);
  }
  const SampleExtent extent = sample_extent(config.samples);
  out.u_low = position(extent.low.x);
  out.u_high = position(extent.high.x);
  out.v_low = position(extent.low.y);
  out.v_high = position(extent.high.y);
  return out;
}

// Quarter (i, j) of an 8x8 mask as a 4x4 mask.
std::uint64_t quarter(std::uint64_t mask, unsigned i, unsigned j) {
  mask >>= 32 * j + 4 * i;
  return (mask & 0xf) | (mask >> 4 & 0xf0) | (mask >> 8 & 0xf00) | (mask >> 12 & 0xf000);
}

// Bits of an 8x8 or 4x4 tile.
std::uint64_t lanes(int grid_log2) { return std::uint64_t{1} << (2 * grid_log2); }

}  // namespace

std::vector<std::string_view> coverage_isas() { return simd::isas(simd::coverage_kernels()); }

CoverageEngine::CoverageEngine(const FrameState& frame, const Config& config, std::string_view isa)
    : config_(config),
      frame_(kernel_frame(frame, config)),
      kernel_(simd::find_isa(simd::coverage_kernels(), isa)),
      buffer_(config.samples),
      small_(config.samples) {}

std::size_t CoverageEngine::fill(std::span<const Triangle> triangles, std::size_t first,
                                 std::size_t enough) {
  buffer_.clear();
  const std::size_t done =
      kernel_.cover(frame_, triangles.subspan(first), static_cast<std::uint32_t>(first), enough,
                    buffer_, counts_);
  if (config_.grid_log2 == 2) split_tiles();
  return done;
}

CoverageChunk CoverageEngine::chunk() const {
  return (config_.grid_log2 == 2 ? small_ : buffer_).chunk(config_.grid_log2);
}

void CoverageEngine::split_tiles() {
  const auto samples = static_cast<std::size_t>(config_.samples);
  small_.clear();
  small_.reserve(4 * buffer_.count);
  small_.reserve_triangles(buffer_.triangle_count);
  std::size_t from = 0;
  for (std::size_t t = 0; t < buffer_.triangle_count; ++t) {
    for (; from < buffer_.end[t]; ++from) {
      const RecordPlace place{buffer_.place[from]};
      const std::uint32_t corner = (place.tile_y() << 16 | place.tile_x()) << 1;
      for (unsigned part = 0; part < (place.is_run() ? 2u : 4u); ++part) {
        const std::size_t to = small_.count;
        std::uint64_t any = 0;
        if (place.is_run()) {
          small_.place[to] = kRunFlag | (corner + (part << 16));
          small_.mask(0)[to] = any = 2 * buffer_.mask(0)[from];
        } else {
          small_.place[to] = corner + ((part >> 1) << 16) + (part & 1);
          for (std::size_t m = 0; m < samples; ++m) {
            any |= small_.mask(m)[to] = quarter(buffer_.mask(m)[from], part & 1, part >> 1);
          }
        }
        small_.count += any != 0;
      }
    }
    small_.triangle[t] = buffer_.triangle[t];
    small_.end[t] = static_cast<std::uint32_t>(small_.count);
  }
  small_.triangle_count = buffer_.triangle_count;
}

void count_records(const CoverageChunk& chunk, RasterStats& stats) {
  const auto samples = static_cast<std::size_t>(chunk.samples);
  for (std::size_t r = 0; r < chunk.records(); ++r) {
    if (RecordPlace{chunk.place[r]}.is_run()) {
      const std::uint64_t length = chunk.plane[0][r];
      stats.tiles_covered += length;
      stats.fragments += length * lanes(chunk.grid_log2);
      stats.samples_covered += length * lanes(chunk.grid_log2) * samples;
      continue;
    }
    ++stats.tiles_covered;
    std::uint64_t any = 0;
    for (std::size_t m = 0; m < samples; ++m) {
      any |= chunk.plane[m][r];
      stats.samples_covered += static_cast<std::uint64_t>(std::popcount(chunk.plane[m][r]));
    }
    stats.fragments += static_cast<std::uint64_t>(std::popcount(any));
  }
}

void count_triangles(const simd::KernelCounts& counts, RasterStats& stats) {
  stats.triangles += counts.triangles;
  stats.triangles_zero_area += counts.zero_area;
  stats.triangles_culled += counts.culled;
  stats.triangles_no_sample += counts.no_sample;
}

}  // namespace halfspace
