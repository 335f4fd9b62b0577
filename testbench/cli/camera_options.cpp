// SPDX-License-Identifier: Apache-2.0
#include "camera_options.hpp"

#include <fmt/format.h>

#include <cctype>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <sstream>
#include <utility>

#include "io/error.hpp"
#include "number_checks.hpp"

namespace halfspace {
namespace {

// Squares of distances stay finite.
constexpr double kFurthest = 1e100;

glm::dvec3 parse_vector(const std::string& text, const char* option) {
  glm::dvec3 value{0.0};
  std::istringstream stream(text);
  char comma1 = 0;
  char comma2 = 0;
  stream >> value.x >> comma1 >> value.y >> comma2 >> value.z;
  if (stream.fail() || comma1 != ',' || comma2 != ',' || !(stream >> std::ws).eof()) {
    throw Error(ErrorCode::kUsage, option,
                fmt::format("'{:.40}' is not three numbers X,Y,Z", text));
  }
  if (glm::any(glm::greaterThan(glm::abs(value), glm::dvec3(kFurthest)))) {
    throw Error(ErrorCode::kUsage, option,
                fmt::format("'{:.40}' is out of range (-{:g}..{:g})", text, kFurthest, kFurthest));
  }
  return value;
}

}  // namespace

void CameraArguments::add_to(Command& command) {
  command.add_option("--eye", eye, "Camera position, world units")->type_name("X,Y,Z");
  command.add_option("--target", target, "Point looked at, world units")->type_name("X,Y,Z");
  command.add_option("--up", up, "Direction that is up in the picture")->type_name("X,Y,Z");
  command.add_option("--fov", fov, "Vertical field of view, degrees (default 40)")
      ->check(above_zero());
  command
      .add_option("--ortho", ortho, "Orthographic camera; picture height in world units, 0 to fit")
      ->check(not_negative())
      ->excludes(command.get_option("--fov"));
}

CameraOptions CameraArguments::options() const {
  CameraOptions camera;
  if (!eye.empty()) camera.eye = parse_vector(eye, "--eye");
  if (!target.empty()) camera.target = parse_vector(target, "--target");
  if (!up.empty()) camera.up = parse_vector(up, "--up");
  if (camera.eye && camera.target && *camera.eye == *camera.target) {
    throw Error(ErrorCode::kUsage, "--eye", "is where the camera looks: it has no direction");
  }
  if (camera.up && *camera.up == glm::dvec3(0.0)) {
    throw Error(ErrorCode::kUsage, "--up", "0,0,0 is no direction");
  }
  if (fov != 0) {
    if (!(fov > 0 && fov < 180)) {
      throw Error(ErrorCode::kUsage, "--fov",
                  fmt::format("{} is out of range (above 0, below 180 degrees)", fov));
    }
    camera.fov_y_degrees = fov;
  }
  if (ortho != -1) {
    if (!(ortho >= 0 && ortho < 1e30)) {
      throw Error(ErrorCode::kUsage, "--ortho", "the height must be positive, or 0 to fit");
    }
    camera.orthographic = true;
    if (ortho > 0) camera.ortho_height = ortho;
  }
  return camera;
}

std::vector<std::string> CameraArguments::given() const {
  std::vector<std::string> names;
  for (const auto& [name, is] : {std::pair{"--eye", !eye.empty()},
                                 {"--target", !target.empty()},
                                 {"--up", !up.empty()},
                                 {"--fov", fov != 0},
                                 {"--ortho", ortho != -1}}) {
    if (is) names.emplace_back(name);
  }
  return names;
}

std::string CameraArguments::text() const {
  // One word each, whatever spaces they were given with.
  const auto word = [](std::string vector) {
    std::erase_if(vector, [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; });
    return vector;
  };
  std::string out;
  if (!eye.empty()) out += " --eye " + word(eye);
  if (!target.empty()) out += " --target " + word(target);
  if (!up.empty()) out += " --up " + word(up);
  if (fov != 0) out += fmt::format(" --fov {}", fov);
  if (ortho != -1) out += fmt::format(" --ortho {}", ortho);
  return out;
}

}  // namespace halfspace
