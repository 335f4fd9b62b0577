// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <ctime>
#include <nlohmann/json.hpp>

#include "charts.hpp"
#include "engines/coverage/coverage_engine.hpp"
#include "suite_shapes.hpp"

namespace halfspace::lab {
namespace {

constexpr double kLeastSeconds = 0.004;  // of CPU, per repetition
constexpr int kRepetitions = 3;

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// CPU seconds that one call takes: the least of a few averages.
template <class Work>
double seconds_of(Work&& work) {
  work();
  double least = INFINITY;
  for (int n = 0; n < kRepetitions; ++n) {
    const double start = cpu_seconds();
    double spent = 0;
    int calls = 0;
    while (spent < kLeastSeconds) {
      work();
      ++calls;
      spent = cpu_seconds() - start;
    }
    least = std::min(least, spent / calls);
  }
  return least;
}

struct Workload {
  std::string name;
  SuiteCase timed;
  std::vector<SuiteCase> judged;
};

// timed, judged: cells a side.
Workload synthetic(int side, int timed, int judged, std::uint64_t seed) {
  const int cell = side + side / 2;
  const auto cells = [&](int count) {
    return area_case("separate", separate(seed, cell, count, 0), {cell * count, cell * count});
  };
  const int mesh = std::clamp(8 * side, 128, 1024);
  Workload work;
  work.name = std::to_string(side) + " px triangles";
  work.timed = cells(timed);
  work.judged.push_back(cells(judged));
  work.judged.push_back(area_case("mesh on half pixels",
                                  facets_of(jittered_mesh(seed, mesh, side, 128, kShapeGrid)),
                                  {mesh, mesh}));
  return work;
}

Workload chosen(const RealScene& scene) {
  std::vector<Facet> facets;
  for (const oracle::Corners& t : scene.triangles) {
    facets.push_back(facet_of({t[0].x, t[0].y}, {t[1].x, t[1].y}, {t[2].x, t[2].y}));
  }
  const SuiteCase one = area_case(scene.name, facets, {scene.width, scene.height});
  return {scene.name, one, {one}};
}

// What is drawn, pixel by pixel, against the truth. Triangles one by one would be needed to see a
// hit that moved from one to its neighbour; hits per pixel are what a picture shows.
oracle::HitErrors errors_of(const methods::Method& method, const SuiteCase& one) {
  methods::Canvas canvas(one.window.width, one.window.height);
  methods::draw(method, one.drawing, canvas);
  return oracle::compare_hits(canvas.hits(), true_hits(one, method.input()));
}

Json point(const std::string& name, const std::string& family, const std::string& precision,
           double ppm, double seconds, std::size_t primitives, std::uint64_t pixels) {
  return {{"method", name},
          {"family", family},
          {"precision", precision},
          {"wrong_ppm", ppm},
          {"cpu_ns_per_triangle", 1e9 * seconds / static_cast<double>(primitives)},
          {"mpixels_per_cpu_second", 1e-6 * static_cast<double>(pixels) / seconds}};
}

// Level coverage of the design as the program runs it: many triangles at once, by SIMD, with
// vertices snapped to `bits` subpixel bits.
Json engine_point(const Workload& work, int bits) {
  Config config;
  config.guard_bits = 14;
  config.subpixel_bits = bits;
  RealScene scene{work.name, work.timed.window.width, work.timed.window.height, {}};
  for (const Facet& f : work.timed.drawing.facets) {
    scene.triangles.push_back({{{f[0].x, f[0].y}, {f[1].x, f[1].y}, {f[2].x, f[2].y}}});
  }
  const std::vector<Triangle> triangles = snapped(scene, config);
  CoverageEngine engine({scene.width, scene.height, Cull::kNone}, config);
  RasterStats stats;
  engine.cover(triangles, [&](const CoverageChunk& chunk) { count_records(chunk, stats); });
  RasterStats unused;
  const double seconds = seconds_of([&] {
    engine.cover(triangles, [&](const CoverageChunk& chunk) { count_records(chunk, unused); });
  });
  // Its masks are the pipeline's (tests/coverage_engine_test.cpp), so its errors are too.
  const auto* same = methods::find("halfspace_s" + std::to_string(bits));
  oracle::HitErrors errors;
  for (const SuiteCase& one : work.judged) errors += errors_of(*same, one);
  return point("engine_s" + std::to_string(bits), "engine", "fixed, SIMD", errors.ppm(), seconds,
               triangles.size(), stats.samples_covered);
}

Json panel(const Workload& work) {
  Json points = Json::array();
  for (int bits = 0; bits <= 12; ++bits) points.push_back(engine_point(work, bits));
  std::uint64_t covered = 0;
  for (const std::uint32_t hits : true_hits(work.timed, methods::InputKind::kTriangles)) {
    covered += hits;
  }
  for (const methods::Method& method : methods::all()) {
    if (method.input() == methods::InputKind::kLines) continue;
    oracle::HitErrors errors;
    for (const SuiteCase& one : work.judged) errors += errors_of(method, one);
    methods::Canvas canvas(work.timed.window.width, work.timed.window.height);
    const double seconds = seconds_of([&] { methods::draw(method, work.timed.drawing, canvas); });
    points.push_back(point(method.name, method.family, method.precision, errors.ppm(), seconds,
                           methods::primitives(method, work.timed.drawing), covered));
  }
  return {{"name", work.name}, {"triangles", work.timed.drawing.facets.size()}, {"points", points}};
}

}  // namespace

Json methods_chart(const RealScene* scene) {
  Json data;
  data["chart"] = "methods";
  if (scene != nullptr) {
    data["panels"].push_back(panel(chosen(*scene)));
    return data;
  }
  data["panels"].push_back(panel(synthetic(4, 24, 96, 891)));
  data["panels"].push_back(panel(synthetic(32, 6, 20, 892)));
  data["panels"].push_back(panel(synthetic(256, 2, 4, 893)));
  return data;
}

}  // namespace halfspace::lab
