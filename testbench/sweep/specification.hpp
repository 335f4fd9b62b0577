// SPDX-License-Identifier: Apache-2.0
//
// What a sweep or a soak is to do, from a JSON file. Keys and values: docs/02_use/many_machines.md.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "config.hpp"
#include "scene/scene.hpp"

namespace halfspace {

// One object read from a file, taken apart key by key, so that what is wrong names file, key and
// value. Every refusal is Error(kSpecification).
class SpecificationFile {
 public:
  using Json = nlohmann::ordered_json;

  // At most 1 MiB and 8 levels deep; no key twice in an object.
  explicit SpecificationFile(const std::string& path);

  const std::string& path() const { return path_; }
  // The same for the same values, however they are laid out.
  std::string canonical() const { return json_.dump(); }

  // The value of a key; null when it is not there.
  const Json* find(const char* key) const;
  // After the last find(): refuses a key that nobody asked for.
  void require_known(const std::vector<const char*>& keys) const;

  // The whole number at `key`, or `otherwise`.
  std::uint64_t whole(const char* key, std::uint64_t low, std::uint64_t high,
                      std::uint64_t otherwise) const;
  double number(const char* key, double low, double high, double otherwise) const;
  // The strings of a list that is not empty; `otherwise` when the key is not there.
  std::vector<std::string> strings(const char* key,
                                   const std::vector<std::string>& otherwise) const;

  // "PATH: KEY = VALUE WHAT"
  [[noreturn]] void refuse(const std::string& key, const Json& value,
                           const std::string& what) const;

 private:
  std::string path_;
  Json json_;
};

// Values of one field of the configuration.
struct SweepAxis {
  std::string key;
  std::vector<nlohmann::json> values;
};
// All combinations of the axes' values, the last axis fastest.
struct SweepGrid {
  Config base;
  std::vector<SweepAxis> axes;

  std::uint64_t size() const;
  Config at(std::uint64_t index) const;  // may be illegal
};

enum class Measure { kCoverageError, kAttributeError, kClocks, kLatency, kArea, kSynth, kRtl };

struct SweepSpecification {
  std::string path;
  std::vector<std::string> scenes;       // as written
  std::vector<std::string> scene_files;  // where they are
  std::vector<FrameSize> sizes;
  int views = 1;
  std::vector<SweepGrid> grids;
  std::vector<Measure> measures;  // each once
  double stall = 0;               // of `rtl`
  std::uint64_t seed = 1;
  std::uint64_t budget = 0;  // of `coverage_error`, and of `attribute_error` / 40
  std::uint64_t hash = 0;    // of the file's values and of the files it names
};

inline constexpr std::uint64_t kMostCases = 10'000'000;

// Throws Error(kSpecification), and kFitOracle for a measure that this build has not.
SweepSpecification read_sweep(const std::string& path);

const char* measure_name(Measure measure);

}  // namespace halfspace
