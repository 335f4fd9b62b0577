// SPDX-License-Identifier: Apache-2.0
//
// Level cycle, fast: CycleModel's packets and clocks, many triangles at a time.
// How: docs/03_design/cycle_engine.md. Must equal: CycleModel (cycle_model.hpp).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "cycle_kernel.hpp"

namespace halfspace {

// Names of the instruction sets this machine can run, the best first; the last is "scalar".
std::vector<std::string_view> cycle_isas();

// Same packets and clocks as CycleModel for every configuration and stall pattern. Where the fast
// kernels do not reach (4x4 grids, lanes over 32 bits) it is CycleModel.
//
//   frame   as triangle_setup(); fixed for the life of the engine
//   config  any legal configuration
//   isa     one of cycle_isas(); empty: the best
//
// One engine per thread. Give it many triangles at a time: 64 are set up together.
class CycleEngine {
 public:
  CycleEngine(const FrameState& frame, const Config& config, const Stalls& stalls,
              std::string_view isa = {});

  // Calls sink(const CycleChunk&) with all packets of the triangles, in order. Nodes are left out
  // unless asked for: they cost the shortcuts past the upper levels.
  template <class Sink>
  void run(std::span<const Triangle> triangles, Sink&& sink, bool nodes = false) {
    using Plain = std::remove_reference_t<Sink>;
    state_.want_nodes = nodes;
    state_.sink = [](void* context, const CycleChunk& chunk) {
      (*static_cast<Plain*>(context))(chunk);
    };
    state_.context = const_cast<void*>(static_cast<const void*>(&sink));
    kernel_.run(state_, triangles);
  }

  // The same packet by packet, to the listener of CycleModel::draw() and in its order:
  //   accepted(clock), setup(clock, SetupTriangle), node(level, clock, Node),
  //   tile(clock, CoverageTile)
  // for each triangle. A listener says with constexpr static bools kWantsSetup and kWantsNodes
  // whether it has the second and the third; both are true when it does not say.
  template <class Listener>
  void draw(std::span<const Triangle> triangles, Listener&& listener);
  template <class Listener>
  void draw(const Triangle& triangle, Listener&& listener) {
    draw(std::span<const Triangle>(&triangle, 1), listener);
  }

  const RasterStats& stats() const { return state_.stats; }
  // As CycleModel::clocks().
  std::uint64_t clocks() const { return state_.clocks; }
  // Of the kernel in use: "scalar" when no other covers the configuration.
  std::string_view isa() const { return kernel_.isa; }

 private:
  cycle::State state_;
  cycle::CycleKernels kernel_;
};

namespace cycle {

template <class Listener>
constexpr bool wants_setup() {
  if constexpr (requires { Listener::kWantsSetup; }) return Listener::kWantsSetup;
  return true;
}
template <class Listener>
constexpr bool wants_nodes() {
  if constexpr (requires { Listener::kWantsNodes; }) return Listener::kWantsNodes;
  return true;
}

}  // namespace cycle

template <class Listener>
void CycleEngine::draw(std::span<const Triangle> triangles, Listener&& listener) {
  using Plain = std::remove_cvref_t<Listener>;
  constexpr bool kSetup = cycle::wants_setup<Plain>();
  constexpr bool kNodes = cycle::wants_nodes<Plain>();
  const auto deliver = [&](const CycleChunk& chunk) {
    const auto samples = static_cast<std::size_t>(chunk.samples);
    std::size_t tile = 0;
    [[maybe_unused]] std::size_t node = 0;
    for (const CycleTriangle& part : chunk.triangle) {
      const Triangle& triangle = triangles[part.index];
      if (!part.continued) {
        listener.accepted(part.accepted);
        if constexpr (kSetup) {
          if (part.outcome == SetupOutcome::kDrawn) {
            listener.setup(part.entered, *triangle_setup(triangle, state_.frame, state_.config));
          }
        }
      }
      CoverageTile out{0, 0, {}, triangle.tag};
      for (; tile < part.tile_end; ++tile) {
        if constexpr (kNodes) {
          for (; node < part.node_end && chunk.node[node].tile == tile; ++node) {
            listener.node(chunk.node[node].level, chunk.node[node].clock, chunk.node[node].node);
          }
        }
        out.x = chunk.x(tile);
        out.y = chunk.y(tile);
        for (std::size_t m = 0; m < samples; ++m) out.mask[m] = chunk.plane[m][tile];
        listener.tile(chunk.clock[tile], out);
      }
      if constexpr (kNodes) {
        for (; node < part.node_end; ++node) {
          listener.node(chunk.node[node].level, chunk.node[node].clock, chunk.node[node].node);
        }
      }
    }
  };
  run(triangles, deliver, kNodes);
}

}  // namespace halfspace
