// SPDX-License-Identifier: Apache-2.0
#include "lab_picture.hpp"

#include <algorithm>
#include <cmath>

namespace halfspace::lab {
namespace {

constexpr int kShown = 64;  // px a side
constexpr int kScale = 10;  // picture pixels per px
constexpr Rgb kPaper{250, 250, 248};
constexpr Rgb kCovered{205, 208, 212};
constexpr Rgb kOutline{44, 82, 130};

Rgb color_of(Wrong wrong, bool covered) {
  switch (wrong) {
    case Wrong::kGap: return {214, 44, 160};
    case Wrong::kExtra: return {240, 140, 20};
    case Wrong::kValue: return {210, 40, 40};
    case Wrong::kNo: break;
  }
  return covered ? kCovered : kPaper;
}

// The window's columns or rows to show, around the densest wrong part: least and how many.
struct Crop {
  int x = 0, y = 0, width = 0, height = 0;
};
Crop crop_of(const CasePixels& pixels, const oracle::Window& window) {
  Crop crop{0, 0, std::min(window.width, kShown), std::min(window.height, kShown)};
  // Wrong pixels of each block of half the shown size; the best four together are shown.
  const int half = kShown / 2;
  const int columns = window.width / half + 2;
  std::vector<std::uint32_t> count(static_cast<std::size_t>(columns) *
                                   static_cast<std::size_t>(window.height / half + 2));
  const auto at = [&](int x, int y) -> std::uint32_t& {
    return count[static_cast<std::size_t>(y * columns + x)];
  };
  for (std::size_t i = 0; i < pixels.wrong.size(); ++i) {
    if (pixels.wrong[i] == Wrong::kNo) continue;
    const int x = static_cast<int>(i) % window.width, y = static_cast<int>(i) / window.width;
    ++at(x / half, y / half);
  }
  std::uint32_t best = 0;
  crop.x = (window.width - crop.width) / 2;
  crop.y = (window.height - crop.height) / 2;
  for (int y = 0; y * half < window.height; ++y) {
    for (int x = 0; x * half < window.width; ++x) {
      const std::uint32_t sum = at(x, y) + at(x + 1, y) + at(x, y + 1) + at(x + 1, y + 1);
      if (sum <= best) continue;
      best = sum;
      crop.x = std::clamp(x * half, 0, window.width - crop.width);
      crop.y = std::clamp(y * half, 0, window.height - crop.height);
    }
  }
  return crop;
}

// Picture pixels whose centre is within half a picture pixel of the segment.
void outline(Image& image, const Crop& crop, const oracle::Window& window, methods::Position a,
             methods::Position b) {
  const auto to_picture = [&](methods::Position p) {
    return methods::Position{(p.x - window.x_first - crop.x) * kScale,
                             (p.y - window.y_first - crop.y) * kScale};
  };
  a = to_picture(a);
  b = to_picture(b);
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double length = std::max({std::abs(dx), std::abs(dy), 1.0});
  const bool flat = std::abs(dx) >= std::abs(dy);
  // Along the longer axis, only the part that may be seen.
  const double from = flat ? std::min(a.x, b.x) : std::min(a.y, b.y);
  const double to = flat ? std::max(a.x, b.x) : std::max(a.y, b.y);
  const int last = (flat ? image.width : image.height) - 1;
  for (int u = std::max(0, static_cast<int>(std::clamp(from, 0.0, 1e6)));
       u <= std::min(last, static_cast<int>(std::clamp(to, -1.0, 1e6))); ++u) {
    const double part = (u + 0.5 - (flat ? a.x : a.y)) / (flat ? dx : dy);
    if (length < 1.5 || !(part >= 0 && part <= 1)) continue;
    const double v = flat ? a.y + part * dy : a.x + part * dx;
    const int other = (flat ? image.height : image.width) - 1;
    if (!(v >= 0 && v <= other)) continue;
    image.at(flat ? u : static_cast<int>(v), flat ? static_cast<int>(v) : u) = kOutline;
  }
}

}  // namespace

Image case_picture(const methods::Method& method, const Suite& suite, const SuiteCase& one) {
  const CasePixels pixels = case_pixels(method, suite, one, -1);
  const Crop crop = crop_of(pixels, one.window);
  Image image{crop.width * kScale, crop.height * kScale, {}};
  image.pixel.assign(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height),
                     kPaper);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const auto i =
          static_cast<std::size_t>((y / kScale + crop.y) * one.window.width + x / kScale + crop.x);
      // A line between pixels, so that they can be counted.
      const bool gap = x % kScale == kScale - 1 || y % kScale == kScale - 1;
      if (!gap) image.at(x, y) = color_of(pixels.wrong[i], pixels.truth[i] != 0);
    }
  }
  if (method.input() == methods::InputKind::kLines) {
    for (const methods::Segment& s : one.drawing.segments) {
      outline(image, crop, one.window, s.from, s.to);
    }
  } else if (method.input() == methods::InputKind::kPolygons) {
    for (const methods::Polygon& polygon : one.drawing.polygons) {
      for (const auto& ring : polygon.rings) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
          outline(image, crop, one.window, ring[i], ring[(i + 1) % ring.size()]);
        }
      }
    }
  } else {
    for (const methods::Facet& f : one.drawing.facets) {
      for (std::size_t i = 0; i < 3; ++i) {
        outline(image, crop, one.window, f[i].position(), f[(i + 1) % 3].position());
      }
    }
  }
  return image;
}

}  // namespace halfspace::lab
