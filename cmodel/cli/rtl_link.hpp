// SPDX-License-Identifier: Apache-2.0
//
// The program's only door to the Verilated RTL: a build without Verilator has rtl_absent.cpp behind
// it instead of rtl_link.cpp.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "../config.hpp"
#include "../fit/replay.hpp"
#include "../io/trace.hpp"
#include "../packets.hpp"
#include "../stalls.hpp"

namespace halfspace {

// Throws Error(kLevel) when this build has no RTL of the configuration, naming what there is.
void require_rtl(const Config& config, const std::string& place);

// Level rtl: the triangles through the RTL, tiles in order. Returns the clocks it took. Throws
// Error(kInternal) when an assertion in the RTL fails or nothing moves.
std::uint64_t rasterize_rtl(std::span<const Triangle> triangles, const FrameState& frame,
                            const Config& config,
                            const std::function<void(const CoverageTile&)>& tile);

// Level rtl against level cycle (fit/replay.hpp): every packet at every handshake, in bits and
// clock, from reset, without stalls. Nothing when this build has no RTL of the configuration.
std::optional<RtlAgreement> compare_with_rtl(std::span<const Triangle> triangles,
                                             const FrameState& frame, const Config& config);

// The handshakes of level rtl (io/trace.hpp). Throws as rasterize_rtl().
TraceLog trace_rtl_level(std::span<const Triangle> triangles, const FrameState& frame,
                         const Config& config);

}  // namespace halfspace
