// SPDX-License-Identifier: Apache-2.0
//
// Triangle setup, 64 triangles at a time, in plain loops that the compiler vectorizes for the
// instruction set it is in. docs/03_design/cycle_engine.md has what differs from triangle_setup().
#if defined(HALFSPACE_CYCLE_SETUP_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HALFSPACE_CYCLE_SETUP_INL
#undef HALFSPACE_CYCLE_SETUP_INL
#else
#define HALFSPACE_CYCLE_SETUP_INL
#endif

#include <hwy/highway.h>

#include "../../fixed.hpp"
#include "../../samples.hpp"
#include "../../triangle_setup.hpp"
#include "cycle_kernel.hpp"

HWY_BEFORE_NAMESPACE();
namespace halfspace::cycle::HWY_NAMESPACE {

inline constexpr std::size_t kBatch = CycleBuffer::kBatch;

// One lane per triangle. Positions in 2^-f px.
struct alignas(64) Batch {
  std::int32_t x[3][kBatch], y[3][kBatch];
  std::int32_t a[3][kBatch], b[3][kBatch];  // oriented slopes
  std::int64_t e[3][kBatch];                // at the start node's origin, biased, saturated
  std::int32_t x_first[kBatch], y_first[kBatch], x_last[kBatch], y_last[kBatch];
  std::int32_t x_node[kBatch], y_node[kBatch];  // the start node
  std::int32_t level[kBatch];
  std::int32_t outcome[kBatch];  // SetupOutcome
  std::int32_t flip[kBatch];     // all ones: slopes are negated
  std::int64_t area[kBatch];     // its sign
};

// What setup needs of a configuration.
struct SetupConstants {
  SetupConstants(const State& state)
      : config(state.config), frame(state.frame), from_root(state.want_nodes) {
    const SampleExtent extent = sample_extent(config.samples);
    f = config.position_bits();
    x_low = extent.low.x << f >> 4;
    y_low = extent.low.y << f >> 4;
    x_high = extent.high.x << f >> 4;
    y_high = extent.high.y << f >> 4;
    HS_CHECK(frame.width >= 1 && frame.width <= config.max_size());
    HS_CHECK(frame.height >= 1 && frame.height <= config.max_size());
  }
  Config config;
  FrameState frame;
  bool from_root;  // start at level 0 always
  int f;
  std::int32_t x_low, y_low, x_high, y_high;  // extremes of the samples in a pixel
};

// Vertices of t[0 .. count - 1] in lanes; lanes up to a multiple of 16 repeat the last.
HWY_NOINLINE void load(const SetupConstants& c, const Triangle* t, std::size_t count, Batch& o) {
  const int up = c.f - c.config.subpixel_bits;
  std::int32_t low = 0, high = 0;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Point p = t[i].vertex[k];
      low = std::min(low, std::min(p.x, p.y));
      high = std::max(high, std::max(p.x, p.y));
      o.x[k][i] = p.x << up;
      o.y[k][i] = p.y << up;
    }
  }
  HS_CHECK(low >= c.config.coordinate_min() && high <= c.config.coordinate_max());
  if (c.config.extent_bits != 0) {
    for (std::size_t i = 0; i < count; ++i) HS_CHECK(within_extent(t[i], c.config));
  }
  for (std::size_t i = count; i < (count + 15) / 16 * 16; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      o.x[k][i] = o.x[k][count - 1];
      o.y[k][i] = o.y[k][count - 1];
    }
  }
}

// By value: std::min and std::max return references, which keeps loops from being vectorized.
HWY_INLINE std::int32_t least(std::int32_t a, std::int32_t b) { return a < b ? a : b; }
HWY_INLINE std::int32_t most(std::int32_t a, std::int32_t b) { return a > b ? a : b; }

// Sample box, and the deepest node that surely is the only one alive on its level.
HWY_NOINLINE void boxes(const SetupConstants& c, std::size_t lanes, Batch& o) {
  const int f = c.f, leaf = c.config.levels() - 1, side_log2 = c.config.node_log2(0);
  const std::int32_t up = (1 << f) - 1, w = c.frame.width - 1, h = c.frame.height - 1;
  const std::int32_t x_low = c.x_low, y_low = c.y_low, x_high = c.x_high, y_high = c.y_high;
  const std::int32_t from_root = c.from_root ? -1 : 0;
  for (std::size_t i = 0; i < lanes; ++i) {
    const std::int32_t x_min = least(least(o.x[0][i], o.x[1][i]), o.x[2][i]);
    const std::int32_t x_max = most(most(o.x[0][i], o.x[1][i]), o.x[2][i]);
    const std::int32_t y_min = least(least(o.y[0][i], o.y[1][i]), o.y[2][i]);
    const std::int32_t y_max = most(most(o.y[0][i], o.y[1][i]), o.y[2][i]);
    o.x_first[i] = most((x_min - x_high + up) >> f, 0);
    o.y_first[i] = most((y_min - y_high + up) >> f, 0);
    o.x_last[i] = least(((x_max - x_low + up) >> f) - 1, w);
    o.y_last[i] = least(((y_max - y_low + up) >> f) - 1, h);
    // Pixels whose samples enclose all vertices.
    const std::int32_t x0 = (x_min - x_low) >> f, x1 = (x_max - x_high + up) >> f;
    const std::int32_t y0 = (y_min - y_low) >> f, y1 = (y_max - y_high + up) >> f;
    // Bits in which they differ; all when they are not all in the root.
    const std::int32_t all = x0 | x1 | y0 | y1;
    const std::int32_t differ =
        ((x0 ^ x1) | (y0 ^ y1) | from_root | -((all >> side_log2) != 0)) & 0x7fffffff;
    const std::int32_t up_levels =
        (differ >= 8) + (differ >= 64) + (differ >= 512) + (differ >= 4096);
    const std::int32_t level = most(leaf - up_levels, 0);
    const std::int32_t z = 3 * (leaf + 1 - level);
    const std::int32_t keep = level == 0 ? 0 : static_cast<std::int32_t>(~0u << z);
    o.level[i] = level;
    o.x_node[i] = x0 & keep;
    o.y_node[i] = y0 & keep;
  }
}

