// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "camera_options.hpp"
#include "depth.hpp"
#include "scene/scene.hpp"
#include "scene_file.hpp"

namespace CLI {
class App;
}

namespace halfspace {

// The options with which a subcommand chooses a scene, its frame and its camera, as render has
// them.
struct SceneOptions {
  std::string path;    // "-": standard input
  std::string format;  // of standard input
  std::string size;    // empty: 640x480, less where the configuration is smaller
  CameraArguments camera;
  int case_id = -1;

  // The scene, required when it is an argument ("SCENE") and not an option ("--scene"); --size,
  // --eye, --target, --up, --fov, --ortho, --case, --format.
  void add_to(Command& command, const std::string& name = "SCENE");
  // The file to read: scene_file(). Before outputs are checked.
  std::string file() const { return scene_file(path, format); }
  // simplify_px: as open_scene(). Options that a TCOV file leaves without effect are said. Throws
  // what frame_size() and open_scene() throw.
  std::unique_ptr<Scene> open(const Config& config, Lighting lighting,
                              double simplify_px = 0) const;
  // The same for a command that looks at one frame. Throws Error(kUsage) when a TCOV file has
  // several cases and --case does not choose one.
  std::unique_ptr<Scene> open_one(const Config& config, Lighting lighting) const;
};

// Says which of them a TCOV file leaves without effect.
void say_no_camera(const std::string& size, const CameraArguments& camera, int views = 1);
inline constexpr const char* kTcovHasNoCamera = "a TCOV file is drawn as it is, without a camera";

// A scene that was opened, after a note on stderr of what the file has that is not drawn.
std::unique_ptr<Scene> noted(std::unique_ptr<Scene> scene, const std::string& path);

// How fragments are tested, as render has the options.
struct DepthOptions {
  std::string test = "less";
  double clear = 1.0;

  // --depth-test, --depth-clear.
  void add_to(Command& command);
  // Throws Error(kUsage).
  DepthState load(const Config& config) const;
};

// X,Y,WIDTHxHEIGHT, pixels. Throws Error(kUsage) when it is something else or not in the frame.
Box parse_scissor(const std::string& text, const FrameState& frame);

}  // namespace halfspace
