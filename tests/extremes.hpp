// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>

#include "config.hpp"
#include "fixed.hpp"

namespace halfspace {

// The range of one value over an enumeration.
struct Extremes {
  std::int64_t least = 0;
  std::int64_t greatest = 0;
  void see(std::int64_t value) {
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
  bool fit(int bits) const { return fits(least, bits) && fits(greatest, bits); }
};

// The values fit `bits`, and not one bit less.
inline void expect_sharp(const Extremes& seen, int bits, const char* what, const Config& config) {
  const std::string told = std::string(what) + " " + std::to_string(seen.least) + ".." +
                           std::to_string(seen.greatest) + ": " + describe(config) +
                           " x=" + std::to_string(config.extent_bits);
  EXPECT_TRUE(seen.fit(bits)) << told;
  EXPECT_FALSE(seen.fit(bits - 1)) << told;
}

}  // namespace halfspace
