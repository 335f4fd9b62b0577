// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <string>

namespace halfspace {

// Installs a handler for SIGINT, SIGTERM and SIGHUP (unless that is ignored, as by nohup) that
// prints one line, ends the processes of kill_on_interrupt(), removes what RemovedOnInterrupt names
// and ends this process with status 2; one for SIGABRT, which a failed check raises after its own
// line, does the same without a line, and one for SIGPIPE lets the signal end the process then.
// SIGXFSZ is ignored: a file beyond the limit is one that cannot be written. Called once, by
// main().
void handle_interrupts();

// While one lives, an interrupt waits: for a step that must be whole or not begun, such as making a
// file and registering it, or putting several in place. Then it takes place as ever. One thread at
// a time; in each other. Short: a user waits for it.
class InterruptsHeld {
 public:
  InterruptsHeld();
  ~InterruptsHeld();
  InterruptsHeld(const InterruptsHeld&) = delete;
  InterruptsHeld& operator=(const InterruptsHeld&) = delete;
};

// The default again, for a child process: what it leaves is its parent's to remove.
void leave_interrupts();

// A file, or a folder, to be removed when interrupted while this object lives; the newest goes
// first. Up to 64 at a time, more are not removed. Any thread.
class RemovedOnInterrupt {
 public:
  // A folder must be empty by then, or be kTree, which goes with all that is in it.
  enum class Kind { kFileOrEmptyFolder, kTree };
  explicit RemovedOnInterrupt(const std::string& path, Kind kind = Kind::kFileOrEmptyFolder);
  ~RemovedOnInterrupt();
  RemovedOnInterrupt(const RemovedOnInterrupt&) = delete;
  RemovedOnInterrupt& operator=(const RemovedOnInterrupt&) = delete;

 private:
  std::size_t slot_;
};

// Whether a file of that name is removed when interrupted: by its own name or in a tree.
bool is_removed_on_interrupt(const std::string& path);

// A child to end when interrupted, so that it writes nothing after this process; 0: none. It leads
// a process group of its own, and all of that group is ended: by SIGTERM, so that a build tool can
// end what it started in other groups, and by SIGKILL two seconds later.
void kill_on_interrupt(pid_t child);

// From here on the line of an interrupt does not say that nothing was written.
void outputs_stay_on_interrupt();

}  // namespace halfspace
