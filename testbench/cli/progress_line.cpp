// SPDX-License-Identifier: Apache-2.0
#include "progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "scene/progress.hpp"

namespace halfspace {
namespace {

class ProgressLine {
 public:
  void operator()(const Progress::State& state) {
    if (state.finished) {
      if (shown_) fmt::print(stderr, "\r\033[K");
      shown_ = false;
      return;
    }
    const WallClock::time_point now = WallClock::now();
    const WallClock::time_point last = shown_ ? last_ : state.start;
    if (now - last < std::chrono::milliseconds(shown_ ? 100 : 500)) return;
    last_ = now;
    shown_ = true;
    const auto done = static_cast<double>(state.done);
    const double seconds = std::chrono::duration<double>(now - state.start).count();
    const double rate = done / std::max(seconds, 1e-9);
    const auto left = static_cast<double>(state.total - std::min(state.done, state.total));
    const auto total = static_cast<double>(std::max<std::uint64_t>(state.total, 1));
    fmt::print(stderr, "\r\033[K{}  {}/{}  {:.0f}%  {:.3g}/s  {:.1f} s left", state.what,
               state.done, state.total, 100.0 * done / total, rate, left / std::max(rate, 1e-9));
  }

 private:
  using WallClock = std::chrono::steady_clock;
  bool shown_ = false;
  WallClock::time_point last_;
};

}  // namespace

void show_progress() {
  if (::isatty(STDERR_FILENO) != 0) Progress::observe(ProgressLine());
}

}  // namespace halfspace
