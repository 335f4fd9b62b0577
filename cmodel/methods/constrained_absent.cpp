// SPDX-License-Identifier: Apache-2.0
#include "catalogue.hpp"
#include "decomposition.hpp"

namespace halfspace::methods {

// A build without CGAL: the gallery lacks this one method.
Pieces constrained_pieces(const Polygon&) { return {}; }
void add_constrained(std::vector<Method>&) {}

}  // namespace halfspace::methods
