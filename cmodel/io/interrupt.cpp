// SPDX-License-Identifier: Apache-2.0
#include "interrupt.hpp"

#include <unistd.h>

#include <array>
#include <csignal>
#include <cstring>

namespace halfspace {
namespace {

// Fixed storage, because a handler may not allocate. `unfinished[0] == 0` means none.
std::array<char, 4096> unfinished{};

// A failed check has said its line already.
extern "C" void on_abort(int) {
  if (unfinished[0] != 0) ::unlink(unfinished.data());
  ::_exit(2);
}

extern "C" void on_interrupt(int) {
  static constexpr char kLine[] = "\nhalfspace: error[HS050]: interrupted; nothing was written\n";
  if (unfinished[0] != 0) ::unlink(unfinished.data());
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

void remove_on_interrupt(const std::string& path) {
  if (path.size() >= unfinished.size()) return;
  unfinished[0] = 0;
  std::memcpy(unfinished.data() + 1, path.c_str() + (path.empty() ? 0 : 1), path.size());
  unfinished[0] = path.empty() ? '\0' : path[0];
}

}  // namespace halfspace
