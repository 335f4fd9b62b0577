// SPDX-License-Identifier: Apache-2.0
//
// halfspace vectors: stimulus and expected results for other people's benches.
#include "vectors_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "io/error.hpp"
#include "io/input_files.hpp"
#include "io/output_file.hpp"
#include "number_checks.hpp"
#include "vectors/vectors_bench.hpp"
#include "vectors/vectors_file.hpp"

namespace halfspace {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& place, const std::string& text) {
  throw Error(ErrorCode::kVectorRequest, place, text);
}

VectorMeta meta_of(const VectorsRequest& request) {
  VectorMeta meta;
  const std::optional<VectorStage> stage = find_stage(request.stage);
  if (!stage) {
    std::string names;
    for (int i = 0; i < kVectorStages; ++i) {
      names += (i == 0 ? "" : ", ") + std::string(stage_name(static_cast<VectorStage>(i)));
    }
    refuse("--stage", fmt::format("'{:.40}' is no stage (there are {})", request.stage, names));
  }
  meta.stage = *stage;
  meta.config = request.config.load();
  meta.seed = request.seed;
  meta.program = std::string("halfspace ") + HALFSPACE_VERSION;
  if (meta.stage == VectorStage::kTileTraversal) {
    meta.level = request.node_level;
    const int levels = meta.config.levels() - 1;
    if (meta.level < 0 || meta.level >= levels) {
      refuse("--node-level",
             levels == 0 ? "this configuration has no level that tests nodes"
                         : fmt::format("{} is out of range (0..{})", meta.level, levels - 1));
    }
  } else if (request.node_level != 0) {
    refuse("--node-level", "only stage tile_traversal has levels");
  }
  return meta;
}

void require_request(const VectorsRequest& request, const VectorMeta& meta) {
  const int sources = (request.in.empty() ? 0 : 1) + (request.generate.empty() ? 0 : 1) +
                      (request.goal.empty() ? 0 : 1) + (request.from.empty() ? 0 : 1);
  if (sources != 1) {
    refuse("", "give one source: a file, --generate, --goal or --from (try --help)");
  }
  if (request.goal.empty() && request.out.empty() && request.bench.empty()) {
    refuse("", "give --out FILE or --bench FOLDER (try --help)");
  }
  if (!(request.stall >= 0 && request.stall <= 0.95)) {
    refuse("--stall", fmt::format("{} is out of range (0..0.95)", request.stall));
  }
  if (request.in == kStandardStream) {
    refuse("IN", "vectors name their source: give a file, not standard input (-)");
  }
  if (std::count(request.out.begin(), request.out.end(), kStandardStream) != 0) {
    if (request.out.size() > 1 || !request.bench.empty() || !request.goal.empty()) {
      refuse("--out", "standard output (-) takes one file and nothing else");
    }
    if (request.format.empty()) {
      refuse("--out", "standard output (-) has no name to know a format by: give --format");
    }
  }
  if (request.list_bins && request.goal.empty()) refuse("--list-bins", "is for --goal and --bins");
  if (request.max_tiles < 1) refuse("--max-tiles", "must be 1 or more");
  if (!request.bench.empty() && !has_rtl(meta.stage)) {
    refuse("--bench", fmt::format("stage {} has no RTL yet: write its vectors with --out",
                                  stage_name(meta.stage)));
  }
}

FolderFiles outputs_of(const VectorsRequest& request, const VectorSet& set) {
  FolderFiles outputs;
  if (request.out == std::vector<std::string>{kStandardStream}) {  // one file, and no manifest
    const VectorFormat format = vector_format(kStandardStream, request.format);
    outputs.push_back({"", vector_files(set, format, kStandardStream)});
    if (format != VectorFormat::kReadmemh) return outputs;
    refuse("--out", "readmemh makes several files: standard output (-) takes one");
  }
  for (const std::string& out : request.out) {
    const fs::path path(out);
    const std::vector<NamedBytes> files =
        vector_files(set, vector_format(out, request.format), path.filename().string());
    const std::string folder = path.parent_path().string();
    if (outputs.empty() || outputs.back().first != folder) outputs.push_back({folder, {}});
    outputs.back().second.insert(outputs.back().second.end(), files.begin(), files.end());
  }
  if (!outputs.empty()) {
    if (outputs.size() > 1) refuse("--out", "files of one manifest go to one folder");
    std::vector<NamedBytes>& files = outputs.front().second;
    const std::string name = request.manifest.empty()
                                 ? fs::path(request.out.front()).stem().string() + ".manifest.json"
                                 : request.manifest;
    files.push_back(vector_manifest(set, files, name));
  }
  if (!request.bench.empty()) outputs.push_back({request.bench, vector_bench(set)});
  return outputs;
}

