// SPDX-License-Identifier: Apache-2.0
//
// The one way a user's mistake is reported: a code with a page in docs/02_use/errors.md, the place
// and one line of text. The CLI prints `halfspace: error[HSnnn]: PLACE: TEXT` and exits 2.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace halfspace {

// Numbers are stable; a retired one is never reused. docs/02_use/errors.md has a section for each,
// and tests/check_tree.py fails when one is missing.
enum class ErrorCode : int {
  kUsage = 1,            // unknown option, missing argument
  kConfigRead = 2,       // configuration file missing or not JSON
  kConfigKey = 3,        // unknown key
  kConfigRange = 4,      // value out of range or of the wrong type
  kSize = 5,             // frame size zero, or beyond the configuration
  kFileRead = 10,        // missing or unreadable input
  kMeshBroken = 11,      // not parseable, truncated
  kMeshEmpty = 12,       // no triangles
  kMeshNotFinite = 13,   // NaN or infinity in a vertex
  kMeshIndex = 14,       // a face names a vertex that is not there
  kTcovBroken = 20,      // TCOV syntax
  kTcovRange = 21,       // a vertex beyond the configuration's coordinate range
  kFitRange = 22,        // a triangle outside what the configuration was fitted to
  kFitLimit = 23,        // no configuration keeps the limits asked for
  kFitOracle = 24,       // this build has no oracle to measure against
  kFitTool = 25,         // a tool that --synth or --emit-rtl needs is missing or failed
  kFileWrite = 30,       // cannot create, write or rename the output
  kLevel = 40,           // level not available here
  kScene = 41,           // the scene does not fit the request (camera, case number, ...)
  kRtlBuild = 42,        // the RTL of a configuration could not be built
  kRtlDrift = 43,        // the RTL was elaborated to other widths than the model's
  kMethod = 70,          // no method of that name
  kMethodOption = 71,    // an option that the method cannot honour
  kMethodGaveUp = 72,    // a method did not finish within its budget of steps
  kInterrupted = 50,     // Ctrl-C
  kEngine = 60,          // an engine of the bench that this machine does not have
  kIsa = 61,             // an instruction set that this machine does not have
  kPixel = 80,           // a pixel outside the frame
  kSample = 81,          // a sample that the configuration does not have
  kLabCell = 82,         // unknown method or suite
  kDrawing = 83,         // a chart cannot be drawn here
  kChart = 84,           // unknown chart, or one that cannot be measured on this
  kNoLab = 85,           // this build has no lab
  kVectorRequest = 90,   // the options ask for vectors that cannot be made
  kVectorsBroken = 91,   // a vectors file or manifest is damaged
  kVectorInput = 92,     // a vectors file holds an input that the stage must not get
  kVectorsEmpty = 93,    // nothing to compare
  kVectorsSize = 95,     // too many records or clocks for the formats
  kSpecification = 100,  // what a sweep or soak is asked for cannot be done
  kShards = 101,         // the shards of a folder are not those of one sweep
  kInternal = 99,        // a check failed: a bug in Halfspace
};

class Error : public std::runtime_error {
 public:
  // place: "FILE", "FILE:LINE", an option, or empty. text: what and why. Both become one line that
  // can be shown: see printable().
  Error(ErrorCode code, const std::string& place, const std::string& text);
  ErrorCode code() const { return code_; }

 private:
  ErrorCode code_;
};

}  // namespace halfspace
