// SPDX-License-Identifier: Apache-2.0
//
// The places in hs_rasterizer where packets change hands.
#pragma once

#include <string>
#include <vector>

#include "config.hpp"
#include "vectors/layout.hpp"

namespace halfspace {

struct Link {
  enum class Kind {
    kAccept,  // a triangle enters triangle_setup; the testbench gives it
    kSetup,   // and leaves it for level 0 of the pyramid
    kNode,    // a node enters `level` of the pyramid, 1 .. levels - 1 (levels - 1 is coverage)
    kTile     // a tile leaves coverage
  };
  Kind kind = Kind::kAccept;
  int level = 0;  // of kNode

  bool operator==(const Link&) const = default;
};
inline constexpr Link kLinkAccept{Link::Kind::kAccept, 0};
inline constexpr Link kLinkSetup{Link::Kind::kSetup, 0};
inline constexpr Link kLinkTile{Link::Kind::kTile, 0};
constexpr Link link_into(int level) { return {Link::Kind::kNode, level}; }

// All links in the order of the flow; a link's place there is its number in rtl_object.h.
std::vector<Link> links(const Config& config);
std::size_t index_of(Link link, const Config& config);

// The fields of a link's packet; none at kLinkAccept.
Layout link_layout(Link link, const Config& config);

// The stage whose packet it is: "triangle_setup", "tile_traversal[2]", "coverage"; "accept".
std::string stage_of(Link link);

}  // namespace halfspace
