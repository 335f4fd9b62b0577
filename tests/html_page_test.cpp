// SPDX-License-Identifier: Apache-2.0
#include "io/html_page.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace halfspace {
namespace {

using testing::HasSubstr;
using testing::Not;

LineChart falling() {
  return {"a < b", "bits", "ppm", {{"rounded", {{0, 20000}, {1, 1500}, {2, 100}, {3, 0}}}}, 1, 500};
}

TEST(HtmlPage, AChartSaysWhatItMarks) {
  const std::string svg = line_chart(falling());
  EXPECT_THAT(svg, HasSubstr(">a &lt; b</text>"));
  EXPECT_THAT(svg, HasSubstr(">1,500</text>"));  // the chosen point
  EXPECT_THAT(svg, HasSubstr(">limit 500</text>"));
  EXPECT_THAT(svg, HasSubstr(">10,000</text>"));  // a decade
  EXPECT_THAT(svg, HasSubstr(">0</text>"));       // which has no logarithm
  EXPECT_THAT(svg, Not(HasSubstr(">rounded</text>")));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
}

TEST(HtmlPage, SeveralLinesHaveALegend) {
  LineChart chart = falling();
  chart.lines.push_back({"truncated", {{0, 40000}, {3, 10}}, true});
  const std::string svg = line_chart(chart);
  EXPECT_THAT(svg, HasSubstr(">rounded</text>"));
  EXPECT_THAT(svg, HasSubstr(">truncated</text>"));
}

TEST(HtmlPage, NoSlopeAndAllZeroAreDrawnToo) {
  for (const bool logarithmic : {false, true}) {
    for (const double y : {0.0, 7.0}) {
      LineChart chart = falling();
      chart.lines = {{"", {{1, y}, {2, y}}}};
      chart.limit = 0;
      chart.logarithmic = logarithmic;
      const std::string svg = line_chart(chart);
      EXPECT_THAT(svg, HasSubstr("<circle")) << logarithmic << y;
      EXPECT_THAT(svg, Not(HasSubstr("nan"))) << logarithmic << y;
      EXPECT_THAT(svg, Not(HasSubstr("inf"))) << logarithmic << y;
    }
  }
}

TEST(HtmlPage, OnePointIsNoChart) {
  LineChart chart = falling();
  chart.lines = {{"", {{1, 2}}}};
  EXPECT_EQ(line_chart(chart), "");
}

}  // namespace
}  // namespace halfspace