// Winding, and why a triangle is dropped.
HWY_NOINLINE void outcomes(const SetupConstants& c, std::size_t lanes, Batch& o) {
  for (std::size_t i = 0; i < lanes; ++i) {
    const std::int64_t dx1 = o.x[1][i] - o.x[0][i], dy1 = o.y[1][i] - o.y[0][i];
    const std::int64_t dx2 = o.x[2][i] - o.x[0][i], dy2 = o.y[2][i] - o.y[0][i];
    o.area[i] = dx1 * dy2 - dy1 * dx2;
  }
  const bool cull_flipped = c.frame.cull == Cull::kFront;
  const bool cull_other = c.frame.cull == Cull::kBack;
  for (std::size_t i = 0; i < lanes; ++i) {
    const bool flipped = o.area[i] < 0;
    const bool culled = (flipped & cull_flipped) | (!flipped & cull_other);
    const bool empty = (o.x_first[i] > o.x_last[i]) | (o.y_first[i] > o.y_last[i]);
    const std::int32_t why = culled  ? static_cast<int>(SetupOutcome::kCulled)
                             : empty ? static_cast<int>(SetupOutcome::kNoSample)
                                     : static_cast<int>(SetupOutcome::kDrawn);
    o.outcome[i] = o.area[i] == 0 ? static_cast<int>(SetupOutcome::kZeroArea) : why;
    o.flip[i] = flipped ? -1 : 0;
  }
}

// Edge values at the start node's origin. Only the root's can be too great for a node's width.
HWY_NOINLINE void edges(const SetupConstants& c, std::size_t lanes, Batch& o) {
  const int f = c.f, up = f - c.config.subpixel_bits, dropped = c.config.dropped_bits();
  const std::int64_t limit = std::int64_t{1} << (c.config.node_bits(c.config.node_log2(0)) - 1);
  const std::int32_t centre = c.config.samples == 1 ? 1 << (f - 1) : 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int32_t* const x0 = o.x[k];
    const std::int32_t* const y0 = o.y[k];
    const std::int32_t* const x1 = o.x[(k + 1) % 3];
    const std::int32_t* const y1 = o.y[(k + 1) % 3];
    std::int32_t* HWY_RESTRICT const out_a = o.a[k];
    std::int32_t* HWY_RESTRICT const out_b = o.b[k];
    std::int64_t* HWY_RESTRICT const out_e = o.e[k];
    for (std::size_t i = 0; i < lanes; ++i) {
      const std::int32_t flip = o.flip[i];
      const std::int32_t a = (((y0[i] - y1[i]) >> up) ^ flip) - flip;
      const std::int32_t b = (((x1[i] - x0[i]) >> up) ^ flip) - flip;
      out_a[i] = a;
      out_b[i] = b;
    }
    for (std::size_t i = 0; i < lanes; ++i) {
      const std::int64_t a = out_a[i], b = out_b[i];
      const std::int32_t dx = (o.x_node[i] << f) + centre - x0[i];
      const std::int32_t dy = (o.y_node[i] << f) + centre - y0[i];
      // -1 unless top-left: a > 0, or a = 0 and b > 0.
      const std::int64_t bias = a > 0 ? 0 : (a < 0 ? -1 : (b > 0 ? 0 : -1));
      const std::int64_t at = (a * dx + b * dy + bias) >> dropped;
      const std::int64_t low = at < -limit ? -limit : at;
      out_e[i] = low > limit - 1 ? limit - 1 : low;
    }
  }
}

HWY_INLINE void set_up(const SetupConstants& c, const Triangle* t, std::size_t count, Batch& o) {
  const std::size_t lanes = (count + 15) / 16 * 16;
  load(c, t, count, o);
  boxes(c, lanes, o);
  outcomes(c, lanes, o);
  edges(c, lanes, o);
}

}  // namespace halfspace::cycle::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
