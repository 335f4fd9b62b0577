// SPDX-License-Identifier: Apache-2.0
//
// The Verilated rasterizer behind one interface for every preset: packets in and out, one clock at
// a time. The only place where packets meet ports is rtl_model.cpp.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "config.hpp"
#include "packets.hpp"

namespace halfspace {

// A place where packets change hands. 0: triangle accepted; 1: setup to the root level;
// l + 1: into level l of the pyramid, l = 1 .. levels - 1 (levels - 1 is coverage);
// levels + 1: a tile leaves coverage.
constexpr int kLinkAccept = 0;
constexpr int kLinkSetup = 1;
constexpr int link_output(const Config& config) { return config.levels() + 1; }

class RtlRasterizer {
 public:
  virtual ~RtlRasterizer() = default;

  // The free values the RTL was built with; those it does not have are the preset's.
  virtual const Config& config() const = 0;

  // Holds reset for `clocks` clocks; everything inside is lost, the clock count starts again.
  virtual void reset(int clocks) = 0;
  // Stable while busy().
  virtual void set_frame(const FrameState& frame) = 0;

  // Inputs of the coming clock edge: a triangle (null: none) and whether a tile can be taken.
  virtual void drive(const Triangle* triangle, bool ready) = 0;

  // After drive(): whether a packet changes hands at the coming edge, and which.
  virtual bool fires(int link) const = 0;
  virtual SetupTriangle setup() const = 0;  // link kLinkSetup
  virtual Node node(int level) const = 0;   // link level + 1, level >= 1
  virtual std::uint32_t node_tag(int level) const = 0;
  virtual CoverageTile coverage() const = 0;  // link_output()

  // The edge. Throws std::runtime_error when an assertion in the RTL fired.
  virtual void clock() = 0;
  virtual bool busy() const = 0;

  // Waves from now on into an FST file, until close or destruction.
  virtual void open_trace(const std::string& path) = 0;
  virtual void close_trace() = 0;
};

// The model built for this configuration's RTL values (subpixel, viewport and guard bits, samples,
// grid, setup interval, tag); null when there is none in this build.
std::unique_ptr<RtlRasterizer> make_rtl_rasterizer(const Config& config);

// Names of the RTL configurations in this build.
std::vector<std::string> rtl_configurations();

}  // namespace halfspace
