// SPDX-License-Identifier: Apache-2.0
#include "layout.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bits.hpp"
#include "samples.hpp"

namespace halfspace {
namespace {

void add_slopes(Layout& layout, const Config& config) {
  for (int i = 0; i < 3; ++i) {
    layout.push_back({fmt::format("slope{}.a", i), config.delta_bits(), true});
    layout.push_back({fmt::format("slope{}.b", i), config.delta_bits(), true});
  }
}
void add_slopes(Values& values, const SetupTriangle& setup) {
  for (const EdgeSlope& slope : setup.slope) {
    values.push_back(slope.a);
    values.push_back(slope.b);
  }
}

void add_edges(Layout& layout, const Config& config) {
  const int bits = config.node_bits(config.node_log2(0));
  for (int i = 0; i < 3; ++i) layout.push_back({fmt::format("e{}", i), bits, true});
}

void add_box(Layout& layout, const Config& config) {
  for (const char* name : {"box.x_first", "box.y_first", "box.x_last", "box.y_last"}) {
    layout.push_back({name, config.viewport_bits, false});
  }
}
void add_box(Values& values, const Box& box) {
  for (const std::int64_t side : {box.x_first, box.y_first, box.x_last, box.y_last}) {
    values.push_back(side);
  }
}

void add_tag(Layout& layout, const Config& config) {
  layout.push_back({"tag", config.tag_bits, false});
}
void add_tag(Values& values, std::uint32_t tag, const Config& config) {
  values.push_back(tag & ((std::uint64_t{1} << config.tag_bits) - 1));
}

void add_corners(Layout& layout, const Config& config) {
  for (int i = 0; i < 3; ++i) {
    layout.push_back({fmt::format("corner{}.reach", i), config.delta_bits(), false});
    layout.push_back(
        {fmt::format("corner{}.inset", i), config.delta_bits() + config.sample_bits(), false});
  }
}
// hs_pkg::corner_t: reach = max(a, 0) + max(b, 0); inset = 2^q reach - (a, b) . offset, the offset
// being that of the sample furthest inside.
void add_corners(Values& values, const SetupTriangle& setup, const Config& config) {
  const int q = config.sample_bits();
  const SampleExtent extent = sample_extent(config.samples);
  const auto offset = [&](std::int64_t slope, int low, int high) {
    return q == 0 ? 0 : slope * ((slope > 0 ? high : low) >> (4 - q));
  };
  for (const EdgeSlope& slope : setup.slope) {
    const std::int64_t reach = std::max(slope.a, 0) + std::int64_t{std::max(slope.b, 0)};
    values.push_back(reach);
    values.push_back((reach << q) - offset(slope.a, extent.low.x, extent.high.x) -
                     offset(slope.b, extent.low.y, extent.high.y));
  }
}

void add_stored(Layout& layout, const Config& config) {
  for (int lane = 0; lane < config.lanes(); ++lane) {
    layout.push_back({fmt::format("stored{}", lane), config.depth_bits, false});
  }
}

}  // namespace

int layout_bits(const Layout& layout) {
  int bits = 0;
  for (const PortField& field : layout) bits += field.bits;
  return bits;
}

Layout triangle_layout(const Config& config) {
  Layout layout;
  for (int i = 0; i < 3; ++i) {
    layout.push_back({fmt::format("vertex{}.x", i), config.vertex_bits(), true});
    layout.push_back({fmt::format("vertex{}.y", i), config.vertex_bits(), true});
  }
  add_tag(layout, config);
  return layout;
}

Layout setup_layout(const Config& config) {
  Layout layout;
  add_slopes(layout, config);
  add_edges(layout, config);
  add_box(layout, config);
  layout.push_back({"flipped", 1, false});
  add_tag(layout, config);
  add_corners(layout, config);
  return layout;
}

Layout traversal_layout(const Config& config) {
  Layout layout{{"x", config.viewport_bits, false}, {"y", config.viewport_bits, false}};
  add_edges(layout, config);
  add_slopes(layout, config);
  add_box(layout, config);
  add_tag(layout, config);
  add_corners(layout, config);
  return layout;
}

Layout coverage_layout(const Config& config) {
  Layout layout{{"x", config.viewport_bits, false}, {"y", config.viewport_bits, false}};
  for (int m = config.samples - 1; m >= 0; --m) {
    layout.push_back({fmt::format("mask[{}]", m), config.lanes(), false});
  }
  add_tag(layout, config);
  return layout;
}

Layout frame_layout(const Config& config) {
  return {{"width", config.viewport_bits + 1, false},
          {"height", config.viewport_bits + 1, false},
          {"cull", 2, false}};
}

Layout grid_in_layout(const Config& config) {
  return {{"base", config.lane_bits(), true},
          {"a", config.delta_bits(), true},
          {"b", config.delta_bits(), true}};
}

Layout grid_out_layout(const Config& config) {
  return {{"ab", config.delta_bits() + 1, true}, {"covered", config.lanes(), false}};
}

Layout interpolation_in_layout(const Config& config) {
  Layout layout;
  add_slopes(layout, config);
  layout.push_back({"flipped", 1, false});
  layout.push_back({"vertex0.x", config.vertex_bits(), true});
  layout.push_back({"vertex0.y", config.vertex_bits(), true});
  for (int i = 0; i < 3; ++i) {
    layout.push_back({fmt::format("depth{}", i), kPlaneBits + 2, true});
    layout.push_back({fmt::format("inverse_w{}", i), config.inverse_w_bits, false});
    for (int n = 0; n < config.attributes; ++n) {
      layout.push_back({fmt::format("value{}.{}", i, n), 10 + kAttributeFractionBits, true});
    }
  }
  layout.push_back({"x", config.viewport_bits, false});
  layout.push_back({"y", config.viewport_bits, false});
  layout.push_back({"sample", 4, false});
  layout.push_back({"lane", 2 * config.grid_log2, false});
  return layout;
}

Layout interpolation_out_layout(const Config& config) {
  Layout layout;
  const auto add_plane = [&layout](const std::string& name) {
    for (const char* part : {"base", "dx", "dy", "sample"}) {
      layout.push_back({name + "." + part, 32, true});
    }
  };
  add_plane("depth");
  if (config.attributes > 0) add_plane("inverse_w");
  for (int n = 0; n < config.attributes; ++n) add_plane(fmt::format("attribute{}", n));
  layout.push_back({"depth", config.depth_bits, false});
  for (int n = 0; n < config.attributes; ++n) {
    layout.push_back({fmt::format("attribute{}", n), 8, false});
  }
  return layout;
}

Layout depth_in_layout(const Config& config) {
  Layout layout{{"covered", config.lanes(), false},
                {"plane.base", 32, true},
                {"plane.dx", 32, true},
                {"plane.dy", 32, true},
                {"function", 3, false}};
  add_stored(layout, config);
  return layout;
}

Layout depth_out_layout(const Config& config) {
  Layout layout{{"passed", config.lanes(), false}};
  add_stored(layout, config);
  return layout;
}

Values values_of(const Triangle& triangle, const Config& config) {
  Values values;
  for (const Point& vertex : triangle.vertex) {
    values.push_back(vertex.x);
    values.push_back(vertex.y);
  }
  add_tag(values, triangle.tag, config);
  return values;
}

Values values_of(const SetupTriangle& setup, const Config& config) {
  Values values;
  add_slopes(values, setup);
  values.insert(values.end(), setup.e.begin(), setup.e.end());
  add_box(values, setup.box);
  values.push_back(setup.flipped ? 1 : 0);
  add_tag(values, setup.tag, config);
  add_corners(values, setup, config);
  return values;
}

Values values_of(const Node& node, const SetupTriangle& setup, const Config& config) {
  Values values{node.x, node.y};
  values.insert(values.end(), node.e.begin(), node.e.end());
  add_slopes(values, setup);
  add_box(values, setup.box);
  add_tag(values, setup.tag, config);
  add_corners(values, setup, config);
  return values;
}

Values values_of(const CoverageTile& tile, const Config& config) {
  Values values{tile.x, tile.y};
  for (int m = config.samples - 1; m >= 0; --m) {
    values.push_back(static_cast<std::int64_t>(tile.mask[static_cast<std::size_t>(m)]));
  }
  add_tag(values, tile.tag, config);
  return values;
}

Values values_of(const FrameState& frame) {
  return {frame.width, frame.height, static_cast<std::int64_t>(frame.cull)};
}

PortWords pack(const Values& values, const Layout& layout) {
  BitWriter bits(layout_bits(layout));
  for (std::size_t i = 0; i < layout.size(); ++i) bits.put(values[i], layout[i].bits);
  return bits.words();
}

Values unpack(const PortWords& words, const Layout& layout) {
  BitReader bits(words.data(), layout_bits(layout));
  Values values;
  for (const PortField& field : layout) {
    values.push_back(field.is_signed ? bits.signed_bits(field.bits)
                                     : static_cast<std::int64_t>(bits.unsigned_bits(field.bits)));
  }
  return values;
}

std::string first_difference(const Values& model, const Values& rtl, const Layout& layout) {
  for (std::size_t i = 0; i < layout.size(); ++i) {
    if (model[i] == rtl[i]) continue;
    return layout[i].name.starts_with("mask")
               ? fmt::format("field={} model={:#x} rtl={:#x}", layout[i].name,
                             static_cast<std::uint64_t>(model[i]),
                             static_cast<std::uint64_t>(rtl[i]))
               : fmt::format("field={} model={} rtl={}", layout[i].name, model[i], rtl[i]);
  }
  return {};
}

}  // namespace halfspace
