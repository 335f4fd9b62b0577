// SPDX-License-Identifier: Apache-2.0
#include "io/config_json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/error.hpp"

namespace halfspace {
namespace {

// The message of the error that parsing causes; empty when there is none.
std::string refusal(const std::string& text, ErrorCode expected) {
  try {
    parse_config(text, "f.json");
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), expected) << error.what();
    return error.what();
  }
  return {};
}

TEST(ConfigJson, RoundTripsEveryPreset) {
  for (const Preset& preset : kPresets) {
    EXPECT_EQ(parse_config(config_json(preset.config).dump(), ""), preset.config) << preset.name;
  }
}

TEST(ConfigJson, PresetFillsWhatIsLeftOut) {
  const Config config = parse_config(R"({"preset": "tiny", "samples": 8, "snap": "truncate"})", "");
  EXPECT_EQ(config.viewport_bits, kTiny.viewport_bits);
  EXPECT_EQ(config.samples, 8);
  EXPECT_EQ(config.snap, SnapMode::kTruncate);
}

TEST(ConfigJson, UnknownKeyIsRefusedByName) {
  EXPECT_NE(refusal(R"({"subpixelbits": 4})", ErrorCode::kConfigKey).find("subpixelbits"),
            std::string::npos);
  EXPECT_NE(refusal(R"({"preset": "huge"})", ErrorCode::kConfigKey).find("huge"),
            std::string::npos);
}

TEST(ConfigJson, OutOfRangeValueIsRefusedByName) {
  for (const char* text : {R"({"subpixel_bits": 13})", R"({"subpixel_bits": -1})",
                           R"({"viewport_bits": 16})", R"({"guard_bits": 11})", R"({"samples": 3})",
                           R"({"grid_log2": 1})", R"({"setup_interval": 2})",
                           R"({"snap": "nearest"})", R"({"samples": 4.0})", R"({"samples": "4"})",
                           R"({"depth_bits": 99999999999999999999})", R"({"tag_bits": null})"}) {
    const std::string message = refusal(text, ErrorCode::kConfigRange);
    const std::string key = std::string(text).substr(2, std::string(text).find('"', 2) - 2);
    EXPECT_NE(message.find(key), std::string::npos) << text << " gave: " << message;
  }
}

TEST(ConfigJson, BrokenJsonNamesItsLine) {
  EXPECT_NE(refusal("{\n\"samples\": 4,\n", ErrorCode::kConfigRead).find("f.json:"),
            std::string::npos);
  EXPECT_FALSE(refusal("[]", ErrorCode::kConfigRead).empty());
  EXPECT_FALSE(refusal("", ErrorCode::kConfigRead).empty());
}

TEST(ConfigJson, NestingIsBoundedWhereverItStands) {
  const auto nested = [](const std::string& before, int depth, const std::string& after) {
    return before + std::string(static_cast<std::size_t>(depth), '[') +
           std::string(static_cast<std::size_t>(depth), ']') + after;
  };
  for (const auto& [before, after] :
       {std::pair{"", ""}, {"{\"samples\":", "}"}, {"{\"preset\":", "}"}, {"{\"x\":", "}"}}) {
    const std::string message = refusal(nested(before, 80000, after), ErrorCode::kConfigRead);
    EXPECT_NE(message.find("f.json:1: JSON nested deeper than 64"), std::string::npos) << message;
  }
  EXPECT_FALSE(refusal(std::string(80000, '{'), ErrorCode::kConfigRead).empty());
  EXPECT_FALSE(refusal(nested("{\"samples\":", 63, "}"), ErrorCode::kConfigRange).empty());
  // Brackets in a string are no nesting.
  EXPECT_FALSE(
      refusal("{\"" + std::string(100, '[') + "\\\"[\":1}", ErrorCode::kConfigKey).empty());
}

TEST(ConfigJson, NumbersBeyondAnyTypeAreOutOfRange) {
  for (const char* text :
       {"1e999", "-1e999", "1e99999999999999999999", "99999999999999999999999"}) {
    EXPECT_FALSE(
        refusal(std::string("{\"samples\": ") + text + "}", ErrorCode::kConfigRange).empty());
  }
}

TEST(ConfigJson, AKeyThatIsThereTwiceIsRefused) {
  EXPECT_FALSE(refusal(R"({"samples": 1, "samples": 4})", ErrorCode::kConfigKey).empty());
  EXPECT_FALSE(refusal(R"({"samples": [{"a": 1, "a": 2}]})", ErrorCode::kConfigKey).empty());
  EXPECT_FALSE(refusal(R"({"samples": [{"a": 1}, {"a": 2}]})", ErrorCode::kConfigRange).empty());
}

}  // namespace
}  // namespace halfspace
