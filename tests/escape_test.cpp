// SPDX-License-Identifier: Apache-2.0
#include "io/escape.hpp"

#include <gtest/gtest.h>

#include "io/tcov.hpp"
#include "splitmix.hpp"

namespace halfspace {
namespace {

TEST(Escape, HtmlHasNoMarkupOfTheText) {
  EXPECT_EQ(escaped("a<b> & \"c\" 'd'"), "a&lt;b&gt; &amp; &quot;c&quot; 'd'");
  EXPECT_EQ(escaped("&amp;"), "&amp;amp;");
}

TEST(Escape, ShellWordIsOneWord) {
  EXPECT_EQ(quoted("a b$c"), "'a b$c'");
  EXPECT_EQ(quoted("it's"), "'it'\\''s'");
  EXPECT_EQ(quoted(""), "''");
}

TEST(Crc32, IsTheStandardsCheckValueForBytesAndText) {
  const std::string text = "123456789";
  EXPECT_EQ(crc32_of(std::string_view(text)), 0xcbf43926u);
  EXPECT_EQ(crc32_of(std::vector<std::uint8_t>(text.begin(), text.end())), 0xcbf43926u);
  EXPECT_EQ(crc32_of(std::string_view("6789"), crc32_of(std::string_view("12345"))), 0xcbf43926u);
}

// The first words from state 1234567, as the authors' reference program prints them.
TEST(Splitmix, HasThePublishedSequence) {
  std::uint64_t state = 1234567;
  EXPECT_EQ(splitmix_next(state), 6457827717110365317u);
  EXPECT_EQ(splitmix_next(state), 3203168211198807973u);
  EXPECT_EQ(splitmix_next(state), 9817491932198370423u);
}

}  // namespace
}  // namespace halfspace
