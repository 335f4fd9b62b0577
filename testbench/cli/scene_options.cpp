// SPDX-License-Identifier: Apache-2.0
#include "scene_options.hpp"

#include <fmt/format.h>

#include "io/error.hpp"
#include "number_checks.hpp"

namespace halfspace {

void SceneOptions::add_to(Command& command, const std::string& name) {
  command.add_option(name, path, "Mesh (OBJ, glTF, GLB, PLY, STL) or TCOV file")
      ->required(name.front() != '-');
  command
      .add_option("--size", size, "Frame size in pixels (default 640x480; a TCOV file has its own)")
      ->type_name("WxH");
  camera.add_to(command);
  command.add_option("--case", case_id, "The case of a TCOV file")->check(whole());
}

std::unique_ptr<Scene> SceneOptions::open(const Config& config, Lighting lighting,
                                          double simplify_px) const {
  return open_scene(path, case_id, frame_size(size, config), camera.options(), lighting, 1,
                    simplify_px);
}

std::unique_ptr<Scene> SceneOptions::open_one(const Config& config, Lighting lighting) const {
  std::unique_ptr<Scene> scene = open(config, lighting);
  if (scene->frames() == 1) return scene;
  if (scene->frames() == 0) throw Error(ErrorCode::kScene, path, "has no cases");
  throw Error(ErrorCode::kUsage, path,
              fmt::format("the file has {} cases: choose one with --case", scene->frames()));
}

DepthFunction parse_depth_test(const std::string& name) {
  if (name == "less") return DepthFunction::kLess;
  if (name == "less_equal") return DepthFunction::kLessEqual;
  throw Error(ErrorCode::kUsage, "--depth-test",
              fmt::format("'{}' is not less or less_equal", name));
}

}  // namespace halfspace
