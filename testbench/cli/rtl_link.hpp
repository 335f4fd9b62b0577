// SPDX-License-Identifier: Apache-2.0
//
// What the program does with the Verilated RTL, which is built when it is asked for
// (testbench/rtl/rtl_build.hpp).
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "config.hpp"
#include "fit/replay.hpp"
#include "io/trace.hpp"
#include "packets.hpp"
#include "stalls.hpp"

namespace halfspace {

// Builds the RTL of the configuration if need be. Throws Error, kLevel when it cannot be built
// here.
void require_rtl(const Config& config, const std::string& place);

// Level rtl: the triangles through the RTL, tiles in order. Returns the clocks it took. Throws
// Error(kInternal) when an assertion in the RTL fails or nothing moves.
std::uint64_t rasterize_rtl(std::span<const Triangle> triangles, const FrameState& frame,
                            const Config& config,
                            const std::function<void(const CoverageTile&)>& tile);

// Level rtl against level cycle (fit/replay.hpp): every packet at every handshake, in bits and
// clock, from reset, without stalls. Nothing where no RTL can be built.
std::optional<RtlAgreement> compare_with_rtl(std::span<const Triangle> triangles,
                                             const FrameState& frame, const Config& config);

// The handshakes of level rtl (io/trace.hpp). Throws as rasterize_rtl().
TraceLog trace_rtl_level(std::span<const Triangle> triangles, const FrameState& frame,
                         const Config& config);

}  // namespace halfspace
