// SPDX-License-Identifier: Apache-2.0
//
// Vectors of lanes to the picture's lines and back, one sample.
#if defined(HALFSPACE_SIMD_FRAME_PIXELS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef HALFSPACE_SIMD_FRAME_PIXELS_INL
#undef HALFSPACE_SIMD_FRAME_PIXELS_INL
#else
#define HALFSPACE_SIMD_FRAME_PIXELS_INL
#endif

#include "../coverage/vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace halfspace::simd::HWY_NAMESPACE {

// A tile in the picture: its first pixel, and from line to line.
struct TilePixels {
  std::uint32_t* first;
  std::size_t stride;  // px

  // Of the first lane of a vector.
  template <int kGridLog2>
  HWY_INLINE std::uint32_t* at(std::size_t lane) const {
    return first + (lane >> kGridLog2) * stride + (lane & ((std::size_t{1} << kGridLog2) - 1));
  }
};

// As many lanes as D has, which are part of a line or several lines.
template <int kGridLog2, class D>
HWY_INLINE hn::Vec<D> load_pixels(D d, const std::uint32_t* at, std::size_t stride) {
  constexpr std::size_t kGrid = std::size_t{1} << kGridLog2;
  if constexpr (hn::MaxLanes(D()) <= kGrid) {
    return hn::Load(d, at);
  } else {
    const hn::Half<D> half;
    const std::uint32_t* const below = at + hn::MaxLanes(half) / kGrid * stride;
    return hn::Combine(d, load_pixels<kGridLog2>(half, below, stride),
                       load_pixels<kGridLog2>(half, at, stride));
  }
}

template <int kGridLog2, class D>
HWY_INLINE void store_pixels(D d, hn::Vec<D> color, std::uint32_t* at, std::size_t stride) {
  constexpr std::size_t kGrid = std::size_t{1} << kGridLog2;
  if constexpr (hn::MaxLanes(D()) <= kGrid) {
    hn::Store(color, d, at);
  } else {
    const hn::Half<D> half;
    store_pixels<kGridLog2>(half, hn::LowerHalf(half, color), at, stride);
    store_pixels<kGridLog2>(half, hn::UpperHalf(half, color),
                            at + hn::MaxLanes(half) / kGrid * stride, stride);
  }
}

}  // namespace halfspace::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
