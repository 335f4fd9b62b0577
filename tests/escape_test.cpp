// SPDX-License-Identifier: Apache-2.0
#include "io/escape.hpp"

#include <gtest/gtest.h>

#include "io/error.hpp"
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

TEST(Escape, WhatIsShownHasNoControlBytes) {
  EXPECT_EQ(printable("plain, \xc3\xa4 and \xe2\x82\xac, \xf0\x9f\x90\xb0"),
            "plain, \xc3\xa4 and \xe2\x82\xac, \xf0\x9f\x90\xb0");
  EXPECT_EQ(printable("a\x1b[31m\n\t\x7f\x07"), "a\\x1B[31m\\x0A\\x09\\x7F\\x07");
  EXPECT_EQ(printable("\xc2\x9b"
                      "31m \xff \xc3 \xe2\x82"),
            "\\xC2\\x9B"
            "31m \\xFF \\xC3 \\xE2\\x82");
  EXPECT_EQ(printable(std::string(50, 'x'), 10), std::string(10, 'x') + "...");
  EXPECT_EQ(printable(std::string("a\0b", 3)), "a\\x00b");
}

TEST(Escape, ErrorsAreOneShortLine) {
  const Error error(ErrorCode::kMeshBroken, "a\x1b.obj", "bad\n" + std::string(5000, 'y'));
  const std::string what = error.what();
  EXPECT_EQ(what.rfind("a\\x1B.obj: bad\\x0Ayyy", 0), 0U);
  EXPECT_LT(what.size(), 700U);
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
