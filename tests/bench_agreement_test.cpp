// SPDX-License-Identifier: Apache-2.0
//
// The bench's figures are of equal work: whatever differs is found.
#include <gtest/gtest.h>

#include "bench/agreement.hpp"

namespace halfspace {
namespace {

MaskSum two_tiles() {
  MaskSum sum;
  sum.add(3, 5, 0xff);
  sum.add(4, 5, 0x0f);
  return sum;
}

BenchRow row_of(const char* engine) {
  BenchRow row;
  row.engine = engine;
  return row;
}

// 20 x 20 px, all of them `level`.
Image grey(std::uint8_t level) { return {20, 20, std::vector<Rgb>(400, Rgb{level, level, level})}; }

BenchOutput output(const MaskSum& masks) { return {masks.samples, masks, {}, {}, {}}; }

class Agreed : public testing::Test {
 protected:
  void accept(const BenchOutput& found, const char* engine = "coverage") {
    BenchRow row = row_of(engine);
    EXPECT_NO_THROW(agreement_.check(row, found));
    last_ = row;
  }
  void refuse(const BenchOutput& found, const char* engine = "coverage") {
    BenchRow row = row_of(engine);
    EXPECT_THROW(agreement_.check(row, found), BenchMismatch);
  }

  Agreement agreement_{"test", two_tiles()};
  BenchRow last_;
};

TEST_F(Agreed, OrderOfTilesDoesNotMatter) {
  MaskSum other;
  other.add(4, 5, 0x0f);
  other.add(3, 5, 0xff);
  accept(output(other));
  EXPECT_EQ(last_.covered_samples, 12U);
}

TEST_F(Agreed, AsManySamplesInOtherPlacesAreFound) {
  MaskSum moved;
  moved.add(3, 5, 0xff);
  moved.add(4, 5, 0xf0);
  refuse(output(moved));
  MaskSum elsewhere;
  elsewhere.add(5, 3, 0xff);
  elsewhere.add(4, 5, 0x0f);
  refuse(output(elsewhere));
  MaskSum swapped;
  swapped.add(4, 5, 0xff);
  swapped.add(3, 5, 0x0f);
  refuse(output(swapped));
}

TEST_F(Agreed, OtherNumbersOfSamplesAreFound) {
  refuse({11, {}, {}, {}, {}});
  refuse({13, {}, {}, {}, {}});
  accept({12, {}, {}, {}, {}});
}

TEST_F(Agreed, OtherClocksAreFound) {
  accept({12, {}, 100, {}, {}});
  EXPECT_EQ(last_.clocks, 100U);
  accept({12, {}, 100, {}, {}});
  refuse({12, {}, 101, {}, {}});
}

TEST_F(Agreed, OtherHitsAreFound) {
  accept({12, {}, {}, {}, std::vector<std::uint8_t>{0, 1, 2}});
  accept({12, {}, {}, {}, std::vector<std::uint8_t>{0, 1, 2}}, "llvmpipe");
  refuse({12, {}, {}, {}, std::vector<std::uint8_t>{0, 2, 1}}, "llvmpipe");
}

TEST_F(Agreed, OurPicturesMustBeTheSameBytes) {
  accept({12, {}, {}, grey(100), {}}, "bit");
  accept({12, {}, {}, grey(100), {}}, "bit");
  Image other = grey(100);
  other.at(7, 7)[2] = 101;
  refuse({12, {}, {}, other, {}}, "bit");
}

TEST_F(Agreed, TheDriversPictureMayDifferAtOnePixelInAHundred) {
  accept({12, {}, {}, grey(100), {}}, "bit");
  accept({12, {}, {}, grey(101), {}}, "llvmpipe");
  EXPECT_EQ(last_.pixels_off, 0U);
  EXPECT_EQ(last_.largest_difference, 1);
  Image other = grey(100);
  for (int x = 0; x < 4; ++x) other.at(x, 0)[1] = 90;
  accept({12, {}, {}, other, {}}, "llvmpipe");
  EXPECT_EQ(last_.pixels_off, 4U);
  EXPECT_EQ(last_.largest_difference, 10);
  other.at(0, 1)[0] = 98;
  refuse({12, {}, {}, other, {}}, "llvmpipe");
}

TEST(Agreement, NothingIsNoAgreement) { EXPECT_THROW(Agreement("test", MaskSum()), BenchMismatch); }

}  // namespace
}  // namespace halfspace
