// SPDX-License-Identifier: Apache-2.0
//
// The program's options. CLI11 reads them, in options.cpp alone: a file that includes it takes
// eight seconds to compile.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace halfspace {

// What is wrong with an option's text; empty when nothing is. Asked only when the user gives the
// option, so a default may lie outside.
struct Check {
  std::function<std::string(const std::string&)> fault;
  std::string range;  // for --help; empty: nothing to say
};

class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}
  Option* check(const Check& check);
  Option* type_name(const std::string& name);
  Option* capture_default_str();  // --help shows the default
  Option* required(bool is = true);
  Option* take_last();  // given several times: the last counts
  Option* excludes(const Option* other);
  Option* needs(const Option* other);
  Option* note(bool& given);  // true once the option is on the command line; must outlive parsing

 private:
  friend class Command;
  CLI::Option* option_;
};

// A subcommand, or the program, which has no options but --help and --version.
class Command {
 public:
  explicit Command(CLI::App& app) : app_(app) {}
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;

  // What is returned lives as long as this command.
  Command* add_subcommand(const std::string& name, const std::string& help);
  // name: "--name", or "NAME" of an argument. The value must outlive the parsing. Text may not be
  // empty: it would mean that the option was not given.
  Option* add_option(const std::string& name, std::string& value, const std::string& help);
  Option* add_option(const std::string& name, std::vector<std::string>& value,
                     const std::string& help);
  Option* add_option(const std::string& name, std::vector<int>& value, const std::string& help);
  Option* add_option(const std::string& name, int& value, const std::string& help);
  Option* add_option(const std::string& name, std::uint64_t& value, const std::string& help);
  Option* add_option(const std::string& name, double& value, const std::string& help);
  Option* add_flag(const std::string& name, bool& value, const std::string& help);
  Option* get_option(const std::string& name);
  void footer(const std::string& text);

  // An option that makes the command do another thing: together with any but those of `with` it is
  // refused, because they would do nothing. Call it after the last option was added.
  void stands_alone(const Option* option, const std::vector<std::string>& with = {});

 private:
  template <class Value>
  Option* add(const std::string& name, Value& value, const std::string& help);

  CLI::App& app_;
  std::deque<Option> options_;
  std::deque<Command> subcommands_;
};

// A subcommand adds itself to the program and returns what to run when it is chosen.
using Action = std::function<int()>;  // returns the exit status
struct Subcommand {
  const char* name;
  Action (*add)(Command& program);  // null: this build lacks it, and says so when it is chosen
};

// Reads the command line; the action of the subcommand that it chooses. Without one: --help or
// --version was printed on standard output, as for "help" and "help SUBCOMMAND". Throws
// Error(kUsage), with the name that is nearest to one that does not exist.
Action parse_command_line(int argc, const char* const* argv,
                          const std::vector<Subcommand>& subcommands);

}  // namespace halfspace
