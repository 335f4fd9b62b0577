// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <memory>

#include "cosim.hpp"
#include "entry.hpp"

namespace halfspace {

bool has_rtl() { return make_rtl_rasterizer(kBenchConfig) != nullptr; }

std::vector<BenchEntry> rtl_entries(const Workload& work) {
  const std::shared_ptr<RtlRasterizer> rtl = make_rtl_rasterizer(kBenchConfig);
  if (rtl == nullptr) return {};
  const auto run = [&work, rtl] {
    BenchOutput out;
    std::uint64_t tiles = 0;
    out.clocks = run_rtl(*rtl, work.triangles, work.frame, Stalls(), [&](const CoverageTile& tile) {
                   ++tiles;
                   out.samples += static_cast<std::uint64_t>(std::popcount(tile.mask[0]));
                 }).clocks;
    out.tiles = tiles;
    return out;
  };
  BenchRow row;
  row.work = "coverage";
  row.engine = "rtl";
  return {{row, [run] { run(); }, run}};
}

}  // namespace halfspace
