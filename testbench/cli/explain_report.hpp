// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "explain.hpp"

namespace halfspace {

// What an explanation is about, for its reader.
struct ExplainedFrame {
  std::string scene;
  FrameState frame;
  Config config;
  SamplePoint at;
};

// For people: where, how many triangles by reason, then every account that was kept, the winner
// first. Ends in a newline.
std::string explain_text(const Explainer& explainer, const ExplainedFrame& about);

// Everything; fields in docs/02_use/explain.md.
nlohmann::ordered_json explain_json(const Explainer& explainer, const ExplainedFrame& about);

}  // namespace halfspace
