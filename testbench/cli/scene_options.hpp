// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "camera_options.hpp"
#include "depth.hpp"
#include "scene/scene.hpp"

namespace CLI {
class App;
}

namespace halfspace {

// The options with which a subcommand chooses a scene, its frame and its camera, as render has
// them.
struct SceneOptions {
  std::string path;
  std::string size;  // empty: 640x480, less where the configuration is smaller
  CameraArguments camera;
  int case_id = -1;

  // The scene, required when it is an argument ("SCENE") and not an option ("--scene"); --size,
  // --eye, --target, --up, --fov, --ortho, --case.
  void add_to(Command& command, const std::string& name = "SCENE");
  // simplify_px: as open_scene(). Throws what frame_size() and open_scene() throw.
  std::unique_ptr<Scene> open(const Config& config, Lighting lighting,
                              double simplify_px = 0) const;
  // The same for a command that looks at one frame. Throws Error(kUsage) when a TCOV file has
  // several cases and --case does not choose one.
  std::unique_ptr<Scene> open_one(const Config& config, Lighting lighting) const;
};

// "less" or "less_equal". Throws Error(kUsage).
DepthFunction parse_depth_test(const std::string& name);

}  // namespace halfspace
