// SPDX-License-Identifier: Apache-2.0
#include "fixed.hpp"

#include <cstdio>
#include <cstdlib>

namespace halfspace {

void check_failed(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "halfspace: error[HS099]: %s:%d: check failed: %s\n", file, line, condition);
  std::abort();
}

}  // namespace halfspace
