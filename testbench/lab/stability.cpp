// SPDX-License-Identifier: Apache-2.0
#include "stability.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>

#include "geometry.hpp"
#include "io/interrupt.hpp"
#include "rasterizer.hpp"
#include "suite_shapes.hpp"

namespace halfspace::lab {
namespace {

using methods::Canvas;
using methods::InputKind;
using methods::Method;

constexpr int kSeconds = 10;  // CPU time per case

bool applies(const Method& method, const Suite& suite, const SuiteCase& one) {
  if ((one.kinds >> static_cast<int>(method.input()) & 1u) == 0) return false;
  const bool colors = suite.judge == Judge::kAttribute || suite.judge == Judge::kDepth;
  return method.attributes || !colors;
}

void draw_clipped(const methods::ClipFacet& facet, const methods::View& view, Canvas& canvas) {
  Config config;
  config.viewport_bits = 15;
  config.guard_bits = 16;
  const FrameState frame{view.width, view.height, Cull::kNone};
  GeometryStage stage(frame, config);
  std::array<ClipVertex, 3> triangle;
  for (std::size_t i = 0; i < 3; ++i) triangle[i].position = facet[i].position;
  std::vector<ShadedTriangle> pieces;
  stage.process(triangle, 0, pieces);
  RasterStats stats;
  for (const ShadedTriangle& piece : pieces) {
    rasterize(piece.triangle, frame, config, stats, [&](const CoverageTile& tile) {
      for (GridMask rest = tile.mask[0]; rest != 0; rest &= rest - 1) {
        const int lane = std::countr_zero(rest);
        canvas.hit(tile.x + lane % config.grid(), tile.y + lane / config.grid());
      }
    });
  }
}

// The child's answer, or how it ended.
CaseResult collect(pid_t child, int pipe) {
  CaseResult out;
  char* bytes = reinterpret_cast<char*>(&out);
  std::size_t got = 0;
  while (got < sizeof out) {
    const ssize_t n = read(pipe, bytes + got, sizeof out - got);
    if (n <= 0) break;
    got += static_cast<std::size_t>(n);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (got == sizeof out && WIFEXITED(status) && WEXITSTATUS(status) == 0) return out;
  out = {};
  out.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  out.hung = out.signal == SIGXCPU || out.signal == SIGKILL;
  out.crashed = !out.hung;
  return out;
}

template <class Work>
CaseResult in_child(int seconds, Work&& work) {
  int ends[2];
  if (pipe(ends) != 0) return work();
  const pid_t child = fork();
  if (child < 0) return work();
  if (child == 0) {
    const rlimit cpu{static_cast<rlim_t>(seconds), static_cast<rlim_t>(seconds + 1)};
    setrlimit(RLIMIT_CPU, &cpu);
    const rlimit core{0, 0};
    setrlimit(RLIMIT_CORE, &core);
    leave_interrupts();
    signal(SIGXCPU, SIG_DFL);
    signal(SIGSEGV, SIG_DFL);
    const CaseResult result = work();
    const bool sent = write(ends[1], &result, sizeof result) == sizeof result;
    _exit(sent ? 0 : 1);
  }
  close(ends[1]);
  const CaseResult result = collect(child, ends[0]);
  close(ends[0]);
  return result;
}

bool failed(const CaseResult& r) { return r.hung || r.crashed; }

nlohmann::ordered_json marks(const Cell& cell, Judge judge) {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  const auto any = [&](auto&& test) {
    return std::any_of(cell.cases.begin(), cell.cases.end(),
                       [&](const auto& entry) { return test(entry.second); });
  };
  if (any([](const CaseResult& r) { return r.not_finite != 0; })) out.push_back("nan");
  if (any([](const CaseResult& r) { return r.crashed; })) out.push_back("crash");
  if (any([](const CaseResult& r) { return r.hung; })) out.push_back("hang");
  if (judge == Judge::kOrder && any([](const CaseResult& r) { return r.wrong != 0; })) {
    out.push_back("order");
  }
  return out;
}

nlohmann::ordered_json cell_json(const Cell& cell, const Suite& suite) {
  nlohmann::ordered_json json{{"method", cell.method},
                              {"suite", cell.suite},
                              {"wrong_ppm", cell.ppm()},
                              {"marks", marks(cell, suite.judge)},
                              {"worst", cell.worst()}};
  if (cell.snapped_ppm) json["wrong_ppm_snapped"] = *cell.snapped_ppm;
  for (const auto& [name, r] : cell.cases) {
    nlohmann::ordered_json one{{"case", name}, {"covered", r.covered}, {"wrong", r.wrong}};
    if (suite.judge == Judge::kHits) {
      one["gaps"] = r.gaps;
      one["doubles"] = r.doubles;
    }
    if (suite.judge == Judge::kAttribute) one["greatest_lsb"] = r.greatest;
    if (r.not_finite != 0) one["not_finite"] = r.not_finite;
    if (r.hung) one["hung"] = true;
    if (r.crashed) one["signal"] = r.signal;
    json["cases"].push_back(std::move(one));
  }
  return json;
}

}  // namespace

double Cell::ppm() const {
  CaseResult sum;
  for (const auto& [name, r] : cases) {
    if (failed(r)) return 1e6;
    sum.covered += r.covered;
    sum.wrong += r.wrong;
  }
  return sum.ppm();
}

const std::string& Cell::worst() const {
  return std::max_element(
             cases.begin(), cases.end(),
             [](const auto& a, const auto& b) { return a.second.ppm() < b.second.ppm(); })
      ->first;
}

const std::vector<Method>& lab_methods() {
  static const std::vector<Method> list = [] {
    std::vector<Method> all(methods::all().begin(), methods::all().end());
    Method m = *methods::find("halfspace_s8");
    m.name = "halfspace_clip";
    m.title = "The project's geometry stage and pipeline: clip, divide, snap, cover";
    m.exact = false;  // a cut point is rounded to a subpixel
    m.attributes = false;
    m.draw = methods::DrawClip(draw_clipped);
    all.push_back(std::move(m));
    return all;
  }();
  return list;
}

CaseResult run_case(const Method& method, const Suite& suite, const SuiteCase& one) {
  return case_pixels(method, suite, one, -1).result;
}

CaseResult run_case_guarded(const Method& method, const Suite& suite, const SuiteCase& one,
                            int seconds) {
  return in_child(seconds, [&] { return run_case(method, suite, one); });
}

std::optional<Cell> run_cell(const Method& method, const Suite& suite) {
  Cell cell{method.name, suite.name, {}, {}};
  CaseResult snapped;
  const int bits = method.subpixel_bits;
  const bool coarse = bits >= 0 && bits < 8 && suite.judge == Judge::kHits;
  for (const SuiteCase& one : suite.make()) {
    if (!applies(method, suite, one)) continue;
    cell.cases.emplace_back(one.name, run_case_guarded(method, suite, one, kSeconds));
    if (!coarse || one.hits) continue;
    const CaseResult r =
        in_child(kSeconds, [&] { return case_pixels(method, suite, one, bits).result; });
    snapped.covered += r.covered;
    snapped.wrong += r.wrong;
  }
  if (cell.cases.empty()) return std::nullopt;
  if (coarse) cell.snapped_ppm = snapped.ppm();
  return cell;
}

nlohmann::ordered_json stability_json(const std::vector<const Method*>& methods,
                                      const std::vector<const Suite*>& suites,
                                      const std::function<void()>& progress) {
  nlohmann::ordered_json json;
  json["chart"] = "stability";
  json["attribute_bound_lsb"] = kAttributeBound;
  for (const Suite* suite : suites) {
    json["suites"].push_back({{"name", suite->name},
                              {"title", suite->title},
                              {"reason", suite->reason},
                              {"exact", suite->exact}});
  }
  json["cells"] = nlohmann::ordered_json::array();
  for (const Method* method : methods) {
    json["methods"].push_back({{"name", method->name},
                               {"row", method->row},
                               {"family", method->family},
                               {"input", methods::input_name(method->input())},
                               {"exact", method->exact}});
    for (const Suite* suite : suites) {
      const auto cell = run_cell(*method, *suite);
      if (cell) json["cells"].push_back(cell_json(*cell, *suite));
      progress();
    }
  }
  return json;
}

Suite scene_suite(const RealScene& scene) {
  Suite suite;
  suite.name = "scene";
  suite.title = scene.name;
  suite.reason = "the scene itself";
  suite.exact = false;
  suite.make = [&scene] {
    std::vector<Facet> facets;
    for (const oracle::Corners& t : scene.triangles) {
      facets.push_back(facet_of({t[0].x, t[0].y}, {t[1].x, t[1].y}, {t[2].x, t[2].y}));
    }
    return std::vector<SuiteCase>{area_case(scene.name, facets, {scene.width, scene.height})};
  };
  return suite;
}

nlohmann::ordered_json scene_stability(const RealScene& scene) {
  const Suite suite = scene_suite(scene);
  std::vector<const Method*> methods;
  for (const Method& method : lab_methods()) methods.push_back(&method);
  return stability_json(methods, {&suite}, [] {});
}

}  // namespace halfspace::lab
