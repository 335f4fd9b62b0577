// SPDX-License-Identifier: Apache-2.0
#include "polygon_pieces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace halfspace {
namespace {

using Points = std::vector<Point>;
using Corners = std::array<Point, 3>;

std::int64_t turn(const Point& a, const Point& b, const Point& c) {
  return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) -
         (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
}

std::string text(const Points& ring) {
  std::ostringstream out;
  for (const Point& p : ring) out << '(' << p.x << ',' << p.y << ')';
  return out.str();
}

std::vector<Corners> corners(const Points& ring) {
  std::vector<Corners> out;
  const Pieces pieces = polygon_pieces(ring);
  for (const Piece& piece : pieces.all()) {
    out.push_back({ring[piece[0]], ring[piece[1]], ring[piece[2]]});
  }
  return out;
}

// How often the ring goes around p, which is on no edge.
int winding(const Points& ring, const Point& p) {
  int out = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& a = ring[i];
    const Point& b = ring[(i + 1) % ring.size()];
    if ((a.y <= p.y) == (b.y <= p.y)) continue;
    const std::int64_t side = turn(a, b, p);
    if (a.y <= p.y && side > 0) ++out;
    if (a.y > p.y && side < 0) --out;
  }
  return out;
}

// Points of a unit lattice that no edge of a ring with vertices in multiples of kUnit meets.
constexpr std::int32_t kUnit = 1024;
std::vector<Point> probes(std::int32_t size) {
  std::vector<Point> out;
  for (std::int32_t y = -1; y <= size; ++y) {
    for (std::int32_t x = -1; x <= size; ++x) {
      for (int n = 0; n < 3; ++n) {
        out.push_back({x * kUnit + 331 + 173 * n, y * kUnit + 489 - 211 * n});
      }
    }
  }
  return out;
}

bool on_an_edge(const Points& ring, const Point& p) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (turn(ring[i], ring[(i + 1) % ring.size()], p) == 0) return true;
  }
  return false;
}

bool meet(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto sign = [](std::int64_t v) { return (v > 0) - (v < 0); };
  const int abc = sign(turn(a, b, c)), abd = sign(turn(a, b, d));
  const int cda = sign(turn(c, d, a)), cdb = sign(turn(c, d, b));
  if (abc == 0 && abd == 0) {
    const auto overlap = [](std::int32_t p, std::int32_t q, std::int32_t r, std::int32_t s) {
      return std::max(std::min(p, q), std::min(r, s)) <= std::min(std::max(p, q), std::max(r, s));
    };
    return overlap(a.x, b.x, c.x, d.x) && overlap(a.y, b.y, c.y, d.y);
  }
  return abc * abd <= 0 && cda * cdb <= 0;
}

// Edges meet at their common ends and nowhere else.
bool is_simple(const Points& ring) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % n], &c = ring[(i + 2) % n];
    if (a == b) return false;
    const bool back = (std::int64_t{a.x} - b.x) * (std::int64_t{c.x} - b.x) +
                          (std::int64_t{a.y} - b.y) * (std::int64_t{c.y} - b.y) >
                      0;
    if (turn(a, b, c) == 0 && back) return false;
    for (std::size_t j = i + 2; j < n && (j + 1) % n != i; ++j) {
      if (meet(a, b, ring[j], ring[(j + 1) % n])) return false;
    }
  }
  return true;
}

struct Seen {
  int simple = 0, crossing = 0, dented = 0, left_out = 0, added = 0, covered = 0;
};

void check(const Points& ring, const std::vector<Point>& where, Seen& seen) {
  const std::vector<Corners> pieces = corners(ring);
  const bool simple = is_simple(ring);
  ++(simple ? seen.simple : seen.crossing);
  std::int64_t area = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) area += turn(ring[0], ring[i], ring[i + 1]);
  for (const Point& p : where) {
    if (on_an_edge(ring, p)) continue;
    int times = 0;
    for (const Corners& c : pieces) {
      const bool clockwise = turn(c[0], c[1], c[2]) > 0;
      bool in = true, on = false;
      for (std::size_t e = 0; e < 3; ++e) {
        in = in && (turn(c[e], c[(e + 1) % 3], p) > 0) == clockwise;
        on = on || turn(c[e], c[(e + 1) % 3], p) == 0;
      }
      if (on) times = -100;
      times += in;
    }
    if (times < 0) continue;
    ASSERT_LE(times, 1) << text(ring) << " at " << p.x << "," << p.y;
    const int around = winding(ring, p) * (area > 0 ? 1 : -1);
    seen.added += times == 1 && around <= 0;
    if (simple) {
      ASSERT_EQ(times, around != 0) << text(ring) << " at " << p.x << "," << p.y;
    }
    seen.left_out += times == 0 && around > 0;
    seen.covered += times;
  }
  for (const Corners& c : pieces) {
    ASSERT_NE(turn(c[0], c[1], c[2]), 0) << text(ring);
    ASSERT_EQ(turn(c[0], c[1], c[2]) > 0, area > 0) << text(ring);
  }
}

