// SPDX-License-Identifier: Apache-2.0
//
// In place of llvmpipe.cpp where OSMesa's headers are not installed.
#include "entry.hpp"

namespace halfspace {

std::string no_llvmpipe() {
  return "this build has no llvmpipe (install libosmesa6-dev and configure again)";
}

std::vector<BenchEntry> llvmpipe_coverage_entries(const Workload&) { return {}; }
std::vector<BenchEntry> llvmpipe_frame_entries(const Workload&) { return {}; }

}  // namespace halfspace
