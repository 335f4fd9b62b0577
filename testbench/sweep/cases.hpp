// SPDX-License-Identifier: Apache-2.0
//
// The cases of a sweep, numbered from 0 in the order of the specification: scenes, then sizes,
// views, and configurations fastest.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "specification.hpp"

namespace halfspace {

struct SweepCase {
  std::uint64_t number = 0;
  std::size_t scene = 0;
  std::size_t size = 0;  // 0 for a TCOV file, which has its own
  std::size_t view = 0;
  Config config;
};

class SweepCases {
 public:
  // Throws Error(kSpecification): more than kMostCases, or no legal configuration; what reading a
  // TCOV scene throws.
  explicit SweepCases(const SweepSpecification& specification);

  std::uint64_t count() const { return count_; }
  SweepCase at(std::uint64_t number) const;

  // Combinations that no case has, because they are illegal or hold no frame of a size: how many,
  // and the first few with the reason.
  std::uint64_t left_out() const { return left_out_; }
  const std::vector<std::string>& left_out_names() const { return left_out_names_; }

 private:
  using GridIndex = std::pair<std::uint32_t, std::uint32_t>;  // grid, index in it
  struct Block {
    std::uint64_t first = 0;
    std::size_t scene = 0;
    std::size_t size = 0;
    std::size_t list = 0;  // of lists_
  };

  void leave_out(std::size_t grid, const Config& config, const std::string& reason);
  void list_configs();

  const SweepSpecification& specification_;
  std::vector<std::vector<GridIndex>> lists_;  // legal configurations for each size, then for any
  std::vector<Block> blocks_;
  std::uint64_t count_ = 0;
  std::uint64_t left_out_ = 0;
  std::vector<std::string> left_out_names_;
};

}  // namespace halfspace
