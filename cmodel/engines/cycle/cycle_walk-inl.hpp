// SPDX-License-Identifier: Apache-2.0
//
// Triangles through the pyramid, packets and clocks into the buffer.
#if defined(HALFSPACE_CYCLE_WALK_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HALFSPACE_CYCLE_WALK_INL
#undef HALFSPACE_CYCLE_WALK_INL
#else
#define HALFSPACE_CYCLE_WALK_INL
#endif

#include <bit>

#include "cycle_grid-inl.hpp"
#include "cycle_setup-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace halfspace::cycle::HWY_NAMESPACE {

// kPlain: one sample, no stalls, no node packets.
template <bool kPlain>
class Walk {
 public:
  explicit Walk(State& state)
      : s_(state),
        out_(state.buffer),
        leaf_level_(state.config.levels() - 1),
        q_(state.config.sample_bits()),
        samples_(static_cast<std::size_t>(state.config.samples)) {
    for (std::size_t m = 0; m < samples_; ++m) {
      offset_[m] = sample_offset(state.config, static_cast<int>(m));
      low_ = m == 0
                 ? offset_[m]
                 : SamplePosition{std::min(low_.x, offset_[m].x), std::min(low_.y, offset_[m].y)};
      high_ =
          m == 0 ? offset_[m]
                 : SamplePosition{std::max(high_.x, offset_[m].x), std::max(high_.y, offset_[m].y)};
    }
    for (int level = 0; level <= leaf_level_; ++level) {
      const int bits = state.config.node_bits(state.config.node_log2(level));
      greatest_[level] = (std::int64_t{1} << (bits - 1)) - 1;
    }
  }

  void draw(const Batch& batch, std::size_t i, std::uint32_t index) {
    CycleTiming& timing = s_.timing;
    flows_ = kPlain && timing.flows();
    const std::uint64_t accepted = flows_ ? timing.accept_flowing() : timing.accept();
    s_.clocks = std::max(s_.clocks, accepted + 1);
    ++s_.stats.triangles;
    CycleTriangle& record = out_.open(index, accepted);
    record.outcome = static_cast<SetupOutcome>(batch.outcome[i]);
    if (record.outcome != SetupOutcome::kDrawn) {
      count_drop(record.outcome, s_.stats);
      if (!flows_) timing.drop_setup();
      out_.close();
      return;
    }
    record.entered = flows_ ? timing.root_flowing() : timing.enter_root();
    Point3 e;
    for (std::size_t k = 0; k < 3; ++k) {
      a_[k] = batch.a[k][i];
      b_[k] = batch.b[k][i];
      e[k] = batch.e[k][i];
    }
    box_ = {batch.x_first[i], batch.y_first[i], batch.x_last[i], batch.y_last[i]};
    make_table(a_, b_, table_);
    const int start = batch.level[i];
    for (int l = 0; l <= start; ++l) ++s_.stats.traversal.nodes[static_cast<std::size_t>(l)];
    s_.stats.upper_nodes_skipped += static_cast<std::uint64_t>(start);
    if (!flows_) timing.descend(start);
    single_ = true;
    leaves_ = 0;
    if (start == leaf_level_) {
      leaf(batch.x_node[i], batch.y_node[i], e);
    } else {
      node(batch.x_node[i], batch.y_node[i], start, e);
    }
    if (kPlain && !flows_ && single_ && leaves_ == 1) timing.try_flow();
    out_.close();
  }

 private:
  using Point3 = std::array<std::int64_t, 3>;

  // Edge `k`'s change from a node's origin to the corner of child (0, 0) furthest inside (or out).
  std::int64_t corner(std::size_t k, std::int64_t last, bool inside) const {
    const std::int64_t a = a_[k], b = b_[k];
    return a * ((a > 0) == inside ? last + high_.x : low_.x) +
           b * ((b > 0) == inside ? last + high_.y : low_.y);
  }
  // Lanes of which the nearest (inside) or no (outside) corner is out of reach of the edges.
  HWY_INLINE std::uint64_t corners(const Point3& e, int child_log2, bool inside) const {
    const std::int64_t last = ((std::int64_t{1} << child_log2) - 1) << q_;
    const int shift = child_log2 + q_;
    std::int32_t base[3];
    for (std::size_t k = 0; k < 3; ++k) {
      base[k] = static_cast<std::int32_t>((e[k] + corner(k, last, inside)) >> shift);
    }
    return grid_mask(table_.lane, base[0], base[1], base[2]);
  }

