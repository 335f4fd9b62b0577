// SPDX-License-Identifier: Apache-2.0
#include "progress.hpp"

#include <utility>

namespace halfspace {
namespace {

Progress::Observer& observer() {
  static Progress::Observer one;
  return one;
}

}  // namespace

Progress::Progress(std::string what, std::uint64_t total)
    : state_{std::move(what), 0, total, std::chrono::steady_clock::now()} {}

Progress::~Progress() {
  state_.finished = true;
  tell();
}

void Progress::observe(Observer new_observer) { observer() = std::move(new_observer); }

void Progress::tell() const {
  if (observer()) observer()(state_);
}

}  // namespace halfspace
