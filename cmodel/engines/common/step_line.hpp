// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace halfspace {

// A task queue without barriers, which threads may join late. Tasks of a step may run at the same
// time and in any order; the next step begins when all have ended. A thread waits only for tasks
// that others have begun, so one thread alone gets through, and a late one joins in where the
// others are.
class StepLine {
 public:
  // Called between steps, by one thread at a time: how many tasks the next step has, below 2^15; 0
  // ends the line. Sees everything the tasks before wrote, and every task after sees what it wrote.
  using Plan = std::function<std::size_t()>;
  using Task = std::function<void(std::size_t task)>;

  explicit StepLine(Plan plan);

  // Takes part until the line ends. When a task or the plan throws, the line ends for all, and
  // throws here, in the thread that ran it.
  void work(const Task& task);

 private:
  void next(std::uint64_t step);

  Plan plan_;
  std::atomic<std::uint64_t> ticket_{0};  // step << 32 | its tasks << 16 | the next one to take
  std::atomic<std::size_t> done_{0};      // tasks of this step that have ended
};

}  // namespace halfspace
