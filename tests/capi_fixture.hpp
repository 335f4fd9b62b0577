// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "halfspace.h"

namespace halfspace::capi_test {

// Destroys its model.
class Handle {
 public:
  enum Kind { kPreset, kJson };
  explicit Handle(const char* text, Kind kind = kPreset) {
    EXPECT_EQ(kind == kPreset ? hs_create_preset(text, &model_) : hs_create_json(text, &model_),
              HS_OK)
        << hs_last_error();
  }
  ~Handle() { hs_destroy(model_); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hs_model*() const { return model_; }

 private:
  hs_model* model_ = nullptr;
};

inline hs_frame frame_of(int width, int height, std::uint32_t outputs) {
  hs_frame frame{};
  frame.struct_size = sizeof frame;
  frame.width = width;
  frame.height = height;
  frame.outputs = outputs;
  return frame;
}

inline constexpr std::int32_t kTriangle[6] = {0, 0, 4000, 0, 0, 4000};

// The status, and one line of text that names `word`.
inline void expect_refused(hs_status got, hs_status expected, const std::string& word) {
  EXPECT_EQ(got, expected) << hs_status_text(got) << ": " << hs_last_error();
  const std::string text = hs_last_error();
  EXPECT_NE(text.find(word), std::string::npos) << text;
  EXPECT_EQ(text.find('\n'), std::string::npos) << text;
}

// All that wait, some at a time.
inline std::vector<hs_tile> pull_all(hs_model* model) {
  std::vector<hs_tile> all;
  std::vector<hs_tile> part(100);
  std::size_t count = 0;
  while (hs_pull_tiles(model, part.data(), part.size(), &count) == HS_OK) {
    all.insert(all.end(), part.begin(), part.begin() + static_cast<std::ptrdiff_t>(count));
  }
  return all;
}

inline std::uint32_t crc_of(hs_model* model) {
  hs_stats stats{};
  stats.struct_size = sizeof stats;
  EXPECT_EQ(hs_get_stats(model, &stats), HS_OK) << hs_last_error();
  return stats.coverage_crc32;
}

}  // namespace halfspace::capi_test
