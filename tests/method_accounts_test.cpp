// SPDX-License-Identifier: Apache-2.0
#include <map>

#include "method_accounts_support.hpp"

namespace halfspace::lab {
namespace {

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
      EXPECT_EQ(owner.pieces[0].hits, owner.hits);
      const MethodPixel near = quad_pixel(*methods::find(claim.method), x, 7 - x, false);
      EXPECT_EQ(near.counts, pixel.counts) << claim.method;
      EXPECT_EQ(near.accounts.size(), 2u) << claim.method << ": the tie that was lost is kept";
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

TEST(MethodAccounts, HitsBesideEachOtherWithoutAnOwnerAreBothFalse) {
  const MethodPixel pixel = pixel_of(invented([](auto&&...) { return 1; }),
                                     methods::drawing_of(quad(), 16, 16), 2, 12, 12, 16);
  EXPECT_EQ(count(pixel, MethodFate::kFalseHit), 2u);
}

TEST(MethodAccounts, TrianglesAreBesideEachOtherWhoseverEdgePartsThem) {
  // Only the second one's edge at x = 9 has all of the other on its far side.
  const std::vector<Facet> two{facet_of({10, 5}, {14, 0}, {14, 10}),
                               facet_of({9, -50}, {9, 50}, {-50, 0})};
  const Drawing drawing = methods::drawing_of(two, 16, 16);
  const Method both = invented([](auto&&...) { return 1; });
  for (const int x : {5, 12}) {
    const MethodPixel pixel = pixel_of(both, drawing, 2, x, 4, 16);
    EXPECT_EQ(count(pixel, MethodFate::kDouble), 1u) << x;
    EXPECT_EQ(count(pixel, MethodFate::kCovers), 1u) << x;
  }
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

TEST(MethodAccounts, FirstFragmentShowsWhateverItsDepth) {
  std::vector<Facet> nearest{facet_of({0, 0}, {8, 0}, {0, 8})};
  for (methods::Vertex& v : nearest[0]) v.z = 0;
  const MethodPixel pixel =
      pixel_of(*methods::find("bary_area_double"), methods::drawing_of(nearest, 8, 8), 1, 2, 2, 8);
  EXPECT_EQ(pixel.winner, 0);
  EXPECT_EQ(pixel.depth, 0.0);
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

methods::ClipPoint clip_point(double x, double y, double z) { return {{x, y, z, 1}, {}}; }

TEST(MethodAccounts, TriangleThatIsCutAwayIsClipped) {
  const std::vector<methods::ClipFacet> clip{
      {clip_point(-1, -1, 2), clip_point(1, -1, 2), clip_point(0, 1, 2)},  // beyond far
      {clip_point(-1, -1, 0), clip_point(1, -1, 0), clip_point(0, 1, 0)}};
  const Drawing drawing = methods::drawing_of(clip, 8, 8);
  for (const char* name : {"edge_fixed_s8", "parity_exact", "line_exact", "clip_guard_band"}) {
    const MethodPixel pixel = pixel_of(*methods::find(name), drawing, 2, 4, 4, 8);
    ASSERT_EQ(pixel.accounts.size(), 2u) << name;
    EXPECT_EQ(pixel.accounts[0].fate, MethodFate::kClipped) << name;
    EXPECT_NE(pixel.accounts[1].fate, MethodFate::kClipped) << name;
    EXPECT_EQ(count(pixel, MethodFate::kClipped), 1u) << name;
  }
  // A method that draws it all the same: nothing of it is beside the other.
  Method all = *methods::find("clip_none");
  all.attributes = false;
  all.draw = methods::DrawClip([](const auto&, const auto&, Canvas& canvas) { canvas.hit(4, 4); });
  const MethodPixel pixel = pixel_of(all, drawing, 2, 4, 4, 8);
  EXPECT_EQ(pixel.accounts[0].fate, MethodFate::kFalseHit);
  EXPECT_EQ(pixel.accounts[1].fate, MethodFate::kCovers);
}

TEST(MethodAccounts, PiecesOfATriangleOwnWhatItOwns) {
  // Far cuts it into two pieces.
  const std::vector<methods::ClipFacet> clip{
      {clip_point(-1, -1, -0.5), clip_point(1, -1, -0.5), clip_point(0, 1, 2)}};
  const Drawing drawing = methods::drawing_of(clip, 8, 8);
  ASSERT_EQ(drawing.facets.size(), 2u);
  std::uint32_t owned = 0;
  for (int i = 0; i < 64; ++i) {
    const MethodPixel pixel =
        pixel_of(*methods::find("edge_fixed_s8"), drawing, 1, i % 8, i / 8, 8);
    const MethodAccount& account = pixel.accounts[0];
    EXPECT_FALSE(is_mistake(account.fate)) << i % 8 << ", " << i / 8;
    EXPECT_EQ(account.pieces.size(), 2u);
    owned += account.owns;
  }
  EXPECT_GT(owned, 10u);
}

TEST(MethodAccounts, LinesAreAccountedBySegments) {
  const MethodPixel pixel = quad_pixel(*methods::find("line_exact"), 2, 5);
  ASSERT_EQ(pixel.accounts[0].segments.size(), 3u);
  EXPECT_EQ(pixel.hits, pixel.owns);
  EXPECT_EQ(count(pixel, MethodFate::kCovers), 2u);  // the shared edge is drawn for both
  for (const MethodAccount& account : pixel.accounts) {
    std::uint32_t hits = 0;
    for (const SegmentDecision& segment : account.segments) {
      EXPECT_EQ(segment.hits, segment.owns);
      hits += segment.hits;
    }
    EXPECT_EQ(hits, account.hits);
  }
  Method gone = *methods::find("line_exact");
  gone.draw = methods::DrawSegment([](const methods::Segment&, Canvas&) {});
  EXPECT_EQ(count(quad_pixel(gone, 2, 5), MethodFate::kGap), 2u);
  gone.draw = methods::DrawSegment([](const methods::Segment&, Canvas& c) { c.hit(1, 1); });
  EXPECT_EQ(count(quad_pixel(gone, 1, 1), MethodFate::kFalseHit), 2u);
}

TEST(MethodAccounts, TriangleWithOneOfItsTwoLinesDrawnIsMissed) {
  const Drawing drawing =
      methods::drawing_of(std::vector{facet_of({0.5, 0.5}, {7.5, 0.5}, {0.5, 0.75})}, 8, 8);
  Method first = *methods::find("line_exact");
  first.draw = methods::DrawSegment([](const methods::Segment& s, Canvas& canvas) {
    if (s.from.y == s.to.y) canvas.hit(3, 0);
  });
  const MethodPixel pixel = pixel_of(first, drawing, 1, 3, 0, 8);
  EXPECT_EQ(pixel.owns, 2u);
  EXPECT_EQ(pixel.hits, 1u);
  EXPECT_EQ(pixel.accounts[0].fate, MethodFate::kMissed);
}

TEST(MethodAccounts, LinesHaveNoTrianglesBesideThem) {
  const std::vector<Facet> two{facet_of({0.5, 0.5}, {6.5, 0.5}, {0.5, 6.5}),
                               facet_of({7.5, 1.5}, {7.5, 7.5}, {1.5, 7.5})};
  const Method& exact = *methods::find("line_exact");
  Method extra = exact;
  extra.draw = methods::DrawSegment([&exact](const methods::Segment& s, Canvas& canvas) {
    std::get<methods::DrawSegment>(exact.draw)(s, canvas);
    if (s.from.y == s.to.y && s.from.y < 1) canvas.hit(7, 4);
  });
  const MethodPixel pixel = pixel_of(extra, methods::drawing_of(two, 8, 8), 2, 7, 4, 8);
  EXPECT_EQ(pixel.accounts[0].fate, MethodFate::kFalseHit);
  EXPECT_EQ(pixel.accounts[1].fate, MethodFate::kCovers);
}

}  // namespace
}  // namespace halfspace::lab
