// SPDX-License-Identifier: Apache-2.0
//
// Accessors: of every component type, interleaved, sparse, normalized, or of nothing but zeros.
#include <algorithm>
#include <array>
#include <bit>
#include <limits>

#include "../io/scan.hpp"
#include "gltf_file.hpp"

namespace halfspace {
namespace {

using nlohmann::json;

// Elements that an accessor without data may have: they take memory, but no file.
constexpr std::uint64_t kMostZeros = 1U << 22;

enum ComponentType : std::uint64_t {
  kInt8 = 5120,
  kUint8 = 5121,
  kInt16 = 5122,
  kUint16 = 5123,
  kUint32 = 5125,
  kFloat = 5126,
};

std::size_t component_size(std::uint64_t type) {
  switch (type) {
    case kInt8:
    case kUint8: return 1;
    case kInt16:
    case kUint16: return 2;
    case kUint32:
    case kFloat: return 4;
    default: return 0;
  }
}

double component(std::string_view bytes, std::uint64_t type) {
  std::uint32_t bits = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) {
    bits = bits << 8 | static_cast<std::uint8_t>(bytes[i]);
  }
  switch (type) {
    case kInt8: return static_cast<std::int8_t>(bits);
    case kInt16: return static_cast<std::int16_t>(bits);
    case kFloat: return static_cast<double>(std::bit_cast<float>(bits));
    default: return bits;
  }
}

// What a normalized integer is divided by.
double unit_of(std::uint64_t type) {
  switch (type) {
    case kInt8: return 127.0;
    case kUint8: return 255.0;
    case kInt16: return 32767.0;
    case kUint16: return 65535.0;
    case kUint32: return 4294967295.0;
    default: return 1.0;
  }
}

}  // namespace

GltfFile::Layout GltfFile::layout(std::size_t accessor) const {
  static constexpr std::array<std::pair<const char*, std::size_t>, 7> kTypes{{{"SCALAR", 1},
                                                                              {"VEC2", 2},
                                                                              {"VEC3", 3},
                                                                              {"VEC4", 4},
                                                                              {"MAT2", 4},
                                                                              {"MAT3", 9},
                                                                              {"MAT4", 16}}};
  const json& object = list("accessors")[accessor];
  Layout layout;
  layout.type = whole(object, "componentType", 0);
  layout.size = component_size(layout.type);
  const auto flag = object.find("normalized");
  layout.normalized = flag != object.end() && flag->is_boolean() && flag->get<bool>();
  const auto type = object.find("type");
  for (const auto& [name, components] : kTypes) {
    if (type != object.end() && *type == name) layout.components = components;
  }
  if (layout.size == 0 || layout.components == 0) {
    fail("accessor " + std::to_string(accessor) + " has an unknown type");
  }
  return layout;
}

std::size_t GltfFile::components(std::size_t accessor) const { return layout(accessor).components; }

std::uint64_t GltfFile::count(std::size_t accessor) const {
  const json& object = list("accessors")[accessor];
  const std::uint64_t count = whole(object, "count", 0);
  const bool has_data = object.contains("bufferView");
  if (count > (has_data ? std::numeric_limits<std::uint32_t>::max() - 1 : kMostZeros)) {
    fail("accessor " + std::to_string(accessor) + " has too many elements");
  }
  return count;
}

GltfFile::View GltfFile::view(std::size_t at) {
  const json& object = list("bufferViews")[at];
  const std::string_view bytes = buffer(index(object, "buffer", "buffers"));
  const std::uint64_t offset = whole(object, "byteOffset", 0);
  const std::uint64_t length = whole(object, "byteLength", 0);
  if (offset > bytes.size() || length > bytes.size() - offset) {
    fail("bufferView " + std::to_string(at) + " reaches beyond its buffer");
  }
  return {bytes.substr(offset, length), whole(object, "byteStride", 0)};
}

