// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace halfspace {

// Installs a handler for SIGINT and SIGTERM that prints one line, removes the unfinished file named
// by remove_on_interrupt() and ends the process with status 2; one for SIGABRT, which a failed
// check raises after its own line, does the same without a line. Called once, by main().
void handle_interrupts();

// The file to remove when interrupted; empty for none. One at a time is enough: outputs are written
// one after the other.
void remove_on_interrupt(const std::string& path);

}  // namespace halfspace
