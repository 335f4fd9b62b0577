// SPDX-License-Identifier: Apache-2.0
#include "stage_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace halfspace {
namespace {

// Rule 1 of timing.md: when a packet is offered, one after the other.
class Offers {
 public:
  explicit Offers(const Stalls& stalls) : stalls_(stalls), next_(stalls.gap(0)) {}
  std::uint64_t at() const { return next_; }
  void accepted(std::uint64_t clock) { next_ = clock + 1 + stalls_.gap(++count_); }

 private:
  const Stalls& stalls_;
  std::uint64_t count_ = 0;
  std::uint64_t next_;
};

// One run of the RTL with the model's packets and clocks beside it.
class Comparison {
 public:
  Comparison(StageRtl& rtl, const StageRun& run, const std::vector<StagePacket>& packets,
             const Stalls& stalls)
      : rtl_(rtl), run_(run), packets_(packets), stalls_(stalls), offers_(stalls) {
    for (const StagePacket& packet : packets) words_.push_back(pack(packet.in, run.in));
  }

  // Without comparing: so many clocks, then whatever is inside stays there.
  void stir(std::uint64_t clocks) {
    for (std::uint64_t clock = 0; clock < clocks; ++clock) {
      drive(clock);
      if (rtl_.accepts()) accept(clock);
      rtl_.clock();
    }
  }

  std::string compare(const StageClocks& model) {
    std::vector<const Values*> out;
    for (const StagePacket& packet : packets_) {
      for (const Values& values : packet.out) out.push_back(&values);
    }
    const std::uint64_t last = packets_.empty() ? 0 : model.ended.back();
    for (std::uint64_t clock = 0; clock <= last + 16; ++clock) {
      drive(clock);
      const auto where = [&](const char* what, std::size_t packet) {
        return fmt::format("{} packet={} clock={} ", what, packet, clock);
      };
      const bool busy = taken_ > 0 && model.ended[taken_ - 1] >= clock;
      if (rtl_.busy() != busy) return where("busy_o", taken_) + values(busy, rtl_.busy());
      const bool accepts = taken_ < packets_.size() && model.accepted[taken_] == clock;
      if (rtl_.accepts() != accepts) return where("input", taken_) + values(accepts, !accepts);
      const bool emits = given_ < out.size() && model.emitted[given_] == clock;
      if (rtl_.emits() != emits) return where("output", given_) + values(emits, !emits);
      if (emits) {
        Values rtl = unpack(rtl_.out(), run_.out);
        if (run_.clean != nullptr) run_.clean(rtl);
        const std::string difference = first_difference(*out[given_], rtl, run_.out);
        if (!difference.empty()) return where("output", given_) + difference;
        ++given_;
      }
      if (accepts) accept(clock);
      rtl_.clock();
    }
    return taken_ == packets_.size() && given_ == out.size() ? "" : "packets are missing";
  }

 private:
  static std::string values(bool model, bool rtl) {
    return fmt::format("field=clock model={} rtl={}", model ? "now" : "not now",
                       rtl ? "now" : "not now");
  }
  void drive(std::uint64_t clock) {
    const bool offered = taken_ < packets_.size() && clock >= offers_.at();
    rtl_.drive(offered ? &words_[taken_] : nullptr, stalls_.ready(clock));
  }
  void accept(std::uint64_t clock) {
    ++taken_;
    offers_.accepted(clock);
  }

  StageRtl& rtl_;
  const StageRun& run_;
  const std::vector<StagePacket>& packets_;
  const Stalls& stalls_;
  Offers offers_;
  std::vector<PortWords> words_;
  std::size_t taken_ = 0;
  std::size_t given_ = 0;
};

// A row of one-entry registers; a packet without a result ends in the last.
StageClocks register_clocks(const std::vector<StagePacket>& packets, const Stalls& stalls,
                            std::size_t registers) {
  StageClocks clocks;
  Offers offers(stalls);
  std::vector<std::uint64_t> free(registers);
  for (const StagePacket& packet : packets) {
    std::uint64_t t = std::max(offers.at(), free[0]);
    clocks.accepted.push_back(t);
    offers.accepted(t);
    for (std::size_t r = 1; r < registers; ++r) {
      t = std::max(t + 1, free[r]);
      free[r - 1] = t;
    }
    free.back() = packet.out.empty() ? t + 1 : stalls.next_ready(t + 1);
    if (!packet.out.empty()) clocks.emitted.push_back(free.back());
    clocks.ended.push_back(free.back());
  }
  return clocks;
}

}  // namespace

