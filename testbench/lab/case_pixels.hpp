// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "suites.hpp"

namespace halfspace::lab {

// One case of a suite drawn by one method.
struct CaseResult {
  std::uint64_t covered = 0;     // pixels with a hit in the true picture
  std::uint64_t wrong = 0;       // of the window
  std::uint64_t gaps = 0;        // kHits: with too few hits
  std::uint64_t doubles = 0;     // kHits: with too many
  std::uint64_t not_finite = 0;  // stored colours or depths that are NaN or infinite
  double greatest = 0;           // kAttribute: |error|, levels of 255
  bool hung = false;             // out of steps or time
  bool crashed = false;
  int signal = 0;  // that ended it

  double ppm() const;  // wrong per million covered; a million when it did not end
};

enum class Wrong : std::uint8_t { kNo, kGap, kExtra, kValue };

// The same pixel by pixel, row by row from the top of the case's window.
struct CasePixels {
  CaseResult result;
  std::vector<Wrong> wrong;
  std::vector<std::uint32_t> truth;  // hits
};

// Draws and judges in this process; steps are limited, time is not.
//
//   snapped_bits  -1, or what the truth's vertices are snapped to first
CasePixels case_pixels(const methods::Method& method, const Suite& suite, const SuiteCase& one,
                       int snapped_bits);

}  // namespace halfspace::lab
