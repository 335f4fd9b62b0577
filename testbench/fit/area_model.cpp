// SPDX-License-Identifier: Apache-2.0
#include "area_model.hpp"

namespace halfspace {
namespace {

// One hs_half_plane_grid of `side` lanes a side.
struct Grid {
  Grid(int side_log2, const Config& config) {
    const int half = 1 << (side_log2 - 1);
    const int side = 1 << side_log2;
    const int lane = config.lane_bits();
    const int delta = config.delta_bits();
    adders = 3 * (lane - (side_log2 - 1));     // where the quadrants start
    adders += (4 + side) * (half - 1) * lane;  // rows, then lanes of the half that turns
    adders += delta + 1 + (half == 4 ? 2 * (delta + 2) : 0);
    multiplexer = half > 1 ? side * lane : 0;
  }
  double adders = 0;
  double multiplexer = 0;
};

// Bits of a packet between levels whose edge values are cut to those of a node.
double packet_bits(int node_log2, const Config& config) {
  return 6 * config.viewport_bits + 3 * config.node_bits(node_log2) + 6 * config.delta_bits() +
         config.tag_bits;
}

void add_level(int level, const Config& config, AreaFeatures& out) {
  const int g = config.grid_log2;
  const int child = config.node_log2(level + 1);
  const int side_log2 = level == 0 ? config.viewport_bits - child : g;
  const Grid grid(side_log2, config);
  const int lane = config.lane_bits();
  const int delta = config.delta_bits();
  const int node = config.node_bits(child + g);
  const int q = config.sample_bits();
  const double step = (delta + 2) * side_log2 + (node - child - q + 1);
  out.pyramid_adders += 3 * (grid.adders + (lane + delta) + lane + step);
  out.multiplexer += 3 * (grid.multiplexer + (delta + 1) * side_log2 + config.node_bits(child));
  out.lanes += 1 << (2 * side_log2);
  const bool buffered = config.buffered(level);
  const double corners = 3 * (2 * delta + q);
  out.pyramid_state += (packet_bits(child + g, config) + corners) * (buffered ? 5 : 4);
  out.pyramid_state += 3 * (4 * lane + 4 * delta) + 6 * (delta + 1);
}

void add_coverage(const Config& config, AreaFeatures& out) {
  const Grid grid(config.grid_log2, config);
  const int m = config.samples;
  const int lane = config.lane_bits();
  const double packet = packet_bits(config.grid_log2, config);
  out.pyramid_adders += 3 * m * (grid.adders + (m > 1 ? 2 * (lane + config.sample_bits()) : 0));
  out.multiplexer += 3 * m * grid.multiplexer;
  out.lanes += m * config.lanes();
  out.pyramid_state += 2 * packet + 12 * m * lane + 9 * config.delta_bits() + m * config.lanes();
  if (m > 1) out.pyramid_state += packet + 3 * m * lane;
}

}  // namespace

AreaFeatures area_features(const Config& config) {
  AreaFeatures out;
  for (int level = 0; level + 1 < config.levels(); ++level) add_level(level, config, out);
  add_coverage(config, out);
  const int vertex = config.vertex_bits();
  const int delta = config.delta_bits();
  const int products = config.setup_interval == 1 ? 3 : 1;
  const double sums = 3 * vertex + config.constant_bits() + 2 * config.edge_full_bits();
  out.setup_adders = products * 2 * delta + 3 * sums + 6 * vertex + 6 * delta;
  out.setup_state = 30 * vertex + 3 * (config.constant_bits() + config.edge_full_bits() +
                                       config.node_bits(config.node_log2(0)) + 6 * delta);
  return out;
}

AreaEstimate area_estimate(const Config& config) {
  const AreaFeatures f = area_features(config);
  AreaEstimate out;
  // Least squares of relative errors over docs/charts/fit_area.json, by
  // testbench/synth/area_model.py.
  out.ccu2c = 0.4951 * f.pyramid_adders + 0.5104 * f.setup_adders;
  out.lut4 = 2.034 * f.multiplexer + 1484;
  out.flip_flops = 1.0004 * f.pyramid_state + 0.877 * f.setup_state + 5.593 * f.lanes;
  // A product takes one block per half of y up to 19 bits of x, else two.
  const int products = config.setup_interval == 1 ? 3 : 1;
  out.multipliers = products * (config.vertex_bits() <= 19 ? 4 : 8);
  return out;
}

}  // namespace halfspace
