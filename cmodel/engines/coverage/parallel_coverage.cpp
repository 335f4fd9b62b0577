// SPDX-License-Identifier: Apache-2.0
#include "parallel_coverage.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <limits>
#include <mutex>

#include "../common/threads.hpp"

namespace halfspace {
namespace {

// Triangles a body takes at a time: a function of their number alone, so that chunks do not depend
// on the number of threads. Long enough to pay for the hand-over, short enough to share out few
// large triangles.
std::size_t range_of(std::size_t triangles) {
  return std::clamp<std::size_t>(triangles / 64, 16, 2048);
}

// Deals out ranges of triangles, first to last.
class Ranges {
 public:
  explicit Ranges(std::size_t triangles) : triangles_(triangles), range_(range_of(triangles)) {}

  struct Range {
    std::size_t first;
    std::size_t last;
    bool empty() const { return first >= last; }
  };
  Range take() {
    const std::size_t first = next_.fetch_add(range_);
    return {first, std::min(first + range_, triangles_)};
  }
  std::size_t after(const Range& range) const { return range.first + range_; }
  void stop() { next_ = triangles_; }

 private:
  const std::size_t triangles_;
  const std::size_t range_;
  std::atomic<std::size_t> next_ = 0;
};

void add_counts(const simd::KernelCounts& from, simd::KernelCounts& to) {
  to.triangles += from.triangles;
  to.zero_area += from.zero_area;
  to.culled += from.culled;
  to.no_sample += from.no_sample;
}

}  // namespace

simd::KernelCounts cover_parallel(std::span<const Triangle> triangles, const FrameState& frame,
                                  const Config& config, const ParallelOptions& options,
                                  const std::function<void(const CoverageChunk&)>& sink) {
  Ranges ranges(triangles.size());
  std::mutex mutex;  // of all that follows
  std::condition_variable turn_changed;
  std::size_t turn = 0;  // first triangle of the range to hand over next
  bool failed = false;
  simd::KernelCounts counts;

  // A range is handed over by the body that took it, so the earliest never waits.
  const auto give = [&](const Ranges::Range& range, const CoverageChunk& chunk) {
    std::unique_lock lock(mutex);
    turn_changed.wait(lock, [&] { return turn == range.first || failed; });
    if (failed) return;
    try {
      sink(chunk);
    } catch (...) {
      failed = true;
      ranges.stop();
      turn_changed.notify_all();
      throw;
    }
    turn = ranges.after(range);
    turn_changed.notify_all();
  };
  run_on_threads(options.threads, [&](int) {
    Ranges::Range range = ranges.take();
    if (range.empty()) return;
    CoverageEngine engine(frame, config, options.isa);
    for (; !range.empty(); range = ranges.take()) {
      engine.fill(triangles.first(range.last), range.first,
                  std::numeric_limits<std::size_t>::max());
      give(range, engine.chunk());
    }
    const std::lock_guard lock(mutex);
    add_counts(engine.counts(), counts);
  });
  return counts;
}

HitPlane hits_parallel(std::span<const Triangle> triangles, const FrameState& frame,
                       const Config& config, const ParallelOptions& options, RasterStats& stats) {
  Ranges ranges(triangles.size());
  std::mutex mutex;  // of sum and stats
  HitPlane sum(frame.width, frame.height);
  run_on_threads(options.threads, [&](int) {
    Ranges::Range range = ranges.take();
    if (range.empty()) return;
    CoverageEngine engine(frame, config, options.isa);
    HitPlane plane(frame.width, frame.height);
    RasterStats mine;
    for (; !range.empty(); range = ranges.take()) {
      for (std::size_t done = range.first; done < range.last;) {
        done += engine.fill(triangles.first(range.last), done);
        const CoverageChunk chunk = engine.chunk();
        plane.add(chunk);
        count_records(chunk, mine);
      }
    }
    count_triangles(engine.counts(), mine);
    const std::lock_guard lock(mutex);
    sum.add(plane);
    stats += mine;
  });
  return sum;
}

}  // namespace halfspace
