// SPDX-License-Identifier: Apache-2.0
//
// The halfspace program. Results go to files or stdout, talk to stderr. Exit status: 0 done, 1 a
// comparison failed, 2 bad input or an interrupted run.
#include <fmt/format.h>

#include <iostream>
#include <new>
#include <system_error>

#include "command.hpp"
#include "io/error.hpp"
#include "io/interrupt.hpp"
#include "lab_door.hpp"
#include "method_picture.hpp"
#include "progress_line.hpp"

namespace {

int fail(halfspace::ErrorCode code, const std::string& text) {
  // One line, whatever a library put into its message.
  std::string line = text.substr(0, text.find('\n'));
  fmt::print(stderr, "halfspace: error[HS{:03}]: {}\n", static_cast<int>(code), line);
  return 2;
}

using halfspace::Command;

// HALFSPACE_SUBCOMMANDS=drawing leaves out what a null stands for.
#ifdef HALFSPACE_DRAWING_ONLY
#define HS_UNLESS_DRAWING_ONLY(function) nullptr
constexpr const halfspace::MethodDrawing* kGallery = nullptr;
#else
#define HS_UNLESS_DRAWING_ONLY(function) function
constexpr const halfspace::MethodDrawing* kGallery = &halfspace::kMethodDrawing;
#ifdef HALFSPACE_HAS_LAB
constexpr const halfspace::LabDoor* kLab = &halfspace::kLabDoor;
#else
constexpr const halfspace::LabDoor* kLab = nullptr;
#endif

template <halfspace::Action (*add)(Command&, const halfspace::LabDoor*)>
halfspace::Action with_lab(Command& program) {
  return add(program, kLab);
}
#endif

const std::vector<halfspace::Subcommand> kSubcommands{
    {"render", [](Command& program) { return halfspace::add_render_command(program, kGallery); }},
    {"coverage", halfspace::add_coverage_command},
    {"cosim", halfspace::add_cosim_command},
    {"bench", HS_UNLESS_DRAWING_ONLY(halfspace::add_bench_command)},
    {"vectors", HS_UNLESS_DRAWING_ONLY(halfspace::add_vectors_command)},
    {"fit", HS_UNLESS_DRAWING_ONLY(halfspace::add_fit_command)},
    {"methods", HS_UNLESS_DRAWING_ONLY(halfspace::add_methods_command)},
    {"config", halfspace::add_config_command},
    {"chart", HS_UNLESS_DRAWING_ONLY(with_lab<halfspace::add_chart_command>)},
    {"explain", HS_UNLESS_DRAWING_ONLY(with_lab<halfspace::add_explain_command>)},
    {"report", HS_UNLESS_DRAWING_ONLY(with_lab<halfspace::add_report_command>)},
    {"stability", HS_UNLESS_DRAWING_ONLY(with_lab<halfspace::add_stability_command>)},
};

int run(int argc, char** argv) {
  const halfspace::Action action = halfspace::parse_command_line(argc, argv, kSubcommands);
  const int status = action ? action() : 0;
  if (std::fflush(stdout) != 0 || !std::cout.flush()) {
    return fail(halfspace::ErrorCode::kFileWrite, "cannot write to standard output");
  }
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  halfspace::handle_interrupts();
  halfspace::show_progress();
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
