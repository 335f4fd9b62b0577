// SPDX-License-Identifier: Apache-2.0
#include "io/escape.hpp"

#include <gtest/gtest.h>

#include "io/error.hpp"
#include "io/printable.hpp"
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

TEST(Printable, IsOneLineThatMovesNoCursor) {
  EXPECT_EQ(printable("a\x1b[31mb\x7f\tc\nforged"), "a\\x1b[31mb\\x7f\\x09c\\x0aforged");
  EXPECT_EQ(printable("Gr\xc3\xbc\xc3\x9f"
                      "e \xe2\x82\xac"),
            "Gr\xc3\xbc\xc3\x9f"
            "e \xe2\x82\xac");
  EXPECT_EQ(printable("\xc2\x9b"
                      "31m"),
            "\\xc2\\x9b31m");  // a control character of Unicode
  EXPECT_EQ(printable("\x9b"
                      "31m \xc3"),
            "\\x9b31m \\xc3");  // no UTF-8
}

TEST(Printable, ErrorsAreOneShortLine) {
  const Error error(ErrorCode::kMeshBroken, "a\x1b\n.obj", std::string(5000, 'y') + "\nforged");
  const std::string what = error.what();
  EXPECT_TRUE(what.starts_with("a\\x1b\\x0a.obj: yyy"));
  EXPECT_LT(what.size(), kLongestLine + 10);
}

TEST(Printable, KeepsBothEndsOfALongText) {
  const std::string line = printable("here: " + std::string(3000000, 'x') + ": why");
  EXPECT_LT(line.size(), kLongestLine + 10);
  EXPECT_TRUE(line.starts_with("here: xxx"));
  EXPECT_TRUE(line.ends_with("xxx: why"));
  EXPECT_EQ(printable(std::string(kLongestLine / 2, 'x')), std::string(kLongestLine / 2, 'x'));
  EXPECT_LT(printable(std::string(100000, '\x1b')).size(), 2000u);
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
