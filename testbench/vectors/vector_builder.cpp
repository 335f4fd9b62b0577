// SPDX-License-Identifier: Apache-2.0
#include "vector_builder.hpp"

#include <fmt/format.h>

#include <bit>
#include <stdexcept>

#include "coverage.hpp"
#include "half_plane_grid.hpp"
#include "packets_of.hpp"
#include "shading.hpp"
#include "tile_traversal.hpp"
#include "triangle_setup.hpp"

namespace halfspace {
namespace {

constexpr std::uint64_t kMostCount = 0xffffffffu;

std::int64_t counted(std::uint64_t count) {
  if (count > kMostCount) throw std::length_error("more than 2^32 - 1 records or clocks");
  return static_cast<std::int64_t>(count);
}

Values grid_out(const Values& ports, const Config& config) {
  const EdgeSlope slope{static_cast<std::int32_t>(ports[1]), static_cast<std::int32_t>(ports[2])};
  return {std::int64_t{slope.a} + slope.b,
          static_cast<std::int64_t>(half_plane_grid(ports[0], slope, config))};
}

// One sample of one lane, by the planes.
Values interpolation_out(const InterpolationInput& in, const Config& config) {
  const InterpolationSetup setup =
      interpolation_setup(in.setup, in.triangle, in.attributes, config.attributes, config);
  const int column = in.lane & (config.grid() - 1);
  const int row = in.lane >> config.grid_log2;
  Values planes;
  const auto at_sample = [&](const Plane& plane) {
    const TilePlane tile = tile_plane(plane, setup.origin, in.x, in.y, config);
    const std::uint32_t delta = sample_delta(plane, in.sample, config);
    for (const std::uint32_t part : {tile.base, tile.dx, tile.dy, delta}) {
      planes.push_back(static_cast<std::int32_t>(part));
    }
    return TilePlane{tile.base + delta, tile.dx, tile.dy}.at(column, row);
  };
  Values results{depth_value(at_sample(setup.depth), config)};
  if (config.attributes > 0) {
    const std::int32_t inverse_w = at_sample(setup.inverse_w);
    for (std::size_t n = 0; n < static_cast<std::size_t>(config.attributes); ++n) {
      results.push_back(
          perspective(at_sample(setup.attribute[n]), inverse_w, setup.level[n], config));
    }
  }
  planes.insert(planes.end(), results.begin(), results.end());
  return planes;
}

Values depth_out(DepthInput in, const Config& config) {
  Values values{
      static_cast<std::int64_t>(depth_test(in.covered, in.plane, in.function, in.stored, config))};
  values.insert(values.end(), in.stored.begin(), in.stored.begin() + config.lanes());
  return values;
}

// The outputs of a stage whose clocks are not predicted.
std::vector<Values> outputs_of(const Values& ports, const FrameState& frame,
                               const VectorMeta& meta) {
  const Config& config = meta.config;
  std::vector<Values> out;
  switch (meta.stage) {
    case VectorStage::kRasterizer: break;
    case VectorStage::kTriangleSetup:
      if (const auto setup = triangle_setup(triangle_of(ports), frame, config)) {
        out.push_back(values_of(*setup, config));
      }
      break;
    case VectorStage::kHalfPlaneGrid: out.push_back(grid_out(ports, config)); break;
    case VectorStage::kTileTraversal: {
      const NodeOfTriangle in = node_of(ports);
      for (GridMask live = live_children(in.node, meta.level, in.setup, config); live != 0;
           live &= live - 1) {
        const int bit = std::countr_zero(live);
        out.push_back(
            values_of(child_node(in.node, meta.level, bit, in.setup, config), in.setup, config));
      }
      break;
    }
    case VectorStage::kCoverage: {
      const NodeOfTriangle in = node_of(ports);
      if (const auto tile = coverage(in.node, in.setup, config)) {
        out.push_back(values_of(*tile, config));
      }
      break;
    }
    case VectorStage::kInterpolation:
      out.push_back(interpolation_out(interpolation_input_of(ports, config), config));
      break;
    case VectorStage::kDepthTest:
      out.push_back(depth_out(depth_input_of(ports, config), config));
      break;
  }
  return out;
}

// What one triangle does in the rasterizer.
struct Events {
  std::uint64_t accept = 0;
  std::vector<std::pair<std::uint64_t, CoverageTile>> tiles;
  void accepted(std::uint64_t clock) { accept = clock; }
  void setup(std::uint64_t, const SetupTriangle&) {}
  void node(int, std::uint64_t, const Node&) {}
  void tile(std::uint64_t clock, const CoverageTile& tile) { tiles.emplace_back(clock, tile); }
};

// Stimulus with the fields that follow from others put right.
Values normal(const Values& ports, const VectorMeta& meta) {
  if (meta.stage != VectorStage::kTileTraversal && meta.stage != VectorStage::kCoverage) {
    return ports;
  }
  const NodeOfTriangle in = node_of(ports);
  return values_of(in.node, in.setup, meta.config);
}

std::string record_place(const VectorSet& set, std::size_t index) {
  std::size_t same = 0;
  for (std::size_t i = 0; i < index; ++i) same += set.records[i].kind == set.records[index].kind;
  return fmt::format("{} {}", kind_name(set.records[index].kind), same);
}

std::string first_field(const VectorRecord& file, const VectorRecord& model,
                        const VectorMeta& meta) {
  const Layout layout = vector_layout(file.kind, meta);
  for (std::size_t i = 0; i < layout.size(); ++i) {
    if (file.values[i] == model.values[i]) continue;
    return fmt::format("field={} file={} model={}", layout[i].name,
                       field_text(file.values[i], layout[i]),
                       field_text(model.values[i], layout[i]));
  }
  return {};
}

}  // namespace

VectorBuilder::VectorBuilder(const VectorMeta& meta) { set_.meta = meta; }

void VectorBuilder::run(const FrameState& frame, std::uint32_t stall, std::uint64_t stall_seed) {
  end_run();
  frame_ = frame;
  run_at_ = set_.records.size();
  Values values{0, 0, 0, stall, static_cast<std::int64_t>(stall_seed)};
  const Values state = values_of(frame);
  values.insert(values.end(), state.begin(), state.end());
  stalls_ = stall == 0 ? Stalls() : Stalls(stall_probability(values), stall_seed);
  set_.records.push_back({RecordKind::kRun, values});
  model_.emplace(frame, set_.meta.config, stalls_);
}

std::size_t VectorBuilder::begin_input(const Values& ports) {
  const std::size_t fields = bookkeeping_fields(RecordKind::kIn, set_.meta.stage);
  Values values(fields, 0);
  const Values port = normal(ports, set_.meta);
  values.insert(values.end(), port.begin(), port.end());
  set_.records.push_back({RecordKind::kIn, values});
  ++inputs_;
  return set_.records.size() - 1;
}

void VectorBuilder::output(const Values& values) {
  set_.records.push_back({RecordKind::kOut, values});
  ++outputs_;
}

void VectorBuilder::add(const Values& ports) {
  if (set_.meta.stage == VectorStage::kRasterizer) return add_rasterizer(ports);
  const std::size_t at = begin_input(ports);
  const std::vector<Values> out = outputs_of(ports, frame_, set_.meta);
  for (const Values& values : out) output(values);
  set_.records[at].values[kInOutputs] = counted(out.size());
}

void VectorBuilder::add_rasterizer(const Values& ports) {
  const std::uint64_t offer = next_offer_ + stalls_.gap(inputs_);
  const std::size_t at = begin_input(ports);
  Events events;
  model_->draw(triangle_of(ports), events);
  for (const auto& [clock, tile] : events.tiles) {
    Values values{counted(clock)};
    const Values port = values_of(tile, set_.meta.config);
    values.insert(values.end(), port.begin(), port.end());
    output(values);
  }
  next_offer_ = events.accept + 1;
  Values& values = set_.records[at].values;
  values[kInOutputs] = counted(events.tiles.size());
  values[kInOffer] = counted(offer);
  values[kInAccept] = counted(events.accept);
}

void VectorBuilder::end_run() {
  if (!model_) return;
  Values& values = set_.records[run_at_].values;
  values[kRunInputs] = counted(inputs_);
  values[kRunOutputs] = counted(outputs_);
  values[kRunClocks] = set_.meta.stage == VectorStage::kRasterizer ? counted(model_->clocks()) : 0;
  inputs_ = outputs_ = next_offer_ = 0;
}

VectorSet VectorBuilder::finish() {
  end_run();
  return std::move(set_);
}

std::optional<VectorDifference> check_vectors(const VectorSet& set) {
  VectorBuilder builder(set.meta);
  const auto book =
      static_cast<std::ptrdiff_t>(bookkeeping_fields(RecordKind::kIn, set.meta.stage));
  for (const VectorRecord& record : set.records) {
    if (record.kind == RecordKind::kRun) {
      builder.run(frame_of(record.values), static_cast<std::uint32_t>(record.values[kRunStall]),
                  stall_seed(record.values));
    } else if (record.kind == RecordKind::kIn) {
      builder.add(Values(record.values.begin() + book, record.values.end()));
    }
  }
  const VectorSet model = builder.finish();
  for (std::size_t i = 0; i < set.records.size() && i < model.records.size(); ++i) {
    const VectorRecord& file = set.records[i];
    if (file == model.records[i]) continue;
    if (file.kind != model.records[i].kind) {
      return VectorDifference{
          i, fmt::format("{}: the model has a record of kind {} here", record_place(set, i),
                         kind_name(model.records[i].kind))};
    }
    return VectorDifference{
        i, record_place(set, i) + ": " + first_field(file, model.records[i], set.meta)};
  }
  if (set.records.size() < model.records.size()) {
    return VectorDifference{set.records.size(),
                            "the file ends, but the model has more outputs of the last input"};
  }
  if (set.records.size() > model.records.size()) {
    return VectorDifference{model.records.size(), "the model has no output here"};
  }
  return std::nullopt;
}

}  // namespace halfspace
