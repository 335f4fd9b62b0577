// SPDX-License-Identifier: Apache-2.0
//
// A Verilated port of any width as 32-bit words, least significant first; as many as it needs.
#pragma once

#include <verilated.h>

#include <cstdint>
#include <vector>

namespace halfspace {

template <class Port>
std::vector<std::uint32_t> port_words(const Port& port) {
  const auto value = static_cast<std::uint64_t>(port);
  if constexpr (sizeof(Port) <= 4) return {static_cast<std::uint32_t>(value)};
  return {static_cast<std::uint32_t>(value), static_cast<std::uint32_t>(value >> 32)};
}
template <std::size_t N>
std::vector<std::uint32_t> port_words(const VlWide<N>& port) {
  return {port.data(), port.data() + N};
}

template <class Port>
void set_port(Port& port, const std::uint32_t* words) {
  std::uint64_t value = words[0];
  if constexpr (sizeof(Port) > 4) value |= std::uint64_t{words[1]} << 32;
  port = static_cast<Port>(value);
}
template <std::size_t N>
void set_port(VlWide<N>& port, const std::uint32_t* words) {
  for (std::size_t i = 0; i < N; ++i) port[i] = words[i];
}

}  // namespace halfspace
