// Tests morph/media/color_profile.cpp and morph/media/color_tags.cpp.
// Pictures with ICC profiles. The profiles are made with Little CMS; what must come out is computed from the primaries.

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <lcms2.h>

#include <array>
#include <cmath>
#include <opencv2/core/matx.hpp>

#include "tests/unit/media/image_support.h"
#include "tests/unit/media/webp_support.h"
#include "warp/image/color.h"

namespace morphkit::media {
namespace {

namespace fs = std::filesystem;
using test::Bytes;
using test::contains;
using test::TemporaryFolder;

constexpr cmsCIExyY kD65 = {0.3127, 0.3290, 1.0};
constexpr cmsCIExyYTRIPLE kRec709 = {{0.64, 0.33, 1.0}, {0.30, 0.60, 1.0}, {0.15, 0.06, 1.0}};
constexpr cmsCIExyYTRIPLE kDisplayP3 = {{0.680, 0.320, 1.0}, {0.265, 0.690, 1.0}, {0.150, 0.060, 1.0}};
constexpr cmsCIExyYTRIPLE kAdobeRgb = {{0.64, 0.33, 1.0}, {0.21, 0.71, 1.0}, {0.15, 0.06, 1.0}};

/// The curve of sRGB as ICC's parametric curve 4, or a power.
cmsToneCurve* curve(double gamma) {
  if (gamma > 0) return cmsBuildGamma(nullptr, gamma);
  const std::array<double, 5> parameters = {2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045};
  return cmsBuildParametricToneCurve(nullptr, 4, parameters.data());
}

Bytes saved(cmsHPROFILE profile, const char* name) {
  cmsMLU* text = cmsMLUalloc(nullptr, 1);
  cmsMLUsetASCII(text, "en", "US", name);
  cmsWriteTag(profile, cmsSigProfileDescriptionTag, text);
  cmsMLUfree(text);
  cmsUInt32Number size = 0;
  cmsSaveProfileToMem(profile, nullptr, &size);
  Bytes bytes(size);
  cmsSaveProfileToMem(profile, bytes.data(), &size);
  cmsCloseProfile(profile);
  return bytes;
}

/// @param gamma  0: the curve of sRGB.
Bytes rgb_profile(const cmsCIExyYTRIPLE& primaries, double gamma, const char* name) {
  cmsToneCurve* one = curve(gamma);
  const std::array<cmsToneCurve*, 3> curves = {one, one, one};
  const cmsHPROFILE profile = cmsCreateRGBProfile(&kD65, &primaries, curves.data());
  cmsFreeToneCurve(one);
  return saved(profile, name);
}

Bytes gray_profile(double gamma, const char* name) {
  cmsToneCurve* one = curve(gamma);
  const cmsHPROFILE profile = cmsCreateGrayProfile(&kD65, one);
  cmsFreeToneCurve(one);
  return saved(profile, name);
}

/// XYZ of D65 white = matrix * (1, 1, 1); the textbook's way from chromaticities to a matrix.
cv::Matx33d xyz_from_rgb(const cmsCIExyYTRIPLE& primaries) {
  const auto column = [](const cmsCIExyY& c) { return cv::Vec3d(c.x / c.y, 1.0, (1 - c.x - c.y) / c.y); };
  cv::Matx33d matrix;
  int c = 0;
  for (const cmsCIExyY& primary : {primaries.Red, primaries.Green, primaries.Blue}) {
    const cv::Vec3d xyz = column(primary);
    for (int row = 0; row < 3; ++row) matrix(row, c) = xyz[row];
    ++c;
  }
  const cv::Vec3d scale = matrix.inv() * column(kD65);
  return matrix * cv::Matx33d::diag(scale);
}

cv::Vec3d rec709_from(const cmsCIExyYTRIPLE& primaries, const cv::Vec3d& linear) {
  return xyz_from_rgb(kRec709).inv() * (xyz_from_rgb(primaries) * linear);
}

cv::Vec3d linear_light(const std::array<float, 3>& codes) {
  cv::Vec3d result;
  for (int c = 0; c < 3; ++c) result[c] = warp::linear_from_srgb(codes[static_cast<std::size_t>(c)] / 255.0F);
  return result;
}

void tag(OIIO::ImageSpec& spec, const Bytes& icc) {
  spec.attribute("ICCProfile", OIIO::TypeDesc(OIIO::TypeDesc::UINT8, static_cast<int>(icc.size())), icc.data());
}

/// A flat picture of 16 x 16 pixels.
template <typename Sample>
void write_flat(const fs::path& file, const std::vector<Sample>& pixel, const Bytes& icc, bool linear = false) {
  OIIO::ImageSpec spec(16, 16, static_cast<int>(pixel.size()), OIIO::BaseTypeFromC<Sample>::value);
  if (!icc.empty()) tag(spec, icc);
  spec["compression"] = file.extension() == ".jpg" ? "jpeg:100" : "zip";
  spec["jpeg:subsampling"] = "4:4:4";
  spec["oiio:UnassociatedAlpha"] = 1;
  if (linear) spec["oiio:ColorSpace"] = "Linear";
  std::vector<Sample> samples;
  for (int i = 0; i < 16 * 16; ++i) samples.insert(samples.end(), pixel.begin(), pixel.end());
  const auto output = OIIO::ImageOutput::create(file.string());
  ASSERT_TRUE(output && output->open(file.string(), spec)) << file;
  ASSERT_TRUE(output->write_image(OIIO::BaseTypeFromC<Sample>::value, samples.data())) << output->geterror();
  ASSERT_TRUE(output->close());
}

void expect_color(const warp::Image& image, const cv::Vec3d& wanted, double tolerance, const fs::path& what) {
  for (const warp::Pixel& pixel : image) {
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(pixel[c], wanted[c], tolerance) << what << " channel " << c;
  }
}

TEST(ColorProfile, DisplayP3BecomesRec709InEveryFormat) {
  const TemporaryFolder folder;
  const Bytes icc = rgb_profile(kDisplayP3, 0, "Display P3");
  const cv::Vec3d linear = linear_light({234, 51, 35});
  const cv::Vec3d wanted = rec709_from(kDisplayP3, linear);
  EXPECT_NEAR(wanted[0], 1.0, 0.01);  // red of sRGB
  EXPECT_NEAR(wanted[1], 0.0, 0.002);
  EXPECT_NEAR(wanted[2], 0.0, 0.002);
  for (const char* name : {"p3.png", "p3.tif", "p3.jpg"}) {
    const fs::path file = folder / name;
    write_flat<std::uint8_t>(file, {234, 51, 35}, icc);
    const Picture picture = read_picture(file);
    expect_color(picture.image, wanted, file.extension() == ".jpg" ? 0.02 : 2e-4, file);
    EXPECT_EQ(picture.info.color_space, "Display P3");
    EXPECT_EQ(picture.info.color_told, "Display P3 profile, converted");
    EXPECT_TRUE(warnings_of(picture).empty());
  }
  const fs::path deep = folder / "p3-16.png";
  write_flat<std::uint16_t>(deep, {234 * 257, 51 * 257, 35 * 257}, icc);
  expect_color(read_picture(deep).image, wanted, 2e-4, deep);
}

TEST(ColorProfile, AWebpFileHasOneToo) {
  const TemporaryFolder folder;
  Bytes pixels;
  for (int i = 0; i < 16 * 16; ++i) pixels.insert(pixels.end(), {234, 51, 35});
  test::write_webp(folder / "p3.webp", {16, 16}, pixels, {{"ICCP", rgb_profile(kDisplayP3, 0, "Display P3")}});

  const cv::Vec3d linear = linear_light({234, 51, 35});
  const Picture picture = read_picture(folder / "p3.webp");
  expect_color(picture.image, rec709_from(kDisplayP3, linear), 2e-4, "p3.webp");
  EXPECT_EQ(picture.info.color_space, "Display P3");
}

TEST(ColorProfile, WideColoursStay) {
  const TemporaryFolder folder;
  const fs::path file = folder / "green.tif";
  write_flat<std::uint16_t>(file, {0, 65535, 0}, rgb_profile(kAdobeRgb, 2.19921875, "Adobe RGB (1998)"));
  const cv::Vec3d wanted = rec709_from(kAdobeRgb, {0, 1, 0});
  EXPECT_LT(wanted[0], -0.3);
  expect_color(read_picture(file).image, wanted, 5e-4, file);

  const fs::path bright = folder / "bright.tif";
  write_flat<float>(bright, {4.0F, 0.5F, -0.25F}, rgb_profile(kDisplayP3, 1, "Linear P3"), true);
  expect_color(read_picture(bright).image, rec709_from(kDisplayP3, {4.0, 0.5, -0.25}), 2e-3, bright);
}

TEST(ColorProfile, ColourUnderAlphaIsConvertedStraight) {
  const TemporaryFolder folder;
  const fs::path file = folder / "half.png";
  write_flat<std::uint8_t>(file, {234, 51, 35, 51}, rgb_profile(kDisplayP3, 0, "Display P3"));
  const cv::Vec3d linear = linear_light({234, 51, 35});
  const warp::Image image = read_picture(file).image;
  expect_color(image, rec709_from(kDisplayP3, linear) * 0.2, 1e-4, file);
  EXPECT_FLOAT_EQ(image(3, 3)[3], 0.2F);
}

TEST(ColorProfile, GrayHasProfilesToo) {
  const TemporaryFolder folder;
  const fs::path file = folder / "gray.tif";
  write_flat<std::uint8_t>(file, {100}, gray_profile(1.8, "Gray Gamma 1.8"));
  const double wanted = std::pow(100 / 255.0, 1.8);
  expect_color(read_picture(file).image, {wanted, wanted, wanted}, 2e-4, file);
  write_flat<std::uint8_t>(file, {100}, rgb_profile(kDisplayP3, 1.8, "P3 of gamma 1.8"));
  expect_color(read_picture(file).image, {wanted, wanted, wanted}, 2e-4, file);
}

TEST(ColorProfile, SrgbGivesTheSameNumbersAsNoProfile) {
  const TemporaryFolder folder;
  for (int code = 0; code < 256; code += 15) {
    const auto sample = static_cast<std::uint8_t>(code);
    const std::vector<std::uint8_t> pixel = {sample, static_cast<std::uint8_t>(255 - code), 77};
    write_flat<std::uint8_t>(folder / "plain.png", pixel, {});
    write_flat<std::uint8_t>(folder / "tagged.png", pixel, rgb_profile(kRec709, 0, "sRGB"));
    const Picture plain = read_picture(folder / "plain.png"), tagged = read_picture(folder / "tagged.png");
    EXPECT_EQ(test::distance(plain.image, tagged.image), 0);
    EXPECT_EQ(tagged.info.color_told, "sRGB profile, read as sRGB");
    EXPECT_EQ(tagged.info.color_space, "sRGB");
  }
  write_flat<std::uint8_t>(folder / "power.png", {10, 10, 10}, rgb_profile(kRec709, 2.2, "Gamma 2.2"));
  EXPECT_NEAR(read_picture(folder / "power.png").image(0, 0)[1], std::pow(10 / 255.0, 2.2), 1e-5);
}

TEST(ColorProfile, TheProjectOverridesIt) {
  const TemporaryFolder folder;
  const fs::path file = folder / "p3.png";
  write_flat<std::uint8_t>(file, {234, 51, 35}, rgb_profile(kDisplayP3, 0, "Display P3"));
  EXPECT_EQ(read_picture(file, ColorSpace::kSrgb).image(0, 0)[0], warp::linear_from_srgb(234 / 255.0F));
  EXPECT_EQ(read_picture(file, ColorSpace::kLinear).image(0, 0)[0], 234 / 255.0F);
  EXPECT_EQ(read_picture(file, ColorSpace::kSrgb).info.color_told, "read as sRGB");
}

TEST(ColorProfile, OneThatCannotBeAppliedIsNamed) {
  const TemporaryFolder folder;
  const fs::path file = folder / "wrong.tif";
  write_flat<std::uint8_t>(file, {234, 51, 35}, gray_profile(2.2, "Dull Gray"));
  const Picture wrong = read_picture(file);
  EXPECT_EQ(
      wrong.info.color_warning,
      "Dull Gray profile is not applied, for it is for GRAY and the picture has 3 colour channels; the picture is "
      "read as sRGB");
  EXPECT_EQ(warnings_of(wrong), std::vector<std::string>{wrong.info.color_warning});
  EXPECT_EQ(wrong.image(0, 0)[0], warp::linear_from_srgb(234 / 255.0F));

  const Bytes whole = rgb_profile(kDisplayP3, 0, "Display P3");
  for (std::size_t size = 0; size < whole.size(); size += 37) {
    Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    cut.resize(std::max<std::size_t>(size, 1));
    const fs::path broken = folder / "broken.tif";
    write_flat<std::uint8_t>(broken, {234, 51, 35}, cut);
    const Picture picture = read_picture(broken);
    if (picture.info.color_warning.empty()) continue;  // what is lost was only text
    EXPECT_TRUE(contains(picture.info.color_warning, "not applied")) << picture.info.color_warning;
    EXPECT_EQ(picture.image(0, 0)[0], warp::linear_from_srgb(234 / 255.0F));
  }
}

}  // namespace
}  // namespace morphkit::media
