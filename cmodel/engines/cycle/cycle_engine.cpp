// SPDX-License-Identifier: Apache-2.0
#include "cycle_engine.hpp"

#include "../common/isas.hpp"

namespace halfspace {
namespace {

cycle::CycleKernels choose(const Config& config, std::string_view isa) {
  const auto all = cycle::cycle_kernels();
  return cycle::is_fast(config) ? simd::find_isa(all, isa) : all.back();
}

}  // namespace

std::vector<std::string_view> cycle_isas() { return simd::isas(cycle::cycle_kernels()); }

CycleEngine::CycleEngine(const FrameState& frame, const Config& config, const Stalls& stalls,
                         std::string_view isa)
    : state_(frame, config, stalls), kernel_(choose(config, isa)) {}

namespace cycle {
namespace {

// CycleModel's listener: packets into the buffer.
struct Collect {
  State& state;
  std::uint32_t index;

  void accepted(std::uint64_t clock) { state.buffer.open(index, clock); }
  void setup(std::uint64_t clock, const SetupTriangle&) {
    state.buffer.triangle[state.buffer.triangles - 1].entered = clock;
    drawn = true;
  }
  void node(int level, std::uint64_t clock, const Node& packet) {
    if (!state.want_nodes) return;
    state.make_room();
    state.buffer.node.push_back(
        {clock, static_cast<std::uint32_t>(state.buffer.tiles), level, packet});
  }
  void tile(std::uint64_t clock, const CoverageTile& packet) {
    state.make_room();
    CycleBuffer& to = state.buffer;
    to.clock[to.tiles] = clock;
    to.place[to.tiles] = cycle_place(packet.x, packet.y, state.config.grid_log2);
    for (std::size_t m = 0; m < static_cast<std::size_t>(to.samples); ++m) {
      to.masks[m * CycleBuffer::kStride + to.tiles] = packet.mask[m];
    }
    ++to.tiles;
  }

  bool drawn = false;
};

// Why a triangle was dropped, from what its drop changed.
SetupOutcome outcome_of(const RasterStats& before, const RasterStats& after) {
  if (after.triangles_zero_area != before.triangles_zero_area) return SetupOutcome::kZeroArea;
  if (after.triangles_culled != before.triangles_culled) return SetupOutcome::kCulled;
  return SetupOutcome::kNoSample;
}

}  // namespace

void run_scalar(State& state, std::span<const Triangle> triangles) {
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (state.buffer.full()) state.flush();
    const RasterStats before = state.model.stats();
    Collect collect{state, static_cast<std::uint32_t>(i)};
    state.model.draw(triangles[i], collect);
    if (!collect.drawn) {
      state.buffer.triangle[state.buffer.triangles - 1].outcome =
          outcome_of(before, state.model.stats());
    }
    state.buffer.close();
  }
  state.flush();
  state.stats = state.model.stats();
  state.clocks = state.model.clocks();
}

}  // namespace cycle
}  // namespace halfspace
