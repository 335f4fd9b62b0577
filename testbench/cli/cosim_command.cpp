// SPDX-License-Identifier: Apache-2.0
//
// halfspace cosim: options. What it does is in cosim_run.cpp.
#include <memory>

#include "command.hpp"
#include "number_checks.hpp"
#include "scene_file.hpp"

namespace halfspace {

Action add_cosim_command(Command& program) {
  Command* command = program.add_subcommand(
      "cosim", "Run a scene through model and RTL; compare every packet's bits and clock");
  auto o = std::make_shared<CosimRequest>();
  command
      ->add_option("IN", o->in, "Mesh (OBJ, glTF, GLB, PLY, STL) or TCOV file; -: standard input")
      ->required();
  add_format_option(*command, o->format);
  command->add_option("--size", o->size, "Frame size in pixels (default 640x480)")
      ->type_name("WxH");
  o->config.add_to(*command);
  command->add_option("--stall", o->stall, "Probability that input or output is held up, 0..0.95")
      ->capture_default_str();
  command->add_option("--seed", o->seed, "Seed of the stall pattern")
      ->check(whole())
      ->note(o->seed_given)
      ->capture_default_str();
  command->add_option("--stats", o->stats, "JSON statistics to write");
  command->add_option("--trace", o->trace,
                      "Trace to write: .fst waves of the RTL, .json (Chrome) or .kanata.gz");
  add_cull_option(*command, o->cull);
  o->camera.add_to(*command);
  command->add_option("--orbit", o->views, "Views: this many cameras around the target, in turn")
      ->check(whole_between(1, 4096))
      ->capture_default_str();
  command->add_option("--case", o->case_id, "The case of a TCOV file to run (default: all)")
      ->check(whole());
  command->footer(
      "Exit status: 0 identical, 1 different (one line says where), 2 bad input.\n"
      "Example: halfspace cosim tests/scenes/bunny.obj --config full --stall 0.3 --seed 7");
  return [o] { return run_cosim(*o); };
}

}  // namespace halfspace
