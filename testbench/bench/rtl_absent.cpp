// SPDX-License-Identifier: Apache-2.0
//
// In place of rtl_entries.cpp in a build without Verilator.
#include "entry.hpp"

namespace halfspace {

bool has_rtl() { return false; }

std::vector<BenchEntry> rtl_entries(const Workload&) { return {}; }

}  // namespace halfspace
