// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdlib>

#include "fit.hpp"
#include "io/error.hpp"

namespace halfspace {
namespace {

constexpr int kMaxGuardBits = 16;
constexpr Config kWidest{.viewport_bits = 15, .guard_bits = kMaxGuardBits, .tag_bits = 32};

// Bits that an unsigned value takes.
int bits_of(std::uint64_t value) { return 64 - std::countl_zero(value); }

// Greatest |difference| along an edge, in x or in y.
std::int64_t edge_extent(const Triangle& triangle) {
  std::int64_t most = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point from = triangle.vertex[i];
    const Point to = triangle.vertex[(i + 1) % 3];
    most = std::max(
        {most, std::abs(std::int64_t{to.x} - from.x), std::abs(std::int64_t{to.y} - from.y)});
  }
  return most;
}

// Draws every view; false when a triangle is cut at, or lies beyond, a side of the range.
template <class Each>
bool draw_uncut(const std::vector<FitView>& views, const Config& config, Each&& each) {
  for (const FitView& view : views) {
    RunStats stats;
    try {
      view.scene->draw(view.index, view.frame, config, stats,
                       [&](const ShadedTriangle& triangle) { each(view, triangle.triangle); });
    } catch (const Error& error) {
      if (error.code() != ErrorCode::kTcovRange) throw;
      return false;
    }
    if (stats.geometry.beyond_sides != 0) return false;
  }
  return true;
}

}  // namespace

FrameState view_frame(const FitView& view, Cull cull) {
  FrameState frame = view.scene->frame(view.index, kWidest);
  frame.cull = cull;
  return frame;
}

std::vector<FitView> fit_views(std::shared_ptr<const Scene> scene, const std::string& path,
                               Cull cull) {
  std::vector<FitView> views;
  for (std::size_t i = 0; i < scene->frames(); ++i) {
    FitView view{.scene = scene, .index = i, .name = path, .place = path, .frame = {}};
    if (scene->case_id(i) >= 0)
      view.name += fmt::format(" case {}", scene->case_id(i));
    else if (scene->frames() > 1)
      view.name += fmt::format(" view {}", i);
    view.frame = view_frame(view, cull);
    views.push_back(view);
  }
  return views;
}

FitRanges fit_ranges(const std::vector<FitView>& views, const Config& base) {
  FitRanges out;
  std::uint64_t most_triangles = 1;
  int side = 1;
  for (const FitView& view : views) {
    side = std::max({side, view.frame.width, view.frame.height});
    most_triangles = std::max(most_triangles, view.scene->triangles(view.index));
    out.triangles += view.scene->triangles(view.index);
  }
  out.viewport_bits = std::max(3, bits_of(static_cast<std::uint64_t>(side - 1)));
  out.tag_bits = std::clamp(bits_of(most_triangles - 1), 1, 32);

  Config config = base;
  config.viewport_bits = out.viewport_bits;
  config.extent_bits = 0;
  config.tag_bits = 32;
  const auto see = [&out](const FitView& view, const Triangle& triangle) {
    const std::int64_t extent = edge_extent(triangle);
    if (extent < out.extent || (extent == out.extent && !out.widest.empty())) return;
    out.extent = extent;
    out.widest = fmt::format("{}, triangle {}", view.name, triangle.tag);
  };
  out.cut_anyway = true;
  for (int k = 0; k <= kMaxGuardBits && out.cut_anyway; k = k == 0 ? out.viewport_bits : k + 1) {
    config.guard_bits = k;
    out.guard_bits = k;
    out.extent = 0;
    out.widest.clear();
    out.cut_anyway = !draw_uncut(views, config, see);
  }
  if (out.cut_anyway) {  // the widths of `full`, which cuts in the same places
    out.guard_bits = std::max(kFull.guard_bits, out.viewport_bits);
    out.extent_bits = 0;
    return out;
  }
  // |difference| < 2^(x + s), and x at least 1.
  const int bits = bits_of(static_cast<std::uint64_t>(out.extent));
  out.extent_bits = std::max(1, bits - base.subpixel_bits);
  return out;
}

Config with_ranges(Config base, const FitRanges& ranges) {
  base.viewport_bits = ranges.viewport_bits;
  base.guard_bits = ranges.guard_bits;
  base.extent_bits = ranges.extent_bits;
  base.tag_bits = ranges.tag_bits;
  return base;
}

}  // namespace halfspace
