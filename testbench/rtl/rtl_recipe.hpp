// SPDX-License-Identifier: Apache-2.0
//
// What the shared object of a configuration's RTL is made of, and with: rtl_build.cpp's own.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "config.hpp"

namespace halfspace {

// An environment variable, or empty.
std::string variable(const char* name);

// The first line that a shell command prints; empty when it fails.
std::string first_line_of(const std::string& command);

struct RtlTools {
  std::string verilator;  // "Verilator 5.006 2023-01-22 ..."; empty: not there
  std::string compiler;   // first line of --version; empty: not there
  std::string command;    // what compiles

  // What is missing and the Debian package that has it; empty: nothing.
  std::string missing() const;
};
// Those of this process's PATH and CXX, looked for once.
const RtlTools& rtl_tools();

// The commands, for a shell in the folder of the build.
extern const char* const kVerilateCommand;  // the sources follow
extern const char* const kCompileCommands;  // $1 the compiler and its flags, $2 libraries

struct RtlRecipe {
  std::map<std::string, std::string> files;  // texts by their names in the folder of the build
  std::string sources;                       // for Verilator, in the order of compilation
};
// Throws Error, kLevel with `place` when the RTL is not there.
RtlRecipe rtl_recipe(const Config& config, const std::string& place);

// Differs when anything does that an object is made of.
std::uint64_t hash_of(const RtlRecipe& recipe, const RtlTools& tools);

}  // namespace halfspace
