// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <charconv>

#include "io/error.hpp"
#include "scene/progress.hpp"
#include "vectors/goal.hpp"
#include "vectors/packets_of.hpp"
#include "vectors/stimulus.hpp"
#include "vectors/vector_builder.hpp"
#include "vectors/vectors_file.hpp"
#include "vectors_command.hpp"

namespace halfspace {
namespace {

// "95" or "95%" as 0.95.
double parse_goal(std::string text) {
  if (text.ends_with('%')) text.pop_back();
  double percent = 0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), percent);
  if (parsed.ec != std::errc() || parsed.ptr != text.data() + text.size() ||
      !(percent > 0 && percent <= 100)) {
    throw Error(ErrorCode::kVectorRequest, "--goal",
                fmt::format("'{:.40}' is not a percentage above 0, up to 100", text));
  }
  return percent / 100;
}

double percent_of(std::size_t part, std::size_t whole) {
  return whole == 0 ? 100.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

// A line for each bin that is missed, or unreachable with the reason, and with `list` for each that
// is hit; then the counts. Returns the reachable ones that were hit.
std::size_t report(const BinModel& model, const BinSet& hits, bool list) {
  std::size_t hit = 0;
  for (std::size_t i = 0; i < model.bins().size(); ++i) {
    const Bin& bin = model.bins()[i];
    if (!bin.reason.empty()) {
      if (hits.has(i)) {
        fmt::print("WRONG: {} was hit, but was held for unreachable: {}\n", bin.name, bin.reason);
      } else {
        fmt::print("unreachable: {}: {}\n", bin.name, bin.reason);
      }
      continue;
    }
    hit += hits.has(i) ? 1u : 0u;
    if (!hits.has(i)) {
      fmt::print("missed: {}\n", bin.name);
    } else if (list) {
      fmt::print("hit: {}\n", bin.name);
    }
  }
  const std::size_t reachable = model.reachable();
  fmt::print("{} bins: {} hit, {} missed, {} unreachable: {:.2f} % of the reachable ones\n",
             model.bins().size(), hit, reachable - hit, model.bins().size() - reachable,
             percent_of(hit, reachable));
  return hit;
}

// An unreachable bin that was hit is a mistake in its reason.
bool reasons_hold(const BinModel& model, const BinSet& hits) {
  for (std::size_t i = 0; i < model.bins().size(); ++i) {
    if (!model.bins()[i].reason.empty() && hits.has(i)) return false;
  }
  return true;
}

VectorSet set_of(const std::vector<VectorRun>& runs, const VectorMeta& meta, double stall) {
  VectorBuilder builder(meta);
  StimulusMaker stimulus(meta);
  Random random(meta.seed);
  const auto probability = static_cast<std::uint32_t>(stall * 0x1p32);
  std::uint64_t number = 0;
  for (const VectorRun& run : runs) {
    stimulus.begin_frame(run.frame);
    builder.run(run.frame, run.stalled ? probability : 0, meta.seed + number++);
    for (const Triangle& triangle : run.triangles) {
      stimulus.draw({triangle, random_attributes(random, meta.config)},
                    [&builder](const Values& ports) { builder.add(ports); });
    }
  }
  return builder.finish();
}

}  // namespace

GoalResult make_goal(const VectorsRequest& request, VectorMeta meta) {
  const double goal = parse_goal(request.goal);
  if (request.times < 1) throw Error(ErrorCode::kVectorRequest, "--times", "must be 1 or more");
  const BinModel model(meta.config);
  meta.source = "goal";
  meta.source_name = fmt::format("{:g}%", 100 * goal);
  std::vector<SampledUnit> units;
  {
    Progress progress("hitting bins", model.reachable());
    std::size_t before = 0;
    units = search_goal(model, goal, request.times, request.tries, meta.seed, [&](std::size_t hit) {
      progress.advance(hit - before);
      before = hit;
    });
  }
  units = minimal_units(units, request.times, model);
  BinSet hits = model.none();
  std::size_t triangles = 0;
  for (const SampledUnit& unit : units) {
    hits.add(unit.hits);
    triangles += unit.unit.triangles.size();
  }
  const std::size_t hit = report(model, hits, request.list_bins);
  const std::vector<VectorRun> runs = by_frame(units, request.stall > 0, meta.config);
  fmt::print("{} triangles in {} runs\n", triangles, runs.size());
  const bool reached =
      static_cast<double>(hit) >= goal * static_cast<double>(model.reachable()) - 1e-9;
  return {set_of(runs, meta, request.stall), reached && reasons_hold(model, hits)};
}

int report_bins_of(const VectorsRequest& request) {
  bool complete = true;
  for (const PlacedVectors& placed : read_vectors(request.bins)) {
    const VectorMeta& meta = placed.set.meta;
    if (meta.stage > VectorStage::kTriangleSetup) {
      throw Error(ErrorCode::kVectorRequest, placed.place,
                  "bins are of triangles: stage rasterizer or triangle_setup");
    }
    const BinModel model(meta.config);
    BinSet hits = model.none();
    FrameState frame;
    std::vector<Triangle> triangles;
    std::size_t count = 0;
    const auto flush = [&] {
      if (!triangles.empty()) model.sample(frame, triangles, hits);
      count += triangles.size();
      triangles.clear();
    };
    const auto book = static_cast<std::ptrdiff_t>(bookkeeping_fields(RecordKind::kIn, meta.stage));
    for (const VectorRecord& record : placed.set.records) {
      if (record.kind == RecordKind::kRun) {
        flush();
        frame = frame_of(record.values);
      } else if (record.kind == RecordKind::kIn) {
        triangles.push_back(triangle_of(Values(record.values.begin() + book, record.values.end())));
      }
    }
    flush();
    const std::size_t hit = report(model, hits, request.list_bins);
    fmt::print("{}: {} triangles\n", placed.place, count);
    complete = complete && hit == model.reachable() && reasons_hold(model, hits);
  }
  return complete ? 0 : 1;
}

}  // namespace halfspace
