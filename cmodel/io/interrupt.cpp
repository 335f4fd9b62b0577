// SPDX-License-Identifier: Apache-2.0
#include "interrupt.hpp"

#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstring>

namespace halfspace {
namespace {

// Fixed storage, because a handler may not allocate. A name that begins with 0 is none.
using Name = std::array<char, 4096>;
std::array<Name, 64> unfinished{};

void remove_unfinished() {
  for (const Name& name : unfinished) {
    if (name[0] != 0) ::unlink(name.data());
  }
}

// A failed check has said its line already.
extern "C" void on_abort(int) {
  remove_unfinished();
  ::_exit(2);
}

extern "C" void on_interrupt(int) {
  static constexpr char kLine[] = "\nhalfspace: error[HS050]: interrupted; nothing was written\n";
  remove_unfinished();
  [[maybe_unused]] const ssize_t written =
      ::write(STDERR_FILENO, kLine + (::isatty(2) ? 0 : 1), sizeof kLine - (::isatty(2) ? 1u : 2u));
  ::_exit(2);
}

}  // namespace

void handle_interrupts() {
  struct sigaction action {};
  ::sigemptyset(&action.sa_mask);
  action.sa_handler = on_interrupt;
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
  action.sa_handler = on_abort;
  ::sigaction(SIGABRT, &action, nullptr);
}

// The first byte is written last, or first when cleared: an interrupt sees a whole name or none.
void remove_on_interrupt(const std::string& path) {
  if (path.empty() || path.size() >= Name().size()) return;
  for (Name& name : unfinished) {
    if (name[0] != 0) continue;
    std::memcpy(name.data() + 1, path.c_str() + 1, path.size());
    std::atomic_signal_fence(std::memory_order_release);
    name[0] = path[0];
    return;
  }
}

void keep_on_interrupt(const std::string& path) {
  for (Name& name : unfinished) {
    if (path == name.data()) name[0] = 0;
  }
}

}  // namespace halfspace
