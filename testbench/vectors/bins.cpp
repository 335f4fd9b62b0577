// SPDX-License-Identifier: Apache-2.0
#include "bins.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <functional>
#include <span>

#include "samples.hpp"

namespace halfspace {
namespace {

using Labels = std::vector<std::string>;

Labels numbers(int count, const char* prefix) {
  Labels labels;
  for (int i = 0; i < count; ++i) labels.push_back(fmt::format("{}{}", prefix, i));
  return labels;
}

Labels winds(int count) {
  Labels labels;
  for (int i = 0; i < count; ++i) labels.emplace_back(wind_name(i));
  return labels;
}

Labels cross(const Labels& first, const Labels& second) {
  Labels labels;
  for (const std::string& a : first) {
    for (const std::string& b : second) labels.push_back(a + "." + b);
  }
  return labels;
}

Labels operator+(Labels first, const Labels& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

// The greatest |E| at the origin of any node of a level, dropped as setup does: twice the area of a
// triangle of that point and two of the legal square, so at most the square's side times the
// distance to its furthest side.
std::int64_t origin_bound(const Config& config, int level) {
  const int f = config.position_bits();
  const std::int64_t scale = std::int64_t{1} << (f - config.subpixel_bits);
  const std::int64_t low = config.coordinate_min() * scale;
  const std::int64_t high = config.coordinate_max() * scale;
  const std::int64_t first = config.samples == 1 ? std::int64_t{1} << (f - 1) : 0;
  const int side = std::min(config.node_log2(level), config.viewport_bits);
  const std::int64_t last =
      first + (((std::int64_t{1} << config.viewport_bits) - (std::int64_t{1} << side)) << f);
  const std::int64_t far = std::max({high - first, first - low, high - last, last - low});
  return ((config.coordinate_max() - config.coordinate_min()) * far) >> config.dropped_bits();
}

std::int64_t node_greatest(const Config& config, int level) {
  return (std::int64_t{1} << (config.node_bits(config.node_log2(level)) - 1)) - 1;
}

}  // namespace

int first_area_bit(const Config& config) { return 2 * config.subpixel_bits + 2; }

int last_area_bit(const Config& config) {
  const auto side = static_cast<std::uint64_t>(config.extent_max());
  return static_cast<int>(std::bit_width(side * side)) - 1;
}

int wind_of(EdgeSlope slope) {
  const std::int64_t a = slope.a;
  const std::int64_t b = slope.b;
  const std::int64_t across = std::abs(a);
  const std::int64_t down = std::abs(b);
  // Within the quadrant: 0 axis a, 1, 2 diagonal, 3, 4 axis b.
  int turn = down == 0 ? 0 : across == 0 ? 4 : down < across ? 1 : down == across ? 2 : 3;
  if (a < 0) turn = 8 - turn;
  return b < 0 ? (16 - turn) % 16 : turn;
}

const char* wind_name(int wind) {
  constexpr std::array<const char*, 16> kNames{"E", "ESE", "SE", "SSE", "S", "SSW", "SW", "WSW",
                                               "W", "WNW", "NW", "NNW", "N", "NNE", "NE", "ENE"};
  return kNames[static_cast<std::size_t>(wind)];
}

void BinSet::add(const BinSet& other) {
  for (std::size_t i = 0; i < words_.size(); ++i) words_[i] |= other.words_[i];
}

std::size_t BinSet::count() const {
  std::size_t count = 0;
  for (const std::uint64_t word : words_) count += static_cast<std::size_t>(std::popcount(word));
  return count;
}

std::size_t BinSet::count_common(const BinSet& other) const {
  std::size_t count = 0;
  for (std::size_t i = 0; i < words_.size(); ++i) {
    count += static_cast<std::size_t>(std::popcount(words_[i] & other.words_[i]));
  }
  return count;
}

// Adds the groups of a model one after the other.
class BinWriter {
 public:
  explicit BinWriter(BinModel& model) : model_(model), config_(model.config_) {}

  void write() {
    BinModel::Groups& g = model_.groups_;
    setup_groups(g);
    tie_groups(g);
    mask_groups(g);
    box_groups(g);
    node_groups(g);
    width_groups(g);
  }

 private:
  using Reason = std::function<std::string(std::size_t)>;  // of the n-th label

