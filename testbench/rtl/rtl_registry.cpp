// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "rtl_configs.hpp"
#include "rtl_rasterizer.hpp"

namespace halfspace {

std::unique_ptr<RtlRasterizer> make_rtl_tiny();
std::unique_ptr<RtlRasterizer> make_rtl_full();
std::unique_ptr<RtlRasterizer> make_rtl_d3d();
std::unique_ptr<RtlRasterizer> make_rtl_msaa4();
std::unique_ptr<RtlRasterizer> make_rtl_interval3();
std::unique_ptr<RtlRasterizer> make_rtl_samples16();
std::unique_ptr<RtlRasterizer> make_rtl_one_level();

namespace {

struct Entry {
  const char* name;
  Config config;
  std::unique_ptr<RtlRasterizer> (*make)();
};
const std::array<Entry, 7> kEntries{{{"tiny", kTiny, make_rtl_tiny},
                                     {"full", kFull, make_rtl_full},
                                     {"d3d", kD3d, make_rtl_d3d},
                                     {"msaa4", kMsaa4, make_rtl_msaa4},
                                     {"interval3", kTestInterval3, make_rtl_interval3},
                                     {"samples16", kTestSamples16, make_rtl_samples16},
                                     {"one_level", kTestOneLevel, make_rtl_one_level}}};

bool same_rtl(const Config& a, const Config& b) {
  return a.subpixel_bits == b.subpixel_bits && a.viewport_bits == b.viewport_bits &&
         a.guard_bits == b.guard_bits && a.samples == b.samples && a.grid_log2 == b.grid_log2 &&
         a.setup_interval == b.setup_interval && a.tag_bits == b.tag_bits;
}

}  // namespace

std::unique_ptr<RtlRasterizer> make_rtl_rasterizer(const Config& config) {
  for (const Entry& entry : kEntries) {
    if (same_rtl(entry.config, config)) return entry.make();
  }
  return nullptr;
}

std::vector<std::string> rtl_configurations() {
  std::vector<std::string> names;
  for (const Entry& entry : kEntries) names.emplace_back(entry.name);
  return names;
}

}  // namespace halfspace
