// SPDX-License-Identifier: Apache-2.0
#include "cases.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/config_json.hpp"
#include "io/error.hpp"

namespace halfspace {
namespace {

constexpr std::size_t kNamed = 10;

// The swept fields of a configuration, as they are written.
std::string point_name(const SweepGrid& grid, const Config& config) {
  std::string out;
  const nlohmann::ordered_json all = config_json(config);
  for (const SweepAxis& axis : grid.axes) {
    out += (out.empty() ? "" : ", ") + axis.key + " " + all[axis.key].dump();
  }
  return out.empty() ? "the base" : out;
}

[[noreturn]] void refuse_count(const SweepSpecification& specification) {
  throw Error(ErrorCode::kSpecification, specification.path,
              fmt::format("config: more than {} cases", kMostCases));
}

}  // namespace

void SweepCases::leave_out(std::size_t grid, const Config& config, const std::string& reason) {
  ++left_out_;
  if (left_out_names_.size() == kNamed) return;
  left_out_names_.push_back(
      fmt::format("{}: {}", point_name(specification_.grids[grid], config), reason));
}

void SweepCases::list_configs() {
  const std::vector<FrameSize>& sizes = specification_.sizes;
  lists_.resize(sizes.size() + 1);
  for (std::size_t g = 0; g < specification_.grids.size(); ++g) {
    const SweepGrid& grid = specification_.grids[g];
    for (std::uint64_t i = 0; i < grid.size(); ++i) {
      const Config config = grid.at(i);
      const std::string wrong = validate(config);
      if (!wrong.empty()) {
        leave_out(g, config, wrong);
        continue;
      }
      const GridIndex index{static_cast<std::uint32_t>(g), static_cast<std::uint32_t>(i)};
      lists_.back().push_back(index);
      for (std::size_t s = 0; s < sizes.size(); ++s) {
        if (std::max(sizes[s].width, sizes[s].height) <= config.max_size()) {
          lists_[s].push_back(index);
        } else {
          leave_out(g, config,
                    fmt::format("size {}x{} is larger than viewport_bits = {} allow",
                                sizes[s].width, sizes[s].height, config.viewport_bits));
        }
      }
    }
  }
}

SweepCases::SweepCases(const SweepSpecification& specification) : specification_(specification) {
  std::uint64_t configs = 0;
  for (const SweepGrid& grid : specification.grids) configs += grid.size();
  if (configs > kMostCases) refuse_count(specification);
  list_configs();
  if (lists_.back().empty()) {
    throw Error(ErrorCode::kSpecification, specification.path,
                fmt::format("config: no configuration is legal: {}", left_out_names_.front()));
  }
  for (std::size_t scene = 0; scene < specification.scenes.size(); ++scene) {
    const std::string& path = specification.scene_files[scene];
    const bool tcov = is_tcov(path);
    const auto views =
        tcov ? make_tcov_scene(path, -1)->frames() : static_cast<std::size_t>(specification.views);
    for (std::size_t s = 0; s < (tcov ? 1 : specification.sizes.size()); ++s) {
      const std::size_t list = tcov ? specification.sizes.size() : s;
      blocks_.push_back({count_, scene, s, list});
      count_ += views * lists_[list].size();
      if (count_ > kMostCases) refuse_count(specification);
    }
  }
  if (count_ == 0) {
    throw Error(ErrorCode::kSpecification, specification.path,
                left_out_names_.empty() ? "scenes: no case in them"
                                        : "config: no case: " + left_out_names_.front());
  }
}

SweepCase SweepCases::at(std::uint64_t number) const {
  const auto after =
      std::upper_bound(blocks_.begin(), blocks_.end(), number,
                       [](std::uint64_t value, const Block& block) { return value < block.first; });
  const Block& block = *(after - 1);
  const std::vector<GridIndex>& list = lists_[block.list];
  const std::uint64_t rest = number - block.first;
  const GridIndex index = list[rest % list.size()];
  return {number, block.scene, block.size, static_cast<std::size_t>(rest / list.size()),
          specification_.grids[index.first].at(index.second)};
}

}  // namespace halfspace
