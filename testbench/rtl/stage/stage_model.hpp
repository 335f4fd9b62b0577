// SPDX-License-Identifier: Apache-2.0
//
// Any stage's Verilated class behind StageRtl: the stages differ in the names of two ports.
#pragma once

#include <memory>
#include <stdexcept>

#include "rtl/ports.hpp"
#include "stage.hpp"

namespace halfspace {

template <class Top>
decltype(auto) input_port(Top& top) {
  if constexpr (requires { top.triangle_i; }) {
    return (top.triangle_i);
  } else if constexpr (requires { top.node_i; }) {
    return (top.node_i);
  } else {
    return (top.tile_i);
  }
}

template <class Top>
decltype(auto) output_port(Top& top) {
  if constexpr (requires { top.setup_o; }) {
    return (top.setup_o);
  } else if constexpr (requires { top.node_o; }) {
    return (top.node_o);
  } else if constexpr (requires { top.coverage_o; }) {
    return (top.coverage_o);
  } else if constexpr (requires { top.passed_o; }) {
    return (top.passed_o);
  } else if constexpr (requires { top.group_o; }) {
    return (top.group_o);
  } else {
    return (top.plane_o);
  }
}

template <class Top>
class StageModel final : public StageRtl {
 public:
  explicit StageModel(const Config& config) : config_(config), top_(&context_, "stage") {
    context_.fatalOnError(false);
    reset(2);
  }
  ~StageModel() override { top_.final(); }

  void reset(int clocks) override {
    top_.rst_ni = 0;
    drive(nullptr, false);
    for (int i = 0; i < clocks; ++i) clock();
    top_.rst_ni = 1;
    drive(nullptr, false);
  }
  void set_frame(const FrameState& frame) override {
    if constexpr (requires { top_.frame_i; }) {
      set_port(top_.frame_i, pack(values_of(frame), frame_layout(config_)).data());
    }
  }
  void set_state(const PortWords& state) override {
    if constexpr (requires { top_.state_i; }) set_port(top_.state_i, state.data());
  }
  void drive(const PortWords* packet, bool ready) override {
    top_.valid_i = packet != nullptr;
    if constexpr (kHeldUp) top_.ready_i = ready;
    if (packet != nullptr) set_port(input_port(top_), packet->data());
    top_.clk_i = 0;
    top_.eval();
  }
  bool accepts() const override { return top_.valid_i && top_.ready_o; }
  bool emits() const override {
    if constexpr (kHeldUp) return top_.valid_o && top_.ready_i;
    return top_.valid_o;
  }
  bool busy() const override { return top_.busy_o != 0; }
  PortWords out() const override { return port_words(output_port(top_)); }
  void clock() override {
    top_.clk_i = 1;
    top_.eval();
    context_.timeInc(1);
    if (context_.gotError()) throw std::runtime_error("an assertion in the RTL failed");
  }

 private:
  // Nothing holds up the groups that leave shade.
  static constexpr bool kHeldUp = requires(Top & top) { top.ready_i; };

  Config config_;
  VerilatedContext context_;
  mutable Top top_;
};

template <class Top, const Config& config>
std::unique_ptr<StageRtl> make_stage() {
  return std::make_unique<StageModel<Top>>(config);
}

}  // namespace halfspace
