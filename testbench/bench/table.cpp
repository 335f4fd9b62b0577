// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>

#include "bench.hpp"

namespace halfspace {
namespace {

// The engine whose time is divided by a row's.
std::string yardstick(const BenchRow& row) {
  if (row.work == "frame") return "llvmpipe";
  return row.engine == "cycle" || row.engine == "rtl" ? "rtl" : "scalar";
}

std::string key(const BenchRow& row, const std::string& engine) {
  return row.workload + ' ' + row.size + ' ' + row.work + ' ' + engine;
}

}  // namespace

std::string bench_table(const Machine& machine, const std::vector<BenchRow>& rows) {
  std::map<std::string, double> median;
  for (const BenchRow& row : rows) median.emplace(key(row, row.engine), row.median);
  const auto ratio = [&](const BenchRow& row, const std::string& engine) {
    const auto found = median.find(key(row, engine));
    return found == median.end() ? std::string("-")
                                 : fmt::format("{:.2f}", found->second / row.median);
  };
  std::string table = machine_line(machine) + '\n';
  table += fmt::format(
      "{:<11}{:<10}{:<9}{:<9}{:<8}{:>4}{:>7}{:>14}{:>14}{:>14}{:>9}{:>10}{:>10}{:>20}{:>12}\n",
      "workload", "size", "work", "engine", "isa", "thr", "time", "ns/triangle", "min", "max",
      "Mpx/s", "Mtiles/s", "Mclk/s", "times faster than", "x llvmpipe");
  for (const BenchRow& row : rows) {
    const double clocks = static_cast<double>(row.clocks.value_or(0));
    const double total = row.median * static_cast<double>(row.triangles);
    table += fmt::format(
        "{:<11}{:<10}{:<9}{:<9}{:<8}{:>4}{:>7}{:>14.2f}{:>14.2f}{:>14.2f}{:>9.0f}{:>10.2f}{:>10}"
        "{:>20}{:>12}\n",
        row.workload, row.size, row.work, row.engine, row.isa, row.threads, row.time, row.median,
        row.min, row.max, row.mpixels_per_s, row.tiles_per_s / 1e6,
        row.clocks ? fmt::format("{:.3f}", 1e3 * clocks / total) : "-",
        yardstick(row) + ' ' + ratio(row, yardstick(row)), ratio(row, "llvmpipe"));
  }
  return table;
}

std::string bench_json(const Machine& machine, const std::vector<BenchRow>& rows) {
  const nlohmann::ordered_json told{
      {"vendor", machine.vendor},     {"processor", machine.processor},
      {"family", machine.family},     {"model", machine.model},
      {"isa", machine.isa},           {"vector_bits", machine.vector_bits},
      {"l2_bytes", machine.l2_bytes}, {"l3_bytes", machine.l3_bytes},
      {"cores", machine.cores},       {"clock_ghz", machine.clock_ghz},
      {"load", machine.load}};
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const BenchRow& row : rows) {
    nlohmann::ordered_json out{{"workload", row.workload},
                               {"engine", row.engine},
                               {"isa", row.isa},
                               {"threads", row.threads},
                               {"ns_per_triangle", row.ns_per_triangle},
                               {"mpixels_per_s", row.mpixels_per_s},
                               {"tiles_per_s", row.tiles_per_s},
                               {"covered_samples", row.covered_samples},
                               {"repetitions", row.repetitions},
                               {"min", row.min},
                               {"median", row.median},
                               {"max", row.max},
                               {"size", row.size},
                               {"work", row.work},
                               {"triangles", row.triangles},
                               {"time", row.time}};
    out["machine"] = told;
    if (row.clocks) out["clocks"] = *row.clocks;
    if (row.pixels_off) out["pixels_off"] = *row.pixels_off;
    if (row.largest_difference) out["largest_difference"] = *row.largest_difference;
    list.push_back(std::move(out));
  }
  return list.dump(1) + "\n";
}

}  // namespace halfspace
