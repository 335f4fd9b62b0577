// SPDX-License-Identifier: Apache-2.0
#include "cycle_model.hpp"
#include "fit.hpp"

namespace halfspace {
namespace {

// Sees every packet as it enters the first register of a level.
struct Entering {
  const Timing& timing;
  std::vector<FifoUse>& fifo;  // one a level, buffered or not

  void accepted(Timing::Clock) const {}
  void setup(Timing::Clock clock, const SetupTriangle&) const { enters(0, clock); }
  void node(int level, Timing::Clock clock, const Node&) const { enters(level, clock); }
  void tile(Timing::Clock, const CoverageTile&) const {}

  // The packet before it, followed to its end by now, left the register in clock left().
  void enters(int level, Timing::Clock clock) const {
    FifoUse& use = fifo[static_cast<std::size_t>(level)];
    ++use.packets;
    const Timing::Clock left = timing.left(level);
    if (left <= clock) return;
    ++use.waited;
    use.both_clocks += left - clock;
  }
};

}  // namespace

FifoUses fifo_uses(const std::vector<FitView>& views, const Config& config) {
  std::vector<FifoUse> all(static_cast<std::size_t>(config.levels()));
  FifoUses out;
  for (const FitView& view : views) {
    CycleModel model(view.frame, config, Stalls());
    const Entering entering{model.timing(), all};
    RunStats unused;
    view.scene->draw(view.index, view.frame, config, unused, [&](const ShadedTriangle& triangle) {
      model.draw(triangle.triangle, entering);
    });
    out.clocks += model.clocks();
  }
  for (int level = 0; level < config.levels(); ++level) {
    if (!config.buffered(level)) continue;
    out.fifo.push_back(all[static_cast<std::size_t>(level)]);
    out.fifo.back().level = level;
  }
  return out;
}

}  // namespace halfspace
