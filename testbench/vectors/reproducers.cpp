// SPDX-License-Identifier: Apache-2.0
#include "reproducers.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

#include "generators.hpp"

namespace halfspace::oracle {
namespace {

// -1..1 in steps of 10^-6.
double unit(Random& random) { return static_cast<double>(random.in(-1'000'000, 1'000'000)) / 1e6; }

double on_grid(double v, double grid, double phase) {
  return std::nearbyint((v - phase) * grid) / grid + phase;
}

}  // namespace

std::vector<Corners> jittered_mesh(const MeshSpec& spec) {
  Random random(spec.seed);
  const int cells = spec.size / spec.cell;
  std::vector<Vec> point;
  const auto moved = [&](int index) {
    const double jitter = unit(random) * spec.amplitude * spec.cell;
    const double v =
        index * spec.cell + (spec.square && (index == 0 || index == cells) ? 0 : jitter);
    return on_grid(v, spec.grid, spec.phase) + spec.offset;
  };
  for (int row = 0; row <= cells; ++row) {
    for (int column = 0; column <= cells; ++column) {
      const double x = moved(column);
      point.push_back({x, moved(row)});
    }
  }
  const auto at = [&](int column, int row) {
    return point[static_cast<std::size_t>(row * (cells + 1) + column)];
  };
  std::vector<Corners> mesh;
  for (int y = 0; y < cells; ++y) {
    for (int x = 0; x < cells; ++x) {
      const Vec a = at(x, y), b = at(x + 1, y), c = at(x + 1, y + 1), d = at(x, y + 1);
      const bool falling = random.in(0, 1) == 1;
      mesh.push_back(falling ? Corners{a, b, c} : Corners{b, c, d});
      mesh.push_back(falling ? Corners{a, c, d} : Corners{a, b, d});
    }
  }
  return mesh;
}

std::vector<Corners> mesh16(double offset) { return jittered_mesh({.offset = offset}); }
std::vector<Corners> mesh4(double offset) { return jittered_mesh({.cell = 4, .offset = offset}); }
std::vector<Corners> mesh_h() { return jittered_mesh({.grid = 1, .phase = 0.5, .square = false}); }

std::vector<Corners> needle_fan(int slivers, double radius) {
  const Vec centre{512.5, 512.5};
  const auto rim = [&](int i) {
    const double angle = 2 * std::numbers::pi * (i % slivers) / slivers;
    return Vec{on_grid(centre.x + radius * std::cos(angle), 256, 0),
               on_grid(centre.y + radius * std::sin(angle), 256, 0)};
  };
  std::vector<Corners> fan;
  for (int i = 0; i < slivers; ++i) fan.push_back({centre, rim(i), rim(i + 1)});
  return fan;
}

std::vector<Corners> random_triangles(std::uint64_t seed, int count, double size, double frame) {
  Random random(seed);
  std::vector<Corners> triangles;
  for (int i = 0; i < count; ++i) {
    const double reach = (frame - size) / 2;
    const Vec centre{frame / 2 + reach * unit(random), frame / 2 + reach * unit(random)};
    Corners t;
    for (Vec& v : t) {
      // Two draws each: 40 bits of fraction, so that no vertex lies on a grid by accident.
      const auto part = [&] {
        const double coarse = unit(random), fine = unit(random);
        return (coarse + fine * 1e-6) * size / 2;
      };
      v.x = centre.x + part();
      v.y = centre.y + part();
    }
    triangles.push_back(t);
  }
  return triangles;
}

std::vector<Corners> quad_on_samples() {
  return {{{{1.5, 1.5}, {9.5, 1.5}, {9.5, 9.5}}}, {{{1.5, 1.5}, {9.5, 9.5}, {1.5, 9.5}}}};
}

Corners thin_sliver() { return {{{1.5, 5.25}, {60.5, 5.5}, {60.5, 5.75}}}; }

Corners collinear() { return {{{10.5, 10.5}, {50.5, 50.5}, {90.5, 90.5}}}; }

std::vector<Vec> diamond() { return {{4.5, 0.5}, {8.5, 4.5}, {4.5, 8.5}, {0.5, 4.5}}; }

}  // namespace halfspace::oracle
