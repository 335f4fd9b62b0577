// SPDX-License-Identifier: Apache-2.0
//
// Every method over every suite: how much is wrong, and how it fails. A cell runs in a process of
// its own, with a limit on its time and on its steps, so that a crash or a hang is a result.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "case_pixels.hpp"
#include "real_scene.hpp"
#include "suites.hpp"

namespace halfspace::lab {

// The gallery's methods, and the design with its geometry stage in front ("halfspace_clip").
const std::vector<methods::Method>& lab_methods();

// In this process.
CaseResult run_case(const methods::Method& method, const Suite& suite, const SuiteCase& one);
// In a child that is ended after `seconds` of CPU time.
CaseResult run_case_guarded(const methods::Method& method, const Suite& suite, const SuiteCase& one,
                            int seconds);

struct Cell {
  std::string method;
  std::string suite;
  std::vector<std::pair<std::string, CaseResult>> cases;  // by name
  // Methods that snap to fewer than 8 bits: wrong per million against vertices snapped alike.
  std::optional<double> snapped_ppm;
  double ppm() const;                // of all cases: wrong per million covered
  const std::string& worst() const;  // the case with the most wrong per million
};

// Empty when the method does not take what the suite has (its kind of input, or attributes).
std::optional<Cell> run_cell(const methods::Method& method, const Suite& suite);

// The scene as a suite of one case. The scene must outlive it.
Suite scene_suite(const RealScene& scene);

// One column: the scene's triangles under every method.
nlohmann::ordered_json scene_stability(const RealScene& scene);

// progress: called once a cell.
nlohmann::ordered_json stability_json(const std::vector<const methods::Method*>& methods,
                                      const std::vector<const Suite*>& suites,
                                      const std::function<void()>& progress);

}  // namespace halfspace::lab
