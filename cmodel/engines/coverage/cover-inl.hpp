// SPDX-License-Identifier: Apache-2.0
//
// Batches of triangles: setup, the list of work in triangle order, the work.
#if defined(HALFSPACE_SIMD_COVER_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HALFSPACE_SIMD_COVER_INL
#undef HALFSPACE_SIMD_COVER_INL
#else
#define HALFSPACE_SIMD_COVER_INL
#endif

#include "../../fixed.hpp"
#include "../../triangle_setup.hpp"
#include "setup-inl.hpp"
#include "strip-inl.hpp"
#include "window-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace halfspace::simd::HWY_NAMESPACE {

// The windows of a block, row by row, for one and two columns of windows; then the strip item.
struct WorkTable {
  alignas(64) std::uint32_t item[3][16];
  constexpr WorkTable() : item{} {
    for (std::uint32_t i = 0; i < 16; ++i) {
      item[0][i] = pack(0, (i * kWindowRows) & 0xff, kWindowItem);
      item[1][i] = pack(i % 2 * kBatch, i / 2 * kWindowRows, kWindowItem);
      item[2][i] = pack(0, 0, kStripItem);
    }
  }
  static constexpr std::uint32_t pack(std::uint32_t column, std::uint32_t row, What what) {
    return column << 8 | row << 16 | std::uint32_t{what} << 24;
  }
};
inline constexpr WorkTable kWork;
static_assert(std::endian::native == std::endian::little && sizeof(WorkItem) == 4);

// The most records that a batch of narrow triangles makes: all tiles of all blocks.
inline constexpr std::size_t kBatchRecords = kBatch * 64;

// Lists the work of the batch, in the order of triangles.
HWY_INLINE void list_work(SetupBatch& batch) {
  const DU du;
  std::size_t count = 0;
  std::uint32_t* HWY_RESTRICT work = reinterpret_cast<std::uint32_t*>(batch.work);
  constexpr std::uint32_t both = 0x101;  // lane and column
  for (std::size_t group = 0; group < kBatch; group += kLanes) {
    const auto windows = hn::Load(du, batch.windows + group);
    const auto strip = hn::Eq(hn::Load(du, batch.kind + group), hn::Set(du, 2));
    // One window each at most: the common case of small triangles.
    const auto more = hn::Add(windows, hn::IfThenElseZero(strip, windows));
    if (hn::AllTrue(du, hn::Eq(hn::ShiftRight<1>(more), hn::Zero(du)))) {
#if HALFSPACE_AVX512
      const auto lane = hn::Mul(hn::Iota(du, static_cast<std::uint32_t>(group)), hn::Set(du, both));
      const auto drawn = hn::Ne(windows, hn::Zero(du));
      hn::StoreU(hn::Compress(lane, drawn), du, work + count);
      count += hn::CountTrue(du, drawn);
#else
      for (std::size_t i = group; i < group + kLanes; ++i) {
        work[count] = static_cast<std::uint32_t>(i) * both;
        count += batch.windows[i];
      }
#endif
      continue;
    }
    for (std::size_t i = group; i < group + kLanes; ++i) {
      const auto lane = hn::Set(du, static_cast<std::uint32_t>(i) * both);
      for (std::size_t k = 0; k < 16; k += kLanes) {
        hn::StoreU(hn::Add(hn::Load(du, kWork.item[batch.kind[i]] + k), lane), du,
                   work + count + k);
      }
      count += batch.windows[i];
    }
  }
  batch.work[count] = {0, 0, 0, kEndOfWork};
}

template <bool kOne>
HWY_INLINE void do_work(SetupBatch& batch, std::size_t samples, RecordBuffer& buffer) {
  const WorkItem* item = batch.work;
  for (;; ++item) {
    Cursor cursor(buffer);
    for (; item->what == kWindowItem; ++item) {
      window<kOne>(batch, samples, *item, cursor);
      batch.end[item->lane] = static_cast<std::uint32_t>(cursor.count);
    }
    buffer.count = cursor.count;
    if (item->what == kEndOfWork) return;
    strips<kOne>(batch, samples, item->lane, buffer);
    batch.end[item->lane] = static_cast<std::uint32_t>(buffer.count);
    buffer.reserve(buffer.count + kBatchRecords);
  }
}

