// SPDX-License-Identifier: Apache-2.0
#include "../io/error.hpp"
#include "fit.hpp"

namespace halfspace {

bool has_fit_oracle() { return false; }

CoverageCurve coverage_curve(const std::vector<FitView>&, const Config&, std::uint64_t) {
  throw Error(ErrorCode::kFitOracle, "--max-error",
              "this build has no oracle (install libcgal-dev and configure again)");
}

}  // namespace halfspace
