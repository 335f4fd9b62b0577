// SPDX-License-Identifier: Apache-2.0
//
// The RTL of any legal configuration as a shared object (rtl_object.h): found in a cache, or built
// into it by Verilator and the C++ compiler from rtl/ and the configuration's package.
#pragma once

#include <filesystem>
#include <string>

#include "config.hpp"

namespace halfspace {

// Empty when objects can be built here, else what is missing and the Debian package that has it.
std::string rtl_tools_missing();

// The object's path. waves: one with an FST writer, which is a build of its own. A build takes some
// ten seconds of two cores, says so on stderr when that is a terminal, and leaves nothing behind
// when it is interrupted. Processes that want the same object build it once.
//
// The cache is $HALFSPACE_RTL_CACHE, or build/rtl of the source tree that the program is in, or
// $XDG_CACHE_HOME/halfspace/rtl. An object's name holds a hash of all that it is made of: RTL,
// configuration, rtl_object.*, versions of Verilator and the compiler ($CXX, or c++), flags. The
// RTL is that of the program's source tree or installation, or $HALFSPACE_RTL, a folder like rtl/.
//
// Throws Error: kLevel with `place` (a tool or the sources are not there), kRtlBuild (with the
// log's path), kFileWrite.
std::filesystem::path rtl_object_file(const Config& config, bool waves, const std::string& place);

}  // namespace halfspace
