// SPDX-License-Identifier: Apache-2.0
#include "agreement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace halfspace {
namespace {

std::string name_of(const BenchRow& row) {
  return fmt::format("{} {} {} {} threads, {} {}", row.engine, row.isa, row.work, row.threads,
                     row.workload, row.size);
}

}  // namespace

Agreement::Agreement(const std::string& workload, const MaskSum& masks) : masks_(masks) {
  if (masks_.samples == 0) {
    throw BenchMismatch("nothing was compared: " + workload + " covers nothing");
  }
}

void Agreement::check(BenchRow& row, const BenchOutput& output) {
  if (output.samples != masks_.samples) {
    throw BenchMismatch(fmt::format("{}: covers {} samples, the plain loop {}", name_of(row),
                                    output.samples, masks_.samples));
  }
  if (output.masks && *output.masks != masks_) {
    throw BenchMismatch(name_of(row) + ": other masks than the plain loop's");
  }
  row.covered_samples = output.samples;
  row.clocks = output.clocks;
  if (output.clocks && !clocks_) clocks_ = output.clocks;
  if (output.clocks && *output.clocks != *clocks_) {
    throw BenchMismatch(fmt::format("{}: {} clocks, the engines before it {}", name_of(row),
                                    *output.clocks, *clocks_));
  }
  if (output.hits && !hits_) hits_ = output.hits;
  if (output.hits && *output.hits != *hits_) {
    throw BenchMismatch(name_of(row) + ": other hits per pixel than the engines before it");
  }
  if (output.picture) compare(row, *output.picture);
}

void Agreement::compare(BenchRow& row, const Image& picture) {
  if (!picture_) {
    picture_ = picture;
    return;
  }
  if (row.engine != "llvmpipe") {
    if (picture.pixel != picture_->pixel) {
      throw BenchMismatch(name_of(row) + ": another picture than the engines before it");
    }
    return;
  }
  row.pixels_off = 0;
  row.largest_difference = 0;
  for (std::size_t i = 0; i < picture.pixel.size(); ++i) {
    int most = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      most = std::max(most, std::abs(picture.pixel[i][c] - picture_->pixel[i][c]));
    }
    *row.pixels_off += most > 1 ? 1u : 0u;
    row.largest_difference = std::max(*row.largest_difference, most);
  }
  // Depths that differ in their last bits may show another of two surfaces, at a few pixels.
  if (*row.pixels_off * 100 > picture.pixel.size()) {
    throw BenchMismatch(fmt::format("{}: {} pixels are more than one level off engine bit's",
                                    name_of(row), *row.pixels_off));
  }
}

}  // namespace halfspace
