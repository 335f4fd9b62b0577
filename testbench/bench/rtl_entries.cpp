// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "entry.hpp"
#include "rtl/cosim.hpp"
#include "rtl/rtl_build.hpp"

namespace halfspace {

bool has_rtl() { return rtl_tools_missing().empty(); }

void build_bench_rtl() { rtl_object_file(kBenchConfig, false, "--engine rtl"); }

std::vector<BenchEntry> rtl_entries(const Workload& work) {
  if (!has_rtl()) return {};
  const auto rtl = std::make_shared<RtlRasterizer>(kBenchConfig, false, "--engine");
  const auto run = [&work, rtl] {
    BenchOutput out;
    MaskSum masks;
    out.clocks = run_rtl(*rtl, work.triangles, work.frame, Stalls(), [&](const CoverageTile& tile) {
                   masks.add(static_cast<std::uint32_t>(tile.x) / 8,
                             static_cast<std::uint32_t>(tile.y) / 8, tile.mask[0]);
                 }).clocks;
    out.samples = masks.samples;
    out.masks = masks;
    return out;
  };
  BenchRow row;
  row.work = "coverage";
  row.engine = "rtl";
  return {{row, [run] { run(); }, run}};
}

}  // namespace halfspace
