// SPDX-License-Identifier: Apache-2.0
#include "stats_json.hpp"

#include <cinttypes>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "config_json.hpp"

namespace halfspace {

// Not getrusage(): that still counts what the process was before exec().
std::uint64_t peak_memory_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    std::uint64_t kilobytes = 0;
    if (std::sscanf(line.c_str(), "VmHWM: %" SCNu64 " kB", &kilobytes) == 1) {
      return kilobytes * 1024;
    }
  }
  return 0;
}

namespace {

// Work that was not done, and that changes nothing of the picture.
nlohmann::ordered_json savings_json(const RunStats& stats) {
  const RasterStats& r = stats.raster;
  nlohmann::ordered_json json;
  json["triangles_before_traversal"] =
      r.triangles_zero_area + r.triangles_culled + r.triangles_no_sample;
  json["upper_nodes_skipped"] = r.upper_nodes_skipped;
  if (stats.tiles_touched != 0) {  // only with depth and colour
    json["fragments_not_shaded"] = r.fragments - r.fragments_shaded;
    json["tiles_without_storage"] = stats.tiles_in_frame - stats.tiles_touched;
  }
  return json;
}

nlohmann::ordered_json prediction_json(const RunStats::Prediction& p) {
  nlohmann::ordered_json rtl;
  rtl["available"] = p.rtl.available;
  rtl["windows"] = p.rtl.windows;
  rtl["clocks"] = p.rtl.clocks;
  rtl["packets"] = p.rtl.packets;
  if (p.rtl.available) rtl["identical"] = p.rtl.mismatch.empty();
  if (!p.rtl.mismatch.empty()) rtl["mismatch"] = p.rtl.mismatch;
  return {{"clocks", p.clocks},
          {"low", p.low},
          {"high", p.high},
          {"confidence", p.confidence},
          {"triangles_at_cycle", p.triangles_at_cycle},
          {"rtl", rtl}};
}

}  // namespace

nlohmann::ordered_json stats_json(const RunStats& stats, const Config& config) {
  const RasterStats& r = stats.raster;
  const GeometryStats& g = stats.geometry;
  nlohmann::ordered_json json;
  json["command"] = stats.command;
  json["level"] = stats.level;
  json["cases"] = stats.cases;
  json["triangles"] = g.triangles_in;
  json["triangles_culled"] = g.dropped_not_finite + g.outside + r.triangles_zero_area +
                             r.triangles_culled + r.triangles_no_sample;
  json["triangles_not_finite"] = g.dropped_not_finite;
  json["triangles_outside"] = g.outside;
  json["triangles_clipped"] = g.clipped;
  json["triangles_to_setup"] = r.triangles;
  json["triangles_zero_area"] = r.triangles_zero_area;
  json["triangles_face_culled"] = r.triangles_culled;
  json["triangles_no_sample"] = r.triangles_no_sample;
  json["tiles_visited"] = r.tiles_visited;
  json["tiles_covered"] = r.tiles_covered;
  json["tiles_touched"] = stats.tiles_touched;
  const int levels = config.levels();
  json["nodes_per_level"] =
      std::vector<std::uint64_t>(r.traversal.nodes.begin(), r.traversal.nodes.begin() + levels);
  json["samples_tested"] = r.samples_tested;
  json["samples_covered"] = r.samples_covered;
  json["fragments"] = r.fragments;
  json["fragments_shaded"] = r.fragments_shaded;
  if (stats.cycles) json["cycles"] = *stats.cycles;
  if (stats.predicted) json["cycles_predicted"] = prediction_json(*stats.predicted);
  json["savings"] = savings_json(stats);
  json["coordinates_resnapped"] = stats.resnapped;
  nlohmann::ordered_json left_out = nlohmann::ordered_json::object();
  for (const LeftOut::Kind& kind : stats.left_out.kinds()) left_out[kind.key] = kind.count;
  json["left_out"] = left_out;
  json["coverage_crc32"] = stats.crc;
  json["wall_seconds"] = stats.wall_seconds;
  json["simulate_seconds"] = stats.simulate_seconds;
  json["peak_memory_bytes"] = peak_memory_bytes();
  json["config"] = config_json(config);
  return json;
}

void write_stats(OutputFile& file, const RunStats& stats, const Config& config) {
  file.write(stats_json(stats, config).dump(2) + "\n");
}

}  // namespace halfspace
