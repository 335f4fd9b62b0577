// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "camera.hpp"
#include "options.hpp"

namespace CLI {
class App;
}

namespace halfspace {

// --eye, --target, --up, --fov and --ortho, the same everywhere.
struct CameraArguments {
  std::string eye, target, up;  // X,Y,Z; empty: found by frame_camera()
  double fov = 0;               // degrees, vertical; 0: the default
  double ortho = -1;            // picture height in world units, 0 to fit; -1: perspective

  void add_to(Command& command);
  // Throws Error(kUsage) naming the option.
  CameraOptions options() const;
  // Names of those that were given.
  std::vector<std::string> given() const;
  // The same as options of a command line, each with a space before it.
  std::string text() const;
};

}  // namespace halfspace
