// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace halfspace {

// Runs a program to its end: words[0] is its path, the others its arguments. It reads nothing, and
// writes where this process writes. It is in a process group of its own, so that Ctrl-C reaches it
// through this process alone, and is ended with this process (kill_on_interrupt).
// Returns its exit status, -1 when it could not be started or a signal ended it.
int run_child(std::vector<std::string> words);

}  // namespace halfspace