int run_vectors(const VectorsRequest& request) {
  if (!request.check.empty()) return check_vector_files(request.check);
  if (!request.bins.empty()) return report_bins_of(request);
  std::vector<PlacedVectors> read;
  if (!request.from.empty()) read = read_vectors(request.from);
  const VectorMeta meta = read.empty() ? meta_of(request) : read.front().set.meta;
  require_request(request, meta);
  note_input(request.in);
  check_distinct(request.out);
  for (const std::string& out : request.out) {
    vector_format(out, request.format);
    check_writable(out);
  }
  const GoalResult made = !read.empty()          ? GoalResult{std::move(read.front().set), true}
                          : request.goal.empty() ? GoalResult{make_vectors(request, meta), true}
                                                 : make_goal(request, meta);
  const VectorSet& set = made.set;
  const VectorCounts counts = count_records(set);
  if (counts.inputs == 0 || counts.outputs == 0) {
    throw Error(ErrorCode::kVectorsEmpty, request.in,
                fmt::format("{} inputs, {} outputs of {}: nothing to compare", counts.inputs,
                            counts.outputs, stage_name(meta.stage)));
  }
  const FolderFiles outputs = outputs_of(request, set);
  const bool to_stdout = !request.out.empty() && request.out.front() == kStandardStream;
  fmt::print(to_stdout ? stderr : stdout, "{}: {} runs, {} inputs, {} outputs\n",
             stage_name(meta.stage), counts.runs, counts.inputs, counts.outputs);
  write_files(outputs);
  return made.reached ? 0 : 1;
}

// Coverage bins, and the checking of files. After all others: some stand alone.
void add_bin_options(Command& command, VectorsRequest& request) {
  command
      .add_option("--goal", request.goal,
                  "The fewest triangles found that hit this part of the reachable bins")
      ->type_name("PERCENT");
  command.add_option("--tries", request.tries, "Triangles that --goal draws at most")
      ->check(whole(1))
      ->capture_default_str();
  command.add_option("--times", request.times, "How often --goal hits each bin, where it can")
      ->capture_default_str();
  Option* bins = command.add_option("--bins", request.bins,
                                    "Report the bins that the triangles of a file hit");
  command.add_flag("--list-bins", request.list_bins, "Report the bins that are hit too");
  Option* check =
      command.add_option("--check", request.check,
                         "Build every expected result of a file or manifest again and compare");
  command.stands_alone(check);
  command.stands_alone(bins, {"--list-bins"});
}

}  // namespace

Action add_vectors_command(Command& program) {
  Command* command = program.add_subcommand(
      "vectors", "Write stimulus and expected results of a stage, or check a file of them");
  auto o = std::make_shared<VectorsRequest>();
  command->add_option("IN", o->in, "Mesh (OBJ, glTF, GLB, PLY, STL) or TCOV file");
  command
      ->add_option("--generate", o->generate,
                   "Random triangles instead: all, or shapes with commas (in_frame, sliver, ...)")
      ->type_name("SHAPES");
  command
      ->add_option("--stage", o->stage,
                   "rasterizer, triangle_setup, half_plane_grid, tile_traversal, coverage, "
                   "interpolation or depth")
      ->capture_default_str();
  command->add_option("--node-level", o->node_level,
                      "Stage tile_traversal: level of the pyramid, 0 is the root");
  command->add_option("--out", o->out,
                      "File to write: .hex, .csv, .jsonl or .hsv; repeatable; -: standard output");
  command->add_option("--format", o->format, "Format of --out, whatever the names end in")
      ->type_name("readmemh|csv|jsonl|binary");
  command->add_option("--manifest", o->manifest,
                      "Name of the manifest, beside the files (default NAME.manifest.json)");
  command->add_option("--bench", o->bench,
                      "Folder for a self-checking SystemVerilog bench with its vectors");
  command
      ->add_option("--count", o->count, "Triangles (default: all of a file, 1000 of a generator)")
      ->check(whole(1));
  command->add_option("--seed", o->seed, "Seed of the generator and of the stalls")
      ->check(whole())
      ->capture_default_str();
  command->add_option("--stall", o->stall, "Probability that input or output is held up, 0..0.95")
      ->capture_default_str();
  command
      ->add_option("--max-tiles", o->max_tiles, "Generator: leaf tiles a triangle visits at most")
      ->capture_default_str();
  command->add_option("--size", o->size, "Frame size in pixels (default 640x480)")
      ->type_name("WxH");
  command->add_option("--case", o->case_id, "The case of a TCOV file (default: all)")
      ->check(whole());
  add_cull_option(*command, o->cull);
  o->config.add_to(*command);
  o->camera.add_to(*command);
  Option* from = command->add_option("--from", o->from,
                                     "Vectors to write again, in other formats or as a bench");
  for (const char* other : {"--config", "--samples", "--generate", "--stage", "--size", "--case",
                            "--count", "--seed", "--stall", "--cull", "--max-tiles", "--node-level",
                            "--eye", "--target", "--up", "--fov", "--ortho"}) {
    from->excludes(command->get_option(other));  // the vectors have their own
  }
  add_bin_options(*command, *o);
  const auto needs = [&](const char* option, const char* other) {
    command->get_option(option)->needs(command->get_option(other));
  };
  for (const char* option : {"--eye", "--target", "--up", "--fov", "--ortho", "--case"}) {
    needs(option, "IN");
  }
  for (const char* option : {"--tries", "--times"}) needs(option, "--goal");
  needs("--max-tiles", "--generate");
  for (const char* option : {"--manifest", "--format"}) needs(option, "--out");
  command->footer(
      "Exit status: 0 done, equal or goal reached; 1 --check found a difference, or bins are "
      "missed; 2 bad input.\n"
      "Example: halfspace vectors --generate all --count 500 --config tiny --bench out/bench");
  return [o] { return run_vectors(*o); };
}

}  // namespace halfspace
