// The accuracy of antialiased sampling: a zone plate, unevenly reduced by a map, against the exact result.

#include <gtest/gtest.h>

#include <string>

#include "tests/unit/warp/sample/plate_reference.h"
#include "warp/sample/sample.h"

namespace morphkit::warp {
namespace {

using test::plate_quality;
using test::PlateQuality;
using test::PlateReduction;
using test::ReferencePixel;

constexpr int kStride = 7;  // between pixels that are compared

PlateQuality quality(Filter filter, const std::vector<ReferencePixel>& references) {
  const Image out = sample(PlateReduction::source(), PlateReduction::map(), {filter, Border::kClamp});
  const PlateQuality result =
      plate_quality(PlateReduction::plate(), references, [&](cv::Point at) { return static_cast<double>(out(at)[1]); });
  testing::Test::RecordProperty("whole_db", std::to_string(result.whole));
  testing::Test::RecordProperty("passband_db", std::to_string(result.passband));
  testing::Test::RecordProperty("alias_zone_db", std::to_string(result.alias_zone));
  return result;
}

TEST(SampleQuality, AreaIsTheMeanOverThePixel) {
  const auto [whole, passband, alias_zone] = quality(Filter::kArea, PlateReduction::box_references(kStride));
  EXPECT_GE(whole, 48);
  EXPECT_GE(passband, 50);
  EXPECT_GE(alias_zone, 52);
}

TEST(SampleQuality, LanczosIsLanczos) {
  const auto [whole, passband, alias_zone] = quality(Filter::kLanczos, PlateReduction::lanczos_references(kStride));
  EXPECT_GE(whole, 64);
  EXPECT_GE(passband, 63);
  EXPECT_GE(alias_zone, 65);
}

TEST(SampleQuality, MitchellKeepsThePassbandAndDropsTheRest) {
  const auto [whole, passband, alias_zone] = quality(Filter::kMitchell, PlateReduction::lanczos_references(kStride));
  EXPECT_GE(passband, 31);
  EXPECT_GE(alias_zone, 40);
  EXPECT_GE(whole, 24);
}

TEST(SampleQuality, APointSampleIsFarFromTheMean) {
  const PlateQuality bicubic = quality(Filter::kBicubic, PlateReduction::box_references(kStride));
  EXPECT_LE(bicubic.alias_zone, 12);
}

}  // namespace
}  // namespace morphkit::warp
