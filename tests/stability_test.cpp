// SPDX-License-Identifier: Apache-2.0
#include "lab/stability.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <map>
#include <string_view>

#include "lab/suite_shapes.hpp"

namespace halfspace::lab {
namespace {

const methods::Method& method(std::string_view name) {
  for (const methods::Method& m : lab_methods()) {
    if (m.name == name) return m;
  }
  ADD_FAILURE() << name;
  return lab_methods().front();
}

const Suite& suite(std::string_view name) {
  for (const Suite& s : suites()) {
    if (s.name == name) return s;
  }
  ADD_FAILURE() << name;
  return suites().front();
}

TEST(Stability, ExactDesignHasNothingWrongInAnyExactSuite) {
  int cells = 0;
  for (const Suite& s : suites()) {
    if (!s.exact) continue;
    for (const char* name : {"halfspace_s8", "halfspace_s12", "line_exact", "parity_exact"}) {
      const auto cell = run_cell(method(name), s);
      if (!cell) continue;
      ++cells;
      EXPECT_EQ(cell->ppm(), 0.0) << name << " on " << s.name << ", " << cell->worst();
    }
  }
  EXPECT_GT(cells, 40);
}

TEST(Stability, AttributesOfTheDesignKeepTheDocumentedBound) {
  // 0.53 LSB + w ratio 2^-16 (docs/03_design/interpolation.md).
  const std::map<std::string, double> bound{
      {"w ratio 4", 0.54}, {"w ratio 100", 0.54}, {"w ratio 10000", 0.53 + 10000.0 / 65536}};
  const auto cell = run_cell(method("halfspace_s8"), suite("perspective"));
  ASSERT_TRUE(cell.has_value());
  ASSERT_EQ(cell->cases.size(), bound.size());
  for (const auto& [name, result] : cell->cases) {
    EXPECT_GT(result.covered, 1000u) << name;
    EXPECT_EQ(result.not_finite, 0u) << name;
    EXPECT_LE(result.greatest, bound.at(name)) << name;
    EXPECT_GT(result.greatest, 0.4) << name << ": nothing was compared";
  }
}

TEST(Stability, CoarseWidthsAreExactOnWhatTheySnappedTo) {
  for (const char* name : {"halfspace_s4", "edge_fixed_s4"}) {
    for (const char* where : {"fine_mesh", "least_area", "off_grid", "slivers"}) {
      const auto cell = run_cell(method(name), suite(where));
      ASSERT_TRUE(cell && cell->snapped_ppm) << name << " " << where;
      EXPECT_EQ(*cell->snapped_ppm, 0.0) << name << " " << where;
    }
  }
  EXPECT_GT(run_cell(method("halfspace_s4"), suite("off_grid"))->ppm(), 1000.0);
}

TEST(Stability, WeakMethodsFailWhereTheirSuiteSays) {
  const std::vector<std::pair<const char*, const char*>> known{
      {"edge_float_strict", "shared_edges"},
      {"walk_no_prestep", "fine_mesh"},
      {"walk_closed", "needle_fan"},
      {"edge_float_cross", "offsets"},
      {"edge_fixed_s8_int32", "large"},
      {"edge_fixed_s8_int32", "guard_band"},
      {"walk_fixed_f8", "long_runs"},
      {"line_dda_fixed_f8", "long_runs"},
      {"parity_closed", "scanline"},
      {"decompose_fan", "concave"},
      {"bary_area_float", "order"},
      {"shade_affine", "perspective"},
      {"clip_none", "w_to_zero"},
      {"table_n8", "fine_mesh"},
      {"edge_fixed_s8_int32", "slivers"},
      {"bary_ratio_unbounded_float", "zero_area"}};
  for (const auto& [name, where] : known) {
    const auto cell = run_cell(method(name), suite(where));
    ASSERT_TRUE(cell.has_value()) << name << " " << where;
    EXPECT_GT(cell->ppm(), 100.0) << name << " " << where;
  }
}

TEST(Stability, ClippedDesignIsRightWhereWReachesZero) {
  const auto clipped = run_cell(method("halfspace_clip"), suite("w_to_zero"));
  ASSERT_TRUE(clipped.has_value());
  for (const auto& [name, result] : clipped->cases) {
    EXPECT_GT(result.covered, 100u) << name;
    EXPECT_LT(result.ppm(), 1000.0) << name << ": more than the cut's rounding";
  }
}

// A quad through pixel centres: 8 x 8 of them, ties on every side.
TEST(Stability, ASuiteCountsGapsAndDoubles) {
  const Suite& s = suite("shared_edges");
  const SuiteCase one = s.make().front();
  const CaseResult strict = run_case(method("edge_double_strict"), s, one);
  EXPECT_EQ(strict.covered, 64u);
  EXPECT_EQ(strict.gaps, 22u);
  EXPECT_EQ(strict.doubles, 0u);
  const CaseResult inclusive = run_case(method("edge_double_inclusive"), s, one);
  EXPECT_EQ(inclusive.wrong, 25u);
  EXPECT_EQ(inclusive.doubles, 25u);
}

methods::Method misbehaving(methods::DrawFacet draw) {
  methods::Method m = method("edge_double_strict");
  m.name = "misbehaving";
  m.draw = std::move(draw);
  return m;
}

TEST(Stability, ACrashIsAResult) {
  const auto m = misbehaving([](const Facet&, methods::Canvas&) { raise(SIGSEGV); });
  const CaseResult r = run_case_guarded(m, suite("tiny"), suite("tiny").make().front(), 5);
  EXPECT_TRUE(r.crashed);
  EXPECT_FALSE(r.hung);
  EXPECT_EQ(r.ppm(), 1e6);
}

TEST(Stability, AHangIsAResult) {
  const auto m = misbehaving([](const Facet&, methods::Canvas&) {
    volatile bool on = true;
    while (on) {
    }
  });
  const CaseResult r = run_case_guarded(m, suite("tiny"), suite("tiny").make().front(), 1);
  EXPECT_TRUE(r.hung);
  EXPECT_FALSE(r.crashed);
  EXPECT_EQ(r.ppm(), 1e6);
}

TEST(Stability, RunningOutOfStepsIsAHang) {
  const auto m = misbehaving([](const Facet&, methods::Canvas& canvas) {
    while (canvas.spend(1u << 30)) {
    }
  });
  EXPECT_TRUE(run_case(m, suite("tiny"), suite("tiny").make().front()).hung);
}

TEST(Stability, NotFiniteColoursAreCounted) {
  const auto nan = [](const Facet&, methods::Canvas& canvas) {
    canvas.fragment(3, 3, 0.25, {NAN, 0, 0});
  };
  methods::Method m = misbehaving(nan);
  m.attributes = true;
  const Suite& s = suite("zero_area");
  EXPECT_EQ(run_case(m, s, s.make().front()).not_finite, 1u);
}

TEST(Stability, EverySuiteHasCasesThatCoverSomething) {
  for (const Suite& s : suites()) {
    const auto cases = s.make();
    ASSERT_FALSE(cases.empty()) << s.name;
    for (const SuiteCase& one : cases) {
      for (int kind = 0; kind < 5; ++kind) {
        if ((one.kinds >> kind & 1u) == 0) continue;
        std::uint64_t covered = 0;
        for (const auto hits : true_hits(one, static_cast<methods::InputKind>(kind))) {
          covered += hits;
        }
        EXPECT_GT(covered, 40u) << s.name << ", " << one.name << ", kind " << kind;
      }
    }
  }
}

}  // namespace
}  // namespace halfspace::lab
