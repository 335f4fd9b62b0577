// SPDX-License-Identifier: Apache-2.0
#include "directed.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "samples.hpp"
#include "stimulus.hpp"

namespace halfspace {
namespace {

struct Step {
  std::int64_t x, y;
};

// Makes one unit for one frame.
class Director {
 public:
  Director(Random& random, const FrameState& frame, const Config& config)
      : random_(random),
        frame_(frame),
        config_(config),
        one_(std::int64_t{1} << config.subpixel_bits) {}

  std::vector<Triangle> make() {
    switch (random_.in(0, 11)) {
      case 0: return {pin()};
      case 1: return tied_pair();
      case 2: return {on_samples()};
      case 3: return {corners()};
      case 4: return {strip()};
      case 5: return {cut_corner()};
      case 6: return {phased()};
      case 7: return {degenerate()};
      case 8: return {upright()};
      case 9: return {crossing()};
      case 10: return {power_of_two()};
      default: {
        const auto shape = static_cast<std::size_t>(random_.in(0, kShapes.size() - 1));
        return {random_triangle(random_, kShapes[shape], frame_, config_)};
      }
    }
  }

 private:
  Point legal(std::int64_t x, std::int64_t y) const {
    const auto cut = [this](std::int64_t v) {
      return static_cast<std::int32_t>(
          std::clamp(v, config_.coordinate_min(), config_.coordinate_max()));
    };
    return {cut(x), cut(y)};
  }
  Triangle triangle(Point a, Point b, Point c) {
    if (random_.in(0, 1) == 1) std::swap(b, c);
    std::array<Point, 3> v{a, b, c};
    std::rotate(v.begin(), v.begin() + random_.in(0, 2), v.end());
    return {v, 0};
  }
  // A sample of a pixel of the frame, as near as the vertices' lattice allows.
  Step sample() {
    const auto all = sample_positions(config_.samples);
    const SamplePosition p =
        all[static_cast<std::size_t>(random_.in(0, static_cast<std::int64_t>(all.size()) - 1))];
    const std::int64_t x = random_.in(0, frame_.width - 1);
    const std::int64_t y = random_.in(0, frame_.height - 1);
    return {x * one_ + ((p.x * one_) >> 4), y * one_ + ((p.y * one_) >> 4)};
  }
  std::int64_t near(std::int64_t reach) { return random_.in(-reach, reach); }
  // Beside (x, y). Like every two draws of this file in statements of their own, y's first:
  // compilers differ in the order in which they evaluate a call's arguments.
  Point beside(std::int64_t x, std::int64_t y, std::int64_t reach, std::int64_t unit = 1) {
    const std::int64_t dy = near(reach) * unit, dx = near(reach) * unit;
    return legal(x + dx, y + dy);
  }

  // Around one sample, seldom around its neighbour too.
  Triangle pin() {
    const Step s = sample();
    const std::int64_t r = random_.in(1, std::max<std::int64_t>(1, one_ / random_.in(1, 4)));
    const auto part = [&] { return random_.in(0, r); };
    const std::int64_t bottom = s.y + part(), middle = s.x + near(r);
    const std::int64_t top_right = s.y - part(), right = s.x + part();
    const std::int64_t top_left = s.y - part(), left = s.x - part();
    return triangle(legal(left, top_left), legal(right, top_right), legal(middle, bottom));
  }

  // A direction of every kind: along an axis, a diagonal, or between.
  Step direction() {
    const std::int64_t a = random_.in(1, 6);
    const std::int64_t b = random_.in(a + 1, 9);
    const std::int64_t u = random_.in(0, 1) == 0 ? -1 : 1;
    const std::int64_t v = random_.in(0, 1) == 0 ? -1 : 1;
    switch (random_.in(0, 5)) {
      case 0: return {u, 0};
      case 1: return {0, v};
      case 2: return {u, v};
      case 3: return {u * b, v * a};
      default: return {u * a, v * b};
    }
  }

  // An edge through a sample, and a triangle on either side of it.
  std::vector<Triangle> tied_pair() {
    const Step s = sample();
    const Step d = direction();
    const std::int64_t unit = std::max<std::int64_t>(1, one_ / random_.in(1, 8));
    const std::int64_t there = random_.in(1, 4) * unit;
    const std::int64_t back = random_.in(1, 4) * unit;
    const Point a = legal(s.x + d.x * there, s.y + d.y * there);
    const Point b = legal(s.x - d.x * back, s.y - d.y * back);
    const std::int64_t reach = random_.in(1, 12) * one_;
    const Point c = beside(s.x, s.y, reach);
    // The mirror image of c in s lies on the other side.
    const Point e = legal(2 * s.x - c.x, 2 * s.y - c.y);
    return {triangle(a, b, c), triangle(a, b, e)};
  }

