// SPDX-License-Identifier: Apache-2.0
//
// A log in the words of two trace viewers.
#pragma once

#include <string>
#include <string_view>

#include "output_file.hpp"
#include "trace.hpp"

namespace halfspace {

// Whether write_trace() knows this name's extension: .json or .kanata.gz.
bool is_trace_file(std::string_view path);

// Writes the log, in the format that the extension of its name says (is_trace_file()).
//
//   .json       Chrome trace events, one clock a microsecond; a track per stage with the packets
//               in its last register. Slices of a track never overlap.
//   .kanata.gz  Kanata 0004: an operation per triangle (stages S, T0) and per leaf tile (T1 .., C);
//               lane 1: waiting, offered and not taken; dropped triangles and empty tiles flushed.
//
// Equal logs make equal bytes. Throws Error(kFileWrite).
void write_trace(OutputFile& file, const TraceLog& log);

// The model's log beside the RTL's: a.kanata.gz -> a.model.kanata.gz. path: is_trace_file().
std::string model_trace_path(const std::string& path);

// The two formats as text, before compression.
std::string chrome_trace(const TraceLog& log);
std::string kanata_trace(const TraceLog& log);

}  // namespace halfspace
