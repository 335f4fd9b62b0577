// SPDX-License-Identifier: Apache-2.0
//
// Edge values as methods of the gallery compute them.
#include "method_accounts_support.hpp"

namespace halfspace::lab {
namespace {

TEST(OwnEdges, OwnEdgeValuesDecideTheHits) {
  // Small, flipped, far away, with and without ties: a hit is exactly three edges that pass.
  std::vector<Facet> facets = quad();
  facets.push_back(facet_of({1.5, 2.5}, {2.5, 13.5}, {14.5, 3.5}));
  facets.push_back(facet_of({16000.25, 16001}, {16013, 16002.125}, {16004.75, 16015}));
  for (const Facet& f : separate(5, 16, 2, 0)) facets.push_back(f);
  facets.push_back(facet_of({1.5, 1.5}, {5.5, 1.5}, {9.5, 1.5}));  // no area, on centres
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

TEST(OwnEdges, OwnEdgesOfExactMethodsAreTheExactOnesInTheirOrder) {
  const std::vector<Facet> facets{facet_of({1.5, 2.5}, {2.5, 13.5}, {14.5, 3.5}),
                                  facet_of({1.5, 2.5}, {14.5, 3.5}, {2.5, 13.5}),
                                  facet_of({1.5, 2.5}, {14.5, 2.5}, {2.5, 13.5}),
                                  facet_of({1.5, 13.5}, {14.5, 13.5}, {2.5, 2.5})};
  const Drawing drawing = methods::drawing_of(facets, 16, 16);
  for (const char* name : {"edge_double_relative", "edge_fixed_s8", "edge_fixed_s12",
                           "edge_fixed_s8_int32", "fill_top_left", "hack_all"}) {
    const MethodPixel pixel = pixel_of(*methods::find(name), drawing, 4, 5, 5, 16);
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

}  // namespace
}  // namespace halfspace::lab
