// SPDX-License-Identifier: Apache-2.0
//
// netlist_vectors PRESET FOLDER: what a simulator without C++ needs to judge hs_rasterizer.
//
//   FOLDER/stimulus.hex   a line per clock for $readmemh: {rst_ni, ready_i, valid_i, frame_i,
//                         triangle_i}, padded with zeros to whole digits
//   FOLDER/expected.txt   what must change hands, from the cycle model: "accept CLOCK" and
//                         "tile CLOCK COVERAGE", COVERAGE as the packet's bits in hex digits
//   FOLDER/widths.txt     "NAME VALUE" lines: FRAME_BITS, TRIANGLE_BITS, COVERAGE_BITS, CLOCKS
//
// Several runs follow each other, each after a reset of one clock: every shape of triangle, every
// cull mode, frames of several sizes, with and without stalls; one run is cut by the reset of the
// next.
#include <cstdio>
#include <fstream>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "cycle_model.hpp"
#include "vectors/generators.hpp"
#include "vectors/layout.hpp"

namespace halfspace {
namespace {

struct Run {
  FrameState frame;
  Stalls stalls;
  std::uint64_t seed;
  std::uint64_t clocks;  // no triangle is added after this clock
  bool cut;              // ends in the middle, busy
};

constexpr std::uint64_t kLongest = 250;  // clocks a triangle may add: none fills a large frame

// One clock's inputs.
struct Inputs {
  bool reset = false;
  bool ready = false;
  const Triangle* triangle = nullptr;
};

// What the model says, in its order.
struct Events {
  std::vector<std::uint64_t> accepted;
  std::map<std::uint64_t, CoverageTile> tiles;
};
struct Listener {
  Events& events;
  void accepted(std::uint64_t clock) { events.accepted.push_back(clock); }
  void setup(std::uint64_t, const SetupTriangle&) {}
  void node(int, std::uint64_t, const Node&) {}
  void tile(std::uint64_t clock, const CoverageTile& tile) { events.tiles.emplace(clock, tile); }
};

// A packed struct in hex digits, padded with zeros to whole ones.
std::string hex(const Values& values, const Layout& layout) {
  const PortWords words = pack(values, layout);
  std::string out;
  for (int digit = (layout_bits(layout) + 3) / 4; digit-- > 0;) {
    out += "0123456789abcdef"[words[static_cast<std::size_t>(digit / 8)] >> digit % 8 * 4 & 15];
  }
  return out;
}

class Writer {
 public:
  Writer(const Config& config, const std::string& folder)
      : config_(config),
        stimulus_(folder + "/stimulus.hex"),
        expected_(folder + "/expected.txt"),
        widths_(folder + "/widths.txt") {}

  void write(const Run& run) {
    Random random(run.seed);
    std::vector<Triangle> triangles;
    Events events;
    CycleModel model(run.frame, config_, run.stalls);
    const auto add = [&](Triangle triangle) {
      triangle.tag = tag_ & tag_mask();
      CycleModel trial = model;
      Events outcome = events;
      trial.draw(triangle, Listener{outcome});
      if (trial.clocks() > model.clocks() + kLongest) return;
      model = trial;
      events = outcome;
      triangles.push_back(triangle);
      ++tag_;
    };
    for (std::size_t i = 0; model.clocks() < run.clocks; ++i) {
      add(random_triangle(random, kShapes[i % kShapes.size()], run.frame, config_));
    }
    // One that covers a pixel, in both windings: when its tile is out, all before it is done.
    const std::int32_t side = 2 << config_.subpixel_bits;
    add({.vertex = {Point{0, 0}, Point{side, 0}, Point{0, side}}, .tag = 0});
    add({.vertex = {Point{0, 0}, Point{0, side}, Point{side, 0}}, .tag = 0});
    // Long enough after the last packet for one that should not be there to come out.
    const std::uint64_t end = run.cut ? model.clocks() / 2 : model.clocks() + 50;
    put(run.frame, {.reset = true});  // one clock empties everything
    std::size_t next = 0;
    std::uint64_t offer = run.stalls.gap(0);
    for (std::uint64_t clock = 0; clock < end; ++clock) {
      const bool offered = next < triangles.size() && clock >= offer;
      const bool accepted = offered && clock == events.accepted[next];
      if (accepted) expected_ << "accept " << clocks_ << '\n';
      const auto tile = events.tiles.find(clock);
      if (tile != events.tiles.end()) {
        expected_ << "tile " << clocks_ << ' ' << packed(tile->second) << '\n';
      }
      put(run.frame, {.reset = false,
                      .ready = run.stalls.ready(clock),
                      .triangle = offered ? &triangles[next] : nullptr});
      if (accepted) {
        ++next;
        offer = clock + 1 + run.stalls.gap(next);
      }
    }
  }

