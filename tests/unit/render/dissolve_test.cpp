#include "morph/render/dissolve.h"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "warp/image/color.h"

namespace morphkit::render {
namespace {

using warp::Pixel;

TEST(Dissolve, EndsAreThePicturesWhateverTheOtherHolds) {
  const float inf = std::numeric_limits<float>::infinity();
  const Pixel good(-0.5f, 3, 0.25f, 1);
  for (const project::Blend blend : {project::Blend::kLinear, project::Blend::kDisplay}) {
    std::vector<Pixel> row{good, {inf, inf, inf, inf}};
    const std::vector<Pixel> destination{{inf, inf, inf, inf}, good};
    dissolve_row(row, destination, std::vector<float>{0, 1}, blend);
    EXPECT_EQ(row[0], good);
    EXPECT_EQ(row[1], good);
  }
}

TEST(Dissolve, LinearMixesLight) {
  std::vector<Pixel> row{{1, 0, 0, 1}};
  dissolve_row(row, std::vector<Pixel>{{0, 0, 1, 0.5f}}, std::vector<float>{0.25f}, project::Blend::kLinear);
  EXPECT_EQ(row[0], Pixel(0.75f, 0, 0.25f, 0.875f));
}

TEST(Dissolve, DisplayMixesCodeValues) {
  std::vector<Pixel> row{{0, 0, 0, 1}};
  dissolve_row(row, std::vector<Pixel>{{1, 1, 1, 1}}, std::vector<float>{0.5f}, project::Blend::kDisplay);
  EXPECT_NEAR(row[0][0], warp::linear_from_srgb(0.5f), 1e-6);
  EXPECT_EQ(row[0][3], 1);
}

TEST(Dissolve, OneAlphaServesAllPixels) {
  std::vector<Pixel> row(3, Pixel(0, 0, 0, 0));
  dissolve_row(row, std::vector<Pixel>(3, Pixel(1, 1, 1, 1)), std::vector<float>{0.5f}, project::Blend::kLinear);
  for (const Pixel& pixel : row) EXPECT_EQ(pixel, Pixel(0.5f, 0.5f, 0.5f, 0.5f));
}

TEST(Over, IsPorterDuffOnPremultipliedColour) {
  std::vector<Pixel> row{{0.25f, 0, 0, 0.5f}, {1, 2, 3, 1}, {0, 0, 0, 0}};
  over_row(row, std::vector<Pixel>{{0, 1, 0, 1}});
  EXPECT_EQ(row[0], Pixel(0.25f, 0.5f, 0, 1));
  EXPECT_EQ(row[1], Pixel(1, 2, 3, 1));
  EXPECT_EQ(row[2], Pixel(0, 1, 0, 1));
}

}  // namespace
}  // namespace morphkit::render
