// SPDX-License-Identifier: Apache-2.0
#include "scene_options.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <span>
#include <string_view>

#include "choice.hpp"
#include "io/error.hpp"
#include "io/printable.hpp"
#include "manners.hpp"
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
  add_format_option(command, format);
}

std::unique_ptr<Scene> SceneOptions::open(const Config& config, Lighting lighting,
                                          double simplify_px) const {
  const std::string read = file();
  if (is_tcov(read)) {
    say_no_camera(size, camera);
    if (simplify_px > 0) say_no_effect("--simplify", kTcovHasNoCamera);
  }
  return noted(open_scene(read, case_id, frame_size(size, config), camera.options(), lighting, 1,
                          simplify_px),
               path);
}

std::unique_ptr<Scene> SceneOptions::open_one(const Config& config, Lighting lighting) const {
  std::unique_ptr<Scene> scene = open(config, lighting);
  if (scene->frames() == 1) return scene;
  if (scene->frames() == 0) throw Error(ErrorCode::kScene, path, "has no cases");
  throw Error(ErrorCode::kUsage, path,
              fmt::format("the file has {} cases: choose one with --case", scene->frames()));
}

std::unique_ptr<Scene> noted(std::unique_ptr<Scene> scene, const std::string& path) {
  const LeftOut left_out = scene->left_out();
  if (!left_out.empty()) {
    fmt::print(stderr, "halfspace: note: {}: {}\n", printable(path), left_out.note());
  }
  return scene;
}

void say_no_camera(const std::string& size, const CameraArguments& camera, int views) {
  if (!size.empty()) say_no_effect("--size", "a TCOV file has its own frames");
  for (const std::string& option : camera.given()) say_no_effect(option, kTcovHasNoCamera);
  if (views != 1) say_no_effect("--orbit", kTcovHasNoCamera);
}

namespace {

constexpr Choice<DepthFunction> kDepthTests[] = {{"never", DepthFunction::kNever},
                                                 {"less", DepthFunction::kLess},
                                                 {"equal", DepthFunction::kEqual},
                                                 {"less_equal", DepthFunction::kLessEqual},
                                                 {"greater", DepthFunction::kGreater},
                                                 {"not_equal", DepthFunction::kNotEqual},
                                                 {"greater_equal", DepthFunction::kGreaterEqual},
                                                 {"always", DepthFunction::kAlways}};
static_assert(std::size(kDepthTests) == kDepthFunctions);

}  // namespace

void DepthOptions::add_to(Command& command) {
  command.add_option("--depth-test", test, "Which fragments pass, against the stored depth")
      ->type_name(type_name_of(std::span(kDepthTests)))
      ->capture_default_str();
  command.add_option("--depth-clear", clear, "Depth where nothing is drawn, 0 (near) to 1 (far)")
      ->check(not_negative())
      ->capture_default_str();
}

DepthState DepthOptions::load(const Config& config) const {
  if (clear > 1.0) {
    throw Error(ErrorCode::kUsage, "--depth-clear", fmt::format("{} is not 0..1", clear));
  }
  const auto cleared = static_cast<std::uint32_t>(std::llround(clear * config.depth_max()));
  return {chosen(std::span(kDepthTests), test, "--depth-test"), cleared};
}

Box parse_scissor(const std::string& text, const FrameState& frame) {
  std::array<std::int32_t, 4> value{};  // x, y, width, height
  constexpr std::string_view kSeparators = ",,x";
  const char* at = text.data();
  const char* const end = at + text.size();
  for (std::size_t i = 0; i < value.size(); ++i) {
    const auto [stop, error] = std::from_chars(at, end, value[i]);
    const bool last = i + 1 == value.size();
    if (error != std::errc() || (last ? stop != end : stop == end || *stop != kSeparators[i])) {
      throw Error(
          ErrorCode::kUsage, "--scissor",
          fmt::format("'{:.40}' is not X,Y,WIDTHxHEIGHT in pixels, such as 0,0,320x240", text));
    }
    at = last ? stop : stop + 1;
  }
  const auto [x, y, width, height] = value;
  const bool fits = x >= 0 && y >= 0 && width >= 1 && height >= 1 && width <= frame.width - x &&
                    height <= frame.height - y;
  if (fits) return {x, y, x + width - 1, y + height - 1};
  throw Error(
      ErrorCode::kUsage, "--scissor",
      fmt::format("{} is not in the frame of {} x {} pixels", text, frame.width, frame.height));
}

}  // namespace halfspace
