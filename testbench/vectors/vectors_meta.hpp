// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "vector_set.hpp"

namespace halfspace {

inline constexpr int kVectorVersion = 1;  // of every format; raised when a reader must know

// What every file of vectors says of itself: version, program, stage, configuration, seed, source,
// counts and the layout of each kind of record.
nlohmann::ordered_json vector_meta_json(const VectorSet& set);

// JSON of a header, a manifest or a record. Throws Error(kVectorsBroken).
nlohmann::json parse_vector_json(std::string_view text, const std::string& place);

// The same read back, with the counts promised. Throws Error(kVectorsBroken): not an object, a
// missing or wrong field, another version, a layout that is not this program's.
struct VectorHeader {
  VectorMeta meta;
  VectorCounts counts;
};
VectorHeader parse_vector_meta(const nlohmann::json& json, const std::string& place);
VectorHeader parse_vector_meta(const std::string& text, const std::string& place);

// Throws Error(kVectorsBroken) when the set does not hold what its header promises or its records
// are out of order, Error(kVectorsEmpty) when it has no input or no output, and
// Error(kVectorInput) when a stage must not be given some input.
void require_vectors(const VectorSet& set, const VectorCounts& promised, const std::string& place);

// Reads a value of a field: decimal, or 0x and hexadecimal. Throws Error(kVectorsBroken) when it is
// neither or does not fit the field.
std::int64_t parse_field(std::string_view text, const PortField& field, const std::string& place);

}  // namespace halfspace
