// SPDX-License-Identifier: Apache-2.0
#include "lod.hpp"

#include <algorithm>

#include "fixed.hpp"
#include "hit_count.hpp"
#include "rasterizer.hpp"

namespace halfspace {
namespace {

std::vector<std::uint8_t> hits_of(const FitView& view) {
  constexpr Config kConfig{.viewport_bits = 15, .guard_bits = 16};
  HitCount hits(view.frame.width, view.frame.height);
  RunStats unused;
  view.scene->draw(view.index, view.frame, kConfig, unused, [&](const ShadedTriangle& shaded) {
    rasterize(shaded.triangle, view.frame, kConfig, unused.raster,
              [&](const CoverageTile& tile) { hits.add(tile, kConfig); });
  });
  return hits.count();
}

}  // namespace

LodError compare_lod(const std::vector<FitView>& before, const std::vector<FitView>& after) {
  HS_CHECK(before.size() == after.size());
  LodError out;
  for (std::size_t v = 0; v < before.size(); ++v) {
    out.triangles_before += before[v].scene->triangles(before[v].index);
    out.triangles_after += after[v].scene->triangles(after[v].index);
    const std::vector<std::uint8_t> want = hits_of(before[v]);
    const std::vector<std::uint8_t> got = hits_of(after[v]);
    for (std::size_t i = 0; i < want.size(); ++i) {
      out.pixels_covered += want[i] != 0 ? 1U : 0U;
      out.pixels_wrong += (want[i] != 0) != (got[i] != 0) ? 1U : 0U;
      out.counts_wrong += want[i] != got[i] ? 1U : 0U;
    }
  }
  return out;
}

}  // namespace halfspace
