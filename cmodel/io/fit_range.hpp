// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "../config.hpp"
#include "../packets.hpp"

namespace halfspace {

// The host's side of Config::extent_bits: a triangle that the widths do not hold is refused, with
// its index among the submitted ones, before it reaches setup.

// Throws Error(kFitRange) when two vertices are further apart than the configuration allows.
// place: the file's name.
void require_extent(const Triangle& triangle, std::uint64_t index, const Config& config,
                    const std::string& place);

// Throws Error(kFitRange) saying that the triangle was cut at a side of the range that the
// configuration was fitted to: what is left of it would not be what a wider one draws.
[[noreturn]] void refuse_cut(std::uint64_t index, const Config& config, const std::string& place);

}  // namespace halfspace
