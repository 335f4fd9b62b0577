// SPDX-License-Identifier: Apache-2.0
//
// Clocks simulated per second: the cycle engine, CycleModel and the Verilated RTL on the same
// triangles, in one run. cycle_bench [MESH.obj]
#include <ctime>

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "batch/cycle_engine.hpp"
#include "camera.hpp"
#include "cli/scene.hpp"
#include "cosim.hpp"
#include "generators.hpp"
#include "geometry.hpp"

namespace halfspace {
namespace {

constexpr int kRuns = 5;

double thread_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct Workload {
  std::string name;
  FrameState frame;
  std::vector<Triangle> triangles;
  std::size_t rtl_triangles;  // the RTL is given no more of them: it is slow
};

// What every simulator must agree on.
struct Result {
  std::uint64_t clocks = 0;
  std::uint64_t tiles = 0;
  std::uint64_t check = 0;  // of places, masks and, but for the RTL's, clocks
  double seconds = 0;
  double rate() const { return static_cast<double>(clocks) / seconds; }
};

Result run_engine(const Workload& work, const Config& config) {
  CycleEngine engine(work.frame, config, Stalls());
  Result out;
  const double start = thread_seconds();
  engine.run(work.triangles, [&](const CycleChunk& chunk) {
    out.tiles += chunk.clock.size();
    for (std::size_t i = 0; i < chunk.clock.size(); ++i) {
      out.check += chunk.clock[i] ^ chunk.plane[0][i] ^ chunk.place[i];
    }
  });
  out.seconds = thread_seconds() - start;
  out.clocks = engine.clocks();
  return out;
}

struct Sum {
  static constexpr bool kWantsNodes = false;
  static constexpr bool kWantsSetup = false;
  Result& to;
  void accepted(std::uint64_t) const {}
  void setup(std::uint64_t, const SetupTriangle&) const {}
  void node(int, std::uint64_t, const Node&) const {}
  void tile(std::uint64_t clock, const CoverageTile& tile) const {
    ++to.tiles;
    to.check += clock ^ tile.mask[0] ^ cycle_place(tile.x, tile.y, 3);
  }
};

// The engine through the packet by packet interface.
Result run_listener(const Workload& work, const Config& config) {
  CycleEngine engine(work.frame, config, Stalls());
  Result out;
  const double start = thread_seconds();
  engine.draw(work.triangles, Sum{out});
  out.seconds = thread_seconds() - start;
  out.clocks = engine.clocks();
  return out;
}

Result run_model(const Workload& work, const Config& config) {
  CycleModel model(work.frame, config, Stalls());
  Result out;
  const double start = thread_seconds();
  for (const Triangle& triangle : work.triangles) model.draw(triangle, Sum{out});
  out.seconds = thread_seconds() - start;
  out.clocks = model.clocks();
  return out;
}

Result run_verilated(const Workload& work, const Config& config, RtlRasterizer& rtl) {
  const std::span<const Triangle> part(work.triangles.data(),
                                       std::min(work.rtl_triangles, work.triangles.size()));
  Result out;
  const double start = thread_seconds();
  const RtlRun run = run_rtl(rtl, part, work.frame, Stalls(), [&](const CoverageTile& tile) {
    ++out.tiles;
    out.check += tile.mask[0] ^ cycle_place(tile.x, tile.y, 3);
  });
  out.seconds = thread_seconds() - start;
  out.clocks = run.clocks;
  CycleEngine engine(work.frame, config, Stalls());
  std::uint64_t check = 0;
  engine.run(part, [&](const CycleChunk& chunk) {
    for (std::size_t i = 0; i < chunk.clock.size(); ++i) {
      check += chunk.plane[0][i] ^ chunk.place[i];
    }
  });
  if (engine.clocks() != out.clocks || check != out.check) {
    throw std::runtime_error(work.name + ": the engine and the RTL differ");
  }
  return out;
}

std::vector<Workload> workloads(const Config& config, const char* mesh) {
  std::vector<Workload> out;
  const FrameState frame{1920, 1080, Cull::kNone};
  const Point p = snap_px(0, 0, config), q = snap_px(1920, 0, config);
  const Point r = snap_px(1920, 1080, config), s = snap_px(0, 1080, config);
  out.push_back({"full screen", frame, {}, 2});
  for (int i = 0; i < 20; ++i) {
    out.back().triangles.push_back({{p, q, r}, 0});
    out.back().triangles.push_back({{p, r, s}, 0});
  }
  for (const int side : {32, 16, 8}) {
    Random random(static_cast<std::uint64_t>(side));
    out.push_back({side == 8 ? "one tile" : std::to_string(side) + " px", frame, {}, 3000});
    while (out.back().triangles.size() < 40000) {
      // In a square of that side; for one tile it is the tile's.
      const std::int64_t step = side == 8 ? 8 << config.subpixel_bits : 1;
      const std::int64_t x = random.in(0, ((1900 - side) << config.subpixel_bits) / step) * step;
      const std::int64_t y = random.in(0, ((1060 - side) << config.subpixel_bits) / step) * step;
      Triangle t;
      for (Point& v : t.vertex) {
        v.x = static_cast<std::int32_t>(x + random.in(0, (side << config.subpixel_bits) - 1));
        v.y = static_cast<std::int32_t>(y + random.in(0, (side << config.subpixel_bits) - 1));
      }
      out.back().triangles.push_back(t);
    }
  }
  if (mesh != nullptr) {
    RunStats stats;
    out.push_back({"bunny", frame, {}, SIZE_MAX});
    open_scene(mesh, -1, {1920, 1080}, {}, Lighting::kGouraud)
        ->draw(0, frame, config, stats, [&](const ShadedTriangle& triangle) {
          out.back().triangles.push_back(triangle.triangle);
        });
  }
  return out;
}

void bench(const Config& config, const char* mesh) {
  const std::unique_ptr<RtlRasterizer> rtl = make_rtl_rasterizer(config);
  std::printf("instruction set %s, medians of %d runs, thread CPU time, M clocks/s\n",
              std::string(CycleEngine({1, 1, Cull::kNone}, config, Stalls()).isa()).c_str(), kRuns);
  std::printf("%-12s %9s %10s %9s %9s %8s %7s %9s %9s\n", "workload", "triangles", "clocks",
              "engine", "listener", "model", "rtl", "eng/rtl", "eng/model");
  for (const Workload& work : workloads(config, mesh)) {
    std::array<std::vector<Result>, 4> runs;
    for (int i = 0; i < kRuns; ++i) {
      runs[0].push_back(run_engine(work, config));
      runs[1].push_back(run_listener(work, config));
      runs[2].push_back(run_model(work, config));
      runs[3].push_back(run_verilated(work, config, *rtl));
      for (const std::size_t k : {1, 2}) {
        if (runs[k].back().check != runs[0].back().check ||
            runs[k].back().clocks != runs[0].back().clocks) {
          throw std::runtime_error(work.name + ": the engine and the model differ");
        }
      }
    }
    std::array<double, 4> rate{};
    for (std::size_t k = 0; k < 4; ++k) {
      std::sort(runs[k].begin(), runs[k].end(),
                [](const Result& l, const Result& r) { return l.rate() < r.rate(); });
      rate[k] = runs[k][kRuns / 2].rate();
    }
    std::printf("%-12s %9zu %10llu %9.1f %9.1f %8.2f %7.3f %9.1f %9.1f\n", work.name.c_str(),
                work.triangles.size(), static_cast<unsigned long long>(runs[0][0].clocks),
                rate[0] * 1e-6, rate[1] * 1e-6, rate[2] * 1e-6, rate[3] * 1e-6, rate[0] / rate[3],
                rate[0] / rate[2]);
  }
}

}  // namespace
}  // namespace halfspace

int main(int argc, char** argv) {
  try {
    halfspace::bench(halfspace::kFull, argc > 1 ? argv[1] : nullptr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "cycle_bench: %s\n", error.what());
    return 1;
  }
  return 0;
}
