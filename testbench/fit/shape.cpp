// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "engines/cycle/cycle_engine.hpp"
#include "fit.hpp"
#include "io/error.hpp"

namespace halfspace {
namespace {

// Wants clocks only.
struct Nothing {
  static constexpr bool kWantsSetup = false;
  static constexpr bool kWantsNodes = false;
  void accepted(Timing::Clock) const {}
  void setup(Timing::Clock, const SetupTriangle&) const {}
  void node(int, Timing::Clock, const Node&) const {}
  void tile(Timing::Clock, const CoverageTile&) const {}
};

void run_view(const FitView& view, const Config& config, FitShape& shape) {
  constexpr std::size_t kTogether = 1024;
  CycleEngine engine(view.frame, config, Stalls());
  std::vector<Triangle> waiting;
  const auto flush = [&] {
    engine.draw(waiting, Nothing{});
    waiting.clear();
  };
  RunStats unused;
  view.scene->draw(view.index, view.frame, config, unused, [&](const ShadedTriangle& triangle) {
    waiting.push_back(triangle.triangle);
    if (waiting.size() == kTogether) flush();
  });
  flush();
  shape.clocks += engine.clocks();
  shape.worst_clocks = std::max(shape.worst_clocks, engine.clocks());
  shape.fragments += engine.stats().fragments;
}

bool meets(const FitShape& shape, const std::optional<FitTarget>& target) {
  if (!target) return true;
  if (target->pixels_per_clock > 0) return shape.pixels_per_clock() >= target->pixels_per_clock;
  return target->megahertz * 1e6 >=
         target->frames_per_second * static_cast<double>(shape.worst_clocks);
}

}  // namespace

double FitShape::pixels_per_clock() const {
  return clocks == 0 ? 0.0 : static_cast<double>(fragments) / static_cast<double>(clocks);
}

FitTarget parse_target(const std::string& text) {
  FitTarget target;
  std::istringstream stream(text);
  std::string unit;
  double first = 0;
  stream >> first >> unit;
  const std::string at = unit.substr(0, 4);
  bool good = !stream.fail() && first > 0 && std::isfinite(first);
  if (unit == "px/clk") {
    target.pixels_per_clock = first;
  } else if (good && at == "fps@") {
    std::istringstream rest(unit.substr(4));
    std::string mhz;
    good =
        static_cast<bool>(rest >> target.megahertz >> mhz) && mhz == "MHz" && target.megahertz > 0;
    target.frames_per_second = first;
  } else {
    good = false;
  }
  if (!good) {
    throw Error(ErrorCode::kUsage, "--throughput",
                fmt::format("'{:.40}' is not a number of px/clk or N fps@M MHz, such as 2.5px/clk "
                            "or 60fps@100MHz",
                            text));
  }
  return target;
}

std::vector<FitShape> fit_shapes(const std::vector<FitView>& views, const Config& config,
                                 const std::optional<FitTarget>& target) {
  std::vector<FitShape> shapes;
  for (const int grid_log2 : {2, 3}) {
    for (const int interval : {1, 3}) {
      FitShape shape;
      shape.grid_log2 = grid_log2;
      shape.setup_interval = interval;
      Config shaped = config;
      shaped.grid_log2 = grid_log2;
      shaped.setup_interval = interval;
      for (const FitView& view : views) run_view(view, shaped, shape);
      shape.area = area_estimate(shaped);
      shape.meets = meets(shape, target);
      shapes.push_back(shape);
    }
  }
  std::stable_sort(shapes.begin(), shapes.end(), [](const FitShape& a, const FitShape& b) {
    return a.area.luts() < b.area.luts();
  });
  return shapes;
}

}  // namespace halfspace
