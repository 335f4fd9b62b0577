// SPDX-License-Identifier: Apache-2.0
//
// What every subcommand does alike with its options and outputs.
#pragma once

#include <cstdio>
#include <initializer_list>
#include <string>

namespace halfspace {

// Says once that an option was given that changes nothing here.
void say_no_effect(const std::string& option, const std::string& why);

// Throws Error(kUsage) when the name of a picture says another format than PNG. A name without an
// extension says none.
void require_png_name(const std::string& path, const char* option);

// Where a command says what it did: standard output, or standard error when an output is "-".
std::FILE* talk(std::initializer_list<std::string> outputs);

}  // namespace halfspace
