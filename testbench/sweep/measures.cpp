// SPDX-License-Identifier: Apache-2.0
#include "measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "engines/cycle/cycle_engine.hpp"
#include "fit/area_model.hpp"
#include "fit/emit.hpp"
#include "io/config_json.hpp"
#include "io/config_package.hpp"
#include "io/error.hpp"
#include "io/escape.hpp"
#include "io/fnv.hpp"
#include "io/output_file.hpp"
#include "io/source_tree.hpp"
#include "rtl/cosim.hpp"

namespace halfspace {
namespace {

using Json = nlohmann::ordered_json;

#ifdef HALFSPACE_HAS_ORACLE
constexpr bool kHasOracle = true;
#else
constexpr bool kHasOracle = false;  // and read_sweep() refuses coverage_error
#endif

// Wants the clock of the first tile.
struct FirstTile {
  static constexpr bool kWantsSetup = false;
  static constexpr bool kWantsNodes = false;
  std::optional<std::uint64_t> clock;
  void accepted(Timing::Clock) const {}
  void setup(Timing::Clock, const SetupTriangle&) const {}
  void node(int, Timing::Clock, const Node&) const {}
  void tile(Timing::Clock at, const CoverageTile&) {
    if (!clock) clock = static_cast<std::uint64_t>(at);
  }
};

std::vector<Triangle> triangles_of(const FitView& view, const Config& config) {
  std::vector<Triangle> out;
  RunStats unused;
  view.scene->draw(view.index, view.frame, config, unused,
                   [&](const ShadedTriangle& shaded) { out.push_back(shaded.triangle); });
  return out;
}

Json clocks_of(const FitView& view, const Config& config) {
  FirstTile first;
  CycleEngine engine(view.frame, config, Stalls());
  engine.draw(triangles_of(view, config), first);
  const std::uint64_t clocks = engine.clocks();
  const std::uint64_t fragments = engine.stats().fragments;
  return {{"clocks", clocks},
          {"fragments", fragments},
          {"pixels_per_clock",
           clocks == 0 ? 0.0 : static_cast<double>(fragments) / static_cast<double>(clocks)}};
}

// From reset to the first covered tile at the output; null where there is none.
Json latency_of(const FitView& view, const Config& config) {
  FirstTile first;
  CycleEngine engine(view.frame, config, Stalls());
  for (const Triangle& triangle : triangles_of(view, config)) {
    engine.draw(triangle, first);
    if (first.clock) break;
  }
  Json out;
  out["clocks"] = first.clock ? Json(*first.clock) : Json();
  return out;
}

Json area_of(const Config& config) {
  const AreaEstimate area = area_estimate(config);
  return {{"luts", area.luts()},
          {"lut4", area.lut4},
          {"ccu2c", area.ccu2c},
          {"flip_flops", area.flip_flops},
          {"multipliers", area.multipliers}};
}

Json attribute_error_of(const FitView& view, const Config& config, std::uint64_t budget) {
  Json out;
  if (config.attributes == 0) return out;
  out["levels"] = attribute_error({view}, config, std::max<std::uint64_t>(1, budget / 40));
  return out;
}

Json error_json(ErrorCode code, const std::string& text) {
  return {{"code", fmt::format("HS{:03}", static_cast<int>(code))},
          {"text", text.substr(0, text.find('\n'))}};
}

}  // namespace

CaseMeasurer::CaseMeasurer(const SweepSpecification& specification, std::string work)
    : specification_(specification), work_(std::move(work)) {}

const FitView& CaseMeasurer::view_of(const SweepCase& at) {
  const std::pair key(at.scene, at.size);
  if (open_ != key) {
    open_.reset();
    metered_.reset();
    const std::string& path = specification_.scene_files[at.scene];
    const std::shared_ptr<const Scene> scene =
        open_scene(path, -1, specification_.sizes[at.size], {}, Lighting::kGouraud,
                   is_tcov(path) ? 1 : specification_.views);
    views_ = fit_views(scene, path, Cull::kNone);
    open_ = key;
  }
  return views_.at(at.view);
}

Json CaseMeasurer::coverage_error_of(const FitView& view, const Config& config) {
  const std::pair key(&view, config.samples);
  if (metered_ != key) {
    metered_.reset();
    if constexpr (kHasOracle) {
      meter_ = coverage_meter(view, config.samples, specification_.budget);
    }
    metered_ = key;
  }
  const CoverageError error = meter_(config);
  return {{"ppm", error.ppm()},
          {"covered", error.covered},
          {"missing", error.missing},
          {"extra", error.extra}};
}

Json CaseMeasurer::rtl_of(const FitView& view, const Config& config) {
  if (!rtl_ || rtl_->config() != config) {
    rtl_.reset();
    rtl_ = std::make_unique<RtlRasterizer>(config, false, "rtl");
  }
  const Stalls stalls(specification_.stall, specification_.seed);
  const CosimResult result = cosim(*rtl_, triangles_of(view, config), view.frame, config,
                                   {.stalls = stalls, .trace = {}, .progress = {}});
  Json out{{"identical", !result.mismatch.has_value()},
           {"packets", result.packets_compared},
           {"clocks", result.clocks}};
  if (result.mismatch) out["mismatch"] = result.mismatch->line();
  return out;
}

// By yosys, in a folder of the configuration's own: whoever needs it again finds it.
Json CaseMeasurer::synth_of(const Config& config) const {
  namespace fs = std::filesystem;
  const std::string package = config_package(config, "a Config");
  Fnv name;
  name.add(package);
  const fs::path work = fs::path(work_) / fmt::format("synth-{:016x}", name.value());
  const fs::path out = work / "area.json";
  if (!fs::exists(out)) {
    fs::create_directories(work);
    write_text((work / "hs_config_pkg.sv").string(), package);
    const std::string script =
        (folder_with("testbench/synth/synth_ecp5.py") / "testbench/synth/synth_ecp5.py").string();
    run_tool(fmt::format("python3 {} {} --work {} --out {}", quoted(script),
                         quoted((work / "hs_config_pkg.sv").string()), quoted(work.string()),
                         quoted(out.string())),
             (work / "log").string(), "synth");
  }
  return Json::parse(read_file(out.string()));
}

Json CaseMeasurer::measured(Measure measure, const FitView& view, const Config& config) {
  switch (measure) {
    case Measure::kCoverageError: return coverage_error_of(view, config);
    case Measure::kAttributeError: return attribute_error_of(view, config, specification_.budget);
    case Measure::kClocks: return clocks_of(view, config);
    case Measure::kLatency: return latency_of(view, config);
    case Measure::kArea: return area_of(config);
    case Measure::kSynth: return synth_of(config);
    case Measure::kRtl: return rtl_of(view, config);
  }
  return nullptr;
}

Json CaseMeasurer::measure(const SweepCase& at) {
  Json json;
  json["case"] = at.number;
  json["scene"] = specification_.scenes[at.scene];
  json["view"] = at.view;
  json["config"] = config_json(at.config);
  try {
    const FitView& view = view_of(at);
    require_size(view.frame.width, view.frame.height, at.config, view.name);
    json["size"] = fmt::format("{}x{}", view.frame.width, view.frame.height);
    json["triangles"] = view.scene->triangles(view.index);
    for (const Measure measure : specification_.measures) {
      json[measure_name(measure)] = measured(measure, view, at.config);
    }
  } catch (const Error& error) {
    json["error"] = error_json(error.code(), error.what());
  } catch (const std::runtime_error& error) {  // an RTL that stops
    json["error"] = error_json(ErrorCode::kInternal, error.what());
  }
  return json;
}

}  // namespace halfspace
