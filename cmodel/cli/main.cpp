// SPDX-License-Identifier: Apache-2.0
//
// The halfspace program. Results go to files or stdout, talk to stderr. Exit status: 0 done, 1 a
// comparison failed, 2 bad input or an interrupted run.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <new>
#include <system_error>

#include "../io/error.hpp"
#include "../io/interrupt.hpp"
#include "command.hpp"

namespace {

int fail(halfspace::ErrorCode code, const std::string& text) {
  // One line, whatever a library put into its message.
  std::string line = text.substr(0, text.find('\n'));
  fmt::print(stderr, "halfspace: error[HS{:03}]: {}\n", static_cast<int>(code), line);
  return 2;
}

int run(int argc, char** argv) {
  CLI::App program{"Halfspace: a bit- and cycle-accurate model of a triangle rasterizer"};
  program.name("halfspace");
  program.set_version_flag("--version", std::string("halfspace ") + HALFSPACE_VERSION);
  program.require_subcommand(1);
  std::vector<std::pair<std::string, halfspace::Action>> actions;
  actions.emplace_back("render", halfspace::add_render_command(program));
  actions.emplace_back("coverage", halfspace::add_coverage_command(program));
  actions.emplace_back("cosim", halfspace::add_cosim_command(program));
  actions.emplace_back("bench", halfspace::add_bench_command(program));
  actions.emplace_back("vectors", halfspace::add_vectors_command(program));
  actions.emplace_back("fit", halfspace::add_fit_command(program));
  actions.emplace_back("methods", halfspace::add_methods_command(program));
  actions.emplace_back("config", halfspace::add_config_command(program));
  actions.emplace_back("chart", halfspace::add_chart_command(program));
  actions.emplace_back("explain", halfspace::add_explain_command(program));
  actions.emplace_back("report", halfspace::add_report_command(program));
  actions.emplace_back("stability", halfspace::add_stability_command(program));
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& said) {  // --help, --version
    program.exit(said);
    if (std::cout.flush()) return 0;
    return fail(halfspace::ErrorCode::kFileWrite, "cannot write to standard output");
  } catch (const CLI::RequiredError& error) {
    // CLI11 takes a word that is no subcommand for a missing one.
    if (program.get_subcommands().empty() && argc > 1 && argv[1][0] != '-') {
      return fail(halfspace::ErrorCode::kUsage,
                  fmt::format("'{:.40}' is not a subcommand (try --help)", argv[1]));
    }
    return fail(halfspace::ErrorCode::kUsage, std::string(error.what()) + " (try --help)");
  } catch (const CLI::ParseError& error) {
    return fail(halfspace::ErrorCode::kUsage, std::string(error.what()) + " (try --help)");
  }
  int status = 0;
  for (const auto& [name, action] : actions) {
    if (program.got_subcommand(name)) status = action();
  }
  if (std::fflush(stdout) != 0) {
    return fail(halfspace::ErrorCode::kFileWrite, "cannot write to standard output");
  }
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  halfspace::handle_interrupts();
  try {
    return run(argc, argv);
  } catch (const halfspace::Error& error) {
    return fail(error.code(), error.what());
  } catch (const std::bad_alloc&) {
    return fail(halfspace::ErrorCode::kScene, "not enough memory");
  } catch (const std::system_error& error) {  // files, and standard output that takes no more
    return fail(halfspace::ErrorCode::kFileWrite, error.what());
  } catch (const std::exception& error) {
    return fail(halfspace::ErrorCode::kInternal, error.what());
  }
}