GltfFile::View GltfFile::elements(const json& object, std::uint64_t count, std::size_t size,
                                  const std::string& name) {
  View found = view(index(object, "bufferView", "bufferViews"));
  if (found.stride == 0) found.stride = size;
  const std::uint64_t offset = whole(object, "byteOffset", 0);
  const std::uint64_t available =
      found.bytes.size() - std::min<std::uint64_t>(offset, found.bytes.size());
  // Neither count * stride nor the sum need fit 64 bits.
  if (count != 0 && (available < size || (available - size) / found.stride < count - 1)) {
    fail(name + " reaches beyond its bufferView");
  }
  found.bytes.remove_prefix(found.bytes.size() - available);
  return found;
}

void GltfFile::require_data(std::size_t accessor) {
  const json& object = list("accessors")[accessor];
  const Layout layout = this->layout(accessor);
  if (!object.contains("bufferView")) return;
  elements(object, count(accessor), layout.components * layout.size,
           "accessor " + std::to_string(accessor));
}

// Calls take(element, component, value) for the first `wanted` components of all elements that the
// accessor has data for; for those that a sparse one replaces once more.
template <class Take>
void GltfFile::each(std::size_t accessor, std::size_t wanted, const Take& take) {
  const json& object = list("accessors")[accessor];
  const std::string name = "accessor " + std::to_string(accessor);
  const Layout layout = this->layout(accessor);
  const std::size_t size = layout.components * layout.size;
  const std::size_t used = std::min(wanted, layout.components);
  const auto take_all = [&](const View& from, std::uint64_t i, std::uint64_t element) {
    for (std::size_t c = 0; c < used; ++c) {
      const std::string_view bytes =
          from.bytes.substr(i * from.stride + c * layout.size, layout.size);
      take(static_cast<std::size_t>(element), c, component(bytes, layout.type));
    }
  };
  const std::uint64_t total = count(accessor);
  if (object.contains("bufferView") && total != 0) {
    const View from = elements(object, total, size, name);
    for (std::uint64_t i = 0; i < total; ++i) take_all(from, i, i);
  }
  if (!object.contains("sparse")) return;
  const json& sparse = object["sparse"];
  const std::uint64_t replaced = whole(sparse, "count", 0);
  const json parts = json::object();
  const json at = sparse.value("indices", parts), values = sparse.value("values", parts);
  const std::uint64_t type = whole(at, "componentType", 0);
  if (replaced > total || (type != kUint8 && type != kUint16 && type != kUint32)) {
    fail(name + " is sparse, but not as the format says");
  }
  if (replaced == 0) return;
  const View places = elements(at, replaced, component_size(type), name);
  const View from = elements(values, replaced, size, name);
  for (std::uint64_t i = 0; i < replaced; ++i) {
    const std::string_view bytes = places.bytes.substr(i * places.stride, component_size(type));
    const auto element = static_cast<std::uint64_t>(component(bytes, type));
    if (element >= total) fail(name + " replaces an element that is not there");
    take_all(from, i, element);
  }
}

std::vector<float> GltfFile::floats(std::size_t accessor, std::size_t components, bool as_unit) {
  const Layout layout = this->layout(accessor);
  const bool scaled = layout.normalized || as_unit;
  const double unit = scaled ? unit_of(layout.type) : 1.0;
  require_data(accessor);
  std::vector<float> out(count(accessor) * components, 0.0F);
  each(accessor, components, [&](std::size_t element, std::size_t c, double value) {
    // -128 and -32768 are -1 too.
    const double scaled_value = scaled && value < -unit && unit > 1.0 ? -1.0 : value / unit;
    out[element * components + c] = static_cast<float>(scaled_value);
  });
  return out;
}

std::vector<std::uint32_t> GltfFile::indices(std::size_t accessor) {
  const Layout layout = this->layout(accessor);
  if (layout.components != 1 || layout.type == kFloat || layout.type == kInt8 ||
      layout.type == kInt16) {
    fail("accessor " + std::to_string(accessor) + " is no list of indices");
  }
  require_data(accessor);
  std::vector<std::uint32_t> out(count(accessor), 0);
  each(accessor, 1, [&out](std::size_t element, std::size_t, double value) {
    out[element] = static_cast<std::uint32_t>(value);
  });
  return out;
}

}  // namespace halfspace
