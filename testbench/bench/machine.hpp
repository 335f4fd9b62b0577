// SPDX-License-Identifier: Apache-2.0
//
// What a time was measured on: ratios of engines differ from one processor family to another.
#pragma once

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <string>

namespace halfspace {

// What the system does not tell is 0 or empty.
struct Machine {
  std::string vendor;
  std::string processor;  // as the system names it
  int family = 0;
  int model = 0;
  std::string isa;             // the best instruction set that the engines have here
  int vector_bits = 0;         // of its registers
  std::uint64_t l2_bytes = 0;  // of one core
  std::uint64_t l3_bytes = 0;  // shared
  int cores = 0;               // that this process may use
  double clock_ghz = 0;        // measured: sums that wait for each other, one a clock
  double load = 0;             // threads that ran or waited, mean of the last minute
};

// The fields that Linux writes down: cpuinfo as /proc/cpuinfo, of its first processor; caches as
// /sys/devices/system/cpu/cpu0/cache.
Machine described_machine(std::istream& cpuinfo, const std::filesystem::path& caches);

// This one, all fields.
Machine this_machine();

// In a line, without its end: what is known.
std::string machine_line(const Machine& machine);

}  // namespace halfspace
