// SPDX-License-Identifier: Apache-2.0
//
// The files of vector_bench(), with @NAME@ where a set's own values go: those of bench/, which
// CMake embeds.
#pragma once

namespace halfspace {

extern const char* const kBenchText;      // the bench, the same for every stage
extern const char* const kDutText;        // the design under test
extern const char* const kIcarusText;     // how Icarus Verilog runs both
extern const char* const kVerilatorText;  // and Verilator
extern const char* const kMakefileText;

}  // namespace halfspace
