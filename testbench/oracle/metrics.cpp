// SPDX-License-Identifier: Apache-2.0
#include "metrics.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace halfspace::oracle {
namespace {

// The first pixel of the row whose centre, moved right and down, lies right of the edge that runs
// down from `top` to `bottom`; first..first + width. A guess, then exact steps: being right of a
// line is monotone along a row.
int first_right(Vec top, Vec bottom, double centre, const Window& window) {
  const double share = (centre - top.y) / (bottom.y - top.y);
  const double crossing = top.x + share * (bottom.x - top.x);
  const int end = window.x_first + window.width;
  int x = static_cast<int>(std::clamp(std::ceil(crossing - 0.5), 1.0 * window.x_first, 1.0 * end));
  const auto right_of = [&](int pixel) { return side(top, bottom, {pixel + 0.5, centre}) < 0; };
  while (x < end && !right_of(x)) ++x;
  while (x > window.x_first && right_of(x - 1)) --x;
  return x;
}

class Crossings {
 public:
  explicit Crossings(const Window& window)
      : window_(window), at_(static_cast<std::size_t>(window.height)) {}

  void edge(Vec a, Vec b) {
    if (a.y == b.y) return;
    const Vec top = a.y < b.y ? a : b, bottom = a.y < b.y ? b : a;
    // Rows whose centre, moved down, lies between the two: top in, bottom out.
    const double limit = window_.y_first + window_.height;
    const auto row = [&](double y) {
      return static_cast<int>(std::clamp(std::ceil(y - 0.5), 1.0 * window_.y_first, limit));
    };
    int first = row(top.y);
    while (first > window_.y_first && first - 0.5 >= top.y) --first;
    for (int y = first; y < limit && y + 0.5 < bottom.y; ++y) {
      if (y + 0.5 < top.y) continue;
      auto& crossings = at_[static_cast<std::size_t>(y - window_.y_first)];
      crossings.push_back(first_right(top, bottom, y + 0.5, window_));
      touched_first_ = std::min(touched_first_, y);
      touched_last_ = std::max(touched_last_, y);
    }
  }

  // Adds the pixels between odd and even crossings, and forgets the polygon.
  void fill(std::vector<std::uint32_t>& hits) {
    for (int y = touched_first_; y <= touched_last_; ++y) {
      const auto row = static_cast<std::size_t>(y - window_.y_first);
      auto& crossings = at_[row];
      std::sort(crossings.begin(), crossings.end());
      for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
        for (int x = crossings[i]; x < crossings[i + 1]; ++x) {
          ++hits[row * static_cast<std::size_t>(window_.width) +
                 static_cast<std::size_t>(x - window_.x_first)];
        }
      }
      crossings.clear();
    }
    touched_first_ = std::numeric_limits<int>::max();
    touched_last_ = std::numeric_limits<int>::min();
  }

 private:
  Window window_;
  std::vector<std::vector<int>> at_;  // per row: where edges cross, as first pixels right of them
  int touched_first_ = std::numeric_limits<int>::max();
  int touched_last_ = std::numeric_limits<int>::min();
};

std::vector<std::uint32_t> empty(const Window& window) {
  return std::vector<std::uint32_t>(static_cast<std::size_t>(window.width) *
                                    static_cast<std::size_t>(window.height));
}

long double doubled_area(Vec a, Vec b, Vec c) {
  return (static_cast<long double>(b.x) - a.x) * (static_cast<long double>(c.y) - a.y) -
         (static_cast<long double>(c.x) - a.x) * (static_cast<long double>(b.y) - a.y);
}

}  // namespace

std::vector<std::uint32_t> exact_hits(std::span<const Corners> triangles, const Window& window) {
  std::vector<std::uint32_t> hits = empty(window);
  Crossings crossings(window);
  for (const Corners& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) crossings.edge(t[i], t[(i + 1) % 3]);
    crossings.fill(hits);
  }
  return hits;
}

std::vector<std::uint32_t> exact_hits(std::span<const Rings> polygons, const Window& window) {
  std::vector<std::uint32_t> hits = empty(window);
  Crossings crossings(window);
  for (const Rings& rings : polygons) {
    for (const std::vector<Vec>& ring : rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        crossings.edge(ring[i], ring[(i + 1) % ring.size()]);
      }
    }
    crossings.fill(hits);
  }
  return hits;
}

HitErrors& HitErrors::operator+=(const HitErrors& other) {
  covered += other.covered;
  wrong += other.wrong;
  gaps += other.gaps;
  doubles += other.doubles;
  return *this;
}

double HitErrors::ppm() const {
  if (covered == 0) return wrong == 0 ? 0 : std::numeric_limits<double>::infinity();
  return 1e6 * static_cast<double>(wrong) / static_cast<double>(covered);
}

HitErrors compare_hits(std::span<const std::uint32_t> hits, std::span<const std::uint32_t> exact) {
  HitErrors errors;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    errors.covered += exact[i] > 0 ? 1u : 0u;
    errors.gaps += hits[i] < exact[i] ? 1u : 0u;
    errors.doubles += hits[i] > exact[i] ? 1u : 0u;
  }
  errors.wrong = errors.gaps + errors.doubles;
  return errors;
}

long double attribute_at(const AttributeFacet& facet, Vec point, bool perspective) {
  long double above = 0, below = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const AttributeVertex& v = facet[i];
    const long double weight =
        doubled_area(point, facet[(i + 1) % 3].position, facet[(i + 2) % 3].position) /
        (perspective ? static_cast<long double>(v.w) : 1.0L);
    above += weight * v.value;
    below += weight;
  }
  return above / below;
}

void ErrorSummary::add(double error) {
  if (!std::isfinite(error)) {
    ++not_finite;
    return;
  }
  ++count;
  greatest = std::max(greatest, std::abs(error));
  sum_of_squares += error * error;
}

double ErrorSummary::rms() const {
  return count == 0 ? 0 : std::sqrt(sum_of_squares / static_cast<double>(count));
}

}  // namespace halfspace::oracle
