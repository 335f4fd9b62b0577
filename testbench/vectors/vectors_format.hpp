// SPDX-License-Identifier: Apache-2.0
//
// Sets of vectors as the bytes of files. Formats: docs/02_use/vectors.md. The same set gives the
// same bytes on every machine.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "vector_set.hpp"

namespace halfspace {

enum class VectorFormat { kReadmemh, kCsv, kJsonLines, kBinary };

std::string vectors_to_csv(const VectorSet& set);
std::string vectors_to_json_lines(const VectorSet& set);
std::string vectors_to_binary(const VectorSet& set);

// Four files for $readmemh, a word a line.
struct HexFiles {
  std::string run, in, out;
  std::string ready;  // 32 clocks a word, clock 0 in bit 0: words as ready_words() says, run by run
};
HexFiles vectors_to_hex(const VectorSet& set);

// Words of HexFiles::ready that belong to a run; 0 without stalls. A bench takes them in turn, from
// the first again after the last.
std::size_t ready_words(const Values& run);

// The sets back, required by require_vectors(). Throw Error(kVectorsBroken) with the place.
VectorSet vectors_from_csv(const std::string& bytes, const std::string& place);
VectorSet vectors_from_json_lines(const std::string& bytes, const std::string& place);
VectorSet vectors_from_binary(const std::string& bytes, const std::string& place);
VectorSet vectors_from_hex(const HexFiles& files, const std::string& manifest,
                           const std::string& place);

}  // namespace halfspace
