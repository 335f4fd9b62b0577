// SPDX-License-Identifier: Apache-2.0
#include "soak.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "io/error.hpp"
#include "scene/progress.hpp"
#include "specification.hpp"
#include "vectors/stimulus.hpp"

namespace halfspace {
namespace {

// Compared together: engines batch triangles, the cycle model and the RTL overlap them.
constexpr std::uint64_t kTogether = 500;

std::string spelled(Shape shape) {
  std::string name = shape_name(shape);
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

// A stream of its own for each number, whatever the others draw.
Random stream(std::uint64_t seed, std::uint64_t number) {
  return Random(splitmix_mixed(seed + (number + 1) * kSplitmixStep));
}

int pick(Random& random, int low, int high) { return static_cast<int>(random.in(low, high)); }

Config draw_config(Random& random) {
  Config c;
  c.subpixel_bits = pick(random, 0, 12);
  c.viewport_bits = pick(random, 3, 15);
  c.guard_bits = pick(random, c.viewport_bits - 1, 16);
  if (c.guard_bits < c.viewport_bits) c.guard_bits = 0;
  c.extent_bits = pick(random, 0, (c.has_guard_band() ? c.guard_bits : c.viewport_bits) + 1);
  c.samples = 1 << pick(random, 0, 4);
  c.grid_log2 = pick(random, 2, 3);
  c.setup_interval = pick(random, 0, 1) == 0 ? 1 : 3;
  c.tag_bits = pick(random, 1, 32);
  c.depth_bits = pick(random, 16, 32);
  c.attributes = pick(random, 0, 8);
  c.inverse_w_bits = pick(random, 12, 30);
  c.gradient_bits = pick(random, 0, 20);
  c.reciprocal_bits = pick(random, 6, 16);
  c.snap = static_cast<SnapMode>(pick(random, 0, 2));
  return c;
}

std::vector<Shape> read_shapes(const SpecificationFile& file) {
  std::vector<Shape> out;
  for (const std::string& name : file.strings("shapes", {})) {
    const auto found = std::find_if(kShapes.begin(), kShapes.end(),
                                    [&](Shape shape) { return spelled(shape) == name; });
    if (found == kShapes.end()) file.refuse("shapes", name, "is no shape");
    out.push_back(*found);
  }
  if (out.empty()) out.assign(kShapes.begin(), kShapes.end());
  return out;
}

std::vector<SoakCheck> read_checks(const SpecificationFile& file) {
  std::vector<std::string> names;
  for (const SoakCheck& check : soak_checks()) {
    if (check.name != "rtl") names.push_back(check.name);  // builds minutes for each configuration
  }
  std::vector<SoakCheck> out;
  for (const std::string& name : file.strings("checks", names)) {
    const auto found = std::find_if(soak_checks().begin(), soak_checks().end(),
                                    [&](const SoakCheck& check) { return check.name == name; });
    if (found == soak_checks().end()) file.refuse("checks", name, "is no check");
    out.push_back(*found);
  }
  return out;
}

SoakDifference minimised(const SoakCheck& check, const SoakPoint& point,
                         std::vector<ShadedTriangle> triangles) {
  const auto fails = [&](std::span<const ShadedTriangle> some) {
    return !check.difference(some, point).empty();
  };
  SoakDifference out{check.name, point.number, {}, {}};
  out.triangles = shrink(std::move(triangles), point.config, fails);
  out.text = check.difference(out.triangles, point);
  return out;
}

}  // namespace

SoakSpecification read_soak(const std::string& path) {
  const SpecificationFile file(path);
  file.require_known({"seed", "configurations", "triangles", "size", "stall", "shapes", "checks"});
  SoakSpecification out;
  out.path = path;
  out.seed = file.whole("seed", 0, ~std::uint64_t{0}, out.seed);
  out.configurations = file.whole("configurations", 1, kMostCases, out.configurations);
  out.triangles = file.whole("triangles", 1, 1'000'000'000, out.triangles);
  out.size = static_cast<int>(file.whole("size", 1, 4096, static_cast<std::uint64_t>(out.size)));
  out.stall = file.number("stall", 0, 0.95, out.stall);
  out.shapes = read_shapes(file);
  out.checks = read_checks(file);
  return out;
}

SoakPoint draw_point(const SoakSpecification& specification, std::uint64_t number) {
  Random random = stream(specification.seed, number);
  SoakPoint out;
  out.number = number;
  do {
    out.config = draw_config(random);
  } while (!validate(out.config).empty());
  const int most = std::min(specification.size, out.config.max_size());
  out.frame.width = pick(random, 1, most);
  out.frame.height = pick(random, 1, most);
  out.stall = specification.stall;
  out.seed = random.next();
  return out;
}

ShadedTriangle draw_soak_triangle(const SoakSpecification& specification, const SoakPoint& point,
                                  std::uint64_t number) {
  Random random = stream(point.seed, number);
  ShadedTriangle out;
  const Shape shape = specification.shapes[number % specification.shapes.size()];
  out.triangle = random_triangle(random, shape, point.frame, point.config);
  out.triangle.tag =
      static_cast<std::uint32_t>(number & ((std::uint64_t{1} << point.config.tag_bits) - 1));
  Random attributes = stream(~point.seed, out.triangle.tag);
  out.attributes = random_attributes(attributes, point.config);
  return out;
}

SoakOutcome run_soak(const SoakSpecification& specification, const Shard& shard) {
  SoakOutcome out;
  Progress progress("soaking", shard.share(specification.configurations) * specification.triangles);
  for (std::uint64_t k = shard.index; k < specification.configurations; k += shard.count) {
    const SoakPoint point = draw_point(specification, k);
    ++out.points;
    for (std::uint64_t first = 0; first < specification.triangles; first += kTogether) {
      std::vector<ShadedTriangle> some;
      for (std::uint64_t i = first; i < std::min(first + kTogether, specification.triangles); ++i) {
        some.push_back(draw_soak_triangle(specification, point, i));
      }
      out.triangles += some.size();
      for (const SoakCheck& check : specification.checks) {
        if (check.difference(some, point).empty()) continue;
        out.difference = minimised(check, point, some);
        return out;
      }
      progress.advance(some.size());
    }
  }
  return out;
}

std::string triangles_text(std::span<const ShadedTriangle> triangles) {
  std::string out;
  for (const ShadedTriangle& shaded : triangles) {
    const std::array<Point, 3>& v = shaded.triangle.vertex;
    out += fmt::format("{}{},{},{},{},{},{},{}", out.empty() ? "" : ";", v[0].x, v[0].y, v[1].x,
                       v[1].y, v[2].x, v[2].y, shaded.triangle.tag);
  }
  return out;
}

std::vector<ShadedTriangle> parse_triangles(const SoakSpecification& specification,
                                            const SoakPoint& point, const std::string& text) {
  std::vector<ShadedTriangle> out;
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  const auto refuse = [&](const char* what) {
    throw Error(ErrorCode::kUsage, "--triangles", fmt::format("'{:.60}' {}", text, what));
  };
  do {
    std::array<std::int64_t, 7> number{};
    for (std::size_t i = 0; i < number.size(); ++i) {
      if (i != 0 && (at == end || *at++ != ',')) refuse("is not X,Y,X,Y,X,Y,TAG;...");
      const auto [next, error] = std::from_chars(at, end, number[i]);
      if (error != std::errc()) refuse("is not X,Y,X,Y,X,Y,TAG;...");
      at = next;
    }
    const auto tag = static_cast<std::uint64_t>(number[6]);
    if (number[6] < 0 || tag >> point.config.tag_bits != 0) refuse("has a tag out of range");
    ShadedTriangle shaded = draw_soak_triangle(specification, point, tag);
    for (std::size_t i = 0; i < 3; ++i) {
      for (const std::int64_t value : {number[2 * i], number[2 * i + 1]}) {
        if (value < point.config.coordinate_min() || value > point.config.coordinate_max()) {
          refuse("has a coordinate out of the configuration's range");
        }
      }
      shaded.triangle.vertex[i] = {static_cast<std::int32_t>(number[2 * i]),
                                   static_cast<std::int32_t>(number[2 * i + 1])};
    }
    out.push_back(shaded);
  } while (at != end && *at++ == ';');
  if (at != end) refuse("is not X,Y,X,Y,X,Y,TAG;...");
  return out;
}

}  // namespace halfspace
