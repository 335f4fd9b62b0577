// SPDX-License-Identifier: Apache-2.0
#include "options.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <sstream>
#include <utility>

#include "io/error.hpp"
#include "nearest.hpp"

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

Option* Option::note(bool& given) {
  option_->each([&given](const std::string&) { given = true; });
  return this;
}

Command* Command::add_subcommand(const std::string& name, const std::string& help) {
  return &subcommands_.emplace_back(*app_.add_subcommand(name, help));
}

template <class Value>
Option* Command::add(const std::string& name, Value& value, const std::string& help) {
  return &options_.emplace_back(app_.add_option(name, value, help));
}

namespace {

const Check kNotEmpty{
    [](const std::string& text) { return std::string(text.empty() ? "is empty" : ""); }, ""};

}  // namespace

Option* Command::add_option(const std::string& name, std::string& value, const std::string& help) {
  return add(name, value, help)->check(kNotEmpty);
}

Option* Command::add_option(const std::string& name, std::vector<std::string>& value,
                            const std::string& help) {
  return add(name, value, help)->check(kNotEmpty);
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

[[noreturn]] void refuse(const std::string& text) { throw Error(ErrorCode::kUsage, "", text); }

std::vector<std::string> names_of(const std::vector<Subcommand>& subcommands) {
  std::vector<std::string> names{"help"};
  for (const Subcommand& subcommand : subcommands) names.emplace_back(subcommand.name);
  return names;
}

[[noreturn]] void refuse_subcommand(const std::string& word,
                                    const std::vector<Subcommand>& subcommands) {
  refuse(fmt::format("'{:.40}' is not a subcommand{} (try --help)", word,
                     suggestion(word, names_of(subcommands))));
}

// A word too many: an option that the command does not have, or an argument.
[[noreturn]] void refuse_extra(const CLI::App& app, const std::string& message) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  const CLI::App& command = chosen.empty() ? app : *chosen.front();
  std::vector<std::string> options;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
  }
  for (const std::string& extra : app.remaining(true)) {
    const std::string word = extra.substr(0, extra.find('='));
    if (!word.starts_with('-')) continue;
    refuse(fmt::format("{:.40} is not an option of {}{} (try --help)", word, command.get_name(),
                       suggestion(word, options)));
  }
  refuse(message + " (try --help)");
}

// "help" and "help SUBCOMMAND" as the options that they stand for.
std::vector<std::string> words_of(int argc, const char* const* argv,
                                  const std::vector<Subcommand>& subcommands) {
  std::vector<std::string> words(argv + 1, argv + argc);
  if (words.empty() || words[0] != "help") return words;
  if (words.size() == 1) return {"--help"};
  const std::vector<std::string> names = names_of(subcommands);
  if (std::find(names.begin(), names.end(), words[1]) == names.end()) {
    refuse_subcommand(words[1], subcommands);
  }
  if (words[1] == "help") return {"--help"};
  return {words[1], "--help"};
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
  std::vector<std::string> words = words_of(argc, argv, subcommands);
  const std::string first = words.empty() ? "" : words[0];
  std::reverse(words.begin(), words.end());  // as the library wants them
  try {
    app.parse(words);
  } catch (const CLI::Success& said) {  // --help, --version
    std::ostringstream text;
    app.exit(said, text, text);
    fmt::print("{}", text.str());
    return {};
  } catch (const CLI::RequiredError& error) {
    // CLI11 takes a word that is no subcommand for a missing one.
    if (app.get_subcommands().empty() && !first.empty()) {
      if (!first.starts_with('-')) refuse_subcommand(first, subcommands);
      refuse_extra(app, error.what());
    }
    refuse(std::string(error.what()) + " (try --help)");
  } catch (const CLI::ExtrasError& error) {
    refuse_extra(app, error.what());
  } catch (const CLI::ParseError& error) {
    refuse(std::string(error.what()) + " (try --help)");
  }
  for (auto& [name, action] : actions) {
    if (app.got_subcommand(name)) return std::move(action);
  }
  throw Error(ErrorCode::kInternal, "", "no subcommand was chosen");
}

}  // namespace halfspace
