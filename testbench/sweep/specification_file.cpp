// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "io/error.hpp"
#include "io/output_file.hpp"
#include "specification.hpp"

namespace halfspace {
namespace {

constexpr std::size_t kMostBytes = 1 << 20;
constexpr int kDeepest = 8;

// Watches a parser: how deep it is, and the keys of the objects it is in.
class Watch {
 public:
  explicit Watch(std::string place) : place_(std::move(place)) {}

  bool operator()(int depth, nlohmann::json::parse_event_t event,
                  const nlohmann::ordered_json& parsed) {
    using Event = nlohmann::json::parse_event_t;
    if (depth > kDeepest) {
      throw Error(ErrorCode::kSpecification, place_,
                  fmt::format("nested deeper than {} levels", kDeepest));
    }
    const auto level = static_cast<std::size_t>(depth);
    if (keys_.size() <= level) keys_.resize(level + 2);
    if (event == Event::object_start) keys_[level + 1].clear();
    if (event != Event::key) return true;
    const auto key = parsed.get<std::string>();
    if (!keys_[level].insert(key).second) {
      throw Error(ErrorCode::kSpecification, place_,
                  fmt::format("key '{:.40}' is there twice", key));
    }
    return true;
  }

 private:
  std::string place_;
  std::vector<std::set<std::string>> keys_;
};

std::string read_bounded(const std::string& path) {
  std::error_code failed;
  const auto size = std::filesystem::file_size(path, failed);
  if (!failed && size > kMostBytes) {
    throw Error(ErrorCode::kSpecification, path, "larger than 1 MiB");
  }
  return read_file(path);
}

}  // namespace

SpecificationFile::SpecificationFile(const std::string& path) : path_(path) {
  const std::string text = read_bounded(path);
  try {
    json_ = Json::parse(text, Watch(path));
  } catch (const nlohmann::json::exception& error) {
    const auto* at = dynamic_cast<const nlohmann::json::parse_error*>(&error);
    const std::size_t byte = at == nullptr ? 0 : std::min(at->byte, text.size());
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(byte);
    throw Error(ErrorCode::kSpecification,
                fmt::format("{}:{}", path, 1 + std::count(text.begin(), end, '\n')),
                "not valid JSON");
  }
  if (!json_.is_object()) throw Error(ErrorCode::kSpecification, path, "not a JSON object");
}

const SpecificationFile::Json* SpecificationFile::find(const char* key) const {
  const auto found = json_.find(key);
  return found == json_.end() ? nullptr : &*found;
}

void SpecificationFile::require_known(const std::vector<const char*>& keys) const {
  for (const auto& [key, value] : json_.items()) {
    if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
    std::string known;
    for (const char* name : keys) known += (known.empty() ? "" : ", ") + std::string(name);
    throw Error(ErrorCode::kSpecification, path_,
                fmt::format("unknown key '{:.40}' (there are {})", key, known));
  }
}

std::uint64_t SpecificationFile::whole(const char* key, std::uint64_t low, std::uint64_t high,
                                       std::uint64_t otherwise) const {
  const Json* value = find(key);
  if (value == nullptr) return otherwise;
  if (value->is_number_unsigned()) {
    const auto got = value->get<std::uint64_t>();
    if (got >= low && got <= high) return got;
  }
  refuse(key, *value, fmt::format("is not a whole number in {}..{}", low, high));
}

double SpecificationFile::number(const char* key, double low, double high, double otherwise) const {
  const Json* value = find(key);
  if (value == nullptr) return otherwise;
  if (value->is_number()) {
    const auto got = value->get<double>();
    if (got >= low && got <= high) return got;
  }
  refuse(key, *value, fmt::format("is not a number in {}..{}", low, high));
}

std::vector<std::string> SpecificationFile::strings(
    const char* key, const std::vector<std::string>& otherwise) const {
  const Json* value = find(key);
  if (value == nullptr) return otherwise;
  if (!value->is_array() || value->empty()) refuse(key, *value, "is not a list of some strings");
  std::vector<std::string> out;
  for (std::size_t i = 0; i < value->size(); ++i) {
    const Json& one = (*value)[i];
    const std::string name = fmt::format("{}[{}]", key, i);
    if (!one.is_string()) refuse(name, one, "is not a string");
    out.push_back(one.get<std::string>());
    if (std::count(out.begin(), out.end(), out.back()) > 1) refuse(name, one, "is there twice");
  }
  return out;
}

void SpecificationFile::refuse(const std::string& key, const Json& value,
                               const std::string& what) const {
  const std::string text =
      value.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace).substr(0, 80);
  throw Error(ErrorCode::kSpecification, path_, fmt::format("{} = {} {}", key, text, what));
}

}  // namespace halfspace
