// SPDX-License-Identifier: Apache-2.0
#include "estimate.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "engines/coverage/coverage_engine.hpp"
#include "engines/cycle/cycle_engine.hpp"
#include "splitmix.hpp"

namespace halfspace {
namespace {

constexpr std::size_t kWindows = 49;      // run, the first included
constexpr double kStudent = 2.012;        // 97.5 % quantile, 47 degrees of freedom
constexpr std::uint64_t kWarmUp = 96;     // clocks of work before a window: more than is in flight
constexpr std::size_t kPopulation = 512;  // windows in all, about
constexpr std::size_t kStretches = 12;
constexpr std::uint64_t kStretchWork = 4096;  // clocks

// Clocks that a triangle takes where nothing but its tiles and setup cost: its work.
std::vector<std::uint64_t> work_of(std::span<const Triangle> triangles, const FrameState& frame,
                                   const Config& config) {
  std::vector<std::uint64_t> work(triangles.size(), 0);
  CoverageEngine engine(frame, config);
  engine.cover(triangles, [&work](const CoverageChunk& chunk) {
    for (std::size_t i = 0; i < chunk.triangle.size(); ++i) {
      std::uint64_t& of = work[chunk.triangle[i]];
      for_each_tile(chunk, i, 0, [&of](const CoverageTile&) { ++of; });
    }
  });
  const auto least = static_cast<std::uint64_t>(config.setup_interval);
  for (std::uint64_t& w : work) w = std::max(w, least);
  return work;
}

// When each triangle is over: its last tile has left, or it was accepted, and so were those before.
struct Ends {
  static constexpr bool kWantsSetup = false;
  static constexpr bool kWantsNodes = false;
  std::vector<std::uint64_t> end;

  void accepted(Timing::Clock clock) {
    end.push_back(std::max(end.empty() ? 0 : end.back(), clock + 1));
  }
  void setup(Timing::Clock, const SetupTriangle&) const {}
  void node(int, Timing::Clock, const Node&) const {}
  void tile(Timing::Clock clock, const CoverageTile&) {
    end.back() = std::max(end.back(), clock + 1);
  }
};

// `count` of the numbers 1 .. last, each as likely as any.
std::vector<std::size_t> choose(std::size_t count, std::size_t last, std::uint64_t seed) {
  std::vector<std::size_t> all(last);
  std::iota(all.begin(), all.end(), 1);
  for (std::size_t i = 0; i < count; ++i) {
    std::swap(all[i], all[i + splitmix_next(seed) % (last - i)]);
  }
  all.resize(count);
  std::sort(all.begin(), all.end());
  return all;
}

class Windows {
 public:
  Windows(std::span<const Triangle> triangles, const FrameState& frame, const Config& config)
      : triangles_(triangles),
        frame_(frame),
        config_(config),
        size_(std::clamp<std::size_t>(triangles.size() / kPopulation, 4, 256)),
        work_(work_of(triangles, frame, config)) {}

  std::size_t count() const { return (triangles_.size() + size_ - 1) / size_; }
  std::size_t first(std::size_t window) const { return window * size_; }
  std::size_t last(std::size_t window) const {
    return std::min((window + 1) * size_, triangles_.size());
  }
  double work(std::size_t window) const { return sum(first(window), last(window)); }
  double sum(std::size_t from, std::size_t to) const {
    std::uint64_t total = 0;
    for (std::size_t i = from; i < to; ++i) total += work_[i];
    return static_cast<double>(total);
  }
  // The triangle at which the window's run begins.
  std::size_t begin(std::size_t window) const {
    std::size_t at = first(window);
    for (std::uint64_t done = 0; at > 0 && done < kWarmUp;) done += work_[--at];
    return at;
  }
  std::size_t length(std::size_t window) const { return last(window) - begin(window); }
  // The window's run again, cut after kStretchWork.
  ClockEstimate::Stretch stretch(std::size_t window) const {
    ClockEstimate::Stretch out{begin(window), begin(window)};
    for (std::uint64_t done = 0; out.end < last(window) && done < kStretchWork;) {
      done += work_[out.end++];
    }
    return out;
  }
  // Clocks between the end of the triangle before the window and the end of its last.
  double clocks(std::size_t window) const {
    Ends ends;
    CycleEngine engine(frame_, config_, Stalls());
    engine.draw(triangles_.subspan(begin(window), length(window)), ends);
    const std::size_t before = first(window) - begin(window);
    return static_cast<double>(ends.end.back() - (before == 0 ? 0 : ends.end[before - 1]));
  }

 private:
  std::span<const Triangle> triangles_;
  FrameState frame_;
  Config config_;
  std::size_t size_;
  std::vector<std::uint64_t> work_;
};

// kStretches of the windows, or all when there are fewer, the first among them.
template <class Window>
void add_stretches(const Windows& windows, std::size_t count, Window&& window, ClockEstimate& out) {
  const std::size_t some = std::min(count, kStretches);
  for (std::size_t i = 0; i < some; ++i) {
    out.stretches.push_back(windows.stretch(window(i * count / some)));
  }
}

ClockEstimate run_all(const Windows& windows, std::span<const Triangle> triangles,
                      const FrameState& frame, const Config& config) {
  Ends ends;
  CycleEngine engine(frame, config, Stalls());
  engine.draw(triangles, ends);
  ClockEstimate out;
  out.clocks = out.low = out.high = static_cast<double>(engine.clocks());
  out.exact = true;
  out.windows = out.of = 1;
  out.triangles = out.triangles_at_cycle = triangles.size();
  const auto every = [](std::size_t i) { return i; };
  add_stretches(windows, windows.count(), every, out);
  return out;
}

}  // namespace

ClockEstimate estimate_clocks(std::span<const Triangle> triangles, const FrameState& frame,
                              const Config& config, std::uint64_t seed) {
  const Windows windows(triangles, frame, config);
  if (windows.count() < 2 * kWindows) return run_all(windows, triangles, frame, config);
  const std::size_t m = kWindows - 1;
  const std::vector<std::size_t> chosen = choose(m, windows.count() - 1, seed);
  ClockEstimate out;
  out.windows = kWindows;
  out.of = windows.count();
  out.triangles = triangles.size();
  out.triangles_at_cycle = windows.length(0);
  for (const std::size_t window : chosen) out.triangles_at_cycle += windows.length(window);
  if (2 * out.triangles_at_cycle > triangles.size()) {
    return run_all(windows, triangles, frame, config);
  }

  std::vector<double> clocks, work;
  for (const std::size_t window : chosen) {
    clocks.push_back(windows.clocks(window));
    work.push_back(windows.work(window));
  }
  const double ratio = std::accumulate(clocks.begin(), clocks.end(), 0.0) /
                       std::accumulate(work.begin(), work.end(), 0.0);
  double squares = 0;
  for (std::size_t i = 0; i < m; ++i) squares += std::pow(clocks[i] - ratio * work[i], 2);
  const auto population = static_cast<double>(windows.count() - 1);
  const auto sampled = static_cast<double>(m);
  const double variance = squares / (sampled - 1) / sampled * (1 - sampled / population);
  const double half = kStudent * population * std::sqrt(variance);
  out.clocks = windows.clocks(0) + ratio * windows.sum(windows.last(0), triangles.size());
  out.low = out.clocks - half;
  out.high = out.clocks + half;
  const auto window = [&](std::size_t i) { return i == 0 ? 0 : chosen[i - 1]; };
  add_stretches(windows, kWindows, window, out);
  return out;
}

}  // namespace halfspace
