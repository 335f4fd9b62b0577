// SPDX-License-Identifier: Apache-2.0
//
// coverage_bench [--scale F] [--repetitions N] [--threads N]... [--isa NAME]... [--no-bit]
//                [WORKLOAD]...
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string_view>

#include "coverage_bench.hpp"

int main(int argc, char** argv) {
  halfspace::BenchOptions options;
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    const char* value = i + 1 < argc ? argv[i + 1] : "";
    if (argument == "--no-bit") {
      options.bit = false;
    } else if (argument == "--scale") {
      options.scale = std::atof(value), ++i;
    } else if (argument == "--repetitions") {
      options.repetitions = std::atoi(value), ++i;
    } else if (argument == "--threads") {
      options.threads.push_back(std::atoi(value)), ++i;
    } else if (argument == "--isa") {
      options.isas.emplace_back(value), ++i;
    } else {
      options.workloads.emplace_back(argument);
    }
  }
  try {
    std::fputs(halfspace::bench_table(halfspace::run_coverage_bench(options)).c_str(), stdout);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "coverage_bench: %s\n", error.what());
    return 1;
  }
  return 0;
}
