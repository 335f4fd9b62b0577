// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <string>

namespace halfspace {

// Installs a handler for SIGINT and SIGTERM that prints one line, ends the processes of
// kill_on_interrupt(), removes what RemovedOnInterrupt names and ends this process with status 2;
// one for SIGABRT, which a failed check raises after its own line, does the same without a line.
// Called once, by main().
void handle_interrupts();

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

// A child to end when interrupted, so that it writes nothing after this process; 0: none. It leads
// a process group of its own, and all of that group is ended: by SIGTERM, so that a build tool can
// end what it started in other groups, and by SIGKILL two seconds later.
void kill_on_interrupt(pid_t child);

// From here on the line of an interrupt does not say that nothing was written.
void outputs_stay_on_interrupt();

}  // namespace halfspace
