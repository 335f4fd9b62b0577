// SPDX-License-Identifier: Apache-2.0
//
// A draw by several threads.
#include <algorithm>
#include <utility>

#include "../common/step_line.hpp"
#include "frame_work.hpp"

namespace halfspace {
namespace {

// The most triangles of a piece and the fewest worth sharing.
constexpr std::size_t kSharedTriangles = 4096;
constexpr std::size_t kLeastTriangles = 512;
// Records of a piece that are kept at a time: most pieces have fewer.
constexpr std::size_t kSharedRecords = 1 << 15;
// Vertices a thread projects at a time, at least.
constexpr std::size_t kVertexRange = 1024;
constexpr std::size_t kMostRanges = 1 << 12;

}  // namespace

// Some triangles of a draw, shared out in `used` pieces of `share`.
struct FrameEngine::Work::Round {
  std::size_t first = 0;
  std::size_t count = 0;
  std::size_t share = 1;
  std::size_t used = 0;
  std::size_t piece = 0;  // the first of its pieces
};

// Four rounds at a time, each a step further: the indices of one are scanned (scanning_), the
// vertices of the one before are projected (projecting_), the pieces of the one before that
// prepared (preparing_), and the tiles of the oldest drawn (drawing_), each band of rows by one
// thread and in the order of triangles. What a step reads was made in the step before.
//
// Of a piece with too many records only the first are there when its round is drawn. Then the line
// waits: in steps of their own its next records are found, and drawn with the pieces behind it.
class FrameEngine::Work::Shared {
 public:
  Shared(Work& work, const Feed& feed) : work_(work), feed_(feed) {
    scanning_ = round(index_++);
    scan();
  }

  // The next step's tasks: one that scans, then bands, then pieces, then ranges of vertices; none
  // when all is drawn.
  std::size_t plan() {
    if (const std::size_t rest = plan_rest(); rest > 0) return rest;
    for (std::size_t i = 0; i < preparing_.used; ++i)
      work_.tell(work_.pieces_[preparing_.piece + i]);
    drawing_ = preparing_;
    draw_from(0);
    preparing_ = projecting_;
    projecting_ = scanning_;
    scanning_ = round(index_++);
    projected_ = needed_;
    needed_ = std::max(needed_, scanning_needed_);
    const std::size_t more = needed_ - projected_;
    range_ = std::max(kVertexRange, (more + kMostRanges - 1) / kMostRanges);
    bands_ = drawing_.used == 0 ? 0 : work_.grid_.bands();
    if (projecting_.used + preparing_.used + drawing_.used == 0) return 0;
    return 1 + bands_ + preparing_.used + (more + range_ - 1) / range_;
  }

  void task(std::size_t task, std::size_t thread) {
    if (step_ == Step::kCover) return cover(drawing_.piece + draw_end_ - 1, thread);
    if (step_ == Step::kDraw) return draw(task, thread);
    if (task == 0) return scan();
    task -= 1;
    if (task < bands_) return draw(task, thread);
    task -= bands_;
    if (task < preparing_.used) return prepare(task, thread);
    const std::size_t from = projected_ + (task - preparing_.used) * range_;
    work_.kernels_.project(work_.project_, *feed_.source, from, std::min(range_, needed_ - from),
                           work_.records_.data());
  }

 private:
  enum class Step { kAll, kCover, kDraw };  // kCover: one task; kDraw: bands only

  // The pieces of drawing_ from `first` on that can be drawn now: up to one that is not finished.
  void draw_from(std::size_t first) {
    draw_begin_ = draw_end_ = first;
    while (draw_end_ < drawing_.used && work_.pieces_[drawing_.piece + draw_end_++].finished()) {
    }
  }

  // The next step when not all of a round was drawn; 0 when it was.
  std::size_t plan_rest() {
    const bool covered = std::exchange(step_, Step::kAll) == Step::kCover;
    if (covered) {
      step_ = Step::kDraw;
      draw_from(draw_end_ - 1);
      return bands_;
    }
    if (drawing_.used == 0 || work_.pieces_[drawing_.piece + draw_end_ - 1].finished()) return 0;
    step_ = Step::kCover;
    return 1;
  }

  void draw(std::size_t band, std::size_t thread) {
    for (std::size_t i = draw_begin_; i < draw_end_; ++i) {
      work_.draw_tiles(work_.pieces_[drawing_.piece + i], static_cast<std::uint32_t>(band), thread);
    }
  }

  void cover(std::size_t piece, std::size_t thread) {
    FramePiece& it = work_.pieces_[piece];
    it.cover(work_.constants_, work_.records_, kSharedRecords, work_.grid_, work_.scratch_[thread]);
    if (work_.options_.count_hits) work_.hits_[thread].add(it.chunk());
  }

  Round round(std::size_t index) const {
    const std::size_t most = work_.pieces_.size() / 2;
    Round out;
    out.first = std::min(index * most * kSharedTriangles, feed_.triangles);
    out.count = std::min(most * kSharedTriangles, feed_.triangles - out.first);
    out.share = std::max(kLeastTriangles, (out.count + most - 1) / most);
    out.used = (out.count + out.share - 1) / out.share;
    out.piece = index % 2 * most;
    return out;
  }

  // Which vertices the round after the next needs.
  void scan() {
    if (feed_.source == nullptr || scanning_.count == 0) return;
    scanning_needed_ = feed_.vertices(scanning_.first, scanning_.count);
  }

  void prepare(std::size_t i, std::size_t thread) {
    const std::size_t from = i * preparing_.share;
    work_.assemble(feed_, preparing_.piece + i, preparing_.first + from,
                   std::min(preparing_.share, preparing_.count - from));
    cover(preparing_.piece + i, thread);
  }

  Work& work_;
  const Feed& feed_;
  std::size_t index_ = 0;
  Round scanning_, projecting_, preparing_, drawing_;
  std::size_t projected_ = 0;  // vertices
  std::size_t needed_ = 0;
  std::size_t scanning_needed_ = 0;
  std::size_t range_ = 1;
  std::size_t bands_ = 0;
  Step step_ = Step::kAll;
  std::size_t draw_begin_ = 0;  // of drawing_'s pieces
  std::size_t draw_end_ = 0;
};

void FrameEngine::Work::draw_shared(const Feed& feed) {
  Shared shared(*this, feed);
  StepLine line([&shared] { return shared.plan(); });
  options_.run(options_.threads, [&](int thread) {
    line.work([&](std::size_t task) { shared.task(task, static_cast<std::size_t>(thread)); });
  });
}

// A band is enough for a task, and few enough tasks for any frame.
void FrameEngine::Work::finish_shared() {
  bool planned = false;
  StepLine line([&] { return std::exchange(planned, true) ? 0 : grid_.bands(); });
  options_.run(options_.threads, [&](int) {
    line.work([&](std::size_t task) {
      const auto first = static_cast<std::uint32_t>(task) * grid_.band;
      const std::uint32_t last = std::min(first + grid_.band, grid_.rows);
      for (std::uint32_t row = first; row < last; ++row) store_.finish_row(row);
    });
  });
}

}  // namespace halfspace
