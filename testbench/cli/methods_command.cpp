// SPDX-License-Identifier: Apache-2.0
//
// halfspace methods: the gallery, one line each or as JSON.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "methods/method.hpp"

namespace halfspace {
namespace {

nlohmann::ordered_json method_json(const methods::Method& m) {
  nlohmann::ordered_json json;
  json["name"] = m.name;
  json["row"] = m.row;
  json["page"] = "docs/05_methods/" + m.family + ".md";
  json["title"] = m.title;
  json["input"] = methods::input_name(m.input());
  json["rule"] = methods::rule_name(m.rule);
  json["precision"] = m.precision;
  if (m.subpixel_bits >= 0) json["subpixel_bits"] = m.subpixel_bits;
  json["exact"] = m.exact;
  json["attributes"] = m.attributes;
  json["complexity"] = m.complexity;
  json["use"] = m.use;
  json["fails"] = m.fails;
  json["source"] = m.source;
  return json;
}

void print_table() {
  fmt::print("{:<27}{:>3}  {:<11}{:<12}{:<6} {}\n", "name", "row", "input", "ties", "exact",
             "title");
  for (const methods::Method& m : methods::all()) {
    fmt::print("{:<27}{:>3}  {:<11}{:<12}{:<6} {}\n", m.name, m.row, methods::input_name(m.input()),
               methods::rule_name(m.rule), m.exact ? "yes" : "no", m.title);
    fmt::print("{:<32}cost: {}\n", "", m.complexity);
    fmt::print("{:<32}precision: {}\n", "", m.precision);
    if (!m.fails.empty()) fmt::print("{:<32}fails: {}\n", "", m.fails);
  }
}

void print_json() {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const methods::Method& m : methods::all()) list.push_back(method_json(m));
  fmt::print("{}\n", list.dump(2));
}

}  // namespace

Action add_methods_command(Command& program) {
  Command* command = program.add_subcommand("methods", "List the gallery of rasterization methods");
  auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "Print JSON, with sources and when to use each");
  command->footer(
      "Draw with one: halfspace render tests/scenes/teapot.obj --method walk_prestep --out "
      "out/walk.png");
  return [json] {
    *json ? print_json() : print_table();
    return 0;
  };
}

}  // namespace halfspace
