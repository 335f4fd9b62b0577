// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace halfspace {

// Installs a handler for SIGINT and SIGTERM that prints one line, removes the unfinished files
// named by remove_on_interrupt() and ends the process with status 2; one for SIGABRT, which a
// failed check raises after its own line, does the same without a line. Called once, by main().
void handle_interrupts();

// Names a file to remove when interrupted, until keep_on_interrupt() names it again. The first 64
// of at most 4095 bytes are; a further one keeps its temporary name. One thread calls these.
void remove_on_interrupt(const std::string& path);
void keep_on_interrupt(const std::string& path);

}  // namespace halfspace
