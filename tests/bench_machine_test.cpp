// SPDX-License-Identifier: Apache-2.0
//
// What the bench says of the machine, from what Linux writes about it.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "bench/machine.hpp"

namespace halfspace {
namespace {

// A folder of caches as the kernel writes it, gone at the end.
class Caches : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  void add(const char* index, const char* level, const char* type, const char* size) {
    const std::filesystem::path cache = folder_ / index;
    std::filesystem::create_directories(cache);
    std::ofstream(cache / "level") << level << '\n';
    std::ofstream(cache / "type") << type << '\n';
    std::ofstream(cache / "size") << size << '\n';
  }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("caches_" + std::to_string(::getpid()));
};

TEST_F(Caches, AreReadBesideTheProcessor) {
  add("index0", "1", "Data", "32K");
  add("index1", "2", "Instruction", "77K");
  add("index2", "2", "Unified", "1024K");
  add("index3", "3", "Unified", "32M");
  std::istringstream cpuinfo(
      "processor\t: 0\nvendor_id\t: AuthenticAMD\ncpu family\t: 25\nmodel\t\t: 17\n"
      "model name\t: AMD EPYC 9B14\nflags\t\t: fpu: no\n\n"
      "processor\t: 1\ncpu family\t: 26\n");
  const Machine machine = described_machine(cpuinfo, folder_);
  EXPECT_EQ("AuthenticAMD", machine.vendor);
  EXPECT_EQ("AMD EPYC 9B14", machine.processor);
  EXPECT_EQ(25, machine.family);
  EXPECT_EQ(17, machine.model);
  EXPECT_EQ(1048576u, machine.l2_bytes);
  EXPECT_EQ(33554432u, machine.l3_bytes);
  EXPECT_NE(machine_line(machine).find("AMD EPYC 9B14 family 25 model 17"), std::string::npos);
  EXPECT_NE(machine_line(machine).find(", L2 1 MB, L3 32 MB, "), std::string::npos);
}

TEST_F(Caches, MayBeMissingAndTheProcessorUnknown) {
  add("index0", "2", "Unified", "unknown");
  std::istringstream arm("processor\t: 0\nCPU implementer\t: 0x41\nno colon\n");
  const Machine machine = described_machine(arm, folder_);
  EXPECT_EQ(0, machine.family);
  EXPECT_EQ(0u, machine.l2_bytes);
  EXPECT_EQ(0u, machine.l3_bytes);
  EXPECT_EQ(0u, machine_line(machine).find("unknown processor, "));
}

TEST(Machine, ThisOneHasVectorsCoresAndAClock) {
  const Machine machine = this_machine();
  EXPECT_FALSE(machine.isa.empty());
  EXPECT_GE(machine.vector_bits, 64);
  EXPECT_GE(machine.cores, 1);
  EXPECT_GT(machine.clock_ghz, 0.1);
  EXPECT_LT(machine.clock_ghz, 10);
  EXPECT_GE(machine.load, 0);
}

}  // namespace
}  // namespace halfspace
