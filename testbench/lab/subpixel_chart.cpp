// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "charts.hpp"

namespace halfspace::lab {
namespace {

constexpr std::uint64_t kSeed = 820;
constexpr int kMostBits = 12;

Config config_with(int bits, SnapMode mode) {
  Config config;
  config.subpixel_bits = bits;
  config.guard_bits = 14;  // one more than the scenes are clipped to: rounding may go beyond
  config.snap = mode;
  return config;
}

Json rows(const RealScene& scene) {
  const auto truth = oracle_pixels(scene);
  Json out = Json::array();
  for (const auto& [name, mode] : {std::pair{"nearest_even", SnapMode::kNearestEven},
                                   std::pair{"truncate", SnapMode::kTruncate}}) {
    for (int bits = 0; bits <= kMostBits; ++bits) {
      const Config config = config_with(bits, mode);
      const Difference d = compare(model_pixels(snapped(scene, config), scene, config), truth);
      out.push_back({{"snap", name},
                     {"subpixel_bits", bits},
                     {"covered", d.covered},
                     {"missing", d.missing},
                     {"extra", d.extra},
                     {"wrong_ppm", d.ppm()}});
    }
  }
  return out;
}

}  // namespace

Json subpixel_chart(const RealScene* scene) {
  Json data;
  data["chart"] = "subpixel";
  if (scene != nullptr) {
    data["scenes"].push_back({{"name", scene->name}, {"rows", rows(*scene)}});
    return data;
  }
  for (const auto& [side, count] : {std::pair{4, 200000}, std::pair{16, 25000}, {64, 2500}}) {
    const RealScene random = random_scene(kSeed, count, side, 512, 512);
    data["scenes"].push_back({{"name", random.name}, {"rows", rows(random)}});
  }
  return data;
}

}  // namespace halfspace::lab
