// SPDX-License-Identifier: Apache-2.0
#include "options.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <utility>

#include "io/error.hpp"

namespace halfspace {

Option* Option::check(const Check& check) {
  option_->check(CLI::Validator(
      [fault = check.fault](const std::string& text) { return fault(text); }, check.range));
  return this;
}

Option* Option::type_name(const std::string& name) {
  option_->type_name(name);
  return this;
}

Option* Option::capture_default_str() {
  option_->capture_default_str();
  return this;
}

Option* Option::required(bool is) {
  option_->required(is);
  return this;
}

Option* Option::take_last() {
  option_->take_last();
  return this;
}

Option* Option::excludes(const Option* other) {
  option_->excludes(other->option_);
  return this;
}

Option* Option::needs(const Option* other) {
  option_->needs(other->option_);
  return this;
}

Command* Command::add_subcommand(const std::string& name, const std::string& help) {
  return &subcommands_.emplace_back(*app_.add_subcommand(name, help));
}

template <class Value>
Option* Command::add(const std::string& name, Value& value, const std::string& help) {
  return &options_.emplace_back(app_.add_option(name, value, help));
}

Option* Command::add_option(const std::string& name, std::string& value, const std::string& help) {
  return add(name, value, help);
}

Option* Command::add_option(const std::string& name, std::vector<std::string>& value,
                            const std::string& help) {
  return add(name, value, help);
}

Option* Command::add_option(const std::string& name, std::vector<int>& value,
                            const std::string& help) {
  return add(name, value, help);
}

Option* Command::add_option(const std::string& name, int& value, const std::string& help) {
  return add(name, value, help);
}

Option* Command::add_option(const std::string& name, std::uint64_t& value,
                            const std::string& help) {
  return add(name, value, help);
}

Option* Command::add_option(const std::string& name, double& value, const std::string& help) {
  return add(name, value, help);
}

Option* Command::add_flag(const std::string& name, bool& value, const std::string& help) {
  return &options_.emplace_back(app_.add_flag(name, value, help));
}

Option* Command::get_option(const std::string& name) {
  return &options_.emplace_back(app_.get_option(name));
}

void Command::footer(const std::string& text) { app_.footer(text); }

void Command::stands_alone(const Option* option, const std::vector<std::string>& with) {
  const CLI::Option* help = app_.get_help_ptr();
  for (CLI::Option* other : app_.get_options()) {
    const bool allowed = std::any_of(with.begin(), with.end(), [&](const std::string& name) {
      return other == app_.get_option(name);
    });
    if (other != option->option_ && other != help && !allowed) option->option_->excludes(other);
  }
}

namespace {

// A subcommand that this build lacks takes whatever it is given, to say so.
Action add_absent(CLI::App& app, const std::string& name) {
  CLI::App* command = app.add_subcommand(name, "(not in this build)");
  command->allow_extras();
  command->set_help_flag();
  return [name]() -> int {
    throw Error(ErrorCode::kNoLab, name,
                "this program was built without it (HALFSPACE_SUBCOMMANDS=drawing)");
  };
}

}  // namespace

Action parse_command_line(int argc, const char* const* argv,
                          const std::vector<Subcommand>& subcommands) {
  CLI::App app{"Halfspace: a bit- and cycle-accurate model of a triangle rasterizer"};
  app.name("halfspace");
  app.set_version_flag("--version", std::string("halfspace ") + HALFSPACE_VERSION);
  app.require_subcommand(1);
  Command program(app);
  std::vector<std::pair<const char*, Action>> actions;
  for (const Subcommand& subcommand : subcommands) {
    const auto& [name, add] = subcommand;
    actions.emplace_back(name, add == nullptr ? add_absent(app, name) : add(program));
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& said) {  // --help, --version
    app.exit(said);
    return {};
  } catch (const CLI::RequiredError& error) {
    // CLI11 takes a word that is no subcommand for a missing one.
    if (app.get_subcommands().empty() && argc > 1 && argv[1][0] != '-') {
      throw Error(ErrorCode::kUsage, "",
                  fmt::format("'{:.40}' is not a subcommand (try --help)", argv[1]));
    }
    throw Error(ErrorCode::kUsage, "", std::string(error.what()) + " (try --help)");
  } catch (const CLI::ParseError& error) {
    throw Error(ErrorCode::kUsage, "", std::string(error.what()) + " (try --help)");
  }
  for (auto& [name, action] : actions) {
    if (app.got_subcommand(name)) return std::move(action);
  }
  throw Error(ErrorCode::kInternal, "", "no subcommand was chosen");
}

}  // namespace halfspace
