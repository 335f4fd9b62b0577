// SPDX-License-Identifier: Apache-2.0
//
// halfspace stability: every method over every suite of inputs that break methods.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "io/error.hpp"
#include "io/output_file.hpp"
#include "io/png_file.hpp"
#include "lab_door.hpp"
#include "manners.hpp"

namespace halfspace {
namespace {

struct StabilityOptions {
  std::vector<std::string> methods;
  std::vector<std::string> suites;
  std::string out;
  std::string explain;
  std::string picture;
  bool list = false;
};

// "METHOD/SUITE" to a picture.
void explain(const LabDoor& lab, const StabilityOptions& options) {
  const std::size_t slash = options.explain.find('/');
  if (slash == std::string::npos) {
    throw Error(ErrorCode::kUsage, "--explain",
                fmt::format("'{:.60}' is not METHOD/SUITE", options.explain));
  }
  if (options.picture.empty()) throw Error(ErrorCode::kUsage, "--picture", "is required");
  require_png_name(options.picture, "--picture");
  check_writable(options.picture);
  const StabilityPicture result =
      lab.stability_picture(options.explain.substr(0, slash), options.explain.substr(slash + 1));
  fmt::print(talk({options.picture}), "{}\n", result.text);
  write_png(options.picture, result.image);
}

int run_stability(const LabDoor& lab, const StabilityOptions& options) {
  if (options.list) {
    fmt::print("{}", lab.stability_list());
    return 0;
  }
  if (!options.explain.empty()) {
    explain(lab, options);
    return 0;
  }
  if (!options.picture.empty()) {
    throw Error(ErrorCode::kUsage, "--picture", "needs --explain METHOD/SUITE");
  }
  if (!options.out.empty()) check_writable(options.out);
  const nlohmann::ordered_json json = lab.stability_data(options.methods, options.suites);
  if (options.out.empty()) {
    fmt::print("{}", lab.stability_table(json));
    return 0;
  }
  write_text(options.out, json.dump(1) + "\n");
  return 0;
}

}  // namespace

Action add_stability_command(Command& program, const LabDoor* lab) {
  Command* command =
      program.add_subcommand("stability", "Every method over every input that breaks methods");
  auto o = std::make_shared<StabilityOptions>();
  command->add_option("--method", o->methods, "Only these methods (see halfspace methods)");
  command->add_option("--suite", o->suites, "Only these suites (see --list)");
  Option* list = command->add_flag("--list", o->list, "Name every suite and its reason, and stop");
  command->add_option("--out", o->out,
                      "JSON file to write, instead of a table on stdout; -: JSON on stdout");
  Option* explain = command->add_option("--explain", o->explain, "Draw the worst case of one cell");
  explain->type_name("METHOD/SUITE");
  command->add_option("--picture", o->picture, "PNG file for --explain");
  command->stands_alone(list);
  command->stands_alone(explain, {"--picture"});
  command->footer(
      "Figures are wrong pixels per million covered, against CGAL's exact predicates.\n"
      "Example: halfspace stability --explain walk_closed/shared_edges --picture out/worst.png");
  return [o, lab] { return run_stability(require_lab(lab), *o); };
}

}  // namespace halfspace
