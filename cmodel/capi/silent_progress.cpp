// SPDX-License-Identifier: Apache-2.0
//
// Progress for the library: a caller's terminal is not ours to write to.
#include <utility>

#include "../cli/progress.hpp"

namespace halfspace {

Progress::Progress(std::string what, std::uint64_t total)
    : what_(std::move(what)), total_(total), terminal_(false) {}

Progress::~Progress() = default;

void Progress::show() {}

}  // namespace halfspace
