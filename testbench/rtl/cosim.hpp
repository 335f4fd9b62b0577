// SPDX-License-Identifier: Apache-2.0
//
// Model against RTL: every packet at every handshake, its bits and its clock.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rasterizer.hpp"
#include "rtl_rasterizer.hpp"
#include "stalls.hpp"

namespace halfspace {

// The first difference, in the order of clocks, then of stages.
struct Mismatch {
  std::string stage;         // accept, setup, level0 .. , coverage
  std::uint64_t packet = 0;  // count of packets at that handshake before this one
  std::uint64_t clock = 0;
  std::uint64_t triangle = 0;
  std::int32_t x = 0;  // node or tile, where there is one
  std::int32_t y = 0;
  std::string field;
  std::string model;
  std::string rtl;

  // "stage=... packet=... clock=... triangle=... tile=(x,y) field=... model=... rtl=..."
  std::string line() const;
};

struct CosimOptions {
  Stalls stalls;
  std::string trace;             // FST file; empty: none
  std::uint64_t trace_from = 0;  // clocks
  std::uint64_t trace_to = UINT64_MAX;
  std::function<void(std::uint64_t)> progress;  // triangles accepted so far, now and then
};

struct CosimResult {
  std::optional<Mismatch> mismatch;
  RasterStats stats;                   // of the model
  std::uint64_t clocks = 0;            // to the last packet
  std::uint64_t packets_compared = 0;  // at all handshakes
  std::uint64_t tiles_compared = 0;
  std::vector<std::uint64_t> busy;  // clocks with a handshake, per link
  double model_seconds = 0;
  double rtl_seconds = 0;
};

// Runs the triangles through both and stops at the first difference. The model runs ahead of the
// RTL by one triangle at most. A packet that does not come ends the run at the clock at which it
// was due, so a hang is a mismatch, not a wait.
CosimResult cosim(RtlRasterizer& rtl, std::span<const Triangle> triangles, const FrameState& frame,
                  const Config& config, const CosimOptions& options);

// The RTL alone: tiles in order. Throws std::runtime_error when nothing moves for 100,000 clocks.
struct RtlRun {
  std::uint64_t clocks = 0;
  double seconds = 0;
};
RtlRun run_rtl(RtlRasterizer& rtl, std::span<const Triangle> triangles, const FrameState& frame,
               const Stalls& stalls, const std::function<void(const CoverageTile&)>& tile);

// Runs several times with resets in the middle: before each of them, the RTL gets a part of the
// triangles and is reset while busy; then the whole stream must be identical.
CosimResult cosim_with_resets(RtlRasterizer& rtl, std::span<const Triangle> triangles,
                              const FrameState& frame, const Config& config,
                              const CosimOptions& options, int resets);

}  // namespace halfspace
