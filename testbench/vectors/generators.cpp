// SPDX-License-Identifier: Apache-2.0
#include "generators.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace halfspace {
namespace {

Point legal(std::int64_t x, std::int64_t y, const Config& config) {
  const auto cut = [&config](std::int64_t v) {
    return static_cast<std::int32_t>(
        std::clamp(v, config.coordinate_min(), config.coordinate_max()));
  };
  return {cut(x), cut(y)};
}

// The low tag_bits of a triangle's number.
std::uint32_t tag(std::size_t number, const Config& config) {
  return static_cast<std::uint32_t>(number & ((std::uint64_t{1} << config.tag_bits) - 1));
}

// The vertices cut to a square around the first that the configuration's edges may span, so that
// long ones attain its extent.
std::array<Point, 3> within(std::array<Point, 3> vertex, const Config& config) {
  if (config.extent_bits == 0) return vertex;
  const std::int64_t side = config.extent_max();
  const auto cut = [&](auto axis) {  // &Point::x or &Point::y
    const std::int64_t most = std::max(config.coordinate_max() - side, config.coordinate_min());
    const std::int64_t middle = (std::int64_t{vertex[1].*axis} + vertex[2].*axis) / 2;
    const std::int64_t first = vertex[0].*axis - (middle < vertex[0].*axis ? side : 0);
    const std::int64_t low = std::clamp(first, config.coordinate_min(), most);
    for (Point& p : vertex) {
      p.*axis = static_cast<std::int32_t>(std::clamp<std::int64_t>(p.*axis, low, low + side));
    }
  };
  cut(&Point::x);
  cut(&Point::y);
  return vertex;
}

Point anywhere(Random& random, const Config& config) {
  const std::int64_t low = config.coordinate_min();
  const std::int64_t high = config.coordinate_max();
  const std::int64_t x = random.in(low, high);
  return legal(x, random.in(low, high), config);
}

Point in_frame(Random& random, const FrameState& frame, const Config& config) {
  const std::int64_t x = random.in(0, std::int64_t{frame.width} << config.subpixel_bits);
  return legal(x, random.in(0, std::int64_t{frame.height} << config.subpixel_bits), config);
}

// p moved by at most `reach` subpixels in each direction.
Point near(Random& random, Point p, std::int64_t reach, const Config& config) {
  const std::int64_t dx = random.in(-reach, reach);
  return legal(p.x + dx, p.y + random.in(-reach, reach), config);
}

// The pixel centre at or above and left of p, or the pixel's corner without subpixels.
Point to_centre(Point p, const Config& config) {
  const int s = config.subpixel_bits;
  const std::int64_t half = s == 0 ? 0 : std::int64_t{1} << (s - 1);
  return legal(((std::int64_t{p.x} >> s) << s) + half, ((std::int64_t{p.y} >> s) << s) + half,
               config);
}

std::array<Point, 3> sliver(Random& random, const Config& config) {
  const Point a = anywhere(random, config);
  const Point b = anywhere(random, config);
  const std::int64_t part = random.in(0, 64);  // how far along from a to b, in 1/64
  const Point on = legal(a.x + ((std::int64_t{b.x} - a.x) * part) / 64,
                         a.y + ((std::int64_t{b.y} - a.y) * part) / 64, config);
  return {a, b, near(random, on, 3, config)};
}

// Two vertices on opposite sides of a pixel centre, in line with it, one then sometimes moved by a
// subpixel; the third anywhere near.
std::array<Point, 3> through_sample(Random& random, const FrameState& frame, const Config& config) {
  const Point centre = to_centre(in_frame(random, frame, config), config);
  const std::int64_t reach = std::int64_t{8} << config.subpixel_bits;
  const std::int64_t dx = random.in(-reach, reach);
  const std::int64_t dy = random.in(0, 3) == 0 ? 0 : random.in(-reach, reach);
  const std::int64_t there = random.in(1, 8);
  const std::int64_t back = random.in(1, 8);
  const Point a = legal(centre.x + dx * there, centre.y + dy * there, config);
  const Point b = legal(centre.x - dx * back, centre.y - dy * back, config);
  return {near(random, a, random.in(0, 1), config), b, near(random, centre, 4 * reach, config)};
}

std::array<Point, 3> no_area(Random& random, const FrameState& frame, const Config& config) {
  const Point a = in_frame(random, frame, config);
  const Point b = in_frame(random, frame, config);
  switch (random.in(0, 2)) {
    case 0: return {a, a, b};
    case 1: return {a, a, a};
    default:  // b is halfway from a to the third, or the third is cut and two are equal
      const Point c = legal(2 * std::int64_t{b.x} - a.x, 2 * std::int64_t{b.y} - a.y, config);
      const bool whole = c.x - b.x == b.x - a.x && c.y - b.y == b.y - a.y;
      return {a, b, whole ? c : b};
  }
}

std::array<Point, 3> vertices(Random& random, Shape shape, const FrameState& frame,
                              const Config& config) {
  const std::int64_t one = std::int64_t{1} << config.subpixel_bits;
  const Point a = in_frame(random, frame, config);
  const Point b = in_frame(random, frame, config);
  const Point c = in_frame(random, frame, config);
  const auto around = [&](std::int64_t reach) {
    const Point first = near(random, a, reach, config);
    return std::array<Point, 3>{a, first, near(random, a, reach, config)};
  };
  const auto wide = [&] { return anywhere(random, config); };
  switch (shape) {
    case Shape::kAnywhere: {
      const Point first = wide();
      const Point second = wide();
      return {first, second, wide()};
    }
    case Shape::kInFrame: return {a, b, c};
    case Shape::kSmall: return around(20 * one);
    case Shape::kTiny: return around(one);
    case Shape::kSliver: return sliver(random, config);
    // Every draw in a statement of its own: compilers differ in the order of a call's arguments.
    case Shape::kNearHorizontal: {
      const auto beside = [&] {
        const std::int64_t y = a.y + random.in(-3, 3);
        return legal(wide().x, y, config);
      };
      return {a, beside(), beside()};
    }
    case Shape::kNearVertical: {
      const auto below = [&] {
        const std::int64_t y = wide().y;
        return legal(a.x + random.in(-3, 3), y, config);
      };
      return {a, below(), below()};
    }
    case Shape::kOnSamples:
      return {to_centre(a, config), to_centre(b, config), to_centre(c, config)};
    case Shape::kThroughSample: return through_sample(random, frame, config);
    case Shape::kExtreme: {
      std::array<Point, 3> corner;
      for (Point& p : corner) {
        const std::int64_t x =
            random.in(0, 1) == 0 ? config.coordinate_min() : config.coordinate_max();
        const std::int64_t y =
            random.in(0, 1) == 0 ? config.coordinate_min() : config.coordinate_max();
        p = near(random, legal(x, y, config), random.in(0, 1) == 0 ? 1 : one, config);
      }
      return corner;
    }
    case Shape::kNoArea: return no_area(random, frame, config);
  }
  return {};
}

}  // namespace

