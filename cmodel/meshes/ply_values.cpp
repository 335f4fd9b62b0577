// SPDX-License-Identifier: Apache-2.0
#include "ply_values.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "../io/error.hpp"
#include "../io/scan.hpp"
#include "raw_mesh.hpp"

namespace halfspace {

void PlyValues::fail(const std::string& text) const {
  const std::string place = line() == 0 ? path_ : path_ + ":" + std::to_string(line());
  throw Error(ErrorCode::kMeshBroken, place, text);
}

std::string_view PlyValues::token() {
  std::size_t blanks = 0;
  for (; blanks < rest_.size() && is_blank(rest_[blanks]); ++blanks) {
    // CR LF counts once.
    const bool crlf = rest_[blanks] == '\r' && rest_.substr(blanks + 1, 1) == "\n";
    if (rest_[blanks] == '\n' || (rest_[blanks] == '\r' && !crlf)) ++line_;
  }
  rest_.remove_prefix(blanks);
  const std::string_view token = next_token(rest_);
  if (token.empty()) {
    fail("the file ends before all its elements (here a " + shown(element_->name) + ")");
  }
  return token;
}

std::string_view PlyValues::take(std::size_t size) {
  if (rest_.size() < size) {
    fail("the file ends before all its elements (here a " + shown(element_->name) + ")");
  }
  const std::string_view bytes = rest_.substr(0, size);
  rest_.remove_prefix(size);
  return bytes;
}

double PlyValues::binary(const PlyType& type) {
  const std::string_view bytes = take(type.size);
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < type.size; ++i) {
    const std::size_t at = format_ == PlyFormat::kLittleEndian ? type.size - 1 - i : i;
    bits = bits << 8 | static_cast<std::uint8_t>(bytes[at]);
  }
  if (type.is_float) {
    return type.size == 4
               ? static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)))
               : std::bit_cast<double>(bits);
  }
  if (!type.is_signed) return static_cast<double>(bits);
  const auto unused = static_cast<int>(64 - 8 * type.size);
  return static_cast<double>(static_cast<std::int64_t>(bits << unused) >> unused);
}

double PlyValues::number(const PlyType& type) {
  if (format_ != PlyFormat::kAscii) return binary(type);
  const std::string_view text = token();
  const std::optional<double> value = parse_coordinate(text);
  if (!value) fail(shown(text) + " is not a number");
  return *value;
}

double PlyValues::any_number(const PlyType& type) {
  if (format_ != PlyFormat::kAscii) return binary(type);
  return parse_coordinate(token()).value_or(std::numeric_limits<double>::quiet_NaN());
}

double PlyValues::whole(const PlyType& type) {
  if (format_ != PlyFormat::kAscii) {
    const double value = binary(type);
    if (value != std::floor(value)) fail("a length or index is not a whole number");
    return value;
  }
  const std::string_view text = token();
  const std::optional<double> value = parse_number(text);
  if (!value) fail(shown(text) + " is not a number");
  if (*value != std::floor(*value)) fail(shown(text) + " is not a whole number");
  return *value;
}

void PlyValues::skip(const PlyType& type) {
  if (format_ == PlyFormat::kAscii) {
    token();
  } else {
    take(type.size);
  }
}

}  // namespace halfspace