  Triangle on_samples() {
    const Step s = sample();
    const auto vertex = [&] { return beside(s.x, s.y, random_.in(1, 6), one_); };
    const Point b = vertex();
    return triangle(legal(s.x, s.y), b, vertex());
  }

  // Corners of the legal square, or places beside them or along its sides.
  Triangle corners() {
    const std::int64_t low = config_.coordinate_min();
    const std::int64_t high = config_.coordinate_max();
    const auto along = [&] {
      const std::int64_t kind = random_.in(0, 9);
      if (kind < 4) return low;
      if (kind < 8) return high;
      return kind == 8 ? random_.in(low, high) : near(20 * one_);
    };
    const auto vertex = [&] {
      const std::int64_t x = along();
      return legal(x, along());
    };
    const Point a = vertex();
    const Point b = vertex();
    return triangle(a, b, vertex());
  }

  // A strip one sample high or wide, over a tile's rows or columns.
  Triangle strip() {
    const Step s = sample();
    const std::int64_t grid = config_.grid() * one_;
    const std::int64_t begin = random_.in(0, 2 * grid), end = random_.in(grid / 2, 3 * grid);
    const std::int64_t half = random_.in(1, std::max<std::int64_t>(1, one_ / 2));
    const std::int64_t first = near(half), second = near(half);
    if (random_.in(0, 1) == 0) {
      return triangle(legal(s.x - begin, s.y - half), legal(s.x - begin, s.y + half),
                      legal(s.x + end, s.y + first));
    }
    return triangle(legal(s.x - half, s.y - begin), legal(s.x + half, s.y - begin + second),
                    legal(s.x + first, s.y + end));
  }

  // An edge that passes just inside a tile's corner, the rest far away.
  Triangle cut_corner() {
    const std::int64_t grid = config_.grid();
    const std::int64_t x = random_.in(0, (frame_.width - 1) / grid) * grid;
    const std::int64_t y = random_.in(0, (frame_.height - 1) / grid) * grid;
    const bool east = random_.in(0, 1) == 1;
    const bool south = random_.in(0, 1) == 1;
    const std::int64_t px = (x + (east ? grid - 1 : 0)) * one_ + one_ / 2;
    const std::int64_t py = (y + (south ? grid - 1 : 0)) * one_ + one_ / 2;
    const std::int64_t u = east ? -1 : 1, v = south ? -1 : 1;  // to the tile's middle
    const std::int64_t shift = random_.in(-one_ / 8, one_);
    const std::int64_t reach = random_.in(grid, 3 * grid) * one_;
    const std::int64_t down = random_.in(grid, 3 * grid) * one_;
    const std::int64_t across = random_.in(grid, 3 * grid) * one_;
    return triangle(legal(px + u * shift + u * reach, py - v * reach),
                    legal(px + u * shift - u * reach, py + v * reach),
                    legal(px + u * across, py + v * down));
  }

  // An edge along an axis, some tiles long.
  Triangle upright() {
    const Step s = sample();
    const std::int64_t x = (s.x & -one_) + random_.in(0, one_), y = (s.y & -one_) + near(one_);
    const std::int64_t reach = 3 * config_.grid() * one_;
    const std::int64_t length = random_.in(1, reach), away = near(reach), end = near(reach);
    if (random_.in(0, 1) == 0) {
      return triangle(legal(x, y), legal(x, y + length), legal(x + away, y + end));
    }
    return triangle(legal(x, y), legal(x + length, y), legal(x + end, y + away));
  }

  // Around a corner of four nodes of some level, of which it may miss one.
  Triangle crossing() {
    const auto level = static_cast<int>(random_.in(0, std::max(config_.levels() - 2, 0)));
    const int side = std::min(config_.node_log2(level + 1), config_.viewport_bits);
    const auto corner = [&](int size) { return random_.in(0, (size - 1) >> side) << side; };
    const std::int64_t x = corner(frame_.width) * one_, y = corner(frame_.height) * one_;
    const std::int64_t reach = random_.in(1, 2 * config_.grid()) * one_;
    const Point a = beside(x, y, reach);
    const Point b = beside(x, y, reach);
    return triangle(a, b, beside(x, y, reach));
  }

