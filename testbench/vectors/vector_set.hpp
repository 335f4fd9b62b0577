// SPDX-License-Identifier: Apache-2.0
//
// Vectors: what goes into a stage and what must come out, as numbers with names. Files of them:
// docs/02_use/vectors.md.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config.hpp"
#include "layout.hpp"
#include "packets.hpp"

namespace halfspace {

// What a set of vectors is for. Interpolation and depth have no RTL twin yet.
enum class VectorStage : std::uint8_t {
  kRasterizer,
  kTriangleSetup,
  kHalfPlaneGrid,
  kTileTraversal,
  kCoverage,
  kInterpolation,
  kDepthTest,
};
inline constexpr int kVectorStages = 7;

// "rasterizer", "triangle_setup", ...
std::string_view stage_name(VectorStage stage);
std::optional<VectorStage> find_stage(std::string_view name);
constexpr bool has_rtl(VectorStage stage) { return stage < VectorStage::kInterpolation; }

// A run starts with a reset and holds one frame state; inputs follow it, and every input is
// followed by the outputs that it causes.
enum class RecordKind : std::uint8_t { kRun, kIn, kOut };
inline constexpr int kRecordKinds = 3;
std::string_view kind_name(RecordKind kind);

struct VectorRecord {
  RecordKind kind = RecordKind::kRun;
  Values values;  // one per field of vector_layout()
  bool operator==(const VectorRecord&) const = default;
};

struct VectorMeta {
  VectorStage stage = VectorStage::kRasterizer;
  int level = 0;  // tile_traversal: the level of the pyramid, 0 = root .. levels() - 2; else 0
  Config config;
  std::uint64_t seed = 0;        // of the generator and the stalls
  std::string program;           // "halfspace 0.1.0"
  std::string source;            // "mesh", "tcov", "generator", "goal"
  std::string source_name;       // a file's name without its folder; the shapes of a generator
  std::uint32_t source_crc = 0;  // CRC-32 of the source file; 0 for a generator
  bool operator==(const VectorMeta&) const = default;
};

struct VectorSet {
  VectorMeta meta;
  std::vector<VectorRecord> records;
};

// Records of each kind, indexed by RecordKind.
struct VectorCounts {
  std::uint64_t runs = 0;
  std::uint64_t inputs = 0;
  std::uint64_t outputs = 0;
};
VectorCounts count_records(const VectorSet& set);

// The fields of a record, the first in the highest bits of its word. A record is some fields of
// bookkeeping and then the DUT's port as it is packed in rtl/hs_pkg.sv, in the lowest bits:
//
//   run  inputs, outputs, clocks (U32, expected); stall (U0.32, probability), stall_seed; width,
//        height, cull (hs_pkg::frame_state_t)
//   in   outputs (U32, expected), for the rasterizer offer (U32) and accept (U32, expected), both
//        clocks since the reset; then the input packet
//   out  for the rasterizer clock (U32, expected); then the output packet, expected
Layout vector_layout(RecordKind kind, const VectorMeta& meta);
inline constexpr std::array<RecordKind, kRecordKinds> kRecordKindList{
    RecordKind::kRun, RecordKind::kIn, RecordKind::kOut};
// The layouts of all kinds.
class VectorLayouts {
 public:
  explicit VectorLayouts(const VectorMeta& meta) {
    for (const RecordKind kind : kRecordKindList) at(kind) = vector_layout(kind, meta);
  }
  const Layout& operator[](RecordKind kind) const {
    return layout_[static_cast<std::size_t>(kind)];
  }

 private:
  Layout& at(RecordKind kind) { return layout_[static_cast<std::size_t>(kind)]; }
  std::array<Layout, kRecordKinds> layout_;
};

// How many fields of a record come before the port's.
std::size_t bookkeeping_fields(RecordKind kind, VectorStage stage);

// True for a field that is a set of lanes: written in hexadecimal.
bool is_lanes(const PortField& field);

// A field's value as it is written and read: lanes as 0x..., numbers in decimal.
std::string field_text(std::int64_t value, const PortField& field);

// The frame state of a run record, and its stalls as Stalls takes them.
FrameState frame_of(const Values& run);
double stall_probability(const Values& run);
std::uint64_t stall_seed(const Values& run);

// Positions of fields in records.
inline constexpr std::size_t kRunInputs = 0, kRunOutputs = 1, kRunClocks = 2, kRunStall = 3,
                             kRunSeed = 4, kRunFrame = 5;
inline constexpr std::size_t kInOutputs = 0, kInOffer = 1, kInAccept = 2;

}  // namespace halfspace
