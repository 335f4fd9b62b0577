// SPDX-License-Identifier: Apache-2.0
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <cstddef>

#include "threads.hpp"

namespace halfspace::detail {

void tbb_for(int threads, void (*call)(void* context, int i), void* context) {
  // More threads than cores are legal, and tests want them.
  const tbb::global_control allow(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);
  arena.execute([=] {
    const auto one = [=](int i) { call(context, i); };
    tbb::parallel_for(0, threads, one, tbb::simple_partitioner());
  });
}

int tbb_threads() { return tbb::this_task_arena::max_concurrency(); }

}  // namespace halfspace::detail
