// SPDX-License-Identifier: Apache-2.0
//
// halfspace sweep, halfspace merge.
#include <fmt/format.h>

#include <memory>

#include "command.hpp"
#include "io/error.hpp"
#include "io/output_file.hpp"
#include "sweep/sweep.hpp"

namespace halfspace {
namespace {

struct SweepArguments {
  std::string specification, out, shard;
  bool count = false;
  bool build_rtl = false;
};

void say_left_out(const SweepCases& cases) {
  for (const std::string& name : cases.left_out_names()) {
    fmt::print(stderr, "halfspace: note: left out: {}\n", name);
  }
  if (cases.left_out() > cases.left_out_names().size()) {
    fmt::print(stderr, "halfspace: note: {} combinations left out in all\n", cases.left_out());
  }
}

int run_sweep(const SweepArguments& a) {
  if (a.out.empty() && !a.count && !a.build_rtl) {
    throw Error(ErrorCode::kUsage, "--out", "sweep needs a folder for the shard's file");
  }
  const Shard shard = parse_shard(a.shard);
  const SweepSpecification specification = read_sweep(a.specification);
  const SweepCases cases(specification);
  if (a.count) {
    fmt::print("{}\n", cases.count());
    return 0;
  }
  if (a.build_rtl) {
    fmt::print("{} configurations\n", build_rtl(cases));
    return 0;
  }
  say_left_out(cases);
  const SweepOutcome done = run_shard(specification, cases, a.out, shard);
  fmt::print("{}: {} of {} cases{}\n", done.path, done.records, cases.count(),
             done.was_there ? ", there already" : "");
  if (done.failed == 0) return 0;
  fmt::print(stderr, "halfspace: {} of {} cases failed{}{}\n", done.failed, done.records,
             done.first_failure.empty() ? "" : "; the first of this run is ", done.first_failure);
  return 1;
}

struct MergeArguments {
  std::string folder, out;
  bool missing = false;
};

int run_merge(const MergeArguments& a) {
  if (a.missing == !a.out.empty()) {
    throw Error(ErrorCode::kUsage, "merge", "give --out FILE or --missing");
  }
  if (!a.out.empty()) check_writable(a.out);
  const ShardFolder shards = read_shards(a.folder, a.out);
  if (a.missing) {
    if (!shards.missing.empty()) fmt::print("{}\n", ranges_text(shards.missing));
    return 0;
  }
  if (!shards.missing.empty()) {
    fmt::print(stderr, "halfspace: {}: {} of {} shards are missing: {}\n", a.folder,
               shards.missing.size(), shards.count, ranges_text(shards.missing));
    return 1;
  }
  const MergeOutcome merged = merge_shards(shards, a.out);
  fmt::print("{}: {} cases of {} shards, CRC-32 {:08x}\n", a.out, merged.records, shards.count,
             merged.crc);
  if (merged.failed == 0) return 0;
  fmt::print(stderr, "halfspace: {} of {} cases failed\n", merged.failed, merged.records);
  return 1;
}

}  // namespace

Action add_sweep_command(Command& program) {
  Command* command = program.add_subcommand(
      "sweep", "Measure scenes x views x configurations, or a shard of them");
  auto a = std::make_shared<SweepArguments>();
  command->add_option("SPEC", a->specification, "What to measure, JSON")->required();
  command->add_option("--out", a->out, "Folder for the shard's file, made if need be");
  command
      ->add_option("--shard", a->shard,
                   "Which of N shards, from 0; default: TEST_SHARD_INDEX/TEST_TOTAL_SHARDS, "
                   "SLURM_ARRAY_TASK_ID/_COUNT, or 0/1")
      ->type_name("I/N");
  command->add_flag("--count", a->count, "Print the number of cases and stop");
  command->add_flag("--build-rtl", a->build_rtl,
                    "Build the RTL of every configuration into the cache and stop");
  command->footer(
      "A shard that was killed goes on where it stopped. docs/02_use/many_machines.md\n"
      "Example: halfspace sweep spec.json --out out/sweep --shard 0/4");
  return [a] { return run_sweep(*a); };
}

Action add_merge_command(Command& program) {
  Command* command = program.add_subcommand("merge", "Put the shards of a sweep together");
  auto a = std::make_shared<MergeArguments>();
  command->add_option("DIR", a->folder, "The folder of the shards")->required();
  command->add_option("--out", a->out, "Records of all cases, in order, JSON Lines");
  command->add_flag("--missing", a->missing, "Print the shards that are not there: 3,7,12-14");
  command->footer("Exit status 1: shards are missing, or cases failed.");
  return [a] { return run_merge(*a); };
}

}  // namespace halfspace
