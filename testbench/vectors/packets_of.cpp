// SPDX-License-Identifier: Apache-2.0
#include "packets_of.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "fixed.hpp"
#include "triangle_setup.hpp"

namespace halfspace {
namespace {

// Takes values one after the other.
class Taker {
 public:
  explicit Taker(const Values& values) : values_(values) {}
  std::int64_t next() { return values_[at_++]; }
  std::int32_t word() { return static_cast<std::int32_t>(next()); }
  std::uint32_t unsigned_word() { return static_cast<std::uint32_t>(next()); }

 private:
  const Values& values_;
  std::size_t at_ = 0;
};

void take_slopes(Taker& take, SetupTriangle& setup) {
  for (EdgeSlope& slope : setup.slope) {
    slope.a = take.word();
    slope.b = take.word();
  }
}

void take_box(Taker& take, Box& box) {
  for (std::int32_t* edge : {&box.x_first, &box.y_first, &box.x_last, &box.y_last}) {
    *edge = take.word();
  }
}

void put_slopes(Values& values, const SetupTriangle& setup) {
  for (const EdgeSlope& slope : setup.slope) {
    values.push_back(slope.a);
    values.push_back(slope.b);
  }
}

std::string slope_fault(const SetupTriangle& setup, const Config& config) {
  const std::int64_t greatest = config.extent_max();
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::abs(std::int64_t{setup.slope[i].a}) > greatest ||
        std::abs(std::int64_t{setup.slope[i].b}) > greatest) {
      return fmt::format("slope{} is longer than any legal edge", i);
    }
  }
  return {};
}

std::string triangle_fault(const Triangle& triangle, const Config& config) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (const std::int32_t v : {triangle.vertex[i].x, triangle.vertex[i].y}) {
      if (v < config.coordinate_min() || v > config.coordinate_max()) {
        return fmt::format("vertex{} is beyond the legal square", i);
      }
    }
  }
  if (within_extent(triangle, config)) return {};
  return fmt::format("an edge is longer than extent_bits = {} allows", config.extent_bits);
}

std::string node_fault(const NodeOfTriangle& in, int level, const Config& config) {
  const int side_log2 = config.node_log2(level);
  const std::int32_t last = (1 << side_log2) - 1;
  if ((in.node.x & last) != 0 || (in.node.y & last) != 0) return "x or y is not a node's origin";
  for (std::size_t i = 0; i < 3; ++i) {
    if (!fits(in.node.e[i], config.node_bits(side_log2))) {
      return fmt::format("e{} is too wide for a node of this level", i);
    }
  }
  const Box& box = in.setup.box;
  if (box.x_first > box.x_last || box.y_first > box.y_last) return "box is empty";
  if (box.x_first > in.node.x + last || box.x_last < in.node.x || box.y_first > in.node.y + last ||
      box.y_last < in.node.y) {
    return "box and node do not overlap";
  }
  return slope_fault(in.setup, config);
}

std::string grid_fault(const Values& ports, const Config& config) {
  const std::int64_t last = config.grid() - 1;
  for (const std::int64_t column : {std::int64_t{0}, last}) {
    for (const std::int64_t row : {std::int64_t{0}, last}) {
      if (!fits(ports[0] + column * ports[1] + row * ports[2], config.lane_bits())) {
        return "a lane does not fit its width";
      }
    }
  }
  return {};
}

std::string interpolation_fault(const InterpolationInput& in, const Config& config) {
  const std::string slopes = slope_fault(in.setup, config);
  if (!slopes.empty()) return slopes;
  const std::string vertex = triangle_fault(in.triangle, config);
  if (!vertex.empty()) return vertex;
  const auto& slope = in.setup.slope;
  const std::int64_t cross =
      std::int64_t{slope[0].a} * slope[1].b - std::int64_t{slope[0].b} * slope[1].a;
  if ((in.setup.flipped ? -cross : cross) <= 0) return "the triangle has no area, or is flipped";
  for (const VertexAttributes& vertex_attributes : in.attributes) {
    if (vertex_attributes.inverse_w == 0) return "inverse_w is 0";
    if (vertex_attributes.depth < kDepthLeast || vertex_attributes.depth > kDepthMost) {
      return "a depth is out of range";
    }
    for (const std::int32_t value : vertex_attributes.value) {
      if (value < kValueLeast || value > kValueMost) return "a value is out of range";
    }
  }
  const int last = config.grid() - 1;
  if ((in.x & last) != 0 || (in.y & last) != 0) return "x or y is not a tile's origin";
  return in.sample >= config.samples ? "sample is out of range" : "";
}

}  // namespace

Triangle triangle_of(const Values& ports) {
  Taker take(ports);
  Triangle triangle;
  for (Point& point : triangle.vertex) {
    point.x = take.word();
    point.y = take.word();
  }
  triangle.tag = take.unsigned_word();
  return triangle;
}

