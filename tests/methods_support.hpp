// SPDX-License-Identifier: Apache-2.0
//
// What the tests of the gallery share: methods by name, and figures.
#pragma once

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "methods/arithmetic.hpp"
#include "methods/method_judge.hpp"
#include "vectors/reproducers.hpp"

namespace halfspace::methods {

// A name that is not there ends the test.
inline const Method& method(const std::string& name) {
  const Method* found = find(name);
  if (found == nullptr) throw std::runtime_error("no method " + name);
  return *found;
}

inline oracle::HitErrors errors_of(const std::string& name,
                                   const std::vector<oracle::Corners>& triangles,
                                   const oracle::Window& window) {
  return hit_errors(method(name), triangles, window);
}

inline constexpr oracle::Window kMegapixel{1024, 1024, 0, 0};

// measured is within a factor of two of the figure that docs/05_methods quotes.
inline void expect_about(double measured, double figure, const std::string& what) {
  EXPECT_GE(measured, figure / 2) << what;
  EXPECT_LE(measured, figure * 2) << what;
}

}  // namespace halfspace::methods
