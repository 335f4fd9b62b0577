// SPDX-License-Identifier: Apache-2.0
#include "gltf_file.hpp"

#include <algorithm>
#include <array>

#include "../io/output_file.hpp"
#include "../io/scan.hpp"
#include "side_file.hpp"

namespace halfspace {
namespace {

using nlohmann::json;

int digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

// A URI's path as a file has it: %20 is a space.
std::string percent_decoded(std::string_view uri) {
  std::string out;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool is_coded =
        uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) >= 0 && digit(uri[i + 2]) >= 0;
    out += is_coded ? static_cast<char>(digit(uri[i + 1]) * 16 + digit(uri[i + 2])) : uri[i];
    if (is_coded) i += 2;
  }
  return out;
}

// What changes no more than textures, light and motion, which are not drawn here.
bool is_understood(std::string_view name) {
  constexpr std::array<std::string_view, 6> kWhole{"KHR_mesh_quantization",
                                                   "KHR_lights_punctual",
                                                   "KHR_animation_pointer",
                                                   "KHR_xmp_json_ld",
                                                   "KHR_xmp",
                                                   "EXT_lights_image_based"};
  constexpr std::array<std::string_view, 4> kBegin{"KHR_materials_", "KHR_texture_", "EXT_texture_",
                                                   "MSFT_texture_"};
  return std::find(kWhole.begin(), kWhole.end(), name) != kWhole.end() ||
         std::any_of(kBegin.begin(), kBegin.end(),
                     [name](std::string_view begin) { return name.starts_with(begin); });
}

}  // namespace

std::string json_error_text(const std::string& text) {
  const std::size_t begin = text.find("] ");
  std::string rest = begin == std::string::npos ? text : text.substr(begin + 2);
  if (const std::size_t quote = rest.find("; last read"); quote != std::string::npos) {
    rest.resize(quote);
  }
  return rest;
}

GltfFile::GltfFile(const std::string& path, std::string_view text, std::string_view chunk)
    : path_(path), chunk_(chunk) {
  try {
    // Deep nesting would exhaust the stack of whatever walks the values.
    root_ = json::parse(text, [this](int depth, json::parse_event_t, const json&) {
      if (depth > kGltfDeepest) fail("the JSON is nested too deeply");
      return true;
    });
  } catch (const json::exception& error) {
    fail(json_error_text(error.what()));
  }
  if (!root_.is_object()) fail("is not a JSON object");
  check_version();
  check_extensions();
}

void GltfFile::check_version() const {
  const json asset = root_.value("asset", json::object());
  const auto text = [&asset](const char* name) {
    const auto found = asset.is_object() ? asset.find(name) : asset.end();
    if (!asset.is_object() || found == asset.end()) return std::string();
    return found->is_string() ? found->get<std::string>() : found->dump();
  };
  const std::string least = text("minVersion");
  const std::string version = text("version");
  const bool objects = root_.contains("meshes") && root_["meshes"].is_object();
  if (version.starts_with("1") || version.starts_with("0") || (version.empty() && objects)) {
    fail("is glTF 1.0, which is not read: export it as glTF 2.0");
  }
  const std::string needed = least.empty() ? version : least;
  if (!needed.empty() && (least.empty() ? !needed.starts_with("2") : needed != "2.0")) {
    fail("needs glTF " + shown(needed) + ", 2.0 is read");
  }
}

void GltfFile::check_extensions() const {
  for (const json& name : list("extensionsRequired")) {
    if (!name.is_string()) fail("extensionsRequired has an element that is no name");
    const auto text = name.get<std::string>();
    if (!is_understood(text)) {
      fail("needs the extension " + shown(text) + ", which is not supported");
    }
  }
}

const json& GltfFile::list(const char* name) const {
  static const json none = json::array();
  const auto found = root_.find(name);
  if (found == root_.end()) return none;
  if (!found->is_array()) fail(std::string(name) + " is not an array");
  return *found;
}

std::uint64_t GltfFile::whole(const json& object, const char* name, std::uint64_t fallback) const {
  if (!object.is_object()) fail(std::string("what has ") + name + " is not a JSON object");
  const auto found = object.find(name);
  if (found == object.end()) return fallback;
  const double value = found->is_number() ? found->get<double>() : -1.0;
  if (!(value >= 0 && value <= 9007199254740992.0)) {
    fail(std::string(name) + " is not a whole number in range");
  }
  return static_cast<std::uint64_t>(value);
}

std::size_t GltfFile::index(const json& object, const char* name, const char* into) const {
  const std::uint64_t value = whole(object, name, UINT64_MAX);
  if (value >= list(into).size()) {
    fail(std::string(name) + " names no element of " + into, ErrorCode::kMeshIndex);
  }
  return static_cast<std::size_t>(value);
}

std::vector<double> GltfFile::numbers(const json& object, const char* name, std::size_t count,
                                      std::vector<double> fallback) const {
  const auto found = object.find(name);
  if (found == object.end()) return fallback;
  const bool right = found->is_array() && found->size() == count &&
                     std::all_of(found->begin(), found->end(),
                                 [](const json& value) { return value.is_number(); });
  if (!right) fail(std::string(name) + " is not " + std::to_string(count) + " numbers");
  return found->get<std::vector<double>>();
}

std::string GltfFile::decode(std::size_t at, std::string_view base64) const {
  while (!base64.empty() && (base64.back() == '=' || is_blank(base64.back()))) {
    base64.remove_suffix(1);
  }
  std::string out;
  out.reserve(base64.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int held = 0;
  for (const char c : base64) {
    int value = -1;
    if (c >= 'A' && c <= 'Z') value = c - 'A';
    if (c >= 'a' && c <= 'z') value = c - 'a' + 26;
    if (c >= '0' && c <= '9') value = c - '0' + 52;
    if (c == '+' || c == '-') value = 62;
    if (c == '/' || c == '_') value = 63;
    if (value < 0) {
      fail("buffer " + std::to_string(at) + ": " + shown(std::string_view(&c, 1)) +
           " is not base64");
    }
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    held += 6;
    if (held < 8) continue;
    held -= 8;
    out += static_cast<char>(static_cast<std::uint8_t>(bits >> held));
  }
  return out;
}

std::string_view GltfFile::buffer(std::size_t at) {
  const json& object = list("buffers")[at];
  const std::uint64_t size = whole(object, "byteLength", 0);
  const std::string name = "buffer " + std::to_string(at) + ": ";
  std::string_view present = chunk_;
  if (object.contains("uri")) {
    const auto [found, is_new] = buffers_.try_emplace(at);
    if (is_new) {
      if (!object["uri"].is_string()) fail(name + "its uri is no text");
      const std::string_view uri = object["uri"].get_ref<const std::string&>();
      const std::size_t comma = uri.find(";base64,");
      if (!uri.starts_with("data:")) {
        std::optional<std::string> file = find_side_file(path_, percent_decoded(uri));
        if (!file) file = find_side_file(path_, uri);
        if (!file) fail(name + "there is no file " + shown(uri));
        found->second = read_file(*file);
      } else if (comma == std::string_view::npos) {
        fail(name + "its data is not base64");
      } else {
        found->second = decode(at, uri.substr(comma + 8));
      }
    }
    present = found->second;
  } else if (at != 0 || chunk_.empty()) {
    fail(name + "has no data here");
  }
  if (present.size() < size) {
    fail(name + std::to_string(size) + " bytes declared, " + std::to_string(present.size()) +
         " present");
  }
  return present.substr(0, size);
}

}  // namespace halfspace
