// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "io/error.hpp"
#include "lab/lab_picture.hpp"
#include "lab/stability.hpp"
#include "lab_door.hpp"
#include "nearest.hpp"
#include "scene/progress.hpp"

namespace halfspace {
namespace {

using methods::Method;

const Method& find_method(const std::string& name) {
  for (const Method& method : lab::lab_methods()) {
    if (method.name == name) return method;
  }
  std::vector<std::string> names;
  for (const Method& method : lab::lab_methods()) names.emplace_back(method.name);
  throw Error(ErrorCode::kLabCell, "--method",
              fmt::format("'{:.40}' is not a method{} (see halfspace methods)", name,
                          suggestion(name, names)));
}

const lab::Suite& find_suite(const std::string& name) {
  for (const lab::Suite& suite : lab::suites()) {
    if (suite.name == name) return suite;
  }
  std::vector<std::string> names;
  for (const lab::Suite& suite : lab::suites()) names.emplace_back(suite.name);
  throw Error(ErrorCode::kLabCell, "--suite",
              fmt::format("'{:.40}' is not a suite{} (see --list)", name, suggestion(name, names)));
}

}  // namespace

std::string stability_list() {
  std::string out;
  for (const lab::Suite& suite : lab::suites()) {
    out += fmt::format("{:<14} {}\n{:<14}   {}\n", suite.name, suite.title, "", suite.reason);
  }
  return out;
}

nlohmann::ordered_json stability_data(const std::vector<std::string>& method_names,
                                      const std::vector<std::string>& suite_names) {
  std::vector<const Method*> methods;
  std::vector<const lab::Suite*> suites;
  for (const std::string& name : method_names) methods.push_back(&find_method(name));
  for (const std::string& name : suite_names) suites.push_back(&find_suite(name));
  if (methods.empty()) {
    for (const Method& method : lab::lab_methods()) methods.push_back(&method);
  }
  if (suites.empty()) {
    for (const lab::Suite& suite : lab::suites()) suites.push_back(&suite);
  }
  Progress progress("stability cells", methods.size() * suites.size());
  return lab::stability_json(methods, suites, [&] { progress.advance(1); });
}

std::string stability_table(const nlohmann::ordered_json& data) {
  std::string out =
      fmt::format("{:<28}{:<14}{:>12}  {}\n", "method", "suite", "wrong ppm", "worst case, marks");
  for (const auto& cell : data["cells"]) {
    std::string marks;
    for (const auto& mark : cell["marks"]) marks += fmt::format(" {}", mark.get<std::string>());
    out += fmt::format("{:<28}{:<14}{:>12.1f}  {}{}\n", cell["method"].get<std::string>(),
                       cell["suite"].get<std::string>(), cell["wrong_ppm"].get<double>(),
                       cell["wrong_ppm"] == 0.0 ? "" : cell["worst"].get<std::string>(), marks);
  }
  return out;
}

StabilityPicture stability_picture(const std::string& method_name, const std::string& suite_name) {
  const Method& method = find_method(method_name);
  const lab::Suite& suite = find_suite(suite_name);
  const auto cell = lab::run_cell(method, suite);
  if (!cell) {
    throw Error(ErrorCode::kLabCell, "--explain",
                fmt::format("{} takes {}, which suite {} does not have (or it has no attributes)",
                            method.name, methods::input_name(method.input()), suite.name));
  }
  for (const lab::SuiteCase& one : suite.make()) {
    if (one.name != cell->worst()) continue;
    for (const auto& [name, result] : cell->cases) {
      if (name != one.name) continue;
      if (result.crashed || (result.hung && result.signal != 0)) {
        throw Error(ErrorCode::kLabCell, "--explain",
                    fmt::format("{} does not come to its end on '{}'", method.name, name));
      }
      return {
          lab::case_picture(method, suite, one),
          fmt::format("{} on {}, case '{}': {} of {} pixels wrong ({:.0f} per million covered)",
                      method.name, suite.name, name, result.wrong, result.covered, result.ppm())};
    }
  }
  throw Error(ErrorCode::kInternal, "stability", "the worst case is not in its suite");
}

}  // namespace halfspace
