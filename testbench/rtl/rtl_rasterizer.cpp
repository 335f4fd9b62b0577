// SPDX-License-Identifier: Apache-2.0
#include "rtl_rasterizer.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cstring>
#include <filesystem>
#include <span>
#include <stdexcept>

#include "rtl_build.hpp"
#include "vectors/packets_of.hpp"

namespace halfspace {
namespace {

std::size_t word_count(const Layout& layout) {
  return static_cast<std::size_t>((layout_bits(layout) + 31) / 32);
}

// Never closed: a library with thread-wide objects does not survive it.
const hs_rtl_object* load(const std::filesystem::path& file) {
  void* library = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* symbol = library == nullptr ? nullptr : ::dlsym(library, HS_RTL_OBJECT_SYMBOL);
  if (symbol == nullptr) {
    throw Error(ErrorCode::kRtlBuild, file.string(), fmt::format("cannot load: {}", ::dlerror()));
  }
  const auto* object = reinterpret_cast<decltype(&halfspace_rtl_object)>(symbol)();
  if (object->version == HS_RTL_OBJECT_VERSION) return object;
  throw Error(
      ErrorCode::kRtlBuild, file.string(),
      fmt::format("is an object of version {}, not {}", object->version, HS_RTL_OBJECT_VERSION));
}

struct Constant {
  const char* name;
  std::int64_t value;
};

// The model's side of rtl/hs_pkg.sv.
std::vector<Constant> constants_of(const Config& c) {
  return {{"SUBPIXEL_BITS", c.subpixel_bits},
          {"VIEWPORT_BITS", c.viewport_bits},
          {"GUARD_BITS", c.guard_bits},
          {"EXTENT_BITS", c.extent_bits},
          {"SAMPLES", c.samples},
          {"GRID_LOG2", c.grid_log2},
          {"SETUP_INTERVAL", c.setup_interval},
          {"TAG_BITS", c.tag_bits},
          {"SAMPLE_POSITION_BITS", c.sample_position_bits()},
          {"SAMPLE_BITS", c.sample_bits()},
          {"POSITION_BITS", c.position_bits()},
          {"DROPPED_BITS", c.dropped_bits()},
          {"GRID", c.grid()},
          {"LANES", c.lanes()},
          {"LEVELS", c.levels()},
          {"ROOT_LOG2", c.node_log2(0)},
          {"NARROW_EXTENT", c.narrow_extent() ? 1 : 0},
          {"EXTENT_LOG2", c.extent_log2()},
          {"VERTEX_BITS", c.vertex_bits()},
          {"DELTA_BITS", c.delta_bits()},
          {"AREA_BITS", c.area_bits()},
          {"CONSTANT_BITS", c.constant_bits()},
          {"EDGE_FULL_BITS", c.edge_full_bits()},
          {"EDGE_BITS", c.edge_bits()},
          {"NODE_BASE_BITS", c.node_bits(0)},
          {"ROOT_BITS", c.node_bits(c.node_log2(0))},
          {"LANE_BITS", c.lane_bits()},
          {"REACH_BITS", c.delta_bits()},
          {"INSET_BITS", c.delta_bits() + c.sample_bits()},
          {"TRAVERSAL_BITS", layout_bits(traversal_layout(c))}};
}

void compare_constants(const hs_rtl_object& object, const Config& config) {
  const std::vector<Constant> expected = constants_of(config);
  std::size_t compared = 0;
  for (const hs_rtl_constant* rtl = object.constants; rtl->name != nullptr; ++rtl) {
    for (const Constant& model : expected) {
      if (std::strcmp(model.name, rtl->name) != 0) continue;
      ++compared;
      if (model.value != rtl->value) throw RtlDrift(rtl->name, model.value, rtl->value);
    }
  }
  if (compared != expected.size()) throw std::logic_error("a constant of the RTL is missing");
}

}  // namespace

RtlDrift::RtlDrift(const std::string& name, std::int64_t model, std::int64_t rtl)
    : Error(ErrorCode::kRtlDrift, "rtl",
            fmt::format("the RTL has {} {}, the model {}", name, rtl, model)),
      line_(fmt::format("stage=configuration field={} model={} rtl={}", name, model, rtl)) {}

RtlRasterizer::RtlRasterizer(const Config& config, bool waves, const std::string& place)
    : config_(config),
      frame_layout_(frame_layout(config)),
      triangle_layout_(triangle_layout(config)),
      object_(load(rtl_object_file(config, waves, place))) {
  compare_constants(*object_, config);
  for (const Link link : links(config)) layouts_.push_back(link_layout(link, config));
  rtl_ = object_->create();
}

RtlRasterizer::~RtlRasterizer() { object_->destroy(rtl_); }

void RtlRasterizer::reset(int clocks) {
  object_->reset(rtl_, clocks);
  fires_ = object_->fires(rtl_);
}

void RtlRasterizer::set_frame(const FrameState& frame) {
  object_->set_frame(rtl_, pack(values_of(frame), frame_layout_).data());
}

void RtlRasterizer::drive(const Triangle* triangle, bool ready) {
  if (triangle == nullptr) {
    object_->drive(rtl_, nullptr, ready);
  } else {
    object_->drive(rtl_, pack(values_of(*triangle, config_), triangle_layout_).data(), ready);
  }
  fires_ = object_->fires(rtl_);
}

Values RtlRasterizer::packet(Link link) const {
  const std::size_t index = index_of(link, config_);
  const Layout& layout = layouts_[index];
  PortWords words(word_count(layout));
  object_->read(rtl_, static_cast<int>(index), words.data(), static_cast<int>(words.size()));
  return unpack(words, layout);
}

CoverageTile RtlRasterizer::coverage() const { return coverage_of(packet(kLinkTile), config_); }

void RtlRasterizer::clock() {
  if (object_->clock(rtl_) != 0) throw std::runtime_error("an assertion in the RTL failed");
}

}  // namespace halfspace
