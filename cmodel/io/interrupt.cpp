// SPDX-License-Identifier: Apache-2.0
#include "interrupt.hpp"

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstring>
#include <string_view>

namespace halfspace {
namespace {

// Fixed storage, because a handler may not allocate.
enum class Slot { kFree, kTaken, kReady };
struct Unfinished {
  std::atomic<Slot> slot{Slot::kFree};
  bool tree = false;
  std::array<char, 4096> path{};
};
static_assert(std::atomic<Slot>::is_always_lock_free && std::atomic<pid_t>::is_always_lock_free);
std::array<Unfinished, 64> unfinished;
std::atomic<pid_t> child_to_kill{0};
std::atomic<bool> outputs_stay{false};

// How many InterruptsHeld live; kEnding once the process is being ended by a handler.
constexpr int kEnding = -1;
std::atomic<int> holds{0};
std::atomic<int> waiting_signal{0};
static_assert(std::atomic<int>::is_always_lock_free);

void end_group(pid_t leader) {
  ::kill(-leader, SIGTERM);
  for (int i = 0; i < 200 && ::kill(-leader, 0) == 0; ++i) {
    ::waitpid(leader, nullptr, WNOHANG);  // one that is not waited for counts as there
    ::poll(nullptr, 0, 10);
  }
  ::kill(-leader, SIGKILL);
  ::waitpid(leader, nullptr, 0);
}

// By another program: a handler may not read folders.
void remove_tree(const char* path) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::execl("/bin/rm", "rm", "-rf", "--", path, nullptr);
    ::_exit(127);
  }
  if (child > 0) ::waitpid(child, nullptr, 0);
}

void clean_up() {
  if (const pid_t child = child_to_kill; child > 0) end_group(child);
  for (std::size_t i = unfinished.size(); i-- > 0;) {
    if (unfinished[i].slot != Slot::kReady) continue;
    const char* path = unfinished[i].path.data();
    if (unfinished[i].tree) {
      remove_tree(path);
    } else if (::unlink(path) != 0) {
      ::rmdir(path);
    }
  }
}

// A failed check has said its line already.
extern "C" void on_abort(int) {
  clean_up();
  ::_exit(2);
}

[[noreturn]] void wait_for_the_end() {
  for (;;) ::pause();
}

[[noreturn]] void end_interrupted() {
  const char* line = outputs_stay
                         ? "\nhalfspace: error[HS050]: interrupted; what was written before stays\n"
                         : "\nhalfspace: error[HS050]: interrupted; nothing was written\n";
  clean_up();
  if (!::isatty(STDERR_FILENO)) ++line;
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, line, std::strlen(line));
  ::_exit(2);
}

// True: this thread is to end the process. False: the one that holds interrupts is.
bool begin_to_end(int signal) {
  for (;;) {
    int none = 0;
    if (holds.compare_exchange_strong(none, kEnding)) return true;
    if (none == kEnding) wait_for_the_end();  // another thread's handler is at work
    waiting_signal = signal;
    if (holds > 0) return false;  // its last holder sees the signal; else the hold ended meanwhile
  }
}

extern "C" void on_interrupt(int signal) {
  if (begin_to_end(signal)) end_interrupted();
}

// What reads the output wants no more: the usual, silent end, but nothing stays behind.
[[noreturn]] void end_by_pipe() {
  clean_up();
  std::signal(SIGPIPE, SIG_DFL);
  ::raise(SIGPIPE);
  sigset_t pipe;
  ::sigemptyset(&pipe);
  ::sigaddset(&pipe, SIGPIPE);
  ::pthread_sigmask(SIG_UNBLOCK, &pipe, nullptr);
  ::_exit(2);
}

extern "C" void on_pipe(int signal) {
  if (begin_to_end(signal)) end_by_pipe();
}

constexpr std::array kInterrupts{SIGINT, SIGTERM, SIGHUP};

}  // namespace

void handle_interrupts() {
  struct sigaction action = {};
  ::sigfillset(&action.sa_mask);
  action.sa_flags = SA_RESTART;  // an interrupt that waits disturbs no read or write
  action.sa_handler = on_interrupt;
  for (const int number : kInterrupts) {
    struct sigaction before = {};
    ::sigaction(number, nullptr, &before);
    if (number != SIGHUP || before.sa_handler != SIG_IGN) ::sigaction(number, &action, nullptr);
  }
  action.sa_handler = on_pipe;
  ::sigaction(SIGPIPE, &action, nullptr);
  action.sa_handler = on_abort;
  ::sigaction(SIGABRT, &action, nullptr);
  std::signal(SIGXFSZ, SIG_IGN);
}

void leave_interrupts() {
  for (const int number : kInterrupts) std::signal(number, SIG_DFL);
  for (const int number : {SIGABRT, SIGPIPE, SIGXFSZ}) std::signal(number, SIG_DFL);
}

InterruptsHeld::InterruptsHeld() {
  for (int now = holds;;) {
    if (now == kEnding) wait_for_the_end();
    if (holds.compare_exchange_weak(now, now + 1)) return;
  }
}

InterruptsHeld::~InterruptsHeld() {
  if (--holds > 0 || waiting_signal == 0) return;
  const int signal = waiting_signal;
  if (begin_to_end(signal)) signal == SIGPIPE ? end_by_pipe() : end_interrupted();
}

RemovedOnInterrupt::RemovedOnInterrupt(const std::string& path, Kind kind)
    : slot_(unfinished.size()) {
  if (path.empty() || path.size() >= unfinished[0].path.size()) return;
  // After the newest, so that a folder's files go before it.
  std::size_t next = unfinished.size();
  while (next > 0 && unfinished[next - 1].slot == Slot::kFree) --next;
  for (; next < unfinished.size(); ++next) {
    Slot expected = Slot::kFree;
    if (!unfinished[next].slot.compare_exchange_strong(expected, Slot::kTaken)) continue;
    std::memcpy(unfinished[next].path.data(), path.c_str(), path.size() + 1);
    unfinished[next].tree = kind == Kind::kTree;
    unfinished[next].slot = Slot::kReady;
    slot_ = next;
    return;
  }
}

RemovedOnInterrupt::~RemovedOnInterrupt() {
  if (slot_ < unfinished.size()) unfinished[slot_].slot = Slot::kFree;
}

bool is_removed_on_interrupt(const std::string& path) {
  return std::any_of(unfinished.begin(), unfinished.end(), [&](const Unfinished& one) {
    if (one.slot != Slot::kReady) return false;
    const std::string_view removed = one.path.data();
    return path == removed || (one.tree && path.size() > removed.size() &&
                               path.starts_with(removed) && path[removed.size()] == '/');
  });
}

void kill_on_interrupt(pid_t child) { child_to_kill = child; }

void outputs_stay_on_interrupt() { outputs_stay = true; }

}  // namespace halfspace
