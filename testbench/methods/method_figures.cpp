// SPDX-License-Identifier: Apache-2.0
//
// method_figures: the tables of docs/05_methods, measured anew, as Markdown on stdout.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>

#include "method_judge.hpp"
#include "vectors/reproducers.hpp"

namespace {

using namespace halfspace;
using methods::Method;

struct Suite {
  const char* name;
  std::vector<oracle::Corners> triangles;
  int first;
};

std::vector<Suite> suites() {
  return {{"mesh16", oracle::mesh16(), 0},
          {"mesh4", oracle::mesh4(), 0},
          {"mesh_h", oracle::mesh_h(), 0},
          {"fan", oracle::needle_fan(), 0},
          {"mesh16 + 4096 px", oracle::mesh16(4096), 4096},
          {"mesh16 + 15800 px", oracle::mesh16(15800), 15800}};
}

void print_hits() {
  const std::vector<Suite> all = suites();
  fmt::print("| method |");
  for (const Suite& s : all) fmt::print(" {} |", s.name);
  fmt::print("\n| --- |{}\n", " ---: | ---: | ---: | ---: | ---: | ---: |");
  for (const Method& m : methods::all()) {
    // The exact ones are all 0 (tests/methods_gallery_test.cpp): one of them stands for all.
    if (m.input() == methods::InputKind::kLines || m.row > 15) continue;
    if (m.exact && m.name != "edge_fixed_s8") continue;
    fmt::print("| {} |", m.name);
    for (const Suite& s : all) {
      const auto e = methods::hit_errors(m, s.triangles, {1024, 1024, s.first, s.first});
      fmt::print(" {:.0f} |", e.ppm());
    }
    fmt::print("\n");
    std::fflush(stdout);
  }
}

void print_subpixel_bits() {
  const auto triangles = oracle::random_triangles(12, 20'000, 16, 1008);
  fmt::print("\n| subpixel bits | ppm wrong, real-valued vertices |\n| ---: | ---: |\n");
  for (int bits = 0; bits <= 12; ++bits) {
    const Method* m = methods::find(fmt::format("halfspace_s{}", bits));
    fmt::print("| {} | {:.0f} |\n", bits, methods::hit_errors_alone(*m, triangles).ppm());
  }
}

void print_attributes() {
  const auto facets = methods::shaded_triangles(21, 40'000);
  fmt::print("\n| method | greatest error, levels | RMS |\n| --- | ---: | ---: |\n");
  for (const Method& m : methods::all()) {
    if (m.row != 15 && m.name != "halfspace_s8") continue;
    if (m.name.starts_with("shade_gradient")) continue;
    const auto e = methods::attribute_errors(m, facets, true);
    fmt::print("| {} | {:.2g} | {:.2g} |\n", m.name, e.greatest, e.rms());
  }
  for (const int bits : {8, 12, 16}) {
    const Method* m = methods::find(fmt::format("shade_gradient_f{}", bits));
    methods::Facet f{};
    f[1].x = 1024, f[2].y = 60;
    f[1].color[0] = 1024 * 20.5 * std::ldexp(1.0, -bits);
    const auto e = methods::attribute_errors(*m, std::span(&f, 1), false);
    fmt::print("| {}, 1024 steps | {:.2g} | {:.2g} |\n", m->name, e.greatest, e.rms());
  }
}

}  // namespace

int main() {
  print_hits();
  print_subpixel_bits();
  print_attributes();
  return 0;
}
