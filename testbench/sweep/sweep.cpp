// SPDX-License-Identifier: Apache-2.0
#include "sweep.hpp"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <set>

#include "io/config_json.hpp"
#include "io/interrupt.hpp"
#include "io/output_file.hpp"
#include "line_reader.hpp"
#include "measures.hpp"
#include "rtl/rtl_build.hpp"
#include "scene/progress.hpp"

namespace halfspace {
namespace {

namespace fs = std::filesystem;

// Its manifest, when the file is whole and of the same making.
std::optional<Manifest> finished(const std::string& path, const Shard& shard,
                                 const Provenance& from) {
  std::error_code failed;
  if (!fs::exists(path, failed)) return {};
  const std::optional<Manifest> manifest = parse_manifest(last_line(path));
  if (!manifest || !(manifest->from == from) || manifest->shard.text() != shard.text()) return {};
  return manifest;
}

std::string failure_text(const nlohmann::ordered_json& record) {
  const auto text = record.contains("error") ? record["error"]["text"].get<std::string>()
                                             : record["rtl"].value("mismatch", std::string());
  return fmt::format("case {}: {}", record["case"].get<std::uint64_t>(), text);
}

}  // namespace

std::uint64_t build_rtl(const SweepCases& cases) {
  std::set<std::string> built;
  Progress progress("building RTL", cases.count());
  for (std::uint64_t k = 0; k < cases.count(); ++k) {
    const Config config = cases.at(k).config;
    if (built.insert(config_json(config).dump()).second) rtl_object_file(config, false, "rtl");
    progress.step();
  }
  return built.size();
}

SweepOutcome run_shard(const SweepSpecification& specification, const SweepCases& cases,
                       const std::string& folder, const Shard& shard) {
  const Provenance from = provenance_of(specification.hash);
  SweepOutcome out;
  out.path = (fs::path(folder) / shard_file_name(shard)).string();
  if (const std::optional<Manifest> manifest = finished(out.path, shard, from)) {
    out.records = manifest->records;
    out.failed = manifest->failed;
    out.was_there = true;
    return out;
  }
  const auto start = std::chrono::steady_clock::now();
  ShardWriter writer(folder, shard, from, cases.count());
  outputs_stay_on_interrupt();
  CaseMeasurer measurer(specification, folder);
  Progress progress("sweeping", shard.share(cases.count()) - writer.records());
  for (std::uint64_t k = shard.index + writer.records() * shard.count; k < cases.count();
       k += shard.count) {
    const nlohmann::ordered_json record = measurer.measure(cases.at(k));
    const bool failed = record_failed(record);
    if (failed && out.first_failure.empty()) out.first_failure = failure_text(record);
    writer.add(record.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n",
               failed);
    progress.step();
  }
  out.records = writer.records();
  out.failed = writer.failed();
  Manifest manifest;
  manifest.from = from;
  manifest.shard = shard;
  manifest.cases = cases.count();
  manifest.left_out = cases.left_out();
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  manifest.seconds = took.count();
  writer.finish(manifest);
  return out;
}

}  // namespace halfspace
