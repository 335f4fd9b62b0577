// SPDX-License-Identifier: Apache-2.0
//
// Packed SystemVerilog structs as bits: fields first to last are the highest bits to the lowest,
// words are 32 bits, least significant first (Verilator's layout of a port).
#pragma once

#include <cstdint>
#include <vector>

namespace halfspace {

class BitReader {
 public:
  // bits: width of the whole struct; word 0 holds bits 31..0.
  BitReader(const std::uint32_t* words, int bits) : words_(words), at_(bits) {}

  // The next field, 1..64 bits.
  std::uint64_t unsigned_bits(int bits) {
    at_ -= bits;
    std::uint64_t value = 0;
    for (int done = 0; done < bits;) {
      const int bit = at_ + done;
      value |= std::uint64_t{words_[bit / 32] >> (bit % 32)} << done;
      done += 32 - bit % 32;
    }
    return bits == 64 ? value : value & ((std::uint64_t{1} << bits) - 1);
  }
  std::int64_t signed_bits(int bits) {
    const std::uint64_t value = unsigned_bits(bits) << (64 - bits);
    return static_cast<std::int64_t>(value) >> (64 - bits);
  }

 private:
  const std::uint32_t* words_;
  int at_;
};

class BitWriter {
 public:
  explicit BitWriter(int bits) : words_(static_cast<std::size_t>((bits + 31) / 32)), at_(bits) {}

  // Appends the low `bits` bits of value, 1..64.
  void put(std::int64_t value, int bits) {
    at_ -= bits;
    for (int i = 0; i < bits; ++i) {
      const auto bit = static_cast<std::size_t>(at_ + i);
      words_[bit / 32] |= static_cast<std::uint32_t>(value >> i & 1) << (bit % 32);
    }
  }
  const std::vector<std::uint32_t>& words() const { return words_; }

 private:
  std::vector<std::uint32_t> words_;
  int at_;
};

}  // namespace halfspace