StageClocks triangle_setup_clocks(const std::vector<StagePacket>& packets,
                                  const StageVariant& variant, const Stalls& stalls) {
  StageClocks clocks;
  Offers offers(stalls);
  std::array<std::uint64_t, 7> free{};
  for (const StagePacket& packet : packets) {
    std::uint64_t t = std::max(offers.at(), free[1]);
    clocks.accepted.push_back(t);
    offers.accepted(t);
    t = std::max(t + 1, free[2]) + static_cast<std::uint64_t>(variant.config.setup_interval) - 1;
    free[1] = t;
    for (std::size_t r = 3; r <= 6; ++r) {
      t = std::max(t + 1, free[r]);
      free[r - 1] = t;
    }
    free[6] = packet.out.empty() ? t + 1 : stalls.next_ready(t + 1);
    if (!packet.out.empty()) clocks.emitted.push_back(free[6]);
    clocks.ended.push_back(free[6]);
  }
  return clocks;
}

StageClocks tile_traversal_clocks(const std::vector<StagePacket>& packets,
                                  const StageVariant& variant, const Stalls& stalls) {
  StageClocks clocks;
  Offers offers(stalls);
  // The rule of timing.md once more, not Config's: this file judges the model too.
  const bool buffered = (variant.config.levels() - 1 - variant.level) % 2 == 0;
  std::uint64_t left1 = 0, left1_before = 0, free2 = 0, free3 = 0, free4 = 0, free5 = 0;
  std::size_t entered = 0;
  for (const StagePacket& packet : packets) {
    // Nothing has left the FIFO before its third packet asks.
    const bool full = buffered && entered >= 2;
    std::uint64_t t = std::max(offers.at(), full ? left1_before + 1 : buffered ? 0 : left1);
    ++entered;
    clocks.accepted.push_back(t);
    offers.accepted(t);
    t = std::max(t + 1, free2);
    left1_before = left1;
    left1 = t;
    t = std::max(t + 1, free3);
    free2 = t;
    if (packet.out.empty()) {
      free3 = t + 1;
      clocks.ended.push_back(std::max(free3, clocks.ended.empty() ? 0 : clocks.ended.back()));
      continue;
    }
    t = std::max(t + 1, free4);
    free3 = t;
    for (std::size_t child = 0; child < packet.out.size(); ++child) {
      t = std::max(t + 1, free5);
      free5 = stalls.next_ready(t + 1);
      clocks.emitted.push_back(free5);
    }
    free4 = t;
    clocks.ended.push_back(free5);
  }
  return clocks;
}

StageClocks coverage_clocks(const std::vector<StagePacket>& packets, const StageVariant& variant,
                            const Stalls& stalls) {
  StageClocks clocks;
  Offers offers(stalls);
  std::uint64_t left1 = 0, left1_before = 0, free2 = 0, free3 = 0, free4 = 0;
  std::size_t entered = 0;
  for (const StagePacket& packet : packets) {
    std::uint64_t t = std::max(offers.at(), entered >= 2 ? left1_before + 1 : 0);
    ++entered;
    clocks.accepted.push_back(t);
    offers.accepted(t);
    left1_before = left1;
    if (variant.config.samples > 1) {
      t = std::max(t + 1, free2);
      left1 = t;
      t = std::max(t + 1, free3);
      free2 = t;
    } else {
      t = std::max(t + 1, free3);
      left1 = t;
    }
    t = std::max(t + 1, free4);
    free3 = t;
    free4 = packet.out.empty() ? t + 1 : stalls.next_ready(t + 1);
    if (!packet.out.empty()) clocks.emitted.push_back(free4);
    clocks.ended.push_back(free4);
  }
  return clocks;
}

StageClocks tile_plane_clocks(const std::vector<StagePacket>& packets, const StageVariant&,
                              const Stalls& stalls) {
  return register_clocks(packets, stalls, 3);
}

StageClocks depth_test_clocks(const std::vector<StagePacket>& packets, const StageVariant&,
                              const Stalls& stalls) {
  return register_clocks(packets, stalls, 4);
}

StageClocks shade_clocks(const std::vector<StagePacket>& packets, const StageVariant& variant,
                         const Stalls& stalls) {
  const int bits = variant.config.reciprocal_bits;
  const auto registers = static_cast<std::uint64_t>(8 + (bits % 2 == 0 ? bits / 2 : bits));
  StageClocks clocks;
  Offers offers(stalls);
  std::uint64_t free = 0;
  for (const StagePacket& packet : packets) {
    std::uint64_t t = std::max(offers.at(), free);
    clocks.accepted.push_back(t);
    offers.accepted(t);
    for (std::size_t group = 0; group < packet.out.size(); ++group) {
      clocks.emitted.push_back(++t + registers);
    }
    free = t;
    clocks.ended.push_back(t + registers);
  }
  return clocks;
}

std::string compare_stage(StageRtl& rtl, const StageVariant& variant, const StageRun& run,
                          const std::vector<StagePacket>& packets, const Stalls& stalls,
                          int resets) {
  try {
    for (int i = 0; i < resets; ++i) {
      rtl.reset(1 + i % 3);
      Comparison(rtl, run, packets, stalls).stir(5 + 7 * static_cast<std::uint64_t>(i));
    }
    rtl.reset(1);
    return Comparison(rtl, run, packets, stalls).compare(run.timing(packets, variant, stalls));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

}  // namespace halfspace
