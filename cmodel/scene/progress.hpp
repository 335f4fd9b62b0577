// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

namespace halfspace {

// How far some work is. Nothing is shown unless somebody observes: a library's caller has a
// terminal of his own.
class Progress {
 public:
  struct State {
    std::string what;
    std::uint64_t done = 0;
    std::uint64_t total = 0;
    std::chrono::steady_clock::time_point start;
    bool finished = false;
  };
  using Observer = std::function<void(const State&)>;

  Progress(std::string what, std::uint64_t total);
  ~Progress();  // tells the observer that the work is finished
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // Call as often as convenient; the observer hears of every 256th step.
  void advance(std::uint64_t done_now = 1) {
    state_.done += done_now;
    if (state_.done < next_tell_) return;
    next_tell_ = state_.done + 256;
    tell();
  }
  // The same for steps that take long: the observer hears of each.
  void step() {
    ++state_.done;
    tell();
  }

  // Who hears of all work from now on; one for the whole process, from main() before any thread.
  static void observe(Observer observer);

 private:
  void tell() const;

  State state_;
  std::uint64_t next_tell_ = 256;
};

}  // namespace halfspace
