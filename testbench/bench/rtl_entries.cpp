// SPDX-License-Identifier: Apache-2.0
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