std::int64_t Random::in(std::int64_t low, std::int64_t high) {
  const auto span = static_cast<std::uint64_t>(high - low) + 1;
  return low + static_cast<std::int64_t>(((next() >> 32) * span) >> 32);
}

const char* shape_name(Shape shape) {
  constexpr std::array<const char*, kShapes.size()> names{
      "anywhere",      "in frame",   "small",          "tiny",    "sliver", "near horizontal",
      "near vertical", "on samples", "through sample", "extreme", "no area"};
  return names[static_cast<std::size_t>(shape)];
}

Triangle random_triangle(Random& random, Shape shape, const FrameState& frame,
                         const Config& config) {
  Triangle triangle{within(vertices(random, shape, frame, config), config), 0};
  if (random.in(0, 1) == 1) std::swap(triangle.vertex[0], triangle.vertex[1]);
  return triangle;
}

Point snap_px(double x, double y, const Config& config) {
  const auto snap = [&config](double v) {
    return static_cast<std::int64_t>(std::nearbyint(std::ldexp(v, config.subpixel_bits)));
  };
  return legal(snap(x), snap(y), config);
}

std::vector<Triangle> jittered_mesh(std::uint64_t seed, int size, int cell, int step,
                                    const Config& config) {
  Random random(seed);
  const int cells = size / cell;
  const std::int64_t side = std::int64_t{cell} << config.subpixel_bits;
  // Strictly less than a quarter of a cell keeps every cell convex, so either diagonal splits it.
  const std::int64_t reach = side / (4 * step) - 1;
  const auto moved = [&](int index) {
    const std::int64_t jitter = random.in(-reach, reach) * step;
    return index * side + (index == 0 || index == cells ? 0 : jitter);
  };
  std::vector<Point> point;
  for (int row = 0; row <= cells; ++row) {
    for (int column = 0; column <= cells; ++column) {
      const std::int64_t x = moved(column);
      point.push_back(legal(x, moved(row), config));
    }
  }
  std::vector<Triangle> mesh;
  const auto add = [&](Point a, Point b, Point c) {
    if (random.in(0, 1) == 1) std::swap(a, b);
    mesh.push_back({{a, b, c}, tag(mesh.size(), config)});
  };
  const auto at = [&](int column, int row) {
    return point[static_cast<std::size_t>(row) * static_cast<std::size_t>(cells + 1) +
                 static_cast<std::size_t>(column)];
  };
  for (int row = 0; row < cells; ++row) {
    for (int column = 0; column < cells; ++column) {
      std::array<Point, 4> quad{at(column, row), at(column + 1, row), at(column + 1, row + 1),
                                at(column, row + 1)};
      if (random.in(0, 1) == 1) std::rotate(quad.begin(), quad.begin() + 1, quad.end());
      add(quad[0], quad[1], quad[2]);
      add(quad[0], quad[2], quad[3]);
    }
  }
  return mesh;
}

std::vector<Triangle> fan(double x, double y, double radius, int slivers, const Config& config) {
  const auto rim = [&](int i) {
    const double angle = 2 * std::numbers::pi * (i % slivers) / slivers;
    return snap_px(x + radius * std::cos(angle), y + radius * std::sin(angle), config);
  };
  std::vector<Triangle> triangles;
  for (int i = 0; i < slivers; ++i) {
    triangles.push_back(
        {{snap_px(x, y, config), rim(i), rim(i + 1)}, tag(triangles.size(), config)});
  }
  return triangles;
}

std::vector<Triangle> widest_triangles(const Config& config) {
  const std::int64_t low = config.coordinate_min();
  const std::int64_t high = config.coordinate_max();
  const std::int64_t frame = std::int64_t{config.max_size()} << config.subpixel_bits;
  std::vector<Point> point;
  for (const std::int64_t y : {low, high}) {
    for (const std::int64_t x : {low, high}) {
      point.push_back(legal(x, y, config));
      point.push_back(legal(x == low ? low + 1 : high - 1, y, config));
      point.push_back(legal(x, y == low ? low + 1 : high - 1, config));
    }
  }
  for (const std::int64_t x : {std::int64_t{0}, frame})
    point.push_back(legal(x, frame - x, config));
  std::vector<Triangle> triangles;
  for (const Point a : point) {
    for (const Point b : point) {
      for (const Point c : point) {
        if (a == b || b == c || c == a) continue;
        triangles.push_back({within({a, b, c}, config), tag(triangles.size(), config)});
      }
    }
  }
  return triangles;
}

}  // namespace halfspace