  // Around a sample, twice the area a power of two: a right angle, or sheared, which reaches more.
  Triangle power_of_two() {
    const Step s = sample();
    const std::int64_t low = config_.coordinate_min(), high = config_.coordinate_max();
    const std::int64_t along = random_.in(0, 3) == 0 ? 3 : 1, across = along / 2;
    const auto most = static_cast<std::uint64_t>(config_.extent_max() / along);
    const auto last = static_cast<std::int64_t>(std::bit_width(most)) - 1;
    const auto leg = [&] { return std::int64_t{1} << random_.in(0, last); };
    const std::int64_t a = leg(), b = leg(), part = random_.in(0, 3);
    const std::int64_t u = random_.in(0, 1) == 0 ? -1 : 1;
    const std::int64_t v = random_.in(0, 1) == 0 ? -1 : 1;
    const Step d{u * along * a, v * across * a}, e{u * across * b, v * along * b};
    const auto place = [&](std::int64_t at, std::int64_t first, std::int64_t second) {
      const auto [least, greatest] = std::minmax({std::int64_t{0}, first, second});
      return std::clamp(at - part * (first + second) / 8, low - least, high - greatest);
    };
    const std::int64_t x = place(s.x, d.x, e.x), y = place(s.y, d.y, e.y);
    return triangle(legal(x, y), legal(x + d.x, y + d.y), legal(x + e.x, y + e.y));
  }

  // A vertex with a phase next to 0, 1/2 or 1.
  Triangle phased() {
    const auto around = [&] {
      const std::int64_t phase = random_.in(0, 3) * (one_ / 2);
      return phase + near(1);
    };
    const Step s = sample();
    const std::int64_t x = (s.x & -one_) + around(), y = (s.y & -one_) + around();
    const std::int64_t reach = 3 * one_;
    const std::int64_t below = random_.in(0, reach), away = near(reach);
    const std::int64_t level = near(reach), right = random_.in(0, reach);
    return triangle(legal(x, y), legal(x + right, y + level), legal(x + away, y + below));
  }

  Triangle degenerate() {
    const Step s = sample();
    const Step d = direction();
    const auto along = [&](std::int64_t t) { return legal(s.x + d.x * t, s.y + d.y * t); };
    const std::int64_t unit = std::max<std::int64_t>(1, one_ / 2);
    const Point a = along(0);
    const Point b = along(unit);
    switch (random_.in(0, 3)) {
      case 0: return {{a, a, random_.in(0, 1) == 0 ? a : b}, 0};
      case 1: return triangle(a, a, b);
      case 2: return triangle(a, b, legal(a.x + 1, a.y + near(1)));  // as small as can be
      default: return triangle(a, b, along(2 * unit));
    }
  }

  Random& random_;
  FrameState frame_;
  Config config_;
  std::int64_t one_;
};

FrameState random_frame(Random& random, const Config& config) {
  const int most = config.max_size();
  const int node = std::min(config.grid() * config.grid(), most);  // of grid() x grid() tiles
  const std::array<std::pair<int, int>, 9> sizes{{{most, most},
                                                  {most, most},
                                                  {1, 1},
                                                  {node, node},
                                                  {std::min(13, most), std::min(10, most)},
                                                  {most, 1},
                                                  {1, most},
                                                  {most - 1, std::min(18, most)},
                                                  {std::min(21, most), most - 3}}};
  const auto [width, height] = sizes[static_cast<std::size_t>(random.in(0, 8))];
  // Few runs: only the whole frame is seen with faces culled.
  if (width != most || height != most || random.in(0, 9) != 0) return {width, height, Cull::kNone};
  return {width, height, random.in(0, 1) == 0 ? Cull::kBack : Cull::kFront};
}

}  // namespace

VectorUnit directed_unit(Random& random, const Config& config) {
  VectorUnit unit;
  bool small = false;
  while (!small) {
    unit.frame = random_frame(random, config);
    unit.triangles = Director(random, unit.frame, config).make();
    small = std::all_of(unit.triangles.begin(), unit.triangles.end(), [&](const Triangle& t) {
      return count_leaves(t, unit.frame, config, kUnitLeaves) <= kUnitLeaves;
    });
  }
  return unit;
}

}  // namespace halfspace
