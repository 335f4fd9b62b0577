// SPDX-License-Identifier: Apache-2.0
#include "link.hpp"

#include <fmt/format.h>

namespace halfspace {

std::vector<Link> links(const Config& config) {
  std::vector<Link> out{kLinkAccept, kLinkSetup};
  for (int level = 1; level < config.levels(); ++level) out.push_back(link_into(level));
  out.push_back(kLinkTile);
  return out;
}

std::size_t index_of(Link link, const Config& config) {
  switch (link.kind) {
    case Link::Kind::kAccept: return 0;
    case Link::Kind::kSetup: return 1;
    case Link::Kind::kNode: return static_cast<std::size_t>(link.level + 1);
    case Link::Kind::kTile: break;
  }
  return static_cast<std::size_t>(config.levels() + 1);
}

Layout link_layout(Link link, const Config& config) {
  switch (link.kind) {
    case Link::Kind::kAccept: break;
    case Link::Kind::kSetup: return setup_layout(config);
    case Link::Kind::kNode: return traversal_layout(config);
    case Link::Kind::kTile: return coverage_layout(config);
  }
  return {};
}

std::string stage_of(Link link) {
  switch (link.kind) {
    case Link::Kind::kAccept: return "accept";
    case Link::Kind::kSetup: return "triangle_setup";
    case Link::Kind::kNode: return fmt::format("tile_traversal[{}]", link.level - 1);
    case Link::Kind::kTile: break;
  }
  return "coverage";
}

}  // namespace halfspace
