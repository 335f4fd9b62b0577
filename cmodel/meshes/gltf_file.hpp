// SPDX-License-Identifier: Apache-2.0
//
// A glTF 2.0 file: its JSON, its buffers, and accessors as numbers. Nothing is looked at before it
// is asked for, so that what is not used cannot be wrong.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "../io/error.hpp"

namespace halfspace {

// Nodes of a scene graph and values in JSON may be nested as deep.
inline constexpr int kGltfDeepest = 500;

// The JSON library's text of an error, without its tag and without what it quotes of the file,
// which may be all of it.
std::string json_error_text(const std::string& text);

class GltfFile {
 public:
  // chunk: the binary chunk of a GLB, the buffer that has no uri. Throws Error(kMeshBroken) for
  // what is no glTF 2.0, and when an extension is required that is not understood here.
  GltfFile(const std::string& path, std::string_view text, std::string_view chunk);

  [[noreturn]] void fail(const std::string& text, ErrorCode code = ErrorCode::kMeshBroken) const {
    throw Error(code, path_, text);
  }

  const nlohmann::json& root() const { return root_; }
  // The array of that name, empty when there is none.
  const nlohmann::json& list(const char* name) const;
  // A member that counts or points: a whole number from 0 to 2^53.
  std::uint64_t whole(const nlohmann::json& object, const char* name, std::uint64_t fallback) const;
  // One that names an element of the array `into`.
  std::size_t index(const nlohmann::json& object, const char* name, const char* into) const;
  // `count` numbers, or those of `fallback` when there is no such member.
  std::vector<double> numbers(const nlohmann::json& object, const char* name, std::size_t count,
                              std::vector<double> fallback) const;

  std::uint64_t count(std::size_t accessor) const;
  // All elements of an accessor, of the first `components` of each; integers that are normalized,
  // or all with as_unit, in -1..1. Elements that it says nothing of are zero.
  std::vector<float> floats(std::size_t accessor, std::size_t components, bool as_unit = false);
  std::vector<std::uint32_t> indices(std::size_t accessor);
  std::size_t components(std::size_t accessor) const;

 private:
  struct View {
    std::string_view bytes;
    std::uint64_t stride = 0;  // 0: elements follow each other
  };
  struct Layout {
    std::size_t components = 0, size = 0;  // of an element; of a component, bytes
    std::uint64_t type = 0;
    bool normalized = false;
  };

  void check_version() const;
  void check_extensions() const;
  std::string_view buffer(std::size_t at);
  std::string decode(std::size_t at, std::string_view base64) const;
  View view(std::size_t at);
  Layout layout(std::size_t accessor) const;
  // The elements of `object`, an accessor or a part of a sparse one.
  View elements(const nlohmann::json& object, std::uint64_t count, std::size_t size,
                const std::string& name);
  // The elements are there: before memory is taken for them.
  void require_data(std::size_t accessor);
  template <class Take>
  void each(std::size_t accessor, std::size_t wanted, const Take& take);

  const std::string& path_;
  std::string_view chunk_;
  nlohmann::json root_;
  std::map<std::size_t, std::string> buffers_;  // those that were asked for
};

}  // namespace halfspace
