// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "charts.hpp"
#include "fixed.hpp"
#include "vectors/generators.hpp"

namespace halfspace::lab {
namespace {

constexpr std::uint64_t kSeed = 830;
constexpr int kRandomTriangles = 4000;
constexpr int kSamplesEach = 64;

using Wide = __int128;

// What a register of `bits` bits holds.
Wide wrapped(Wide value, int bits) {
  const Wide modulus = Wide{1} << bits;
  Wide rest = value % modulus;
  if (rest < 0) rest += modulus;
  return rest >= modulus / 2 ? rest - modulus : rest;
}

// One edge, biased, its low bits dropped as setup drops them: S.s px^2 at pixel (0, 0)'s centre,
// and per pixel.
struct Edge {
  Wide a, b, c;
  Wide at(int x, int y) const { return a * x + b * y + c; }
};

std::array<Edge, 3> edges_of(const Triangle& t, int s) {
  const auto& v = t.vertex;
  const Wide area = (Wide{v[1].x} - v[0].x) * (Wide{v[2].y} - v[0].y) -
                    (Wide{v[2].x} - v[0].x) * (Wide{v[1].y} - v[0].y);
  std::array<Edge, 3> edges;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point from = v[area < 0 ? (i + 1) % 3 : i];
    const Point to = v[area < 0 ? i : (i + 1) % 3];
    const Wide a = Wide{from.y} - to.y;
    const Wide b = Wide{to.x} - from.x;
    const bool top_left = a > 0 || (a == 0 && b > 0);
    // Twice the value, so that the half pixel is whole for every s.
    const Wide one = Wide{1} << (s + 1);
    const Wide c = -2 * (a * from.x + b * from.y) + (a + b) * (one / 2) - (top_left ? 0 : 1);
    edges[i] = {a, b, floor_div(c, one)};
  }
  return edges;
}

// The samples that show a wrap: the frame's corners, where E is greatest, and random ones.
std::vector<std::pair<int, int>> sample_points(Random& random, int width, int height) {
  std::vector<std::pair<int, int>> points;
  for (const int x : {0, width - 1}) {
    for (const int y : {0, height - 1}) points.emplace_back(x, y);
  }
  while (points.size() < 4 + kSamplesEach) {
    const auto y = static_cast<int>(random.in(0, height - 1));
    const auto x = static_cast<int>(random.in(0, width - 1));
    points.emplace_back(x, y);
  }
  return points;
}

// Wrong verdicts per width, bits first..last.
struct Tally {
  int first;
  std::vector<std::uint64_t> wrong;
  std::uint64_t tested = 0;
  int needed = 0;  // bits that hold every value seen
};

void test(const Triangle& triangle, int s, const std::vector<std::pair<int, int>>& points,
          Tally& tally) {
  const auto edges = edges_of(triangle, s);
  for (const auto& [x, y] : points) {
    std::array<Wide, 3> e{};
    bool inside = true;
    for (std::size_t i = 0; i < 3; ++i) {
      e[i] = edges[i].at(x, y);
      inside = inside && e[i] >= 0;
      while (wrapped(e[i], tally.needed) != e[i]) ++tally.needed;
    }
    ++tally.tested;
    for (std::size_t n = 0; n < tally.wrong.size(); ++n) {
      bool found = true;
      for (const Wide value : e) {
        found = found && wrapped(value, tally.first + static_cast<int>(n)) >= 0;
      }
      tally.wrong[n] += found != inside ? 1u : 0u;
    }
  }
}

Json tally_json(const std::string& name, const Tally& tally, int formula) {
  Json rows = Json::array();
  for (std::size_t n = 0; n < tally.wrong.size(); ++n) {
    rows.push_back({{"bits", tally.first + static_cast<int>(n)},
                    {"wrong", tally.wrong[n]},
                    {"wrong_ppm", 1e6 * static_cast<double>(tally.wrong[n]) /
                                      static_cast<double>(tally.tested)}});
  }
  return {{"name", name},
          {"formula_bits", formula},
          {"needed_bits", tally.needed},
          {"tested", tally.tested},
          {"rows", rows}};
}

Json synthetic(int k) {
  Config config;
  config.viewport_bits = std::min(k, 15);
  config.guard_bits = k;
  const int size = config.max_size();
  Random random(kSeed);
  Tally tally{config.edge_bits() - 12, std::vector<std::uint64_t>(14), 0, 2};
  const auto points = sample_points(random, size, size);
  for (const Triangle& t : widest_triangles(config)) {
    test(t, config.subpixel_bits, points, tally);
  }
  for (int n = 0; n < kRandomTriangles; ++n) {
    const Triangle t = random_triangle(random, Shape::kAnywhere, {size, size, Cull::kNone}, config);
    test(t, config.subpixel_bits, sample_points(random, size, size), tally);
  }
  Json json = tally_json("k = " + std::to_string(k), tally, config.edge_bits());
  json["extent_px"] = 1 << k;
  return json;
}

}  // namespace

Json accumulator_chart(const RealScene* scene) {
  Json data;
  data["chart"] = "accumulator";
  data["subpixel_bits"] = Config().subpixel_bits;
  if (scene == nullptr) {
    for (const int k : {6, 8, 10, 12, 13, 15}) data["scenes"].push_back(synthetic(k));
    return data;
  }
  Config config;
  config.guard_bits = 14;
  Random random(kSeed);
  Tally tally{4, std::vector<std::uint64_t>(static_cast<std::size_t>(config.edge_bits() - 4)), 0,
              2};
  for (const Triangle& t : snapped(*scene, config)) {
    test(t, config.subpixel_bits, sample_points(random, scene->width, scene->height), tally);
  }
  data["scenes"].push_back(tally_json(scene->name, tally, config.edge_bits()));
  return data;
}

}  // namespace halfspace::lab
