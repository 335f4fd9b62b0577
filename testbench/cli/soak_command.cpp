// SPDX-License-Identifier: Apache-2.0
//
// halfspace soak.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "command.hpp"
#include "io/config_json.hpp"
#include "io/error.hpp"
#include "io/escape.hpp"
#include "number_checks.hpp"
#include "sweep/soak.hpp"

namespace halfspace {
namespace {

struct SoakArguments {
  std::string specification, shard, check, triangles;
  std::uint64_t point = 0;
};

int say(const SoakSpecification& specification, const SoakDifference& difference) {
  const SoakPoint point = draw_point(specification, difference.point);
  fmt::print(stderr,
             "halfspace: {}: {}; {} of configuration {} in {}x{}; replay: halfspace soak {} "
             "--point {} --check {} --triangles {}\n",
             difference.check, difference.text,
             difference.triangles.size() == 1
                 ? std::string("a triangle")
                 : fmt::format("{} triangles", difference.triangles.size()),
             config_json(point.config).dump(), point.frame.width, point.frame.height,
             quoted(specification.path), difference.point, difference.check,
             quoted(triangles_text(difference.triangles)));
  return 1;
}

int replay(const SoakArguments& a, const SoakSpecification& specification) {
  const std::vector<SoakCheck>& all = soak_checks();
  const auto check = std::find_if(all.begin(), all.end(),
                                  [&](const SoakCheck& one) { return one.name == a.check; });
  if (check == all.end()) {
    throw Error(ErrorCode::kUsage, "--check", fmt::format("'{:.40}' is no check", a.check));
  }
  const SoakPoint point = draw_point(specification, a.point);
  SoakDifference difference{
      a.check, a.point, {}, parse_triangles(specification, point, a.triangles)};
  difference.text = check->difference(difference.triangles, point);
  if (!difference.text.empty()) return say(specification, difference);
  fmt::print("{}: no difference\n", a.check);
  return 0;
}

int run(const SoakArguments& a) {
  const Shard shard = parse_shard(a.shard);
  const SoakSpecification specification = read_soak(a.specification);
  if (a.check.empty() != a.triangles.empty()) {
    throw Error(ErrorCode::kUsage, "soak", "--check and --triangles need each other");
  }
  if (!a.check.empty()) return replay(a, specification);
  const SoakOutcome done = run_soak(specification, shard);
  if (done.difference) return say(specification, *done.difference);
  std::string names;
  for (const SoakCheck& check : specification.checks) names += " " + check.name;
  fmt::print("no difference: {} triangles, {} configurations, checks{}\n", done.triangles,
             done.points, names);
  return 0;
}

}  // namespace

Action add_soak_command(Command& program) {
  Command* command = program.add_subcommand(
      "soak", "Compare engines, stages, oracle and RTL on drawn triangles and configurations");
  auto a = std::make_shared<SoakArguments>();
  command->add_option("SPEC", a->specification, "What to draw and compare, JSON")->required();
  command->add_option("--shard", a->shard, "Which of N shards, from 0, as sweep")->type_name("I/N");
  command->add_option("--point", a->point, "Replay: the drawn configuration")->check(whole());
  command->add_option("--check", a->check, "Replay: the check");
  command->add_option("--triangles", a->triangles, "Replay: vertices in subpixels and a tag")
      ->type_name("X,Y,X,Y,X,Y,TAG;...");
  command->footer("Stops at the first difference: exit status 1, and the line that replays it.");
  return [a] { return run(*a); };
}

}  // namespace halfspace
