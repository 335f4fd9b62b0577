// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace halfspace {

// "drawing triangles  1200/3674  33%  1.2M/s  0.4 s left" on stderr, when that is a terminal and
// the work takes longer than half a second; silent otherwise. Erased when done.
class Progress {
 public:
  Progress(std::string what, std::uint64_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // Call as often as convenient; looks at the clock every 256 steps.
  void advance(std::uint64_t done_now = 1) {
    done_ += done_now;
    if (done_ < next_look_) return;
    next_look_ = done_ + 256;
    show();
  }
  // The same for steps that take long: looks at the clock at each.
  void step() {
    ++done_;
    show();
  }

 private:
  using Clock = std::chrono::steady_clock;
  void show();

  // The library's show() (capi/silent_progress.cpp) reads none of them.
  [[maybe_unused]] std::string what_;
  [[maybe_unused]] std::uint64_t total_;
  std::uint64_t done_ = 0;
  std::uint64_t next_look_ = 256;
  [[maybe_unused]] bool terminal_;
  [[maybe_unused]] bool shown_ = false;
  Clock::time_point start_ = Clock::now();
  [[maybe_unused]] Clock::time_point last_ = start_;
};

}  // namespace halfspace
