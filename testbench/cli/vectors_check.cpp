// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "io/error.hpp"
#include "vectors/vector_builder.hpp"
#include "vectors/vectors_file.hpp"
#include "vectors_command.hpp"

namespace halfspace {

int check_vector_files(const std::string& path) {
  const std::vector<PlacedVectors> sets = read_vectors(path);
  for (const PlacedVectors& placed : sets) {
    const std::optional<VectorDifference> difference = check_vectors(placed.set);
    if (difference) {
      fmt::print(stderr, "halfspace: mismatch: {}: record {}: {}\n", placed.place,
                 difference->record, difference->text);
      return 1;
    }
    const VectorCounts counts = count_records(placed.set);
    fmt::print("{}: {} of {}: {} runs, {} inputs, {} outputs as the model says\n", placed.place,
               stage_name(placed.set.meta.stage), placed.set.meta.program, counts.runs,
               counts.inputs, counts.outputs);
  }
  return 0;
}

}  // namespace halfspace
