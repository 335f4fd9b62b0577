// SPDX-License-Identifier: Apache-2.0
//
// Soak runs: what is drawn is legal, the first difference is found and shrunk, and says how to see
// it again.
#include "sweep/soak.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "config.hpp"

namespace halfspace {
namespace {

SoakSpecification specification_of(std::vector<SoakCheck> checks) {
  SoakSpecification out;
  out.configurations = 40;
  out.triangles = 300;
  out.shapes.assign(kShapes.begin(), kShapes.end());
  out.checks = std::move(checks);
  return out;
}

std::int64_t doubled_area(const Triangle& t) {
  const auto [a, b, c] = t.vertex;
  return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) -
         (std::int64_t{c.x} - a.x) * (std::int64_t{b.y} - a.y);
}

// As if a side were wrong for triangles that are right of x = 5 px and have an area.
std::string wrong_on_the_right(std::span<const ShadedTriangle> triangles, const SoakPoint& point) {
  for (const ShadedTriangle& shaded : triangles) {
    const auto& v = shaded.triangle.vertex;
    const bool right = std::all_of(
        v.begin(), v.end(), [&](const Point& p) { return p.x >= 5 << point.config.subpixel_bits; });
    if (right && doubled_area(shaded.triangle) != 0) return "wrong";
  }
  return {};
}

TEST(Soak, DrawsFromTheWholeLegalSpace) {
  const SoakSpecification specification = specification_of({});
  std::set<int> samples, subpixels;
  bool guard = false, no_guard = false, narrow = false;
  for (std::uint64_t k = 0; k < 2000; ++k) {
    const SoakPoint point = draw_point(specification, k);
    ASSERT_EQ(validate(point.config), "");
    ASSERT_LE(std::max(point.frame.width, point.frame.height), point.config.max_size());
    samples.insert(point.config.samples);
    subpixels.insert(point.config.subpixel_bits);
    (point.config.has_guard_band() ? guard : no_guard) = true;
    narrow = narrow || point.config.narrow_extent();
  }
  EXPECT_EQ(samples, (std::set<int>{1, 2, 4, 8, 16}));
  EXPECT_EQ(subpixels.size(), 13u);
  EXPECT_TRUE(guard && no_guard && narrow);
}

TEST(Soak, DrawsTheSamePointWhateverWasDrawnBefore) {
  const SoakSpecification specification = specification_of({});
  draw_point(specification, 3);
  const SoakPoint once = draw_point(specification, 17);
  draw_soak_triangle(specification, once, 5);
  const SoakPoint again = draw_point(specification, 17);
  EXPECT_EQ(once.config, again.config);
  EXPECT_EQ(draw_soak_triangle(specification, once, 9),
            draw_soak_triangle(specification, again, 9));
}

TEST(Soak, EveryCheckPassesOnTheModel) {
  std::vector<SoakCheck> checks = soak_checks();
  std::erase_if(checks, [](const SoakCheck& check) { return check.name == "rtl"; });
  ASSERT_EQ(checks.size(), 5u);
  const SoakOutcome done = run_soak(specification_of(std::move(checks)), {});
  EXPECT_FALSE(done.difference.has_value()) << done.difference->check << done.difference->text;
  EXPECT_EQ(done.points, 40u);
  EXPECT_EQ(done.triangles, 12000u);
}

TEST(Soak, StopsAtTheFirstDifferenceAndShrinksIt) {
  const SoakSpecification specification = specification_of({{"side", wrong_on_the_right}});
  const SoakOutcome done = run_soak(specification, {});
  ASSERT_TRUE(done.difference.has_value());
  EXPECT_EQ(done.difference->text, "wrong");
  ASSERT_EQ(done.difference->triangles.size(), 1u);
  // The least such triangle there is: at x = 5 px, one subpixel wide and high at the most.
  const SoakPoint point = draw_point(specification, done.difference->point);
  const int five = 5 << point.config.subpixel_bits;
  for (const Point p : done.difference->triangles[0].triangle.vertex) {
    EXPECT_GE(p.x, five);
    EXPECT_LE(p.x, five + 1) << triangles_text(done.difference->triangles);
    EXPECT_LE(std::abs(p.y), 1) << triangles_text(done.difference->triangles);
  }
  // What the replay line says is the same triangle, attributes and all.
  EXPECT_EQ(parse_triangles(specification, point, triangles_text(done.difference->triangles)),
            done.difference->triangles);
}

TEST(Soak, KeepsTheTrianglesThatADifferenceNeedsTogether) {
  const auto two = [](std::span<const ShadedTriangle> triangles, const SoakPoint&) {
    const auto even = std::count_if(triangles.begin(), triangles.end(), [](const auto& shaded) {
      return doubled_area(shaded.triangle) % 2 == 0;
    });
    const bool both = even != 0 && even != static_cast<std::ptrdiff_t>(triangles.size());
    return both ? std::string("two kinds") : std::string();
  };
  const SoakOutcome done = run_soak(specification_of({{"pair", two}}), {});
  ASSERT_TRUE(done.difference.has_value());
  EXPECT_EQ(done.difference->triangles.size(), 2u);
}

TEST(Soak, ShardsShareTheConfigurations) {
  std::uint64_t points = 0;
  for (std::uint64_t i = 0; i < 3; ++i) points += run_soak(specification_of({}), {i, 3}).points;
  EXPECT_EQ(points, 40u);
}

}  // namespace
}  // namespace halfspace
