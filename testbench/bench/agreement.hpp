// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "entry.hpp"

namespace halfspace {

// What every engine must find on one workload. What the plain loop does not know, the first to know
// says.
class Agreement {
 public:
  // masks: what the plain loop covers. Throws BenchMismatch when that is nothing.
  Agreement(const std::string& workload, const MaskSum& masks);

  // Throws BenchMismatch when the output differs from what is known: in samples, masks, clocks,
  // hits per pixel or picture. A picture of llvmpipe may: the row gets how much (pixels_off,
  // largest_difference), and only more than 1 % of pixels more than one level off throw. The row
  // also gets covered_samples and clocks.
  void check(BenchRow& row, const BenchOutput& output);

  double tiles() const { return static_cast<double>(masks_.tiles); }

 private:
  void compare(BenchRow& row, const Image& picture);

  MaskSum masks_;
  std::optional<std::uint64_t> clocks_;
  std::optional<std::vector<std::uint8_t>> hits_;
  std::optional<Image> picture_;
};

}  // namespace halfspace
