// SPDX-License-Identifier: Apache-2.0
//
// One stage of the RTL by itself, Verilated: packets in and out, one clock at a time.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "config.hpp"
#include "vectors/layout.hpp"

namespace halfspace {

class StageRtl {
 public:
  virtual ~StageRtl() = default;

  // Holds reset; everything inside is lost.
  virtual void reset(int clocks) = 0;
  // triangle_setup only; stable while busy().
  virtual void set_frame(const FrameState& frame) = 0;
  // state_i, of depth_test only; stable while busy().
  virtual void set_state(const PortWords& state) = 0;

  // Inputs of the coming clock edge: a packet (null: none), and whether the output is taken.
  virtual void drive(const PortWords* packet, bool ready) = 0;
  // After drive(): what the edge will do.
  virtual bool accepts() const = 0;
  virtual bool emits() const = 0;
  virtual bool busy() const = 0;
  virtual PortWords out() const = 0;

  // The edge. Throws std::runtime_error when an assertion in the RTL fired.
  virtual void clock() = 0;
};

// A stage of a configuration. level: of the pyramid, for tile_traversal; planes side by side, for
// tile_plane; slots_log2, for depth_test; fragments of a group, for shade.
struct StageVariant {
  const char* name;
  Config config;
  int level;
  std::unique_ptr<StageRtl> (*make)();
};

std::span<const StageVariant> triangle_setup_stages();
std::span<const StageVariant> tile_traversal_stages();
std::span<const StageVariant> coverage_stages();
std::span<const StageVariant> tile_plane_stages();
std::span<const StageVariant> depth_test_stages();
std::span<const StageVariant> shade_stages();

// hs_half_plane_grid: a register in front of logic, no handshake.
class GridRtl {
 public:
  virtual ~GridRtl() = default;
  // A clock edge with these inputs.
  virtual void clock(std::int64_t base, EdgeSlope slope, bool load) = 0;
  virtual GridMask covered() const = 0;
  virtual std::int64_t ab() const = 0;  // A + B
};

struct GridVariant {
  const char* name;
  Config config;
  int side;  // lanes
  std::unique_ptr<GridRtl> (*make)();
};
std::span<const GridVariant> half_plane_grid_stages();

// A rigid pipeline: a packet may enter in every clock, and nothing holds up what comes out.
class PipelineRtl {
 public:
  virtual ~PipelineRtl() = default;
  virtual void reset() = 0;
  // A clock with this packet at the input; null: none, the words there are `noise`. What stands at
  // the output before the edge; nothing when it says that it is not valid.
  virtual std::optional<PortWords> clock(const PortWords* packet, const PortWords& noise) = 0;
};

struct PipelineVariant {
  const char* name;
  Config config;
  int parameter;  // what is set of the module: Bits of hs_reciprocal, Interval of hs_gradient
  int latency;    // clocks from input to output
  std::unique_ptr<PipelineRtl> (*make)();
};
std::span<const PipelineVariant> reciprocal_stages();
std::span<const PipelineVariant> gradient_stages();
std::span<const PipelineVariant> depth_setup_stages();       // its planes
std::span<const PipelineVariant> depth_setup_area_stages();  // what they share

}  // namespace halfspace
