// SPDX-License-Identifier: Apache-2.0
#include "rtl_entries.hpp"
#include "rtl_rasterizer.hpp"

namespace halfspace {
namespace {

bool same_rtl(const Config& a, const Config& b) {
  return a.subpixel_bits == b.subpixel_bits && a.viewport_bits == b.viewport_bits &&
         a.guard_bits == b.guard_bits && a.extent_bits == b.extent_bits && a.samples == b.samples &&
         a.grid_log2 == b.grid_log2 && a.setup_interval == b.setup_interval &&
         a.tag_bits == b.tag_bits;
}

}  // namespace

std::unique_ptr<RtlRasterizer> make_rtl_rasterizer(const Config& config) {
  for (const RtlEntry& entry : rtl_entries()) {
    if (same_rtl(entry.config, config)) return entry.make();
  }
  return nullptr;
}

std::vector<std::string> rtl_configurations() {
  std::vector<std::string> names;
  for (const RtlEntry& entry : rtl_entries()) names.emplace_back(entry.name);
  return names;
}

}  // namespace halfspace