  // A node that entered `level`, above the leaves.
  void node(std::int32_t x, std::int32_t y, int level, const Point3& e) {
    CycleTiming& timing = s_.timing;
    const int z = 3 * (leaf_level_ - level);  // log2 of a child's side
    const std::uint64_t box = range_mask((box_.x_first - x) >> z, (box_.y_first - y) >> z,
                                         (box_.x_last - x) >> z, (box_.y_last - y) >> z);
    std::uint64_t live = box & corners(e, z, true);
    if (live == 0) {
      if (!flows_) timing.drop_node(level);
      single_ = false;
      return;
    }
    const auto children = static_cast<std::uint64_t>(std::popcount(live));
    s_.stats.traversal.nodes[static_cast<std::size_t>(level + 1)] += children;
    if (children != 1) {
      single_ = false;
      if (flows_) {
        timing.stop_flow(level);
        flows_ = false;
      }
    }
    if (!flows_) timing.begin_children(level);
    if (kPlain && level == leaf_level_ - 1) {
      plain_leaves(x, y, e, live, children);
      return;
    }
    while (live != 0) {
      const int lane = std::countr_zero(live);
      live &= live - 1;
      const std::int32_t cx = x + ((lane & 7) << z), cy = y + ((lane >> 3) << z);
      Point3 child;
      for (std::size_t k = 0; k < 3; ++k) {
        child[k] =
            std::min(e[k] + (std::int64_t{table_.lane[k][lane]} << (z + q_)), greatest_[level + 1]);
      }
      if (!flows_) {
        const std::uint64_t clock = timing.child(level, live == 0);
        if (!kPlain && s_.want_nodes) {
          s_.make_room();
          out_.node.push_back(
              {clock, static_cast<std::uint32_t>(out_.tiles), level + 1, Node{cx, cy, child}});
        }
      }
      if (level + 1 == leaf_level_) {
        leaf(cx, cy, child);
      } else {
        node(cx, cy, level + 1, child);
      }
    }
  }

  std::uint64_t box_of_tile(std::int32_t x, std::int32_t y) const {
    return range_mask(box_.x_first - x, box_.y_first - y, box_.x_last - x, box_.y_last - y);
  }
  void count_tests(std::uint64_t tiles) {
    leaves_ += tiles;
    s_.stats.tiles_visited += tiles;
    s_.stats.samples_tested += tiles * 64 * samples_;
  }

  // A tile that entered coverage.
  void leaf(std::int32_t x, std::int32_t y, const Point3& e) {
    s_.make_room();
    count_tests(1);
    const std::uint64_t box = box_of_tile(x, y);
    std::uint64_t any = 0, covered = 0;
    for (std::size_t m = 0; m < samples_; ++m) {
      std::int32_t base[3];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t at =
            e[k] + std::int64_t{a_[k]} * offset_[m].x + std::int64_t{b_[k]} * offset_[m].y;
        base[k] = static_cast<std::int32_t>(at >> q_);
      }
      const std::uint64_t mask = box & grid_mask(table_.lane, base[0], base[1], base[2]);
      out_.masks[m * CycleBuffer::kStride + out_.tiles] = mask;
      any |= mask;
      covered += static_cast<std::uint64_t>(std::popcount(mask));
    }
    out_.place[out_.tiles] = cycle_place(x, y, 3);
    if (any == 0) {
      if (!flows_) s_.timing.drop_tile();
      return;
    }
    const std::uint64_t clock = flows_ ? s_.timing.tile_flowing() : s_.timing.leave_tile();
    out_.clock[out_.tiles] = clock;
    ++out_.tiles;
    s_.clocks = std::max(s_.clocks, clock + 1);
    ++s_.stats.tiles_covered;
    s_.stats.samples_covered += covered;
    s_.stats.fragments += static_cast<std::uint64_t>(std::popcount(any));
  }

  void plain_leaves(std::int32_t x, std::int32_t y, const Point3& e, std::uint64_t live,
                    std::uint64_t children);

  State& s_;
  CycleBuffer& out_;
  int leaf_level_;
  int q_;
  std::size_t samples_;
  std::array<SamplePosition, kMaxSamples> offset_{};
  SamplePosition low_, high_;
  std::int64_t greatest_[8] = {};

  // The triangle at hand.
  std::int32_t a_[3] = {}, b_[3] = {};
  Table table_;
  alignas(64) std::int32_t leaf_e_[3][64] = {};  // of a node's children
  Box box_;
  bool flows_ = false;   // in free flow: the timing is not followed
  bool single_ = false;  // one live child at every node so far
  std::uint64_t leaves_ = 0;
};