// The triangles that were drawn, and where their records end.
HWY_INLINE void list_triangles(const SetupBatch& batch, std::uint32_t first, RecordBuffer& buffer) {
  std::size_t count = buffer.triangle_count;
  std::uint32_t* triangle = buffer.triangle.data();
  std::uint32_t* end = buffer.end.data();
#if HALFSPACE_AVX512
  const DU du;
  for (std::size_t i = 0; i < kBatch; i += kLanes) {
    const auto drawn = hn::Ne(hn::Load(du, batch.windows + i), hn::Zero(du));
    const auto index = hn::Iota(du, first + static_cast<std::uint32_t>(i));
    hn::StoreU(hn::Compress(index, drawn), du, triangle + count);
    hn::StoreU(hn::Compress(hn::Load(du, batch.end + i), drawn), du, end + count);
    count += hn::CountTrue(du, drawn);
  }
#else
  for (std::size_t i = 0; i < kBatch; ++i) {
    triangle[count] = first + static_cast<std::uint32_t>(i);
    end[count] = batch.end[i];
    count += batch.windows[i] != 0;
  }
#endif
  buffer.triangle_count = count;
}

// A group's share of the batch after the next; hardware finds the rest of a stream.
HWY_INLINE void prefetch(const Triangle* group) {
  const char* from = reinterpret_cast<const char*>(group + 2 * kBatch);
  for (std::size_t byte = 0; byte < kLanes * sizeof(Triangle); byte += 64) {
    __builtin_prefetch(from + byte);
  }
}

template <bool kOne>
HWY_NOINLINE std::size_t cover(const KernelFrame& frame, std::span<const Triangle> triangles,
                               std::uint32_t first, std::size_t enough, RecordBuffer& buffer,
                               KernelCounts& counts) {
  const DI d;
  SetupBatch batch;
  Triangle padded[kBatch];
  const auto samples = static_cast<std::size_t>(frame.samples);
  std::size_t done = 0;
  while (done < triangles.size() && buffer.count < enough) {
    const Triangle* from = triangles.data() + done;
    const std::size_t lanes = HWY_MIN(kBatch, triangles.size() - done);
    if (lanes < kBatch) {  // fill up with triangles without area
      for (std::size_t i = 0; i < kBatch; ++i) padded[i] = i < lanes ? from[i] : Triangle{};
      from = padded;
      counts.zero_area -= kBatch - lanes;
    }
    VI lowest = hn::Zero(d);
    VI highest = hn::Zero(d);
    for (std::size_t lane = 0; lane < kBatch; lane += kLanes) {
      prefetch(from + lane);
      setup_group<kOne>(frame, from + lane, kWindowRowsLog2, lane, lowest, highest, counts, batch);
    }
    HS_CHECK(hn::AllFalse(d, hn::Lt(lowest, hn::Set(d, frame.coordinate_min))));
    HS_CHECK(hn::AllFalse(d, hn::Gt(highest, hn::Set(d, frame.coordinate_max))));
    if (frame.config.extent_bits != 0) {
      for (std::size_t i = 0; i < lanes; ++i) HS_CHECK(within_extent(from[i], frame.config));
    }
    list_work(batch);
    buffer.reserve(buffer.count + kBatchRecords);
    buffer.reserve_triangles(buffer.triangle_count + kBatch);
    do_work<kOne>(batch, samples, buffer);
    list_triangles(batch, first + static_cast<std::uint32_t>(done), buffer);
    done += lanes;
  }
  counts.triangles += done;
  return done;
}

std::size_t Cover(const KernelFrame& frame, std::span<const Triangle> triangles,
                  std::uint32_t first, std::size_t enough, RecordBuffer& buffer,
                  KernelCounts& counts) {
  return frame.samples == 1 ? cover<true>(frame, triangles, first, enough, buffer, counts)
                            : cover<false>(frame, triangles, first, enough, buffer, counts);
}

}  // namespace halfspace::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
