#include "warp/image/compare.h"

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/support/threads.h"
#include "warp/image/color.h"

namespace morphkit::warp {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

Image random_image(cv::Size size, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<float> value(-0.5F, 3.0F);
  Image image(size);
  for (Pixel& pixel : image) {
    for (int c = 0; c < 4; ++c) pixel[c] = value(engine);
  }
  return image;
}

Image gray(cv::Size size, float display_value) {
  const float value = linear_from_srgb(display_value);
  return {size, Pixel{value, value, value, 1}};
}

TEST(Compare, AnImageEqualsItself) {
  const Image image = random_image({37, 19}, 1);
  const Difference difference = compare(image, image.clone());
  EXPECT_TRUE(difference.identical());
  EXPECT_TRUE(difference.within(0));
  EXPECT_EQ(difference.max_abs, 0);
  EXPECT_EQ(difference.differing, 0);
  EXPECT_EQ(difference.worst, cv::Point(-1, -1));
  EXPECT_EQ(difference.psnr_db, std::numeric_limits<double>::infinity());
}

TEST(Compare, FindsTheOneChangedPixelWhereverItIs) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 engine(seed);
  const Image image = random_image({31, 23}, seed);
  for (int trial = 0; trial < 50; ++trial) {
    Image changed = image.clone();
    const cv::Point at(static_cast<int>(engine() % 31), static_cast<int>(engine() % 23));
    const int channel = static_cast<int>(engine() % 4);
    changed(at)[channel] += 1;
    const Difference difference = compare(image, changed);
    EXPECT_EQ(difference.worst, at);
    EXPECT_EQ(difference.differing, 1);
    EXPECT_GT(difference.max_abs, 0);
    EXPECT_FALSE(difference.within(0));
    EXPECT_TRUE(difference.within(difference.max_abs));
    EXPECT_FALSE(difference.within(difference.max_abs / 2));
  }
}

TEST(Compare, IsSymmetric) {
  const Image a = random_image({16, 9}, 2);
  const Image b = random_image({16, 9}, 3);
  const Difference forth = compare(a, b);
  const Difference back = compare(b, a);
  EXPECT_EQ(forth.psnr_db, back.psnr_db);
  EXPECT_EQ(forth.max_abs, back.max_abs);
  EXPECT_EQ(forth.worst, back.worst);
}

TEST(Compare, PsnrOfAUniformStepFollowsFromItsSize) {
  // Three of four channels differ by 0.1: the mean square is 0.0075.
  const Difference difference = compare(gray({8, 8}, 0.5F), gray({8, 8}, 0.6F));
  EXPECT_NEAR(difference.max_abs, 0.1, 1e-6);
  EXPECT_NEAR(difference.psnr_db, -10 * std::log10(0.0075), 1e-4);
  EXPECT_EQ(difference.worst, cv::Point(0, 0));
  EXPECT_EQ(difference.differing, 64);
}

TEST(Compare, NonFiniteValuesDifferEvenFromThemselves) {
  for (const float bad : {kNan, kInfinity, -kInfinity}) {
    Image image = random_image({5, 4}, 4);
    image(2, 3)[1] = bad;
    const Difference difference = compare(image, image.clone());
    EXPECT_EQ(difference.nonfinite, 1);
    EXPECT_EQ(difference.differing, 1);
    EXPECT_EQ(difference.worst, cv::Point(3, 2));
    EXPECT_FALSE(difference.identical());
    EXPECT_FALSE(difference.within(std::numeric_limits<double>::infinity()));
    EXPECT_EQ(difference.psnr_db, -std::numeric_limits<double>::infinity());
  }
}

TEST(Compare, AStepBelowTheResolutionOfTheScaleIsStillADifference) {
  Image a(1, 1, Pixel{0.25F, 0.25F, 0.25F, 1});
  Image b = a.clone();
  b(0, 0)[0] = std::nextafter(0.25F, 1.0F);
  const Difference difference = compare(a, b);
  EXPECT_EQ(difference.differing, 1);
  EXPECT_FALSE(difference.within(0));
  EXPECT_TRUE(difference.within(1e-6));
  EXPECT_EQ(difference.worst, cv::Point(0, 0));
}

TEST(Compare, ZerosOfEitherSignAreEqual) {
  EXPECT_TRUE(compare(Image(1, 1, Pixel{0, 0, 0, 0}), Image(1, 1, Pixel{-0.0F, 0, -0.0F, 0})).identical());
}

TEST(Compare, DoesNotDependOnTheNumberOfThreads) {
  const Image a = random_image({67, 129}, 5);
  const Image b = random_image({67, 129}, 6);
  const Difference expected = compare(a, b);
  for (const int count : {1, 2, 5}) {
    test::set_threads(count);
    const Difference actual = compare(a, b);
    EXPECT_EQ(actual.psnr_db, expected.psnr_db);
    EXPECT_EQ(actual.worst, expected.worst);
  }
  test::set_threads(0);
}

TEST(Compare, RefusesUnequalSizes) {
  EXPECT_THROW(compare(gray({3, 4}, 0), gray({4, 3}, 0)), std::invalid_argument);
  EXPECT_THROW(difference_image(gray({3, 4}, 0), gray({4, 3}, 0), 1), std::invalid_argument);
}

TEST(DifferenceImage, IsBlackWhereNothingDiffers) {
  const Image image = random_image({6, 5}, 7);
  for (const Pixel& pixel : difference_image(image, image, 100)) EXPECT_EQ(pixel, Pixel(0, 0, 0, 1));
}

TEST(DifferenceImage, ShowsTheAmplifiedDifference) {
  const Image out = difference_image(gray({1, 1}, 0.5F), gray({1, 1}, 0.52F), 10);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(srgb_from_linear(out(0, 0)[c]), 0.2F, 1e-5);
  EXPECT_EQ(difference_image(gray({1, 1}, 0.0F), gray({1, 1}, 1.0F), 10)(0, 0), Pixel(1, 1, 1, 1));
}

TEST(DifferenceImage, ShowsADifferenceOfAlphaAlone) {
  const Image out = difference_image(Image(1, 1, Pixel{0, 0, 0, 1}), Image(1, 1, Pixel{0, 0, 0, 0.5F}), 1);
  EXPECT_NEAR(srgb_from_linear(out(0, 0)[0]), 0.5F, 1e-6);
}

TEST(DifferenceImage, MarksNonFinitePixels) {
  Image bad = gray({2, 1}, 0);
  bad(0, 1)[2] = kNan;
  EXPECT_EQ(difference_image(gray({2, 1}, 0), bad, 1)(0, 1), Pixel(1, 0, 1, 1));
}

}  // namespace
}  // namespace morphkit::warp