  std::size_t add(const std::string& prefix, const Labels& labels, const Reason& reason = {}) {
    const std::size_t first = model_.bins_.size();
    for (std::size_t i = 0; i < labels.size(); ++i) {
      model_.bins_.push_back({prefix + labels[i], reason ? reason(i) : std::string()});
    }
    return first;
  }
  Reason always(const std::string& text) const {
    return [text](std::size_t) { return text; };
  }

  // True when no edge along an axis leaves sample 0 of a pixel out that the box keeps.
  bool box_cuts_too(std::size_t wind) const {
    if (wind % 4 != 0) return false;
    const SampleExtent extent = sample_extent(config_.samples);
    const SamplePosition p = sample_positions(config_.samples)[0];
    const int step = std::max(1, 16 >> config_.subpixel_bits);  // of vertices, 1/16 px
    // A vertex coordinate above `low`, up to `high`.
    const auto between = [step](int low, int high) { return high / step > low / step; };
    switch (wind / 4) {
      case 0: return !between(p.x, extent.high.x);
      case 1: return !between(p.y, extent.high.y);
      case 2: return !between(extent.low.x, p.x);
      default: return !between(extent.low.y, p.y);
    }
  }

  void setup_groups(BinModel::Groups& g) {
    const bool guard = config_.has_guard_band();
    const Reason side = [guard](std::size_t i) {
      return !guard && (i == 0 || i == 2) ? "without a guard band no coordinate is below 0" : "";
    };
    g.cull = add("cull.", cross({"none", "back", "front"}, {"cw", "ccw"}));
    g.outside = add("drop.outside.", {"left", "right", "top", "bottom"}, side);
    g.between = add("drop.between.", {"x", "y"},
                    config_.subpixel_bits == 0
                        ? always("whole-pixel vertices: what is narrower than a pixel has no area")
                        : Reason{});
    g.degenerate = add("degenerate.", {"equal_012", "equal_01", "equal_12", "equal_20", "row",
                                       "column", "diagonal", "oblique"});
    g.area_one = add("degenerate.", {"area_one"});
    g.edge = add("edge", cross(numbers(3, ""), winds(16)));
    g.cut = add("cut.edge", cross(numbers(3, ""), winds(16)), [this](std::size_t i) {
      return box_cuts_too(i % 16) ? "the box ends where an edge along an axis does" : "";
    });
  }

  void tie_groups(BinModel::Groups& g) {
    // A tie needs a sample where the lattice of vertices has a point, for an edge along an axis or
    // a diagonal a line. Other edges leave the lattice and may pass through any sample.
    const int step = std::max(1, 16 >> config_.subpixel_bits);  // of vertices, 1/16 px
    const std::string off = "no sample lies on the lattice of vertices (subpixel_bits)";
    const auto any = [this, step](auto&& distance) {
      const std::span<const SamplePosition> all = sample_positions(config_.samples);
      return std::any_of(all.begin(), all.end(),
                         [&](SamplePosition p) { return distance(p) % step == 0; });
    };
    const std::array<bool, 4> on_line{
        any([](SamplePosition p) { return p.x; }), any([](SamplePosition p) { return p.x + p.y; }),
        any([](SamplePosition p) { return p.y; }), any([](SamplePosition p) { return p.x - p.y; })};
    const bool on_point = any([](SamplePosition p) { return p.x | p.y; });
    const Reason line = [=](std::size_t wind) {
      return wind % 2 == 0 && !on_line[wind / 2 % 4] ? off : std::string();
    };
    g.tie_edge = add("tie.edge.", winds(16), line);
    g.tie_vertex = add("tie.vertex", cross(numbers(3, ""), {"owned", "lost"}),
                       on_point ? Reason{} : always(off));
    g.tie_shared = add("tie.shared.", winds(8), line);
  }

  void mask_groups(BinModel::Groups& g) {
    const int grid = config_.grid();
    const Labels classes = numbers(config_.lanes(), "lane") + numbers(grid, "row") +
                           numbers(grid, "column") + Labels{"full"};
    g.mask = config_.samples == 1 ? add("mask.", classes)
                                  : add("mask.", cross(numbers(config_.samples, "s"), classes));
    g.mask_empty = add("mask.", {"empty"});
    g.mask_lacks = add("mask.lacks.", numbers(config_.lanes(), "lane"), [grid](std::size_t lane) {
      const auto row = static_cast<int>(lane) / grid;
      const auto column = static_cast<int>(lane) % grid;
      const bool corner = (row == 0 || row == grid - 1) && (column == 0 || column == grid - 1);
      return corner ? "" : "coverage is convex: a sample between two covered ones is covered";
    });
    if (config_.samples > 1) {
      g.pixel_alone = add("pixel.alone.", numbers(config_.samples, "s"));
      Labels counts;
      for (int i = 1; i <= config_.samples; ++i) counts.push_back(fmt::format("{}", i));
      g.pixel_count = add("pixel.count.", counts);
    }
  }

