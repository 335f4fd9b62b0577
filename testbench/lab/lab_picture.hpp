// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "case_pixels.hpp"
#include "framebuffer.hpp"

namespace halfspace::lab {

// A case drawn and judged, magnified around its wrong pixels (or its middle when nothing is wrong):
// covered pixels grey, missing ones magenta, those drawn too often orange, wrong colours, depths
// and orders red; the outlines of what was submitted in blue. At most 64 x 64 px are shown.
Image case_picture(const methods::Method& method, const Suite& suite, const SuiteCase& one);

}  // namespace halfspace::lab
