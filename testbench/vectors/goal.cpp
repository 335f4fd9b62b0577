// SPDX-License-Identifier: Apache-2.0
#include "goal.hpp"

#include <algorithm>
#include <cstdint>

namespace halfspace {
namespace {

// How often a bin is met, beyond what is asked, before another unit that hits it is of no interest.
constexpr std::size_t kSpare = 11;

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

std::vector<SampledUnit> search_goal(const BinModel& model, double goal, std::size_t times,
                                     std::uint64_t tries, std::uint64_t seed,
                                     const std::function<void(std::size_t)>& progress) {
  Random random(seed);
  const std::size_t plenty = times + kSpare;
  const BinSet wanted = reachable_set(model);
  const auto needed =
      static_cast<std::size_t>(goal * static_cast<double>(wanted.count()) + 0.999999);
  std::vector<std::size_t> met(model.bins().size());
  std::size_t hit = 0, enough = 0;
  std::vector<SampledUnit> kept;
  for (std::uint64_t i = 0; i < tries; ++i) {
    if (hit >= needed && (goal < 1 || enough >= hit)) break;
    SampledUnit unit{directed_unit(random, model.config()), model.none()};
    model.sample(unit.unit.frame, unit.unit.triangles, unit.hits);
    bool interesting = false;
    for (std::size_t bin = 0; bin < met.size(); ++bin) {
      if (!unit.hits.has(bin)) continue;
      ++met[bin];
      interesting = interesting || met[bin] <= plenty;
      if (!wanted.has(bin)) continue;
      hit += met[bin] == 1 ? 1u : 0u;
      enough += met[bin] == plenty ? 1u : 0u;
    }
    if (interesting) kept.push_back(std::move(unit));
    progress(hit);
  }
  return kept;
}

std::vector<SampledUnit> minimal_units(const std::vector<SampledUnit>& units, std::size_t times,
                                       const BinModel& model) {
  const std::size_t bins = model.bins().size();
  const auto for_each_hit = [bins](const SampledUnit& unit, const auto& visit) {
    for (std::size_t bin = 0; bin < bins; ++bin) {
      if (unit.hits.has(bin)) visit(bin);
    }
  };
  // Unreachable bins, should one be hit, count as well: the report must show them.
  std::vector<std::size_t> wanted(bins), met(bins);
  for (const SampledUnit& unit : units) {
    for_each_hit(unit, [&](std::size_t bin) { wanted[bin] = std::min(times, wanted[bin] + 1); });
  }
  BinSet open = model.none();  // bins that want more
  for (std::size_t bin = 0; bin < bins; ++bin) {
    if (wanted[bin] > 0) open.add(bin);
  }
  std::vector<const SampledUnit*> left, chosen;
  for (const SampledUnit& unit : units) left.push_back(&unit);
  while (!left.empty()) {
    std::size_t best = 0, best_new = 0, best_size = 1;
    for (std::size_t i = 0; i < left.size(); ++i) {
      const std::size_t fresh = left[i]->hits.count_common(open);
      const std::size_t size = left[i]->unit.triangles.size();
      if (fresh * best_size > best_new * size) best = i, best_new = fresh, best_size = size;
    }
    if (best_new == 0) break;
    chosen.push_back(left[best]);
    for_each_hit(*left[best], [&](std::size_t bin) {
      if (++met[bin] == wanted[bin]) open.remove(bin);
    });
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
    std::erase_if(left, [&](const SampledUnit* u) { return u->hits.count_common(open) == 0; });
  }
  std::vector<SampledUnit> out;
  for (std::size_t i = chosen.size(); i-- > 0;) {
    bool needless = true;
    for_each_hit(*chosen[i],
                 [&](std::size_t bin) { needless = needless && met[bin] > wanted[bin]; });
    if (needless) {
      for_each_hit(*chosen[i], [&](std::size_t bin) { --met[bin]; });
    } else {
      out.insert(out.begin(), *chosen[i]);
    }
  }
  return out;
}

std::vector<VectorRun> by_frame(const std::vector<SampledUnit>& units, bool stalls,
                                const Config& config) {
  std::vector<VectorRun> runs;
  for (std::size_t i = 0; i < units.size(); ++i) {
    const VectorUnit& unit = units[i].unit;
    const bool stalled = stalls && i % 2 == 1;
    const auto found = std::find_if(runs.begin(), runs.end(), [&](const VectorRun& run) {
      return same_frame(run.frame, unit.frame) && run.stalled == stalled;
    });
    VectorRun& run =
        found != runs.end() ? *found : runs.emplace_back(VectorRun{unit.frame, stalled, {}});
    run.triangles.insert(run.triangles.end(), unit.triangles.begin(), unit.triangles.end());
  }
  const std::uint64_t tags = std::uint64_t{1} << config.tag_bits;
  std::uint64_t number = 0;
  for (VectorRun& run : runs) {
    for (Triangle& triangle : run.triangles) {
      triangle.tag = static_cast<std::uint32_t>(number++ & (tags - 1));
    }
  }
  return runs;
}

}  // namespace halfspace
