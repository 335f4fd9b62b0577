// SPDX-License-Identifier: Apache-2.0
//
// What drawing allocates, whatever the number of triangles. Every allocation of this program is
// counted.
#include <gtest/gtest.h>
#include <malloc.h>

#include <unistd.h>
#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <new>

#include "bench/bumpy_torus.hpp"
#include "cli/level_run.hpp"
#include "engines/common/threads.hpp"
#include "rasterizer.hpp"
#include "scene/scene.hpp"

namespace {

std::atomic<std::size_t> live_bytes{0};
std::atomic<std::size_t> peak_bytes{0};

}  // namespace

namespace {

void* counted(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  const std::size_t live = live_bytes += malloc_usable_size(memory);
  std::size_t peak = peak_bytes;
  while (peak < live && !peak_bytes.compare_exchange_weak(peak, live)) {
  }
  return memory;
}

}  // namespace

[[gnu::noinline]] void* operator new(std::size_t size) { return counted(std::malloc(size)); }
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t line) {
  const auto to = static_cast<std::size_t>(line);
  return counted(std::aligned_alloc(to, (size + to - 1) / to * to));
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  if (memory != nullptr) live_bytes -= malloc_usable_size(memory);
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  operator delete(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept {
  operator delete(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  operator delete(memory);
}

namespace halfspace {

namespace {

constexpr FrameSize kSize{320, 240};

// A mesh of at least that many triangles, loaded.
std::unique_ptr<Scene> open_mesh(double triangles) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("memory_test_" + std::to_string(getpid()) + ".ply");
  write_bumpy_torus(path, triangles);
  std::unique_ptr<Scene> scene = open_scene(path, -1, kSize, {}, Lighting::kGouraud);
  std::filesystem::remove(path);
  EXPECT_GE(scene->triangles(0), triangles);
  return scene;
}

// Bytes allocated on top of the loaded scene while draw(scene, frame, stats) works, at most.
template <class Draw>
std::size_t drawing_bytes(double triangles, const Draw& draw) {
  const std::unique_ptr<Scene> scene = open_mesh(triangles);
  const std::size_t before = live_bytes;
  peak_bytes = before;
  EXPECT_GT(draw(*scene, scene->frame(0, kFull)).samples_covered, 20000U);
  return peak_bytes - before;
}

RasterStats draw_by_stages(Fidelity level, const Scene& scene, const FrameState& frame) {
  RunStats stats;
  Rasterizer rasterizer(frame, kFull, DepthFunction::kLess, {});
  LevelRun run(
      level, frame, kFull, stats,
      [&](const ShadedTriangle& triangle, const SetupTriangle& setup) {
        rasterizer.begin(triangle, setup);
      },
      [&](const CoverageTile& tile) {
        if (level != Fidelity::kCoverage) rasterizer.draw_tile(tile);
      });
  scene.draw(0, frame, kFull, stats, [&](const ShadedTriangle& triangle) { run.draw(triangle); });
  run.finish();
  return stats.raster;
}

RasterStats draw_by_engine(const Scene& scene, const FrameState& frame) {
  RunStats stats;
  FrameEngine engine(frame, kFull);
  scene.draw(0, frame, kFull, stats, engine);
  return engine.stats();
}

// A byte kept per triangle would be 400,000.
template <class Draw>
void expect_no_more_for_more(const Draw& draw) {
  const auto few = static_cast<double>(drawing_bytes(80000, draw));
  const auto many = static_cast<double>(drawing_bytes(480000, draw));
  EXPECT_LT(many, few + 100000);
  EXPECT_LT(many, 20e6);
}

class MemoryOf : public testing::TestWithParam<Fidelity> {};

TEST_P(MemoryOf, DrawingTakesNoMoreForMoreTriangles) {
  expect_no_more_for_more([](const Scene& scene, const FrameState& frame) {
    return draw_by_stages(GetParam(), scene, frame);
  });
}

TEST(Memory, FrameEngineTakesNoMoreForMoreTriangles) { expect_no_more_for_more(draw_by_engine); }

// Bytes allocated for an engine and that many triangles, each over half of the frame or more.
std::size_t large_triangle_bytes(int triangles, int size, const Config& config, int threads) {
  std::vector<glm::vec3> positions;
  std::vector<TriangleIndices> indices;
  for (int i = 0; i < triangles; ++i) {
    const auto first = static_cast<std::uint32_t>(3 * i);
    // Each before the last: all of it passes.
    const float z = 0.9f - 1.8f * static_cast<float>(i) / static_cast<float>(triangles);
    for (const glm::vec2 at : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1)}) {
      positions.emplace_back(i % 2 == 0 ? at : -at, z);
    }
    indices.push_back({first, first + 1, first + 2});
  }
  const std::vector<glm::vec3> colors(positions.size(), glm::vec3(200, 100, 50));
  FrameOptions options;
  options.threads = threads;
  options.run = run_on_threads;
  const std::size_t before = live_bytes;
  peak_bytes = before;
  FrameEngine engine({size, size, Cull::kNone}, config, options);
  engine.draw(MeshView{positions, colors, indices}, glm::dmat4(1.0));
  const auto half = static_cast<std::uint64_t>(triangles) * static_cast<std::uint64_t>(size) *
                    static_cast<std::uint64_t>(size) / 2;
  EXPECT_GT(engine.stats().fragments_shaded, half - half / 50);
  return peak_bytes - before;
}

// What a frame's tiles take, and some megabytes: 64 triangles are two million tiles at one sample.
TEST(Memory, FrameEngineTakesNoMoreForMoreLargeTriangles) {
  for (const int threads : {1, 2}) {
    for (const Config& config : {kFull, kMsaa4}) {
      const int size = config.samples == 1 ? 2048 : 1024;
      const auto few = static_cast<double>(large_triangle_bytes(4, size, config, threads));
      const auto many = static_cast<double>(large_triangle_bytes(64, size, config, threads));
      const double framebuffer = 8.0 * config.samples * size * size;
      EXPECT_GT(few, framebuffer);
      EXPECT_LT(many, few + 4e6 * threads)
          << threads << " threads, " << config.samples << " samples";
      EXPECT_LT(many, framebuffer + 4e6 * threads) << threads << " threads, " << config.samples;
    }
  }
}

// 16,384 of them have 1.2 million records, were all to be kept at a time.
TEST(Memory, SeveralThreadsKeepFewRecordsOfLargeTriangles) {
  const auto many = static_cast<double>(large_triangle_bytes(16384, 256, kFull, 2));
  EXPECT_LT(many, 16e6);
}

INSTANTIATE_TEST_SUITE_P(Levels, MemoryOf,
                         testing::Values(Fidelity::kCoverage, Fidelity::kBit, Fidelity::kCycle));

}  // namespace
}  // namespace halfspace
