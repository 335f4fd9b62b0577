// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "vectors_file.hpp"

namespace halfspace {

// A self-checking SystemVerilog bench for a set: everything but the RTL. Files: hs_vectors_tb.sv,
// hs_vectors_dut.sv (the only place that names the DUT), hs_config_pkg.sv, vectors.*.hex,
// manifest.json, run_icarus.sh, run_verilator.sh and a Makefile. The stage has RTL (has_rtl()).
// What the bench checks: docs/02_use/vectors.md.
std::vector<NamedBytes> vector_bench(const VectorSet& set);

}  // namespace halfspace
