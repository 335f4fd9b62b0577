// SPDX-License-Identifier: Apache-2.0
#include "goal.hpp"

#include <algorithm>
#include <cstdint>

namespace halfspace {
namespace {

// How often a bin is met before another unit that hits it is of no interest.
constexpr std::size_t kEnough = 12;

BinSet reachable_set(const BinModel& model) {
  BinSet set = model.none();
  for (std::size_t i = 0; i < model.bins().size(); ++i) {
    if (model.bins()[i].reason.empty()) set.add(i);
  }
  return set;
}

bool same_frame(const FrameState& a, const FrameState& b) {
  return a.width == b.width && a.height == b.height && a.cull == b.cull;
}

}  // namespace

std::vector<SampledUnit> search_goal(const BinModel& model, double goal, std::uint64_t tries,
                                     std::uint64_t seed,
                                     const std::function<void(std::size_t)>& progress) {
  Random random(seed);
  const BinSet wanted = reachable_set(model);
  const auto needed =
      static_cast<std::size_t>(goal * static_cast<double>(wanted.count()) + 0.999999);
  std::vector<std::size_t> met(model.bins().size());
  std::size_t hit = 0, enough = 0;
  std::vector<SampledUnit> kept;
  for (std::uint64_t i = 0; i < tries; ++i) {
    if (hit >= needed && enough >= hit) break;
    SampledUnit unit{directed_unit(random, model.config()), model.none()};
    model.sample(unit.unit.frame, unit.unit.triangles, unit.hits);
    bool interesting = false;
    for (std::size_t bin = 0; bin < met.size(); ++bin) {
      if (!unit.hits.has(bin)) continue;
      ++met[bin];
      interesting = interesting || met[bin] <= kEnough;
      if (!wanted.has(bin)) continue;
      hit += met[bin] == 1 ? 1u : 0u;
      enough += met[bin] == kEnough ? 1u : 0u;
    }
    if (interesting) kept.push_back(std::move(unit));
    progress(hit);
  }
  return kept;
}

std::vector<SampledUnit> minimal_units(std::vector<SampledUnit> units, const BinModel& model) {
  BinSet covered = model.none();
  // Unreachable bins, should one be hit, count as well: the report must show them.
  std::vector<SampledUnit> chosen;
  for (;;) {
    std::size_t best = units.size(), best_new = 0, best_size = 1;
    for (std::size_t i = 0; i < units.size(); ++i) {
      const std::size_t fresh = units[i].hits.count_beyond(covered);
      const std::size_t size = units[i].unit.triangles.size();
      if (fresh * best_size > best_new * size) best = i, best_new = fresh, best_size = size;
    }
    if (best == units.size()) break;
    covered.add(units[best].hits);
    chosen.push_back(std::move(units[best]));
    units.erase(units.begin() + static_cast<std::ptrdiff_t>(best));
    std::erase_if(units, [&](const SampledUnit& u) { return u.hits.count_beyond(covered) == 0; });
  }
  for (std::size_t i = chosen.size(); i-- > 0;) {
    BinSet others = model.none();
    for (std::size_t j = 0; j < chosen.size(); ++j) {
      if (j != i) others.add(chosen[j].hits);
    }
    if (chosen[i].hits.count_beyond(others) == 0) {
      chosen.erase(chosen.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
  return chosen;
}

std::vector<VectorUnit> by_frame(const std::vector<SampledUnit>& units, const Config& config) {
  std::vector<VectorUnit> frames;
  for (const SampledUnit& unit : units) {
    const auto found = std::find_if(frames.begin(), frames.end(), [&](const VectorUnit& frame) {
      return same_frame(frame.frame, unit.unit.frame);
    });
    VectorUnit& frame =
        found != frames.end() ? *found : frames.emplace_back(VectorUnit{unit.unit.frame, {}});
    frame.triangles.insert(frame.triangles.end(), unit.unit.triangles.begin(),
                           unit.unit.triangles.end());
  }
  std::uint64_t number = 0;
  for (VectorUnit& frame : frames) {
    for (Triangle& triangle : frame.triangles) {
      triangle.tag =
          static_cast<std::uint32_t>(number++ & ((std::uint64_t{1} << config.tag_bits) - 1));
    }
  }
  return frames;
}

}  // namespace halfspace
