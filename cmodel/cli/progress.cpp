// SPDX-License-Identifier: Apache-2.0
#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

namespace halfspace {

Progress::Progress(std::string what, std::uint64_t total)
    : what_(std::move(what)), total_(total), terminal_(::isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (shown_) fmt::print(stderr, "\r\033[K");
}

void Progress::show() {
  if (!terminal_) return;
  const Clock::time_point now = Clock::now();
  if (now - last_ < std::chrono::milliseconds(shown_ ? 100 : 500)) return;
  last_ = now;
  shown_ = true;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const double rate = static_cast<double>(done_) / std::max(seconds, 1e-9);
  const double left = static_cast<double>(total_ - std::min(done_, total_)) / std::max(rate, 1e-9);
  fmt::print(
      stderr, "\r\033[K{}  {}/{}  {:.0f}%  {:.3g}/s  {:.1f} s left", what_, done_, total_,
      100.0 * static_cast<double>(done_) / static_cast<double>(std::max<std::uint64_t>(total_, 1)),
      rate, left);
}

}  // namespace halfspace
