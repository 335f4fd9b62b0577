// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "Vstage_grid_full.h"
#include "Vstage_grid_tiny.h"
#include "Vstage_grid_tiny_2.h"
#include "rtl/ports.hpp"
#include "stage.hpp"

namespace halfspace {
namespace {

template <class Top>
class Model final : public GridRtl {
 public:
  explicit Model(const Config& config) : config_(config), top_(&context_, "grid") {}
  ~Model() override { top_.final(); }

  void clock(std::int64_t base, EdgeSlope slope, bool load) override {
    const Layout one{{"base", config_.lane_bits(), true}};
    const Layout two{{"a", config_.delta_bits(), true}, {"b", config_.delta_bits(), true}};
    set_port(top_.base_i, pack({base}, one).data());
    set_port(top_.slope_i, pack({slope.a, slope.b}, two).data());
    top_.load_i = load;
    for (const std::uint8_t level : {0, 1}) {
      top_.clk_i = level;
      top_.eval();
    }
  }
  GridMask covered() const override { return static_cast<GridMask>(top_.covered_o); }
  std::int64_t ab() const override {
    return unpack(port_words(top_.ab_o), {{"ab", config_.delta_bits() + 1, true}})[0];
  }

 private:
  Config config_;
  VerilatedContext context_;
  mutable Top top_;
};

template <class Top, const Config& config>
std::unique_ptr<GridRtl> make() {
  return std::make_unique<Model<Top>>(config);
}
const std::array kVariants{GridVariant{"tiny", kTiny, 4, make<Vstage_grid_tiny, kTiny>},
                           GridVariant{"tiny", kTiny, 2, make<Vstage_grid_tiny_2, kTiny>},
                           GridVariant{"full", kFull, 8, make<Vstage_grid_full, kFull>}};

}  // namespace

std::span<const GridVariant> half_plane_grid_stages() { return kVariants; }

}  // namespace halfspace
