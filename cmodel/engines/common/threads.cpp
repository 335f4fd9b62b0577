// SPDX-License-Identifier: Apache-2.0
#include "threads.hpp"

#include <atomic>
#include <exception>
#include <mutex>

namespace halfspace {
namespace {

struct Job {
  const std::function<void(int)>* body;
  std::mutex mutex;
  std::exception_ptr error;
};

// Orders what is written on one side of tbb_for() before what is read on the other, for all to see.
std::atomic<int> gate = 0;

void run_one(void* context, int i) {
  gate.fetch_add(1, std::memory_order_acq_rel);
  Job& job = *static_cast<Job*>(context);
  try {
    (*job.body)(i);
  } catch (...) {
    const std::lock_guard lock(job.mutex);
    if (!job.error) job.error = std::current_exception();
  }
  gate.fetch_add(1, std::memory_order_acq_rel);
}

}  // namespace

void run_on_threads(int threads, const std::function<void(int)>& body) {
  Job job{&body, {}, {}};
  gate.fetch_add(1, std::memory_order_acq_rel);
  detail::tbb_for(threads > 0 ? threads : detail::tbb_threads(), run_one, &job);
  gate.fetch_add(1, std::memory_order_acq_rel);
  if (job.error) std::rethrow_exception(job.error);
}

}  // namespace halfspace