// Whichever vertex comes first, and backwards.
void check_orders(const Points& ring) {
  const std::vector<Corners> first = corners(ring);
  Points other = ring;
  for (const bool reversed : {false, true}) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      std::rotate(other.begin(), other.begin() + 1, other.end());
      std::vector<Corners> pieces = corners(other);
      for (Corners& c : pieces) {
        if (reversed) std::swap(c[1], c[2]);
      }
      ASSERT_EQ(pieces, first) << text(ring) << " as " << text(other);
    }
    std::reverse(other.begin(), other.end());
  }
}

TEST(PolygonPieces, NoPointTwiceAndSimplePolygonsWhole) {
  std::mt19937_64 random(20261130);
  const std::vector<Point> where = probes(6);
  Seen seen;
  for (int n = 0; n < 8000; ++n) {
    Points ring(3 + random() % 8);
    for (Point& p : ring) {
      p = {static_cast<std::int32_t>(random() % 7) * kUnit,
           static_cast<std::int32_t>(random() % 7) * kUnit};
    }
    check(ring, where, seen);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(seen.simple, 800);
  EXPECT_GT(seen.crossing, 4000);
}

// What clipping leaves: convex, then snapped so coarsely that it dents, folds or falls flat.
TEST(PolygonPieces, SnappedConvexPolygonsInEveryOrder) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  const std::vector<Point> where = probes(12);
  Seen seen;
  for (int n = 0; n < 4000; ++n) {
    const std::size_t count = 4 + random() % 7;
    const double tilt = 6.3 * unit(random), width = std::pow(unit(random), 3) * 6;
    const double x0 = 5.5 + unit(random), y0 = 5.5 + unit(random);
    std::vector<double> angle(count);
    for (double& a : angle) a = 6.28318 * unit(random);
    std::sort(angle.begin(), angle.end());
    Points ring;
    for (const double a : angle) {
      const double u = 5.4 * std::cos(a), v = width * std::sin(a);
      ring.push_back(
          {static_cast<std::int32_t>(std::lround(x0 + u * std::cos(tilt) - v * std::sin(tilt))) *
               kUnit,
           static_cast<std::int32_t>(std::lround(y0 + u * std::sin(tilt) + v * std::cos(tilt))) *
               kUnit});
    }
    check(ring, where, seen);
    check_orders(ring);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(seen.simple, 1000);
  EXPECT_GT(seen.crossing, 200);
  EXPECT_LT(seen.left_out, seen.covered / 100);
  EXPECT_LT(seen.added, seen.covered / 100);
}

// A fold at one end costs the rest nothing.
TEST(PolygonPieces, AFoldedEndLeavesTheRest) {
  const Points ring{{0, 0}, {0, 400}, {401, 200}, {400, 201}};  // the last two swapped
  EXPECT_EQ(corners(ring).size(), 1u);
}

// Edges cross; what is inside is taken before what reaches out, and what is outside is not.
TEST(PolygonPieces, PiecesThatFitInsideComeFirst) {
  const std::vector<Point> where = probes(6);
  for (Points ring : {Points{{1, 6}, {0, 4}, {4, 2}, {2, 4}, {1, 4}, {3, 2}},
                      Points{{5, 0}, {4, 1}, {0, 1}, {5, 6}, {3, 1}, {2, 0}}}) {
    for (Point& p : ring) p = {p.x * kUnit, p.y * kUnit};
    Seen seen;
    check(ring, where, seen);
    EXPECT_GT(seen.covered, 10) << text(ring);
    EXPECT_EQ(seen.added, 0) << text(ring);
  }
}

TEST(PolygonPieces, ConvexOnesAreAFan) {
  const Points square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  EXPECT_EQ(corners(square), (std::vector<Corners>{{Point{0, 0}, Point{4, 0}, Point{4, 4}},
                                                   {Point{0, 0}, Point{4, 4}, Point{0, 4}}}));
}

TEST(PolygonPieces, NothingOfAPolygonWithoutArea) {
  EXPECT_TRUE(corners({{0, 0}, {4, 4}, {2, 2}}).empty());
  EXPECT_TRUE(corners({{1, 1}, {1, 1}, {1, 1}, {1, 1}}).empty());
  EXPECT_TRUE(corners({{0, 0}, {4, 0}, {0, 4}, {4, 4}}).empty());  // two loops, opposite
}

TEST(PolygonPieces, TheWidestCoordinatesDoNotWrap) {
  constexpr std::int32_t k = 1 << 28;
  EXPECT_EQ(corners({{-k, -k}, {k, -k}, {k, k}, {-k, k}}).size(), 2u);
  EXPECT_EQ(corners({{-k, -k}, {k, -k}, {0, -k + 1}, {k, k}, {-k, k}}).size(), 3u);
}

}  // namespace
}  // namespace halfspace
