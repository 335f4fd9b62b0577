// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "../io/error.hpp"
#include "../io/tcov.hpp"
#include "scene.hpp"

namespace halfspace {

FrameSize parse_size(const std::string& text) {
  FrameSize size;
  const char* end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size.width);
  const bool separated = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
  const auto height = separated ? std::from_chars(width.ptr + 1, end, size.height) : width;
  if (!separated || height.ec != std::errc() || height.ptr != end) {
    throw Error(ErrorCode::kSize, "--size",
                fmt::format("'{:.40}' is not WIDTHxHEIGHT in pixels, such as 640x480", text));
  }
  if (size.width < 1 || size.height < 1 || size.width > kTcovMaxSize ||
      size.height > kTcovMaxSize) {
    throw Error(ErrorCode::kSize, "--size",
                fmt::format("{} is out of range (1x1..{}x{})", text, kTcovMaxSize, kTcovMaxSize));
  }
  return size;
}

FrameSize frame_size(const std::string& text, const Config& config) {
  if (text.empty()) return {std::min(640, config.max_size()), std::min(480, config.max_size())};
  const FrameSize size = parse_size(text);
  require_size(size.width, size.height, config, "--size");
  return size;
}

void require_size(int width, int height, const Config& config, const std::string& place) {
  if (width <= config.max_size() && height <= config.max_size()) return;
  throw Error(
      ErrorCode::kSize, place,
      fmt::format("{}x{} is larger than the configuration's {}x{} (viewport_bits = {})", width,
                  height, config.max_size(), config.max_size(), config.viewport_bits));
}

}  // namespace halfspace
