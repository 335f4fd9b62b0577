// SPDX-License-Identifier: Apache-2.0
#include "method_accounts.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "fixed.hpp"
#include "methods/arithmetic.hpp"
#include "suites.hpp"

namespace halfspace::lab {
namespace {

using methods::Canvas;
using methods::Drawing;
using methods::Facet;
using methods::InputKind;
using methods::Method;
using oracle::Corners;
using oracle::Vec;

struct Pixel {
  int x = 0;
  int y = 0;
  Vec centre() const { return {x + 0.5, y + 0.5}; }
  oracle::Window window() const { return {1, 1, x, y}; }
};

bool finite(const Corners& t) {
  return std::all_of(t.begin(), t.end(),
                     [](Vec v) { return std::isfinite(v.x) && std::isfinite(v.y); });
}

Corners corners_of(const Facet& f, int bits) {
  const Facet g = bits < 0 ? f : methods::snapped(f, bits);
  return {{{g[0].x, g[0].y}, {g[1].x, g[1].y}, {g[2].x, g[2].y}}};
}

// Hits per primitive at the pixel, and who was stored last.
struct Drawn {
  std::vector<std::uint32_t> hits;
  std::int64_t winner = -1;  // primitive
};

Drawn draw_watched(const Method& method, const Drawing& drawing, Canvas& canvas, const Pixel& at) {
  Drawn out;
  out.hits.resize(methods::primitives(method, drawing));
  const std::size_t i = canvas.index(at.x, at.y);
  HS_CHECK(canvas.hits()[i] == 0);
  std::uint32_t before = 0;
  std::uint64_t depth_before = 0;
  methods::draw(method, drawing, canvas, [&](std::size_t primitive) {
    const std::uint32_t now = canvas.hits()[i];
    out.hits[primitive] = now - before;
    if (now == before) return;
    if (method.attributes && canvas.wants_attributes()) {
      // A depth that changes is a fragment that was stored; so is a first one, whatever its depth.
      const auto depth = std::bit_cast<std::uint64_t>(canvas.depth()[i]);
      if (before == 0 || depth != depth_before) {
        out.winner = static_cast<std::int64_t>(primitive);
      }
      depth_before = depth;
    }
    before = now;
  });
  return out;
}

RuleEdge kind_of(Vec a, Vec b, bool clockwise) {
  // Clockwise as seen: a top edge runs right, a left edge runs up.
  const double dx = clockwise ? b.x - a.x : a.x - b.x;
  const double dy = clockwise ? b.y - a.y : a.y - b.y;
  if (dy < 0) return RuleEdge::kLeft;
  return dy == 0 && dx > 0 ? RuleEdge::kTop : RuleEdge::kOther;
}

PieceDecision decide(const Facet& facet, const Method& method, const Pixel& at) {
  PieceDecision out;
  out.vertex = corners_of(facet, method.subpixel_bits);
  const Corners real = corners_of(facet, -1);
  if (method.edges) out.own = method.edges(facet, at.x, at.y);
  if (!finite(out.vertex)) return out;
  out.owns_unsnapped = oracle::covered(real, at.centre());
  const auto& [a, b, c] = out.vertex;
  const int turn = oracle::turn(a, b, c);
  if (turn == 0) return out;
  bool outside = false, tie = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec from = out.vertex[i], to = out.vertex[(i + 1) % 3];
    const double value = turn * oracle::cross(from, to, at.centre());
    out.edge[i] = {value + 0.0, kind_of(from, to, turn > 0)};
    outside = outside || value < 0;
    tie = tie || value == 0;
  }
  const bool owns = oracle::covered(out.vertex, at.centre());
  out.verdict = outside ? Verdict::kOutside
                : !tie  ? Verdict::kInside
                : owns  ? Verdict::kTieWon
                        : Verdict::kTieLost;
  return out;
}

// May the pixel lie in the facet or on its outline, whichever way it is snapped or drawn?
bool near_to(const Facet& f, const Pixel& at) {
  constexpr double kMargin = 2;  // px
  const auto [left, right] = std::minmax({f[0].x, f[1].x, f[2].x});
  const auto [top, bottom] = std::minmax({f[0].y, f[1].y, f[2].y});
  return at.x >= left - kMargin && at.x <= right + kMargin && at.y >= top - kMargin &&
         at.y <= bottom + kMargin;
}

// Have the interiors no point in common? Then an edge of one has all of the other on its far side.
// Both have an area.
bool beside(const Corners& a, const Corners& b) {
  const auto parted = [](const Corners& s, const Corners& t) {
    const int inside = oracle::turn(s[0], s[1], s[2]);
    for (std::size_t i = 0; i < 3; ++i) {
      const bool far = std::all_of(t.begin(), t.end(), [&](Vec v) {
        return oracle::turn(s[i], s[(i + 1) % 3], v) * inside <= 0;
      });
      if (far) return true;
    }
    return false;
  };
  return parted(a, b) || parted(b, a);
}

// All pieces with an area; false when one of the two has none.
bool beside(const MethodAccount& a, const MethodAccount& b) {
  bool any = false;
  for (const PieceDecision& p : a.pieces) {
    for (const PieceDecision& q : b.pieces) {
      if (p.verdict == Verdict::kNoArea || q.verdict == Verdict::kNoArea) continue;
      if (!beside(p.vertex, q.vertex)) return false;
      any = true;
    }
  }
  return any;
}

class Accountant {
 public:
  Accountant(const Method& method, const Drawing& drawing, const Pixel& at, bool all)
      : method_(method), drawing_(drawing), at_(at), all_(all) {}

