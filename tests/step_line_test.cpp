// SPDX-License-Identifier: Apache-2.0
#include "engines/common/step_line.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

#include "engines/common/threads.hpp"

namespace halfspace {
namespace {

constexpr std::size_t kSteps = 300;
std::size_t tasks_of(std::size_t step) { return 1 + step * 7 % 11; }

// Each task of a step runs once, after all of the step before; plain writes of one step are seen in
// the next.
TEST(StepLine, RunsEveryTaskOnceAndStepsInOrder) {
  for (const int threads : {1, 2, 3, 8}) {
    std::size_t step = 0;  // of the tasks that may run
    std::vector<int> runs;
    std::vector<std::size_t> sums(16, 0);  // one per task, written by whoever runs it
    std::size_t expected = 0;
    bool complete = true;
    StepLine line([&] {
      for (const int count : runs) complete &= count == 1;
      if (step > 0) {
        std::size_t sum = 0;
        for (std::size_t t = 0; t < runs.size(); ++t) sum += std::exchange(sums[t], 0);
        complete &= sum == expected;
      }
      if (step == kSteps) return std::size_t{0};
      runs.assign(tasks_of(step), 0);
      expected = 0;
      for (std::size_t t = 0; t < runs.size(); ++t) expected += step * t + 1;
      ++step;
      return runs.size();
    });
    run_on_threads(threads, [&](int) {
      line.work([&](std::size_t task) {
        ++runs[task];
        sums[task] += (step - 1) * task + 1;
      });
    });
    EXPECT_EQ(kSteps, step) << threads;
    EXPECT_TRUE(complete) << threads;
  }
}

TEST(StepLine, NeedsOnlyTheThreadsThatCome) {
  std::size_t left = 50;
  int ran = 0;
  StepLine line([&] { return left == 0 ? 0 : left-- % 5 + 1; });
  line.work([&](std::size_t) { ++ran; });
  line.work([&](std::size_t) { FAIL() << "the line had ended"; });
  EXPECT_EQ(150, ran);
}

TEST(StepLine, ThreadsShareAStep) {
  int planned = 0;
  StepLine line([&] { return planned++ == 0 ? std::size_t{2} : std::size_t{0}; });
  std::atomic<int> inside = 0;
  const auto task = [&](std::size_t) {  // ends only when both are inside
    ++inside;
    while (inside < 2) std::this_thread::yield();
  };
  std::thread other([&] { line.work(task); });
  line.work(task);
  other.join();
  EXPECT_EQ(2, planned);
}

TEST(StepLine, WhatATaskThrowsEndsTheLineForAll) {
  for (int repeat = 0; repeat < 50; ++repeat) {
    std::size_t steps = 0;
    std::atomic<int> thrown = 0;
    StepLine line([&] { return ++steps, std::size_t{6}; });
    const auto work = [&] {
      try {
        line.work([&](std::size_t task) {
          if (steps == 4 && task == 3) throw std::runtime_error("task");
        });
      } catch (const std::runtime_error&) {
        ++thrown;
      }
    };
    std::thread other(work);
    work();
    other.join();
    EXPECT_EQ(1, thrown);
    EXPECT_EQ(4u, steps);
  }
}

TEST(StepLine, WhatThePlanThrowsEndsIt) {
  std::size_t steps = 0;
  StepLine line([&] { return ++steps < 3 ? std::size_t{2} : throw std::runtime_error("plan"); });
  EXPECT_THROW(line.work([](std::size_t) {}), std::runtime_error);
  line.work([](std::size_t) { FAIL() << "the line had ended"; });
}

}  // namespace
}  // namespace halfspace
