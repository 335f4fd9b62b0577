// SPDX-License-Identifier: Apache-2.0
//
// A rigid pipeline of the RTL against the model: packets with and without gaps, each result
// compared in the clock in which it is due.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "rtl/stage/stage.hpp"
#include "vectors/generators.hpp"

namespace halfspace {

struct PipelinePacket {
  Values in;
  Values out;
};

// Packets enter `interval` clocks apart at least, with gaps of up to three clocks more in a second
// run. has_valid: the module says when a result stands at its output, so it must be then alone.
inline void expect_pipeline(const PipelineVariant& variant, const Layout& in, const Layout& out,
                            const std::vector<PipelinePacket>& packets, int interval,
                            bool has_valid, std::uint64_t seed) {
  const std::unique_ptr<PipelineRtl> rtl = variant.make();
  for (const bool gaps : {false, true}) {
    rtl->reset();
    Random random(seed);
    const auto latency = static_cast<std::size_t>(variant.latency);
    std::vector<const PipelinePacket*> entered;  // one a clock
    const auto clock = [&](const PipelinePacket* packet) {
      PortWords noise(static_cast<std::size_t>((layout_bits(in) + 31) / 32));
      for (std::uint32_t& word : noise) word = static_cast<std::uint32_t>(random.next());
      noise = pack(unpack(noise, in), in);  // no bits beyond the port's
      const PortWords words = packet != nullptr ? pack(packet->in, in) : noise;
      const auto result = rtl->clock(packet != nullptr ? &words : nullptr, noise);
      const std::size_t now = entered.size();
      entered.push_back(packet);
      const PipelinePacket* due = now >= latency ? entered[now - latency] : nullptr;
      if (has_valid) {
        ASSERT_EQ(result.has_value(), due != nullptr) << variant.name << " clock " << now;
      }
      if (due == nullptr) return;
      ASSERT_EQ(first_difference(due->out, unpack(*result, out), out), "")
          << variant.name << " clock " << now << (gaps ? ", with gaps" : "") << ", seed " << seed;
    };
    const auto idle = [&](std::int64_t clocks) {
      for (; clocks > 0 && !testing::Test::HasFatalFailure(); --clocks) clock(nullptr);
    };
    for (const PipelinePacket& packet : packets) {
      clock(&packet);
      idle(interval - 1 + (gaps ? random.in(0, 3) : 0));
      if (testing::Test::HasFatalFailure()) return;
    }
    idle(variant.latency + 1);
  }
}

}  // namespace halfspace
