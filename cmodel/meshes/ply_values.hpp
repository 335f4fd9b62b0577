// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ply_header.hpp"

namespace halfspace {

// The values of a PLY file's data, one after the other: tokens between blanks, however they are
// spread over lines, or bytes.
class PlyValues {
 public:
  // bytes: what follows the header.
  PlyValues(const std::string& path, std::string_view bytes, const PlyHeader& header)
      : path_(path), rest_(bytes), format_(header.format), line_(header.lines + 1) {}

  // element: for messages. All throw Error(kMeshBroken) where the file ends.
  void begin(const PlyElement& element) { element_ = &element; }
  // NaN or infinity when it is not finite. Throws when it is no number.
  double number(const PlyType& type);
  // What need not be a number: NaN then.
  double any_number(const PlyType& type);
  // Throws when it is not whole, or no number.
  double whole(const PlyType& type);
  void skip(const PlyType& type);

  // The line of the last value; 0 in binary data.
  std::size_t line() const { return format_ == PlyFormat::kAscii ? line_ : 0; }
  std::string_view rest() const { return rest_; }
  [[noreturn]] void fail(const std::string& text) const;

 private:
  std::string_view token();
  double binary(const PlyType& type);
  std::string_view take(std::size_t size);

  const std::string& path_;
  std::string_view rest_;
  PlyFormat format_;
  std::size_t line_;
  const PlyElement* element_ = nullptr;
};

}  // namespace halfspace
