// SPDX-License-Identifier: Apache-2.0
//
// Between the cycle engine and its kernels, one of which is compiled per instruction set.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "../../config.hpp"
#include "../../cycle_model.hpp"
#include "../../rasterizer.hpp"
#include "cycle_records.hpp"
#include "cycle_timing.hpp"

namespace halfspace::cycle {

// All that one rasterizer is and remembers between triangles.
struct State {
  State(const FrameState& frame_state, const Config& cfg, const Stalls& stalls)
      : config(cfg),
        frame(frame_state),
        timing(cfg, stalls),
        model(frame_state, cfg, stalls),
        buffer(cfg.samples) {}

  // Hands the chunk out and goes on with the open triangle in an empty one.
  void make_room() {
    if (!buffer.full()) return;
    buffer.close();
    const CycleTriangle open = buffer.triangle[buffer.triangles - 1];
    flush();
    buffer.triangle[0] = open;
    buffer.triangle[0].continued = true;
    buffer.triangles = 1;
  }
  void flush() {
    if (buffer.triangles != 0) sink(context, buffer.chunk(config.grid_log2));
    buffer.clear();
  }

  Config config;
  FrameState frame;
  CycleTiming timing;
  CycleModel model;  // of the scalar kernel, in the place of timing
  CycleBuffer buffer;
  RasterStats stats;
  std::uint64_t clocks = 0;
  bool want_nodes = false;
  void (*sink)(void* context, const CycleChunk& chunk) = nullptr;
  void* context = nullptr;
};

// Runs all triangles; the last chunk is handed out too.
using Kernel = void (*)(State& state, std::span<const Triangle> triangles);

// CycleModel: any configuration, any machine.
void run_scalar(State& state, std::span<const Triangle> triangles);

// What the other kernels cover.
constexpr bool is_fast(const Config& config) {
  return config.grid_log2 == 3 && config.lane_bits() <= 32;
}

struct CycleKernels {
  std::string_view isa;  // avx3 (AVX-512), avx2, sse4, ssse3, neon, emu128, scalar
  Kernel run;
};

// Kernels this machine can run, the best first; the last is run_scalar().
std::span<const CycleKernels> cycle_kernels();

}  // namespace halfspace::cycle
