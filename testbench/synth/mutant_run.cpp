// SPDX-License-Identifier: Apache-2.0
//
// Random triangles with stalls through the RTL of preset tiny and the cycle model, which must agree
// in every packet and clock. Prints the first mismatch and exits with 1, or what was compared.
//
// Run by tests/rtl_mutants_test.py with $HALFSPACE_RTL naming one mutant at a time.
#include <cstdio>
#include <exception>
#include <memory>
#include <vector>

#include "rtl/cosim.hpp"
#include "vectors/generators.hpp"

namespace halfspace {

namespace {

struct Run {
  FrameState frame;
  double stalls;
  std::size_t triangles;
};

bool same(RtlRasterizer& rtl, const Run& run, std::uint64_t seed) {
  Random random(seed);
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < run.triangles; ++i) {
    triangles.push_back(
        random_triangle(random, kShapes[i % kShapes.size()], run.frame, rtl.config()));
  }
  CosimOptions options;
  if (run.stalls > 0) options.stalls = Stalls(run.stalls, seed);
  const CosimResult result = cosim(rtl, triangles, run.frame, rtl.config(), options);
  if (result.mismatch) {
    std::printf("seed %d: %s\n", static_cast<int>(seed), result.mismatch->line().c_str());
    return false;
  }
  std::printf("seed %d: %llu packets equal\n", static_cast<int>(seed),
              static_cast<unsigned long long>(result.packets_compared));
  return true;
}

int run_all() {
  const int size = kTiny.max_size();
  const std::vector<Run> runs{{{100, 60, Cull::kNone}, 0, 220},
                              {{100, 60, Cull::kBack}, 0.3, 220},
                              {{60, 100, Cull::kFront}, 0.5, 110},
                              {{size, size, Cull::kNone}, 0.2, 22}};
  RtlRasterizer rtl(kTiny, false, "rtl");
  std::uint64_t seed = 1;
  for (const Run& run : runs) {
    if (!same(rtl, run, seed++)) return 1;
  }
  return 0;
}

}  // namespace
}  // namespace halfspace

int main() {
  try {
    return halfspace::run_all();
  } catch (const halfspace::RtlDrift& drift) {
    std::printf("mismatch: %s\n", drift.line().c_str());
    return 1;
  } catch (const halfspace::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::printf("mismatch: stage=assertion rtl=%s\n", error.what());
    return 1;
  }
}
