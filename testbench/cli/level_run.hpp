// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "command.hpp"
#include "engines/coverage/coverage_engine.hpp"
#include "engines/cycle/cycle_engine.hpp"
#include "io/stats_json.hpp"

namespace halfspace {

// One frame at any level: triangles in, covered tiles out, work counted. At levels bit, cycle and
// rtl tiles come in the order of the hardware.
class LevelRun {
 public:
  using Begin = std::function<void(const ShadedTriangle&, const SetupTriangle&)>;
  using Tile = std::function<void(const CoverageTile&)>;

  // begin: called before the tiles of each triangle that has any; may be empty. stats must outlive.
  LevelRun(Fidelity level, const FrameState& frame, const Config& config, RunStats& stats,
           Begin begin, Tile tile);

  // The next triangle. Its tiles come now; at levels coverage and cycle some triangles later, at
  // level rtl in finish().
  void draw(const ShadedTriangle& triangle);

  // After the last triangle: adds the frame's counts to the stats. simulate_seconds grows by what
  // finish() itself takes.
  void finish();

 private:
  void draw_bit(const ShadedTriangle& triangle);
  void flush();
  void flush_coverage();
  void finish_rtl();

  Fidelity level_;
  FrameState frame_;
  Config config_;
  RunStats& stats_;
  Begin begin_;
  Tile tile_;
  CoverageEngine coverage_;
  RasterStats covered_;  // level coverage
  CycleEngine cycle_;
  std::vector<ShadedTriangle> waiting_;  // levels coverage and cycle, a few, and rtl, all
};

}  // namespace halfspace
