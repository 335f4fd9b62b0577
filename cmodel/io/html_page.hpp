// SPDX-License-Identifier: Apache-2.0
//
// What the pages of `report` and `fit` are made of: one style, one kind of chart, no network and no
// script. Texts are escaped here, but for cells of a table, which may hold markup.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace halfspace {

struct ChartPoint {
  double x = 0;
  double y = 0;
};

struct ChartLine {
  std::string name;  // in the legend; shown when there are several lines
  std::vector<ChartPoint> points;
  bool dashed = false;  // counted only, or another way of doing the same
};

struct LineChart {
  std::string title;
  std::string x_label;
  std::string y_label;
  std::vector<ChartLine> lines;
  std::optional<double> chosen = std::nullopt;  // x of the point of the first line that is marked
  double limit = 0;                             // a line across; 0: none
  bool logarithmic = true;  // y; 0 is drawn a decade below the least of the others
  bool octaves = false;     // x doubles from point to point
};

// A picture as an element of a page. Empty when the first line has fewer than two points.
std::string line_chart(const LineChart& chart);

// The beginning of a page, up to its first heading's element.
std::string page_head(const std::string& title);
std::string page_end();

// A row of a table; tag th for heads. The class may be empty.
std::string table_row(const std::vector<std::string>& cells, const char* tag = "td",
                      const std::string& css_class = "");

// A bar for a cell, from nothing (0) to the column's width (1).
std::string bar(double share);

}  // namespace halfspace
