// SPDX-License-Identifier: Apache-2.0
#include "step_line.hpp"

#include <hwy/cache_control.h>

#include <thread>

#include "../../fixed.hpp"

namespace halfspace {
namespace {

constexpr int kSpins = 4000;  // some tens of microseconds: most steps end sooner

}  // namespace

StepLine::StepLine(Plan plan) : plan_(std::move(plan)) { next(0); }

void StepLine::next(std::uint64_t step) {
  const std::size_t tasks = plan_();
  HS_CHECK(tasks < 1u << 15);
  done_.store(0, std::memory_order_relaxed);
  ticket_.store(step << 32 | std::uint64_t{tasks} << 16, std::memory_order_release);
}

void StepLine::work(const Task& task) {
  for (;;) {
    const std::uint64_t ticket = ticket_.fetch_add(1, std::memory_order_acq_rel);
    const std::uint64_t step = ticket >> 32;
    const std::size_t tasks = ticket >> 16 & 0xffff;
    const std::size_t mine = ticket & 0xffff;
    if (tasks == 0) return;
    if (mine < tasks) {
      try {
        task(mine);
        if (done_.fetch_add(1, std::memory_order_acq_rel) + 1 == tasks) next(step + 1);
      } catch (...) {
        ticket_.store((step + 2) << 32, std::memory_order_release);
        throw;
      }
      continue;
    }
    for (int spin = 0; ticket_.load(std::memory_order_acquire) >> 32 == step; ++spin) {
      spin < kSpins ? hwy::Pause() : std::this_thread::yield();
    }
  }
}

}  // namespace halfspace
