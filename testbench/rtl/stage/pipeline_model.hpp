// SPDX-License-Identifier: Apache-2.0
//
// The Verilated class of any rigid pipeline behind PipelineRtl. Without valid_i and valid_o it is a
// function with a latency.
#pragma once

#include <memory>
#include <stdexcept>

#include "rtl/ports.hpp"
#include "stage.hpp"

namespace halfspace {

template <class Top>
decltype(auto) pipeline_input(Top& top) {
  if constexpr (requires { top.mantissa_i; }) {
    return (top.mantissa_i);
  } else if constexpr (requires { top.gradient_i; }) {
    return (top.gradient_i);
  } else {
    return (top.triangle_i);
  }
}

template <class Top>
decltype(auto) pipeline_output(Top& top) {
  if constexpr (requires { top.reciprocal_o; }) {
    return (top.reciprocal_o);
  } else {
    return (top.plane_o);
  }
}

// Which of two outputs is looked at: plane_o with valid_o, or area_o with area_valid_o.
enum class PipelineOutput : std::uint8_t { kPlane, kArea };

template <class Top, PipelineOutput output>
class PipelineModel final : public PipelineRtl {
 public:
  PipelineModel() : top_(&context_, "stage") {
    context_.fatalOnError(false);
    reset();
  }
  ~PipelineModel() override { top_.final(); }

  void reset() override {
    if constexpr (requires { top_.rst_ni; }) {
      top_.rst_ni = 0;
      edge();
      top_.rst_ni = 1;
    }
  }
  std::optional<PortWords> clock(const PortWords* packet, const PortWords& noise) override {
    set_port(pipeline_input(top_), packet != nullptr ? packet->data() : noise.data());
    if constexpr (requires { top_.valid_i; }) top_.valid_i = packet != nullptr;
    top_.clk_i = 0;
    top_.eval();
    std::optional<PortWords> out;
    if constexpr (output == PipelineOutput::kArea) {
      if (top_.area_valid_o) out = port_words(top_.area_o);
    } else {
      out = port_words(pipeline_output(top_));
    }
    if constexpr (output == PipelineOutput::kPlane && requires { top_.valid_o; }) {
      if (!top_.valid_o) out.reset();
    }
    edge();
    return out;
  }

 private:
  void edge() {
    for (const std::uint8_t level : {0, 1}) {
      top_.clk_i = level;
      top_.eval();
    }
    context_.timeInc(1);
    if (context_.gotError()) throw std::runtime_error("an assertion in the RTL failed");
  }

  VerilatedContext context_;
  Top top_;
};

template <class Top, PipelineOutput output = PipelineOutput::kPlane>
std::unique_ptr<PipelineRtl> make_pipeline() {
  return std::make_unique<PipelineModel<Top, output>>();
}

}  // namespace halfspace
