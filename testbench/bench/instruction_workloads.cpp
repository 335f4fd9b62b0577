// SPDX-License-Identifier: Apache-2.0
//
// Fixed small work, to have its instructions counted by valgrind: each workload runs once inside
// halfspace_counted_work(), which callgrind is told to count and to report on. Prints the names in
// that order, after a line with what the counts depend on. tests/instruction_baseline_test.py.
#include <hwy/base.h>
#include <hwy/highway.h>

#include <cstdio>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "engines/coverage/coverage_engine.hpp"
#include "engines/cycle/cycle_engine.hpp"
#include "entry.hpp"
#include "workload.hpp"

// Found by its name, so it has one without a namespace.
extern "C" [[gnu::noinline]] void halfspace_counted_work(const std::function<void()>& work) {
  work();
}

namespace halfspace {
namespace {

constexpr std::pair<const char*, double> kWorkloads[] = {
    {"small", 0.002}, {"medium", 0.005}, {"large", 0.004}, {"sliver", 0.01}};

void count(const std::string& name, const std::function<void()>& work) {
  std::printf("%s\n", name.c_str());
  halfspace_counted_work(work);
}

void count_entries(const Workload& work, const std::vector<BenchEntry>& entries) {
  for (const BenchEntry& entry : entries) {
    count(work.name + ' ' + entry.row.work + ' ' + entry.row.engine + ' ' + entry.row.isa,
          entry.run);
  }
}

void count_all() {
  for (const auto& [name, scale] : kWorkloads) {
    const Workload work = make_workload(name, scale);
    count_entries(work, coverage_entries(work, {}));
  }
  const Workload scene = make_scene_workload("million", 320, 240, "", 0.002);
  count("million geometry", [] { make_scene_workload("million", 320, 240, "", 0.002); });
  count_entries(scene, frame_entries(scene, {}));
}

}  // namespace
}  // namespace halfspace

int main() {
#ifdef __clang__
  constexpr const char* kCompiler = "Clang " __clang_version__;
#else
  constexpr const char* kCompiler = "GCC " __VERSION__;
#endif
  std::printf("%s, Highway %d.%d.%d\n", kCompiler, HWY_MAJOR, HWY_MINOR, HWY_PATCH);
  halfspace::count_all();
  return 0;
}
