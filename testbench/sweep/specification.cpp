// SPDX-License-Identifier: Apache-2.0
#include "specification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

#include "io/config_json.hpp"
#include "io/error.hpp"
#include "io/fnv.hpp"
#include "io/output_file.hpp"

namespace halfspace {
namespace {

namespace fs = std::filesystem;
using Json = SpecificationFile::Json;

#ifdef HALFSPACE_HAS_ORACLE
constexpr bool kHasOracle = true;
#else
constexpr bool kHasOracle = false;
#endif

constexpr std::uint64_t kMostBudget = 1'000'000'000;
constexpr std::uint64_t kBudget = 4'000'000;  // as fit has it

constexpr std::array<const char*, 7> kMeasures{
    "coverage_error", "attribute_error", "clocks", "latency", "area", "synth", "rtl"};

bool is_field(const std::string& key) { return config_json(kFull).contains(key); }

// {"from": 4, "to": 8, "step": 2}
std::vector<nlohmann::json> range(const SpecificationFile& file, const std::string& key,
                                  const Json& value) {
  for (const auto& [name, number] : value.items()) {
    if (name != "from" && name != "to" && name != "step") {
      file.refuse(key + "." + name, number, "is an unknown key (there are from, to, step)");
    }
    if (!number.is_number_integer() || number < -1000 || number > 1000) {
      file.refuse(key + "." + name, number, "is not a whole number in -1000..1000");
    }
  }
  if (!value.contains("from") || !value.contains("to")) file.refuse(key, value, "lacks from or to");
  const int step = value.value("step", 1);
  if (step < 1) file.refuse(key + ".step", value["step"], "is below 1");
  std::vector<nlohmann::json> out;
  for (int i = value["from"]; i <= value["to"].get<int>(); i += step) out.emplace_back(i);
  if (out.empty()) file.refuse(key, value, "is an empty range");
  return out;
}

SweepAxis axis(const SpecificationFile& file, const std::string& place, const std::string& key,
               const Json& value) {
  SweepAxis out{key, {}};
  const std::string name = place + "." + key;
  if (value.is_object()) {
    out.values = range(file, name, value);
  } else if (value.is_array()) {
    if (value.empty()) file.refuse(name, value, "is an empty list");
    for (const Json& one : value) out.values.push_back(one);
  } else {
    out.values.push_back(value);
  }
  for (std::size_t i = 0; i < out.values.size(); ++i) {
    const nlohmann::json& one = out.values[i];
    Config unused;
    if (!one.is_primitive()) file.refuse(name, one, "is not a value");
    try {
      set_config_field(unused, key, one, file.path());
    } catch (const Error&) {
      file.refuse(name, one,
                  key == "snap" ? "is not nearest_even, half_away or truncate"
                                : "is not a whole number in range");
    }
    if (std::count(out.values.begin(), out.values.end(), one) > 1) {
      file.refuse(name, one, "is there twice");
    }
  }
  return out;
}

SweepGrid grid(const SpecificationFile& file, const std::string& place, const Json& value) {
  if (!value.is_object()) file.refuse(place, value, "is not an object");
  SweepGrid out;
  for (const auto& [key, one] : value.items()) {
    if (key == "base") {
      if (!one.is_string()) file.refuse(place + ".base", one, "is not a string");
      try {
        out.base = load_config(one.get<std::string>());
      } catch (const Error& error) {
        file.refuse(place + ".base", one, fmt::format("is no configuration: {}", error.what()));
      }
    } else if (is_field(key)) {
      out.axes.push_back(axis(file, place, key, one));
    } else {
      file.refuse(place + "." + key, one, "is an unknown key (there are base and config's fields)");
    }
  }
  return out;
}

std::vector<SweepGrid> grids(const SpecificationFile& file) {
  const Json* value = file.find("config");
  if (value == nullptr) return {SweepGrid{}};
  if (!value->is_array()) return {grid(file, "config", *value)};
  if (value->empty()) file.refuse("config", *value, "is an empty list");
  std::vector<SweepGrid> out;
  for (std::size_t i = 0; i < value->size(); ++i) {
    out.push_back(grid(file, fmt::format("config[{}]", i), (*value)[i]));
  }
  return out;
}

std::vector<FrameSize> sizes(const SpecificationFile& file) {
  std::vector<FrameSize> out;
  for (const std::string& text : file.strings("size", {"640x480"})) {
    try {
      out.push_back(parse_size(text));
    } catch (const Error&) {
      file.refuse("size", text, "is not WIDTHxHEIGHT, each 1..32768");
    }
  }
  return out;
}

std::vector<Measure> measures(const SpecificationFile& file) {
  std::vector<Measure> out;
  for (const std::string& name : file.strings("measure", {"coverage_error", "clocks", "area"})) {
    const auto found = std::find(kMeasures.begin(), kMeasures.end(), name);
    if (found == kMeasures.end()) {
      file.refuse("measure", name,
                  fmt::format("is no measure (there are {})", fmt::join(kMeasures, ", ")));
    }
    out.push_back(static_cast<Measure>(found - kMeasures.begin()));
    if (out.back() == Measure::kCoverageError && !kHasOracle) {
      throw Error(ErrorCode::kFitOracle, file.path(),
                  "coverage_error: this build has no oracle (install libcgal-dev and configure "
                  "again)");
    }
  }
  return out;
}

// Where the program stands, else beside the specification.
std::string find_scene(const SpecificationFile& file, std::size_t index, const std::string& scene) {
  const fs::path beside = fs::path(file.path()).parent_path() / scene;
  for (const fs::path& path : {fs::path(scene), beside}) {
    std::error_code failed;
    if (fs::is_regular_file(path, failed) && std::ifstream(path).good()) return path.string();
  }
  file.refuse(fmt::format("scenes[{}]", index), scene, "cannot be read: no such file");
}

}  // namespace

const char* measure_name(Measure measure) { return kMeasures[static_cast<std::size_t>(measure)]; }

std::uint64_t SweepGrid::size() const {
  std::uint64_t out = 1;
  for (const SweepAxis& axis : axes) out = std::min(out * axis.values.size(), kMostCases + 1);
  return out;
}

Config SweepGrid::at(std::uint64_t index) const {
  Config config = base;
  for (auto axis = axes.rbegin(); axis != axes.rend(); ++axis) {
    set_config_field(config, axis->key, axis->values[index % axis->values.size()], "");
    index /= axis->values.size();
  }
  return config;
}

SweepSpecification read_sweep(const std::string& path) {
  const SpecificationFile file(path);
  file.require_known({"scenes", "size", "views", "config", "measure", "stall", "seed", "budget"});
  SweepSpecification out;
  out.path = path;
  if (file.find("scenes") == nullptr) {
    throw Error(ErrorCode::kSpecification, path, "the key 'scenes' is not there");
  }
  out.scenes = file.strings("scenes", {});
  out.sizes = sizes(file);
  out.views = static_cast<int>(file.whole("views", 1, 4096, 1));
  out.grids = grids(file);
  out.measures = measures(file);
  out.stall = file.number("stall", 0, 0.95, 0);
  out.seed = file.whole("seed", 0, ~std::uint64_t{0}, 1);
  out.budget = file.whole("budget", 40, kMostBudget, kBudget);
  Fnv hash;
  hash.add(file.canonical());
  for (const SweepGrid& grid : out.grids) hash.add(config_json(grid.base).dump());
  for (std::size_t i = 0; i < out.scenes.size(); ++i) {
    out.scene_files.push_back(find_scene(file, i, out.scenes[i]));
    hash.add(read_file(out.scene_files.back()));
  }
  out.hash = hash.value();
  return out;
}

}  // namespace halfspace
