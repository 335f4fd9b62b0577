// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "method.hpp"

namespace halfspace::methods {

// 1 / v rounded to nearest with `bits` fraction bits of its significand: a relative error of at
// most 2^-(bits + 1). v positive and finite.
double reciprocal(double v, int bits);

}  // namespace halfspace::methods