// All live tiles of a node whose children are tiles.
template <bool kPlain>
void Walk<kPlain>::plain_leaves(std::int32_t x, std::int32_t y, const Point3& e, std::uint64_t live,
                                std::uint64_t children) {
  s_.make_room();
  count_tests(children);
  const std::uint64_t first = flows_ ? s_.timing.tile_flowing() : s_.timing.run_leaves(children);
  std::uint64_t* clock = out_.clock.data() + out_.tiles;
  std::uint64_t* masks = out_.masks.data() + out_.tiles;
  std::uint32_t* place = out_.place.data() + out_.tiles;
  const std::uint32_t corner = cycle_place(x, y, 3);
  // Tiles wholly inside, when there are enough tiles for the question to pay.
  std::uint64_t inside = 0;
  if (children > 12) {
    inside = corners(e, 3, false) &
             range_mask((box_.x_first - x + 7) >> 3, (box_.y_first - y + 7) >> 3,
                        ((box_.x_last - x + 1) >> 3) - 1, ((box_.y_last - y + 1) >> 3) - 1);
    if (inside == ~std::uint64_t{0}) {
      for (std::size_t i = 0; i < 64; ++i) {
        clock[i] = first + i;
        masks[i] = ~std::uint64_t{0};
        place[i] = corner + kLane.place[i];
      }
      out_.tiles += 64;
      s_.stats.tiles_covered += 64;
      s_.stats.samples_covered += 4096;
      s_.stats.fragments += 4096;
      s_.clocks = std::max(s_.clocks, first + 64);
      return;
    }
  }
  // Edge values of all children, in steps of 8 so that they fit 32 bits; too great ones are cut at
  // a value that is as positive over the whole tile.
  const DI d;
  const VI most = hn::Set(d, static_cast<std::int32_t>((greatest_[leaf_level_] + 1) >> 3));
  for (std::size_t k = 0; k < 3; ++k) {
    const VI high = hn::Set(d, static_cast<std::int32_t>(e[k] >> 3));
    const VI low = hn::Set(d, static_cast<std::int32_t>(e[k] & 7));
    for (std::size_t v = 0; v < 64; v += kLanes) {
      const VI sum = hn::Min(hn::Add(hn::Load(d, table_.lane[k] + v), high), most);
      hn::Store(hn::Or(hn::ShiftLeft<3>(sum), low), d, leaf_e_[k] + v);
    }
  }
  // The box says more than the edges only where the frame ends.
  const bool boxed = box_.x_last == s_.frame.width - 1 || box_.y_last == s_.frame.height - 1;
  std::size_t count = 0;
  std::uint64_t covered = 0, last = 0;
  for (std::uint64_t tile = first; live != 0; ++tile, live &= live - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(live));
    std::uint64_t mask = ~std::uint64_t{0};
    if ((inside >> lane & 1) == 0) {
      mask = grid_mask(table_.lane, leaf_e_[0][lane], leaf_e_[1][lane], leaf_e_[2][lane]);
      if (boxed) mask &= box_of_tile(x + 8 * kLane.column[lane], y + 8 * kLane.row[lane]);
    }
    clock[count] = tile;
    masks[count] = mask;
    place[count] = corner + kLane.place[lane];
    covered += static_cast<std::uint64_t>(std::popcount(mask));
    count += mask != 0;
    last = mask != 0 ? tile : last;
  }
  out_.tiles += count;
  s_.stats.tiles_covered += count;
  s_.stats.samples_covered += covered;
  s_.stats.fragments += covered;
  if (count != 0) s_.clocks = std::max(s_.clocks, last + 1);
}

}  // namespace halfspace::cycle::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
