// SPDX-License-Identifier: Apache-2.0
//
// The halfspace program. Results go to files or stdout, talk to stderr. Exit status: 0 done, 1 a
// comparison failed, 2 bad input or an interrupted run.
#include <fmt/format.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <stdexcept>
#include <system_error>

#include "command.hpp"
#include "io/error.hpp"
#include "io/interrupt.hpp"
#include "io/output_file.hpp"
#include "io/printable.hpp"
#include "lab_door.hpp"
#include "method_picture.hpp"
#include "progress_line.hpp"
#include "scene_file.hpp"

namespace {

using halfspace::ErrorCode;

int fail(ErrorCode code, const std::string& text) {
  // One line, whatever a file or a library put into its message.
  fmt::print(stderr, "halfspace: error[HS{:03}]: {}\n", static_cast<int>(code),
             halfspace::printable(halfspace::with_scene_names(text)));
  return 2;
}

int fail(const std::system_error& error) {  // threads and memory, or files
  const std::error_code code = error.code();
  const bool memory =
      code == std::errc::not_enough_memory || code == std::errc::resource_unavailable_try_again;
  return memory ? fail(ErrorCode::kScene, "not enough memory")
                : fail(ErrorCode::kFileWrite, error.what());
}

// The line of the exception that is under way, and exit status 2.
int fail() {
  try {
    throw;
  } catch (const halfspace::Error& error) {
    return fail(error.code(), error.what());
  } catch (const std::bad_alloc&) {
    return fail(ErrorCode::kScene, "not enough memory");
  } catch (const std::length_error&) {  // more than any memory has
    return fail(ErrorCode::kScene, "not enough memory");
  } catch (const std::system_error& error) {
    return fail(error);
  } catch (const std::exception& error) {
    return fail(ErrorCode::kInternal, error.what());
  }
}

// Where no handler can be reached, as in a library that does not expect to run out of memory.
[[noreturn]] void on_terminate() {
  if (std::current_exception()) fail();
  std::abort();  // removes what is unfinished, and ends with status 2
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
    {"sweep", HS_UNLESS_DRAWING_ONLY(halfspace::add_sweep_command)},
    {"merge", HS_UNLESS_DRAWING_ONLY(halfspace::add_merge_command)},
    {"soak", HS_UNLESS_DRAWING_ONLY(halfspace::add_soak_command)},
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
  halfspace::flush_standard_output();
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  halfspace::handle_interrupts();
  std::set_terminate(on_terminate);
  halfspace::show_progress();
  try {
    return run(argc, argv);
  } catch (...) {
    return fail();
  }
}
