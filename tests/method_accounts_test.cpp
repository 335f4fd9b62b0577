// SPDX-License-Identifier: Apache-2.0
#include "lab/method_accounts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "lab/case_pixels.hpp"
#include "lab/suite_shapes.hpp"

namespace halfspace::lab {
namespace {

using methods::Canvas;
using methods::Drawing;
using methods::Method;

// Pixels (0, 0) to (7, 7): two triangles whose shared edge holds eight centres.
std::vector<Facet> quad() {
  return {facet_of({8, 0}, {8, 8}, {0, 8}), facet_of({8, 0}, {0, 8}, {0, 0})};
}

MethodPixel pixel_of(const Method& method, const Drawing& drawing, std::uint64_t triangles, int x,
                     int y, int size, bool all = true) {
  Canvas canvas(size, size);
  if (method.attributes) canvas.keep_attributes();
  return method_pixel(method, drawing, triangles, canvas, x, y, all);
}

MethodPixel quad_pixel(const Method& method, int x, int y) {
  return pixel_of(method, methods::drawing_of(quad(), 8, 8), 2, x, y, 8);
}

std::uint64_t count(const MethodPixel& pixel, MethodFate fate) {
  return pixel.counts[static_cast<std::size_t>(fate)];
}

// A method made for a test: what `hits` says of each triangle at each pixel.
Method invented(std::function<int(const Facet&, int, int)> hits) {
  Method m;
  m.name = "invented";
  m.draw = methods::DrawFacet([hits](const Facet& f, Canvas& canvas) {
    for (int y = 0; y < canvas.height(); ++y) {
      for (int x = 0; x < canvas.width(); ++x) {
        for (int n = hits(f, x, y); n > 0; --n) canvas.hit(x, y);
      }
    }
  });
  return m;
}

// The half of the quad that holds its lower right corner.
bool lower(const Facet& f) {
  return std::any_of(f.begin(), f.end(), [](const auto& v) { return v.x == 8 && v.y == 8; });
}

TEST(MethodAccounts, SharedEdgeSamplesAreGapsOrDoublesWithoutATieRuleAndOwnedOnceWithOne) {
  struct Claim {
    const char* method;
    MethodFate owner;  // of the triangle that owns the centre
    MethodFate other;
  };
  constexpr std::array<Claim, 8> kClaims{{
      {"edge_double_strict", MethodFate::kGap, MethodFate::kTieLost},
      {"fill_skip_ties", MethodFate::kGap, MethodFate::kTieLost},
      {"edge_float_inclusive", MethodFate::kCovers, MethodFate::kDouble},
      {"fill_draw_ties", MethodFate::kCovers, MethodFate::kDouble},
      {"hack_or_strict", MethodFate::kCovers, MethodFate::kDouble},
      {"edge_fixed_s8", MethodFate::kCovers, MethodFate::kTieLost},
      {"walk_exact", MethodFate::kCovers, MethodFate::kTieLost},
      {"halfspace_s8", MethodFate::kCovers, MethodFate::kTieLost},
  }};
  for (const Claim& claim : kClaims) {
    for (int x = 0; x < 8; ++x) {
      const MethodPixel pixel = quad_pixel(*methods::find(claim.method), x, 7 - x);
      ASSERT_EQ(pixel.accounts.size(), 2u);
      const std::size_t owning = pixel.accounts[0].owns != 0 ? 0 : 1;
      const MethodAccount& owner = pixel.accounts[owning];
      const MethodAccount& other = pixel.accounts[1 - owning];
      EXPECT_EQ(owner.fate, claim.owner) << claim.method << ": " << fate_name(owner.fate);
      EXPECT_EQ(other.fate, claim.other) << claim.method << ": " << fate_name(other.fate);
      EXPECT_EQ(pixel.owns, 1u);
      EXPECT_EQ(owner.pieces[0].verdict, Verdict::kTieWon);
      EXPECT_EQ(other.pieces[0].verdict, Verdict::kTieLost);
    }
  }
}

TEST(MethodAccounts, EachKindOfMistakeIsToldFromTheOthers) {
  const auto inside = [](const Facet& f, int x, int y) { return lower(f) == (x + y >= 7); };
  // Nothing drawn: a gap. A pixel given to the wrong one of two: missed there, a false hit here.
  const MethodPixel none = quad_pixel(invented([](auto&&...) { return 0; }), 1, 1);
  EXPECT_EQ(count(none, MethodFate::kGap), 1u);
  EXPECT_EQ(count(none, MethodFate::kOutside), 1u);
  const MethodPixel swapped = quad_pixel(
      invented([&](const Facet& f, int x, int y) { return inside(f, x, y) ? 0 : 1; }), 1, 1);
  EXPECT_EQ(count(swapped, MethodFate::kMissed), 1u);
  EXPECT_EQ(count(swapped, MethodFate::kFalseHit), 1u);
  const MethodPixel both = quad_pixel(invented([](auto&&...) { return 1; }), 1, 1);
  EXPECT_EQ(count(both, MethodFate::kDouble), 1u);
  EXPECT_EQ(count(both, MethodFate::kCovers), 1u);
  const MethodPixel twice = quad_pixel(
      invented([&](const Facet& f, int x, int y) { return inside(f, x, y) ? 2 : 0; }), 6, 6);
  EXPECT_EQ(count(twice, MethodFate::kDouble), 1u);
  EXPECT_EQ(count(twice, MethodFate::kOutside), 1u);
}

TEST(MethodAccounts, OverlappingTrianglesAreNotBesideEachOther) {
  // A far layer that covers everything hides no hole of the near one and makes no hit a double.
  const std::vector<Facet> layers{facet_of({0, 0}, {8, 0}, {0, 8}),
                                  facet_of({-20, -20}, {40, -20}, {-20, 40})};
  const Drawing drawing = methods::drawing_of(layers, 8, 8);
  const auto small = [](const Facet& f) { return f[0].x == 0; };
  const MethodPixel hole = pixel_of(
      invented([&](const Facet& f, int, int) { return small(f) ? 0 : 2; }), drawing, 2, 1, 1, 8);
  EXPECT_EQ(count(hole, MethodFate::kGap), 1u);
  const MethodPixel beyond = pixel_of(invented([](auto&&...) { return 1; }), drawing, 2, 6, 6, 8);
  EXPECT_EQ(count(beyond, MethodFate::kFalseHit), 1u);
  EXPECT_EQ(count(beyond, MethodFate::kCovers), 1u);
}

TEST(MethodAccounts, NearestTriangleShowsAndTheOthersAreBehind) {
  std::vector<Facet> layers;
  for (const double z : {0.5, 0.25, 0.75, 0.25}) {
    layers.push_back(facet_of({0, 0}, {8, 0}, {0, 8}));
    for (methods::Vertex& v : layers.back()) {
      v.z = z;
      v.color = {255 * z, 0, 0};
    }
  }
  const Drawing drawing = methods::drawing_of(layers, 8, 8);
  for (const char* name : {"bary_area_double", "halfspace_s8", "plane_double"}) {
    const MethodPixel pixel = pixel_of(*methods::find(name), drawing, 4, 2, 2, 8);
    EXPECT_EQ(pixel.winner, 1) << name;
    EXPECT_NEAR(pixel.depth, 0.25, 1e-6) << name;
    EXPECT_NEAR(pixel.color[0], 63.75, 0.6) << name;
    EXPECT_EQ(count(pixel, MethodFate::kBehind), 3u) << name;
    EXPECT_EQ(pixel.accounts[1].fate, MethodFate::kCovers) << name;
    EXPECT_TRUE(pixel.accounts[1].shows) << name;
  }
}

TEST(MethodAccounts, EveryMethodAgreesWithTheSuitesJudgeAtEveryPixel) {
  // Hits and owners of all triangles together are the canvas's and the judge's, pixel by pixel.
  const std::vector<Suite>& all = suites();
  const auto found =
      std::find_if(all.begin(), all.end(), [](const Suite& s) { return s.name == "shared_edges"; });
  ASSERT_NE(found, all.end());
  const SuiteCase one = found->make().front();
  std::map<methods::InputKind, int> kinds;
  for (const Method& method : methods::all()) {
    if ((one.kinds >> static_cast<int>(method.input()) & 1u) == 0) continue;
    const std::vector<std::uint32_t> truth =
        true_hits_snapped(one, method.input(), method.subpixel_bits);
    Random random(7);
    for (int n = 0; n < 3; ++n) {
      const int x = one.window.x_first + static_cast<int>(random.in(0, one.window.width - 1));
      const int y = one.window.y_first + static_cast<int>(random.in(0, one.window.height - 1));
      Canvas canvas(one.window.width, one.window.height, one.window.x_first, one.window.y_first);
      if (method.attributes) canvas.keep_attributes();
      const MethodPixel pixel =
          method_pixel(method, one.drawing, one.drawing.clip.size(), canvas, x, y, false);
      const std::size_t i = canvas.index(x, y);
      EXPECT_EQ(pixel.hits, canvas.hits()[i]) << method.name << " (" << x << ", " << y << ")";
      EXPECT_EQ(pixel.owns, truth[i]) << method.name << " (" << x << ", " << y << ")";
      std::uint64_t sum = 0;
      for (const std::uint64_t c : pixel.counts) sum += c;
      EXPECT_EQ(sum, one.drawing.clip.size()) << method.name;
      const bool mistaken = std::any_of(pixel.accounts.begin(), pixel.accounts.end(),
                                        [](const auto& a) { return is_mistake(a.fate); });
      if (pixel.hits != pixel.owns || method.exact) {
        EXPECT_EQ(mistaken, pixel.hits != pixel.owns) << method.name;
      }
    }
    ++kinds[method.input()];
  }
  EXPECT_GE(kinds.size(), 4u) << "a kind of input was not compared";
}

TEST(MethodAccounts, OwnEdgeValuesDecideTheHits) {
  // Small, flipped, far away, with and without ties: a hit is exactly three edges that pass.
  std::vector<Facet> facets = quad();
  facets.push_back(facet_of({1.5, 2.5}, {2.5, 13.5}, {14.5, 3.5}));
  facets.push_back(facet_of({16000.25, 16001}, {16013, 16002.125}, {16004.75, 16015}));
  for (const Facet& f : separate(5, 16, 2, 0)) facets.push_back(f);
  int methods_with_edges = 0;
  for (const Method& method : methods::all()) {
    if (!method.edges) continue;
    ++methods_with_edges;
    for (const Facet& f : facets) {
      const int first = f[0].x > 1000 ? 15999 : -1;
      Canvas canvas(40, 40, first, first);
      std::get<methods::DrawFacet>(method.draw)(f, canvas);
      for (int y = first; y < first + 40; ++y) {
        for (int x = first; x < first + 40; ++x) {
          const methods::OwnEdges own = method.edges(f, x, y);
          const bool passes =
              own && std::all_of(own->begin(), own->end(), [](const auto& e) { return e.passes; });
          // int32 wraps outside the box too, where the method does not look.
          if (method.name == "edge_fixed_s8_int32" && canvas.hits()[canvas.index(x, y)] == 0)
            continue;
          ASSERT_EQ(passes, canvas.hits()[canvas.index(x, y)] != 0)
              << method.name << " (" << x << ", " << y << ")";
        }
      }
    }
  }
  EXPECT_GE(methods_with_edges, 27);
}

TEST(MethodAccounts, OwnEdgesOfExactMethodsAreTheExactOnesInTheirOrder) {
  const std::vector<Facet> facets{facet_of({1.5, 2.5}, {2.5, 13.5}, {14.5, 3.5}),
                                  facet_of({1.5, 2.5}, {14.5, 3.5}, {2.5, 13.5})};
  const Drawing drawing = methods::drawing_of(facets, 16, 16);
  for (const char* name : {"edge_double_relative", "edge_fixed_s8", "edge_fixed_s12",
                           "edge_fixed_s8_int32", "fill_top_left", "hack_all"}) {
    const MethodPixel pixel = pixel_of(*methods::find(name), drawing, 2, 5, 5, 16);
    for (const MethodAccount& account : pixel.accounts) {
      const PieceDecision& piece = account.pieces[0];
      ASSERT_TRUE(piece.own.has_value()) << name;
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ((*piece.own)[i].raw, piece.edge[i].value) << name << ", edge " << i;
        const auto& biased = (*piece.own)[i].biased;
        if (!biased) continue;
        EXPECT_EQ(*biased < (*piece.own)[i].raw, piece.edge[i].kind == RuleEdge::kOther)
            << name << ", edge " << i;
      }
    }
  }
}

TEST(MethodAccounts, TruthIsSnappedWhereTheMethodSnaps) {
  // Before snapping the centre (0.5, 0.5) is inside by 1/1000 px, after it on the left of the edge.
  const std::vector<Facet> facets{facet_of({0.499, 0}, {4, 0}, {0.499, 4})};
  const Drawing drawing = methods::drawing_of(facets, 4, 4);
  const auto at = [&](const char* name) {
    return pixel_of(*methods::find(name), drawing, 1, 0, 0, 4).accounts[0];
  };
  EXPECT_EQ(at("halfspace_s12").fate, MethodFate::kCovers);
  EXPECT_EQ(at("edge_double_relative").fate, MethodFate::kCovers);
  const std::vector<Facet> moved{facet_of({0.501, 0}, {4, 0}, {0.501, 4})};
  const Drawing other = methods::drawing_of(moved, 4, 4);
  const MethodAccount snapped =
      pixel_of(*methods::find("edge_fixed_s8"), other, 1, 0, 0, 4).accounts[0];
  EXPECT_EQ(snapped.fate, MethodFate::kCovers) << "0.501 snaps to 128/256";
  EXPECT_EQ(snapped.pieces[0].verdict, Verdict::kTieWon);
  EXPECT_FALSE(snapped.pieces[0].owns_unsnapped);
  const MethodAccount real =
      pixel_of(*methods::find("edge_double_relative"), other, 1, 0, 0, 4).accounts[0];
  EXPECT_EQ(real.fate, MethodFate::kOutside);
}

TEST(MethodAccounts, TriangleThatIsCutAwayIsClipped) {
  const auto at = [](double x, double w) { return methods::ClipPoint{{x, -w, 0, w}, {}}; };
  const std::vector<methods::ClipFacet> clip{
      {at(-1, -1), at(1, -1), at(0, -2)},
      {methods::ClipPoint{{-1, -1, 0, 1}, {}}, methods::ClipPoint{{1, -1, 0, 1}, {}},
       methods::ClipPoint{{0, 1, 0, 1}, {}}}};
  const Drawing drawing = methods::drawing_of(clip, 8, 8);
  for (const char* name : {"edge_fixed_s8", "parity_exact", "line_exact", "clip_guard_band"}) {
    const MethodPixel pixel = pixel_of(*methods::find(name), drawing, 2, 4, 4, 8);
    ASSERT_EQ(pixel.accounts.size(), 2u) << name;
    EXPECT_EQ(pixel.accounts[0].fate, MethodFate::kClipped) << name;
    EXPECT_NE(pixel.accounts[1].fate, MethodFate::kClipped) << name;
    EXPECT_EQ(count(pixel, MethodFate::kClipped), 1u) << name;
  }
}

TEST(MethodAccounts, LinesAreAccountedBySegments) {
  const MethodPixel pixel = quad_pixel(*methods::find("line_exact"), 2, 5);
  ASSERT_EQ(pixel.accounts[0].segments.size(), 3u);
  EXPECT_EQ(pixel.hits, pixel.owns);
  EXPECT_EQ(count(pixel, MethodFate::kCovers), 2u);  // the shared edge is drawn for both
  Method gone = *methods::find("line_exact");
  gone.draw = methods::DrawSegment([](const methods::Segment&, Canvas&) {});
  EXPECT_EQ(count(quad_pixel(gone, 2, 5), MethodFate::kGap), 2u);
  gone.draw = methods::DrawSegment([](const methods::Segment&, Canvas& c) { c.hit(1, 1); });
  EXPECT_EQ(count(quad_pixel(gone, 1, 1), MethodFate::kFalseHit), 2u);
}

}  // namespace
}  // namespace halfspace::lab
