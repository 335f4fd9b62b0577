// SPDX-License-Identifier: Apache-2.0
//
// The one door to TBB.
#pragma once

#include <functional>

namespace halfspace {

// Calls body(0) .. body(threads - 1), each once, on up to as many threads, and returns when all are
// done. What was written before the call is seen by every body, and what they wrote by the caller.
// Rethrows what the first failing body threw, after all of them have ended.
//
//   threads  0 or less: as many as the machine has
//
// Bodies may run one after another, so none may wait for one that has not begun. Everything that
// bodies share needs a mutex or an atomic of its own.
void run_on_threads(int threads, const std::function<void(int)>& body);

namespace detail {

// TBB's part: call(context, i) for every i. Compiled without the thread sanitizer, which does not
// see the synchronisation inside TBB's library and would take its hand-overs for races.
void tbb_for(int threads, void (*call)(void* context, int i), void* context);
int tbb_threads();

}  // namespace detail
}  // namespace halfspace
