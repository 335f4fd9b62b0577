// SPDX-License-Identifier: Apache-2.0
#include "machine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <istream>
#include <map>
#include <thread>

#include "engines/coverage/coverage_engine.hpp"

namespace halfspace {
namespace {

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\n") + 1 - first);
}

// "1024K" or "32M" as bytes; 0 for anything else.
std::uint64_t bytes_of(const std::string& size) {
  char* unit = nullptr;
  const std::uint64_t count = std::strtoull(size.c_str(), &unit, 10);
  if (*unit == 'K') return count << 10;
  if (*unit == 'M') return count << 20;
  return 0;
}

std::string first_word(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string word;
  in >> word;
  return word;
}

std::uint64_t cache_bytes(const std::filesystem::path& caches, const std::string& level) {
  for (int i = 0; i < 8; ++i) {
    const std::filesystem::path cache = caches / fmt::format("index{}", i);
    if (first_word(cache / "level") != level || first_word(cache / "type") == "Instruction") {
      continue;
    }
    return bytes_of(first_word(cache / "size"));
  }
  return 0;
}

int vector_bits_of(const std::string& isa) {
  if (isa.starts_with("avx3")) return 512;
  if (isa == "avx2") return 256;
  return isa == "scalar" ? 64 : 128;
}

// Each sum waits for the one before, and takes a clock on every processor of today.
double measured_ghz() {
  constexpr int kSums = 1 << 20;
  double best = 0;
  for (int run = 0; run < 5; ++run) {
    const auto start = std::chrono::steady_clock::now();
    std::uint64_t sum = 1;
    for (int i = 0; i < kSums; ++i) {
      sum += sum;
      asm volatile("" : "+r"(sum));  // the compiler adds nothing up itself
    }
    const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - start;
    best = std::max(best, kSums / took.count());
  }
  return best;
}

}  // namespace

Machine described_machine(std::istream& cpuinfo, const std::filesystem::path& caches) {
  std::map<std::string, std::string> first;
  for (std::string line; std::getline(cpuinfo, line) && !line.empty();) {
    const std::size_t colon = line.find(':');
    if (colon != std::string::npos) {
      first.emplace(trimmed(line.substr(0, colon)), trimmed(line.substr(colon + 1)));
    }
  }
  Machine out;
  out.vendor = first["vendor_id"];
  out.processor = first["model name"];
  out.family = std::atoi(first["cpu family"].c_str());
  out.model = std::atoi(first["model"].c_str());
  out.l2_bytes = cache_bytes(caches, "2");
  out.l3_bytes = cache_bytes(caches, "3");
  return out;
}

Machine this_machine() {
  std::ifstream cpuinfo("/proc/cpuinfo");
  Machine out = described_machine(cpuinfo, "/sys/devices/system/cpu/cpu0/cache");
  out.isa = coverage_isas().front();
  out.vector_bits = vector_bits_of(out.isa);
  out.cores = static_cast<int>(std::thread::hardware_concurrency());
  out.clock_ghz = measured_ghz();
  double load = 0;
  if (getloadavg(&load, 1) == 1) out.load = load;
  return out;
}

std::string machine_line(const Machine& machine) {
  std::string line = machine.processor.empty() ? "unknown processor" : machine.processor;
  if (machine.family != 0)
    line += fmt::format(" family {} model {}", machine.family, machine.model);
  line += fmt::format(", {} ({}-bit vectors)", machine.isa, machine.vector_bits);
  const auto add = [&](const char* name, std::uint64_t bytes) {
    if (bytes != 0)
      line += fmt::format(", {} {:.3g} MB", name, static_cast<double>(bytes) / 1048576);
  };
  add("L2", machine.l2_bytes);
  add("L3", machine.l3_bytes);
  return line + fmt::format(", {} cores at {:.2f} GHz, load {:.2f}", machine.cores,
                            machine.clock_ghz, machine.load);
}

}  // namespace halfspace
