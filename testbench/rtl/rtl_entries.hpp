// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>

#include "config.hpp"
#include "rtl_rasterizer.hpp"

namespace halfspace {

// One configuration whose RTL is in this build.
struct RtlEntry {
  const char* name;
  Config config;
  std::unique_ptr<RtlRasterizer> (*make)();
};

// All of them; defined in a file that CMake generates (rtl_entries.cpp.in).
std::span<const RtlEntry> rtl_entries();

}  // namespace halfspace