SetupTriangle setup_of(const Values& ports) {
  Taker take(ports);
  SetupTriangle out;
  take_slopes(take, out);
  for (std::int64_t& e : out.e) e = take.next();
  take_box(take, out.box);
  out.flipped = take.next() != 0;
  out.tag = take.unsigned_word();
  return out;
}

NodeOfTriangle node_of(const Values& ports) {
  Taker take(ports);
  NodeOfTriangle out;
  out.node.x = take.word();
  out.node.y = take.word();
  for (std::int64_t& e : out.node.e) e = take.next();
  take_slopes(take, out.setup);
  take_box(take, out.setup.box);
  out.setup.tag = take.unsigned_word();
  return out;
}

CoverageTile coverage_of(const Values& ports, const Config& config) {
  Taker take(ports);
  CoverageTile tile;
  tile.x = take.word();
  tile.y = take.word();
  for (int m = config.samples - 1; m >= 0; --m) {
    tile.mask[static_cast<std::size_t>(m)] = static_cast<GridMask>(take.next());
  }
  tile.tag = take.unsigned_word();
  return tile;
}

InterpolationInput interpolation_input_of(const Values& ports, const Config& config) {
  Taker take(ports);
  InterpolationInput out;
  take_slopes(take, out.setup);
  out.setup.flipped = take.next() != 0;
  out.triangle.vertex[0].x = take.word();
  out.triangle.vertex[0].y = take.word();
  // The others follow from the edges that leave them.
  const int sign = out.setup.flipped ? -1 : 1;
  for (std::size_t i = 0; i < 2; ++i) {
    const Point from = out.triangle.vertex[i];
    const EdgeSlope edge = out.setup.slope[i];
    out.triangle.vertex[i + 1] = {from.x + sign * edge.b, from.y - sign * edge.a};
  }
  for (VertexAttributes& vertex : out.attributes) {
    vertex.depth = take.word();
    vertex.inverse_w = take.unsigned_word();
    for (std::size_t n = 0; n < static_cast<std::size_t>(config.attributes); ++n) {
      vertex.value[n] = take.word();
    }
  }
  out.x = take.word();
  out.y = take.word();
  out.sample = take.word();
  out.lane = take.word();
  return out;
}

Values values_of(const InterpolationInput& in, const Config& config) {
  Values values;
  put_slopes(values, in.setup);
  values.insert(values.end(),
                {in.setup.flipped ? 1 : 0, in.triangle.vertex[0].x, in.triangle.vertex[0].y});
  for (const VertexAttributes& vertex : in.attributes) {
    values.push_back(vertex.depth);
    values.push_back(vertex.inverse_w);
    for (std::size_t n = 0; n < static_cast<std::size_t>(config.attributes); ++n) {
      values.push_back(vertex.value[n]);
    }
  }
  values.insert(values.end(), {in.x, in.y, in.sample, in.lane});
  return values;
}

DepthInput depth_input_of(const Values& ports, const Config& config) {
  Taker take(ports);
  DepthInput out;
  out.covered = static_cast<GridMask>(take.next());
  out.plane.base = take.unsigned_word();
  out.plane.dx = take.unsigned_word();
  out.plane.dy = take.unsigned_word();
  out.function = static_cast<DepthFunction>(take.next());
  for (std::size_t lane = 0; lane < static_cast<std::size_t>(config.lanes()); ++lane) {
    out.stored[lane] = take.unsigned_word();
  }
  return out;
}

Values values_of(const DepthInput& in, const Config& config) {
  Values values{static_cast<std::int64_t>(in.covered), static_cast<std::int32_t>(in.plane.base),
                static_cast<std::int32_t>(in.plane.dx), static_cast<std::int32_t>(in.plane.dy),
                static_cast<std::int64_t>(in.function)};
  values.insert(values.end(), in.stored.begin(), in.stored.begin() + config.lanes());
  return values;
}

std::string stimulus_fault(const Values& ports, const VectorMeta& meta) {
  switch (meta.stage) {
    case VectorStage::kRasterizer:
    case VectorStage::kTriangleSetup: return triangle_fault(triangle_of(ports), meta.config);
    case VectorStage::kHalfPlaneGrid: return grid_fault(ports, meta.config);
    case VectorStage::kTileTraversal: return node_fault(node_of(ports), meta.level, meta.config);
    case VectorStage::kCoverage:
      return node_fault(node_of(ports), meta.config.levels() - 1, meta.config);
    case VectorStage::kInterpolation:
      return interpolation_fault(interpolation_input_of(ports, meta.config), meta.config);
    case VectorStage::kDepthTest: return {};  // every function of three bits is one
  }
  return {};
}

std::string run_fault(const Values& run, const VectorMeta& meta) {
  const FrameState frame = frame_of(run);
  const int most = meta.config.max_size();
  if (frame.width < 1 || frame.width > most || frame.height < 1 || frame.height > most) {
    return "width or height is out of range";
  }
  if (frame.cull > Cull::kFront) return "cull is out of range";
  return stall_probability(run) > 0.95 ? "stall is above 0.95" : "";
}

}  // namespace halfspace
