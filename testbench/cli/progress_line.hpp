// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace halfspace {

// "drawing triangles  1200/3674  33%  1.2M/s  0.4 s left" on stderr for every Progress, when that
// is a terminal and the work takes longer than half a second; silent otherwise. Erased when done.
void show_progress();

}  // namespace halfspace