  // Every triangle with its hits, pieces and what it owns; no fates.
  std::vector<MethodAccount> accounts(std::uint64_t triangles, const Drawn& drawn) {
    std::vector<MethodAccount> out(triangles);
    for (std::uint64_t t = 0; t < triangles; ++t) out[t].triangle = t;
    for (std::size_t i = 0; i < drawn.hits.size(); ++i) {
      out[methods::triangle_of(method_.input(), drawing_, i)].hits += drawn.hits[i];
    }
    for (std::size_t f = 0; f < drawing_.facets.size(); ++f) {
      MethodAccount& account = out[drawing_.origin[f]];
      ++account.facets;
      if (all_ || account.hits != 0 || near_to(drawing_.facets[f], at_)) add(f, drawn, account);
    }
    return out;
  }

 private:
  void add(std::size_t f, const Drawn& drawn, MethodAccount& account) const {
    const InputKind kind = method_.input();
    account.pieces.push_back(decide(drawing_.facets[f], method_, at_));
    if (kind == InputKind::kTriangles || kind == InputKind::kPolygons) {
      account.pieces.back().hits = drawn.hits[f];
    }
    if (kind != InputKind::kLines) {
      account.owns += truth([&](Drawing& d) { copy_piece(f, d); });
      return;
    }
    for (std::size_t s = 3 * f; s < 3 * f + 3; ++s) {
      const methods::Segment& segment = drawing_.segments[s];
      const std::uint32_t owns = truth([&](Drawing& d) { d.segments.push_back(segment); });
      account.segments.push_back({segment, drawn.hits[s], owns});
      account.owns += owns;
    }
  }

  void copy_piece(std::size_t f, Drawing& out) const {
    out.facets.push_back(drawing_.facets[f]);
    out.polygons.push_back(drawing_.polygons[f]);
  }

  // What the suites' judge finds at the pixel for one primitive.
  template <class Fill>
  std::uint32_t truth(Fill&& fill) const {
    SuiteCase one;
    one.window = at_.window();
    fill(one.drawing);
    for (const Facet& f : one.drawing.facets) {
      if (!finite(corners_of(f, -1))) return 0;
    }
    return true_hits_snapped(one, method_.input(), method_.subpixel_bits)[0];
  }

  const Method& method_;
  const Drawing& drawing_;
  Pixel at_;
  bool all_;
};

bool on_edge(const MethodAccount& account) {
  return std::any_of(account.pieces.begin(), account.pieces.end(),
                     [](const PieceDecision& p) { return p.verdict == Verdict::kTieLost; });
}

// The fate of one triangle among those that hit the pixel or own it.
MethodFate fate_of(const MethodAccount& a, const std::vector<const MethodAccount*>& near,
                   std::int64_t winner) {
  const bool lines = !a.segments.empty();
  const auto any_beside = [&](auto&& test) {
    return std::any_of(near.begin(), near.end(), [&](const MethodAccount* b) {
      return b->triangle != a.triangle && !lines && test(*b) && beside(a, *b);
    });
  };
  if (a.hits == 0 && a.owns == 0) {
    if (a.facets == 0) return MethodFate::kClipped;
    return on_edge(a) ? MethodFate::kTieLost : MethodFate::kOutside;
  }
  if (a.hits > a.owns) {
    const bool twice = a.owns != 0 || any_beside([](const MethodAccount& b) {
                         return b.owns != 0 && b.hits != 0;
                       });
    return twice ? MethodFate::kDouble : MethodFate::kFalseHit;
  }
  if (a.hits < a.owns) {
    const bool taken =
        a.hits != 0 || any_beside([](const MethodAccount& b) { return b.hits > b.owns; });
    return taken ? MethodFate::kMissed : MethodFate::kGap;
  }
  return winner < 0 || a.shows ? MethodFate::kCovers : MethodFate::kBehind;
}

}  // namespace

const char* fate_name(MethodFate fate) {
  constexpr std::array<const char*, kMethodFates> names{
      "clipped", "outside", "tie_lost", "false_hit", "double", "missed", "gap", "behind", "covers"};
  return names[static_cast<std::size_t>(fate)];
}

bool is_mistake(MethodFate fate) {
  return fate >= MethodFate::kFalseHit && fate <= MethodFate::kGap;
}

MethodPixel method_pixel(const Method& method, const Drawing& drawing, std::uint64_t triangles,
                         Canvas& canvas, int x, int y, bool keep_all) {
  HS_CHECK(canvas.contains(x, y));
  const Pixel at{x, y};
  const Drawn drawn = draw_watched(method, drawing, canvas, at);
  MethodPixel out;
  out.truth_bits = method.subpixel_bits;
  out.triangles = triangles;
  if (drawn.winner >= 0) {
    out.winner = static_cast<std::int64_t>(
        methods::triangle_of(method.input(), drawing, static_cast<std::size_t>(drawn.winner)));
    out.depth = canvas.depth()[canvas.index(x, y)];
    out.color = canvas.color()[canvas.index(x, y)];
  }
  std::vector<MethodAccount> accounts =
      Accountant(method, drawing, at, keep_all).accounts(triangles, drawn);
  std::vector<const MethodAccount*> near;
  for (MethodAccount& account : accounts) {
    account.shows = static_cast<std::int64_t>(account.triangle) == out.winner;
    if (account.hits != 0 || account.owns != 0) near.push_back(&account);
  }
  for (MethodAccount& account : accounts) {
    account.fate = fate_of(account, near, out.winner);
    ++out.counts[static_cast<std::size_t>(account.fate)];
    out.hits += account.hits;
    out.owns += account.owns;
  }
  if (!keep_all) {
    std::erase_if(accounts, [](const MethodAccount& a) { return a.fate < MethodFate::kTieLost; });
  }
  out.accounts = std::move(accounts);
  return out;
}

}  // namespace halfspace::lab