  bool finish() {
    widths_ << "FRAME_BITS " << layout_bits(frame_layout(config_)) << "\nTRIANGLE_BITS "
            << layout_bits(triangle_layout(config_)) << "\nCOVERAGE_BITS "
            << layout_bits(coverage_layout(config_)) << "\nCLOCKS " << clocks_ << '\n';
    widths_.flush();
    stimulus_.flush();
    expected_.flush();
    return widths_.good() && stimulus_.good() && expected_.good();
  }

 private:
  std::uint32_t tag_mask() const {
    return config_.tag_bits == 32 ? ~0u : (1u << config_.tag_bits) - 1;
  }

  void put(const FrameState& frame, const Inputs& inputs) {
    Layout layout{{"rst_ni", 1, false}, {"ready_i", 1, false}, {"valid_i", 1, false}};
    Values values{inputs.reset ? 0 : 1, inputs.ready ? 1 : 0, inputs.triangle != nullptr ? 1 : 0};
    append(layout, frame_layout(config_));
    append(values, values_of(frame));
    const Layout triangle = triangle_layout(config_);
    append(layout, triangle);
    append(values, inputs.triangle != nullptr ? values_of(*inputs.triangle, config_)
                                              : Values(triangle.size(), 0));
    stimulus_ << hex(values, layout) << '\n';
    ++clocks_;
  }
  template <class List>
  static void append(List& to, const List& more) {
    to.insert(to.end(), more.begin(), more.end());
  }
  std::string packed(const CoverageTile& tile) const {
    return hex(values_of(tile, config_), coverage_layout(config_));
  }

  Config config_;
  std::ofstream stimulus_, expected_, widths_;
  std::uint64_t clocks_ = 0;
  std::uint32_t tag_ = 0;
};

int main_of(const std::string& preset, const std::string& folder) {
  const std::optional<Config> config = find_preset(preset);
  if (!config) {
    std::cerr << "netlist_vectors: no preset " << preset << '\n';
    return 2;
  }
  const int size = config->max_size();
  const std::vector<Run> runs{
      {{64, 48, Cull::kNone}, Stalls(), 1, 400, false},
      {{size, size, Cull::kBack}, Stalls(0.3, 2), 2, 400, true},
      {{33, 65, Cull::kFront}, Stalls(0.5, 3), 3, 600, false},
      {{1, 1, Cull::kNone}, Stalls(), 4, 60, false},
      {{size, size, Cull::kNone}, Stalls(0.2, 5), 5, 600, false},
  };
  Writer writer(*config, folder);
  for (const Run& run : runs) writer.write(run);
  if (!writer.finish()) {
    std::cerr << "netlist_vectors: cannot write to " << folder << '\n';
    return 2;
  }
  return 0;
}

}  // namespace
}  // namespace halfspace

int main(int count, char** arguments) {
  if (count != 3) {
    std::cerr << "usage: netlist_vectors PRESET FOLDER\n";
    return 2;
  }
  return halfspace::main_of(arguments[1], arguments[2]);
}
