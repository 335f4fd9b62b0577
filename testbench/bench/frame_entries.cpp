// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "engines/common/threads.hpp"
#include "engines/coverage/coverage_engine.hpp"
#include "engines/frame/frame_engine.hpp"
#include "entry.hpp"
#include "rasterizer.hpp"

namespace halfspace {
namespace {

BenchRow bit_row(std::string isa, int threads) {
  BenchRow row;
  row.work = "frame";
  row.engine = "bit";
  row.isa = std::move(isa);
  row.threads = threads;
  return row;
}

// The stages one after the other, as halfspace render --level bit does it.
BenchOutput draw_by_stages(const Workload& work) {
  Rasterizer rasterizer(work.frame, kBenchConfig, DepthFunction::kLess, kBenchBackground);
  GeometryStage stage(work.frame, kBenchConfig);
  std::vector<ClipVertex> vertex;
  vertex.reserve(work.mesh->positions.size());
  for (std::uint32_t i = 0; i < work.mesh->positions.size(); ++i) {
    vertex.push_back(work.mesh->vertex(i));
  }
  std::vector<ShadedTriangle> pieces;
  std::uint32_t tag = 0;
  for (const auto& index : work.mesh->triangles) {
    pieces.clear();
    stage.process({vertex[index[0]], vertex[index[1]], vertex[index[2]]}, tag++, pieces);
    for (const ShadedTriangle& piece : pieces) rasterizer.draw(piece);
  }
  return {rasterizer.stats().samples_covered, {}, {}, rasterizer.framebuffer().resolve(), {}};
}

// The same frame by FrameEngine, which keeps its memory and the picture from frame to frame.
class EngineFrame {
 public:
  EngineFrame(const Workload& work, const std::string& isa, int threads)
      : work_(work), engine_(work.frame, kBenchConfig, options(isa, threads)) {}

  PictureView run() {
    engine_.clear();
    engine_.draw(MeshView{work_.mesh->positions, work_.mesh->colors, work_.mesh->triangles},
                 work_.mesh->matrix);
    return engine_.picture();
  }

  BenchOutput count() {
    const PictureView view = run();
    Image picture{work_.frame.width, work_.frame.height, {}};
    for (std::size_t y = 0; y < view.height; ++y) {
      for (const std::uint32_t pixel : view.line(y)) {
        picture.pixel.push_back({static_cast<std::uint8_t>(pixel),
                                 static_cast<std::uint8_t>(pixel >> 8),
                                 static_cast<std::uint8_t>(pixel >> 16)});
      }
    }
    return {engine_.stats().samples_covered, {}, {}, std::move(picture), {}};
  }

 private:
  static FrameOptions options(const std::string& isa, int threads) {
    FrameOptions out;
    out.background = kBenchBackground;
    out.isa = isa;
    out.threads = threads;
    out.run = run_on_threads;
    return out;
  }

  const Workload& work_;
  FrameEngine engine_;
};

}  // namespace

std::vector<BenchEntry> frame_entries(const Workload& work, const BenchOptions& options) {
  std::vector<BenchEntry> entries;
  const auto by_stages = [&work] { return draw_by_stages(work); };
  entries.push_back({bit_row("-", 1), [by_stages] { by_stages(); }, by_stages});
  for (const std::string& isa : wanted_isas(options, coverage_isas())) {
    for (const int threads : options.threads) {
      const auto frame = std::make_shared<EngineFrame>(work, isa, threads);
      entries.push_back(
          {bit_row(isa, threads), [frame] { frame->run(); }, [frame] { return frame->count(); }});
    }
  }
  return entries;
}

}  // namespace halfspace
