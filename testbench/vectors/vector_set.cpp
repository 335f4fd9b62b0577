// SPDX-License-Identifier: Apache-2.0
#include "vector_set.hpp"

#include <fmt/format.h>

#include <array>

namespace halfspace {
namespace {

constexpr std::array<std::string_view, kVectorStages> kStageNames{
    "rasterizer",    "triangle_setup", "half_plane_grid", "tile_traversal", "coverage",
    "interpolation", "depth"};

void append(Layout& layout, const Layout& more) {
  layout.insert(layout.end(), more.begin(), more.end());
}

Layout run_layout(const Config& config) {
  Layout layout{{"inputs", 32, false},
                {"outputs", 32, false},
                {"clocks", 32, false},
                {"stall", 32, false},
                {"stall_seed", 64, false}};
  append(layout, frame_layout(config));
  return layout;
}

Layout in_ports(const VectorMeta& meta) {
  switch (meta.stage) {
    case VectorStage::kHalfPlaneGrid: return grid_in_layout(meta.config);
    case VectorStage::kTileTraversal:
    case VectorStage::kCoverage: return traversal_layout(meta.config);
    case VectorStage::kInterpolation: return interpolation_in_layout(meta.config);
    case VectorStage::kDepthTest: return depth_in_layout(meta.config);
    default: return triangle_layout(meta.config);
  }
}

Layout out_ports(const VectorMeta& meta) {
  switch (meta.stage) {
    case VectorStage::kTriangleSetup: return setup_layout(meta.config);
    case VectorStage::kHalfPlaneGrid: return grid_out_layout(meta.config);
    case VectorStage::kTileTraversal: return traversal_layout(meta.config);
    case VectorStage::kInterpolation: return interpolation_out_layout(meta.config);
    case VectorStage::kDepthTest: return depth_out_layout(meta.config);
    default: return coverage_layout(meta.config);
  }
}

}  // namespace

std::string_view stage_name(VectorStage stage) {
  return kStageNames[static_cast<std::size_t>(stage)];
}

std::optional<VectorStage> find_stage(std::string_view name) {
  for (std::size_t i = 0; i < kStageNames.size(); ++i) {
    if (kStageNames[i] == name) return static_cast<VectorStage>(i);
  }
  return std::nullopt;
}

std::string_view kind_name(RecordKind kind) {
  constexpr std::array<std::string_view, kRecordKinds> kNames{"run", "in", "out"};
  return kNames[static_cast<std::size_t>(kind)];
}

VectorCounts count_records(const VectorSet& set) {
  VectorCounts counts;
  for (const VectorRecord& record : set.records) {
    counts.runs += record.kind == RecordKind::kRun ? 1u : 0u;
    counts.inputs += record.kind == RecordKind::kIn ? 1u : 0u;
    counts.outputs += record.kind == RecordKind::kOut ? 1u : 0u;
  }
  return counts;
}

std::size_t bookkeeping_fields(RecordKind kind, VectorStage stage) {
  const bool clocks = stage == VectorStage::kRasterizer;
  switch (kind) {
    case RecordKind::kRun: return kRunFrame;
    case RecordKind::kIn: return clocks ? 3 : 1;
    case RecordKind::kOut: return clocks ? 1 : 0;
  }
  return 0;
}

Layout vector_layout(RecordKind kind, const VectorMeta& meta) {
  if (kind == RecordKind::kRun) return run_layout(meta.config);
  Layout layout;
  const bool clocks = meta.stage == VectorStage::kRasterizer;
  if (kind == RecordKind::kIn) {
    layout.push_back({"outputs", 32, false});
    if (clocks) append(layout, {{"offer", 32, false}, {"accept", 32, false}});
    append(layout, in_ports(meta));
  } else {
    if (clocks) layout.push_back({"clock", 32, false});
    append(layout, out_ports(meta));
  }
  return layout;
}

bool is_lanes(const PortField& field) {
  return field.name.starts_with("mask") || field.name == "covered" || field.name == "passed";
}

std::string field_text(std::int64_t value, const PortField& field) {
  if (field.is_signed) return fmt::format("{}", value);
  const auto unsigned_value = static_cast<std::uint64_t>(value);
  return is_lanes(field) ? fmt::format("{:#x}", unsigned_value) : fmt::format("{}", unsigned_value);
}

FrameState frame_of(const Values& run) {
  return {static_cast<int>(run[kRunFrame]), static_cast<int>(run[kRunFrame + 1]),
          static_cast<Cull>(run[kRunFrame + 2])};
}

double stall_probability(const Values& run) { return static_cast<double>(run[kRunStall]) / 0x1p32; }

std::uint64_t stall_seed(const Values& run) { return static_cast<std::uint64_t>(run[kRunSeed]); }

}  // namespace halfspace
