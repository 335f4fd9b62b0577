// SPDX-License-Identifier: Apache-2.0
//
// A checksum of everything the generators make, one line per generator and preset. Not a test by
// itself: generators_test.py compares the lines, whichever compiler made this program.
#include <array>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "vectors/directed.hpp"
#include "vectors/generators.hpp"
#include "vectors/stimulus.hpp"

namespace halfspace {
namespace {

constexpr std::uint64_t kSeed = 2026;
constexpr int kCount = 500;

// FNV-1a over values of 64 bits.
class Checksum {
 public:
  void add(std::int64_t value) {
    for (int byte = 0; byte < 8; ++byte) {
      sum_ = (sum_ ^ (static_cast<std::uint64_t>(value) >> (8 * byte) & 0xff)) * 0x100000001b3u;
    }
  }
  void add(const Triangle& triangle) {
    for (const Point& p : triangle.vertex) {
      add(std::int64_t{p.x});
      add(std::int64_t{p.y});
    }
    add(std::int64_t{triangle.tag});
  }
  void add(const std::vector<Triangle>& triangles) {
    for (const Triangle& triangle : triangles) add(triangle);
  }
  std::uint64_t sum() const { return sum_; }

 private:
  std::uint64_t sum_ = 0xcbf29ce484222325u;
};

void print(const Preset& preset, const char* what, const Checksum& checksum) {
  std::printf("%s, %s: %016llx\n", std::string(preset.name).c_str(), what,
              static_cast<unsigned long long>(checksum.sum()));
}

void print_shapes(const Preset& preset) {
  for (const Shape shape : kShapes) {
    Random random(kSeed);
    Checksum checksum;
    for (int i = 0; i < kCount; ++i) {
      checksum.add(random_triangle(random, shape, {400, 300, Cull::kNone}, preset.config));
    }
    print(preset, shape_name(shape), checksum);
  }
}

void print_units(const Preset& preset) {
  Random random(kSeed);
  Checksum checksum;
  for (int i = 0; i < kCount; ++i) {
    const VectorUnit unit = directed_unit(random, preset.config);
    checksum.add(std::int64_t{unit.frame.width});
    checksum.add(std::int64_t{unit.frame.height});
    checksum.add(unit.triangles);
  }
  print(preset, "directed units", checksum);
}

void print_attributes(const Preset& preset) {
  Random random(kSeed);
  Checksum checksum;
  for (int i = 0; i < kCount; ++i) {
    for (const VertexAttributes& vertex : random_attributes(random, preset.config)) {
      checksum.add(std::int64_t{vertex.depth});
      checksum.add(std::int64_t{vertex.inverse_w});
      for (const std::int32_t value : vertex.value) checksum.add(std::int64_t{value});
    }
  }
  print(preset, "attributes", checksum);
}

void print_sets(const Preset& preset) {
  const Config& config = preset.config;
  Checksum mesh, disc, widest;
  mesh.add(jittered_mesh(kSeed, 256, 16, 1, config));
  print(preset, "jittered mesh", mesh);
  disc.add(fan(100.3, 80.7, 60, 97, config));
  print(preset, "fan", disc);
  widest.add(widest_triangles(config));
  print(preset, "widest triangles", widest);
}

}  // namespace
}  // namespace halfspace

int main() {
  for (const halfspace::Preset& preset : halfspace::kPresets) {
    halfspace::print_shapes(preset);
    halfspace::print_units(preset);
    halfspace::print_attributes(preset);
    halfspace::print_sets(preset);
  }
  return 0;
}
