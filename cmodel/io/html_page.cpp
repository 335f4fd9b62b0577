// SPDX-License-Identifier: Apache-2.0
#include "html_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "escape.hpp"

namespace halfspace {
namespace {

constexpr const char* kStyle = R"(
body { font: 16px/1.5 system-ui, sans-serif; margin: 2rem auto; max-width: 70rem; padding: 0 1rem;
       color: #1f2937; background: #fff; }
h1 { font-size: 1.6rem; margin-bottom: 0; } h2 { font-size: 1.2rem; margin-top: 2.2rem; }
.from { color: #6b7280; } code { background: #f3f4f6; padding: 0 .25em; }
figure { margin: .6rem 0; } figcaption { color: #6b7280; font-size: .9rem; }
.row { display: flex; flex-wrap: wrap; gap: 1rem; } .row figure { flex: 1 1 20rem; }
img { max-width: 100%; height: auto; border: 1px solid #d1d5db; }
svg { max-width: 100%; height: auto; margin: .3rem .6rem .3rem 0; vertical-align: top; }
table { border-collapse: collapse; margin: .6rem 0; }
td, th { padding: .2rem .8rem; border-bottom: 1px solid #d1d5db; text-align: right; }
td:first-child, th:first-child { text-align: left; }
.bar { background: #2563eb; height: .6rem; } .chosen { background: #dbeafe; }
.good { color: #276749; } .bad { color: #c2410c; }
)";

constexpr std::array kColors{"#2563eb", "#c2410c", "#6b7280", "#d97706"};
constexpr const char* kMark = "#c2410c";
constexpr double kLeft = 78, kRight = 410, kTop = 34, kBottom = 208;

// Whole from 100 on, with commas between thousands; else three digits.
std::string number(double value) {
  const bool whole = value == std::floor(value) || value >= 100;
  std::string out = whole ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
  for (std::size_t at = out.size(); whole && at > 3;) out.insert(at -= 3, 1, ',');
  return out;
}

// Where values of a chart lie in its picture.
class Scale {
 public:
  explicit Scale(const LineChart& chart) : chart_(chart) {
    double least = chart.limit > 0 ? chart.limit : std::numeric_limits<double>::infinity();
    for_each_point([&](const ChartPoint& p) {
      x0_ = std::min(x0_, along(p.x));
      x1_ = std::max(x1_, along(p.x));
      if (p.y > 0) least = std::min(least, p.y);
      if (p.y == 0) zero_ = true;
    });
    floor_ = std::isfinite(least) ? least / 10 : 1;
    if (chart.limit > 0) include(chart.limit);
    for_each_point([&](const ChartPoint& p) { include(p.y); });
    if (!chart.logarithmic) low_ = std::min(low_, 0.0);
    if (!chart.logarithmic && high_ <= low_) high_ = low_ + 1;
    if (chart.logarithmic && high_ - low_ < 1) {  // less than a decade is no slope
      const double middle = (high_ + low_) / 2;
      low_ = middle - 0.5;
      high_ = middle + 0.5;
    }
  }

  double x(double value) const {
    return kLeft + (kRight - kLeft) * (along(value) - x0_) / std::max(x1_ - x0_, 1e-9);
  }
  double y(double value) const {
    return kBottom - (kBottom - kTop) * (height(value) - low_) / (high_ - low_);
  }

  // Values at which a line is drawn across: decades, with 2 and 5 of each where there are few, or
  // steps of 1, 2 or 5. And 0, where it is drawn.
  std::vector<double> grid() const {
    std::vector<double> values;
    if (chart_.logarithmic) {
      const double every = std::max(1.0, std::ceil((high_ - low_) / 6));
      for (double e = std::floor(low_); e <= high_; e += every) {
        for (const double times : {1.0, 2.0, 5.0}) {
          if (times > 1 && high_ - low_ > 2) break;
          const double value = times * std::pow(10, e);
          const double share = (std::log10(value) - low_) / (high_ - low_);
          if (share >= (zero_ ? 0.08 : 0) && share <= 1) values.push_back(value);
        }
      }
      if (zero_) values.push_back(0);
      return values;
    }
    double step = std::pow(10, std::floor(std::log10((high_ - low_) / 3)));
    for (const double times : {5.0, 2.0}) {
      if ((high_ - low_) / (step * times) >= 2.5) {
        step *= times;
        break;
      }
    }
    for (double v = std::ceil(low_ / step); v * step <= high_; ++v) values.push_back(v * step);
    return values;
  }

 private:
  template <class Each>
  void for_each_point(Each&& each) const {
    for (const ChartLine& line : chart_.lines) {
      for (const ChartPoint& p : line.points) each(p);
    }
  }

  void include(double value) {
    low_ = std::min(low_, height(value));
    high_ = std::max(high_, height(value));
  }

  double along(double value) const { return chart_.octaves ? std::log2(value) : value; }
  double height(double value) const {
    return chart_.logarithmic ? std::log10(std::max(value, floor_)) : value;
  }

  const LineChart& chart_;
  double x0_ = std::numeric_limits<double>::infinity(), x1_ = -x0_;
  double low_ = std::numeric_limits<double>::infinity(), high_ = -low_;
  double floor_ = 1;
  bool zero_ = false;  // a point is 0
};

std::string text(double x, double y, const char* anchor, const std::string& what,
                 const char* more = "") {
  return fmt::format("<text x='{:.1f}' y='{:.1f}' text-anchor='{}'{}>{}</text>", x, y, anchor, more,
                     escaped(what));
}

std::string axes(const LineChart& chart, const Scale& scale) {
  std::string out;
  for (const double value : scale.grid()) {
    const double y = scale.y(value);
    out += fmt::format("<path d='M{} {:.1f}H{}' stroke='#e5e7eb'/>", kLeft, y, kRight);
    out += text(kLeft - 6, y + 4, "end", number(value));
  }
  double last = 0;
  for (const ChartPoint& p : chart.lines.front().points) {
    const double x = scale.x(p.x);
    if (x < last + 18) continue;
    last = x;
    out += text(x, kBottom + 15, "middle", number(p.x));
  }
  out += fmt::format("<path d='M{} {}V{}H{}' fill='none' stroke='#6b7280'/>", kLeft, kTop, kBottom,
                     kRight);
  out += text((kLeft + kRight) / 2, kBottom + 32, "middle", chart.x_label);
  const double middle = (kTop + kBottom) / 2;
  return out + text(14, middle, "middle", chart.y_label,
                    fmt::format(" transform='rotate(-90 14 {})'", middle).c_str());
}

std::string curve(const ChartLine& line, const Scale& scale, const char* color) {
  std::string path, marks;
  for (const ChartPoint& p : line.points) {
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", scale.x(p.x), scale.y(p.y));
    marks += fmt::format(
        "<circle cx='{:.1f}' cy='{:.1f}' r='2.5' fill='{}'><title>{}: {:.4g}</title></circle>",
        scale.x(p.x), scale.y(p.y), color, p.x, p.y);
  }
  return fmt::format("<path d='{}' fill='none' stroke='{}' stroke-width='1.5'{}/>{}", path, color,
                     line.dashed ? " stroke-dasharray='5 3'" : "", marks);
}

// The point of the first line at x = chosen, with its value where the line does not go.
std::string chosen_mark(const LineChart& chart, const Scale& scale) {
  const std::vector<ChartPoint>& points = chart.lines.front().points;
  for (std::size_t n = 0; n < points.size(); ++n) {
    if (points[n].x != chart.chosen) continue;
    const double x = scale.x(points[n].x), y = scale.y(points[n].y);
    const bool left = x > kRight - 40 || (n + 1 < points.size() && points[n + 1].y > points[n].y);
    return fmt::format(
               "<circle cx='{:.1f}' cy='{:.1f}' r='6' fill='none' stroke='{}' stroke-width='2'/>",
               x, y, kMark) +
           text(x + (left ? 4 : 9), y - (left ? 11 : 6), left ? "end" : "start",
                number(points[n].y), " fill='#c2410c' font-weight='bold'");
  }
  return "";
}

// The chosen point, the limit, and which line is which.
std::string marks(const LineChart& chart, const Scale& scale) {
  std::string out = chosen_mark(chart, scale);
  if (chart.limit > 0) {
    const double y = scale.y(chart.limit);
    out += fmt::format("<path d='M{} {:.1f}H{}' stroke='{}' stroke-dasharray='4 3'/>", kLeft, y,
                       kRight, kMark);
    out += text(kRight, y - 4, "end", "limit " + number(chart.limit), " fill='#c2410c'");
  }
  if (chart.lines.size() < 2) return out;
  double x = kLeft;
  for (std::size_t n = 0; n < chart.lines.size(); ++n) {
    const std::string& name = chart.lines[n].name;
    out += fmt::format("<path d='M{} 262H{}' stroke='{}' stroke-width='2'{}/>", x, x + 16,
                       kColors[n % kColors.size()],
                       chart.lines[n].dashed ? " stroke-dasharray='5 3'" : "");
    out += text(x + 20, 266, "start", name);
    x += 34 + 6.2 * static_cast<double>(name.size());
  }
  return out;
}

}  // namespace

std::string line_chart(const LineChart& chart) {
  if (chart.lines.empty() || chart.lines.front().points.size() < 2) return "";
  const Scale scale(chart);
  const int height = chart.lines.size() > 1 ? 276 : 252;
  std::string out = fmt::format(
      "<svg viewBox='0 0 420 {0}' width='420' height='{0}' font-family='sans-serif' "
      "font-size='11' fill='#1f2937'>",
      height);
  out += text(8, 18, "start", chart.title, " font-weight='bold' font-size='13'");
  out += axes(chart, scale);
  for (std::size_t n = chart.lines.size(); n-- > 0;) {
    out += curve(chart.lines[n], scale, kColors[n % kColors.size()]);
  }
  return out + marks(chart, scale) + "</svg>\n";
}

std::string page_head(const std::string& title) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n"
      "<title>{}</title>\n<style>{}</style></head><body>\n",
      escaped(title), kStyle);
}

std::string page_end() { return "</body></html>\n"; }

std::string table_row(const std::vector<std::string>& cells, const char* tag,
                      const std::string& css_class) {
  std::string out =
      css_class.empty() ? std::string("<tr>") : fmt::format("<tr class='{}'>", css_class);
  for (const std::string& cell : cells) out += fmt::format("<{0}>{1}</{0}>", tag, cell);
  return out + "</tr>\n";
}

std::string bar(double share) {
  return fmt::format("<div class='bar' style='width:{:.0f}px'></div>", 200 * share);
}

}  // namespace halfspace
