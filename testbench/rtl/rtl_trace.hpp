// SPDX-License-Identifier: Apache-2.0
//
// The RTL's handshakes into a trace log, the same as trace_model() keeps of level cycle.
#pragma once

#include <span>

#include "io/trace.hpp"
#include "rtl_rasterizer.hpp"

namespace halfspace {

// After RtlRasterizer::drive(): the packets that change hands at the coming edge, number `clock`.
void record_handshakes(const RtlRasterizer& rtl, std::uint64_t clock, TraceLog& log);

// The run of the RTL alone, whole. Throws std::runtime_error when nothing moves for 100,000 clocks.
TraceLog trace_rtl(RtlRasterizer& rtl, std::span<const Triangle> triangles, const FrameState& frame,
                   const Stalls& stalls);

}  // namespace halfspace
