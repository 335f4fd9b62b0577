// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>

#include "raw_mesh.hpp"

namespace halfspace {

// Is it ASCII STL? By the first word and that facets follow, as binary headers start with "solid"
// too. Not to be asked of a file as long as its binary header says.
bool is_stl_text(std::string_view bytes);

// Reads ASCII STL: keywords in any case, spread over lines in any way; what stands where a normal
// should is read over. Sends the corners of each facet and the line of its last one.
void read_stl_text(
    const MeshSource& source,
    const std::function<void(const std::array<glm::dvec3, 3>& corners, std::size_t line)>& sink);

}  // namespace halfspace