  void box_groups(BinModel::Groups& g) {
    const int one = 1 << config_.subpixel_bits;
    for (const int phase : {0, 1, one / 2 - 1, one / 2, one / 2 + 1, one - 1}) {
      if (phase >= 0 && phase < one) model_.phases_.push_back(phase);
    }
    std::sort(model_.phases_.begin(), model_.phases_.end());
    model_.phases_.erase(std::unique(model_.phases_.begin(), model_.phases_.end()),
                         model_.phases_.end());
    Labels x, y;
    for (const int phase : model_.phases_) {
      x.push_back(fmt::format("x{}", phase));
      y.push_back(fmt::format("y{}", phase));
    }
    g.phase = add("phase.", cross(x, y));
    const bool guard = config_.has_guard_band();
    g.box =
        add("box.", cross({"x_first", "y_first", "x_last", "y_last"}, numbers(config_.grid(), "")));
    g.box_cut = add("box.cut.", {"left", "right", "top", "bottom"}, [guard](std::size_t i) {
      return !guard && (i == 0 || i == 2) ? "without a guard band no coordinate is below 0" : "";
    });
    g.box_thin = add("box.", {"one_column", "one_row"});
    g.frame = add("frame.", cross({"width", "height"}, {"one", "most", "odd"}));
  }

  void node_groups(BinModel::Groups& g) {
    const int levels = config_.levels();
    g.split = add("split.", numbers(levels - 1, "level") + Labels{"never"});
    const int reached = config_.viewport_bits - config_.node_log2(1);  // log2 of the root's lanes
    const int grid = config_.grid();
    const Reason beyond = [=, this](std::size_t i) {
      const auto lane = static_cast<int>(i) % config_.lanes();
      const bool root = static_cast<int>(i) < config_.lanes();
      return root && ((lane % grid) >> reached != 0 || (lane / grid) >> reached != 0)
                 ? "the root is wider than the viewport: no pixel is there"
                 : "";
    };
    const Labels level_names = numbers(levels - 1, "level");
    g.child = add("node.", cross(level_names, numbers(config_.lanes(), "child")), beyond);
    g.reject = add("node.", cross(level_names, numbers(config_.lanes(), "reject")), beyond);
    g.dead = add("node.dead.", numbers(levels - 1, "level"));
    if (levels > 1) g.all = add("node.all.", {fmt::format("level{}", levels - 2)});
    g.saturate = add(
        "saturate.", cross(numbers(levels, "level"), numbers(3, "edge")), [this](std::size_t i) {
          const auto level = static_cast<int>(i / 3);
          const std::int64_t bound = origin_bound(config_, level);
          const std::int64_t greatest = node_greatest(config_, level);
          return bound <= greatest
                     ? fmt::format(
                           "|E| at an origin of level {} is at most {}, a register holds {}", level,
                           bound, greatest)
                     : std::string();
        });
  }

  void width_groups(BinModel::Groups& g) {
    g.slope = add("width.", {"a.max", "a.min", "b.max", "b.min"});
    g.area = add("width.area.", {"cw", "ccw"});
    const int first = first_area_bit(config_);
    Labels bits;
    for (int i = first; i <= last_area_bit(config_); ++i) bits.push_back(fmt::format("{}", i));
    g.area_bit = add("area.bit", bits);
    g.vertex = add("width.vertex", cross(numbers(3, ""), {"x.min", "x.max", "y.min", "y.max"}));
    g.corner = add("corner.", {"nw", "ne", "sw", "se"});
    const bool guard = config_.has_guard_band();
    g.corners = add("corners.but_", {"nw", "ne", "sw", "se"}, [guard](std::size_t i) {
      return guard && i == 3 ? "with a guard band its inside is x + y < 0, where no frame is" : "";
    });
  }

  BinModel& model_;
  Config config_;
};

BinModel::BinModel(const Config& config) : config_(config) { BinWriter(*this).write(); }

std::size_t BinModel::reachable() const {
  return static_cast<std::size_t>(
      std::count_if(bins_.begin(), bins_.end(), [](const Bin& bin) { return bin.reason.empty(); }));
}

}  // namespace halfspace
