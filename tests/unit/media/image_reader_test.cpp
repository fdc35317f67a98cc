// Tests morph/media/metadata.cpp.
// Headers of files: orientation, channels, windows, colour tags, metadata. The files are made with OpenImageIO, as
// other programs make them.

#include <OpenImageIO/deepdata.h>
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "tests/unit/media/exif_support.h"
#include "tests/unit/media/image_support.h"
#include "tests/unit/media/webp_support.h"
#include "warp/image/color.h"

namespace morphkit::media {
namespace {

namespace fs = std::filesystem;
using test::contains;
using test::distance;
using test::random_image;
using test::TemporaryFolder;

template <typename Sample>
void make(const fs::path& file, const OIIO::ImageSpec& spec, const std::vector<Sample>& samples) {
  const auto output = OIIO::ImageOutput::create(file.string());
  ASSERT_TRUE(output);
  ASSERT_TRUE(output->open(file.string(), spec)) << output->geterror();
  ASSERT_TRUE(output->write_image(OIIO::BaseTypeFromC<Sample>::value, samples.data())) << output->geterror();
  ASSERT_TRUE(output->close());
}

float srgb8(int code) {
  return warp::linear_from_srgb(static_cast<float>(code) / 255.0F);
}

/// The upright position of the stored pixel (x, y) of a 3 x 2 picture. The EXIF standard (4.6.4, tag 0x0112) says on
/// which side of the scene the 0th row and the 0th column are.
cv::Point upright(int orientation, int x, int y) {
  switch (orientation) {
    case 1:
      return {x, y};  // row top, column left
    case 2:
      return {2 - x, y};  // top, right
    case 3:
      return {2 - x, 1 - y};  // bottom, right
    case 4:
      return {x, 1 - y};  // bottom, left
    case 5:
      return {y, x};  // left, top
    case 6:
      return {1 - y, x};  // right, top
    case 7:
      return {1 - y, 2 - x};  // right, bottom
    default:
      return {y, 2 - x};  // left, bottom
  }
}

TEST(ImageHeader, AllEightOrientationsAreTurnedUpright) {
  const TemporaryFolder folder;
  std::vector<std::uint8_t> samples(3 * 2 * 3);
  std::iota(samples.begin(), samples.end(), std::uint8_t{10});
  for (int orientation = 1; orientation <= 8; ++orientation) {
    SCOPED_TRACE(orientation);
    const fs::path file = folder / (std::to_string(orientation).append(".tif"));
    OIIO::ImageSpec spec(3, 2, 3, OIIO::TypeDesc::UINT8);
    spec["Orientation"] = orientation;
    make(file, spec, samples);
    const Picture picture = read_picture(file);
    const cv::Size size = orientation < 5 ? cv::Size(3, 2) : cv::Size(2, 3);
    ASSERT_EQ(picture.image.size(), size);
    EXPECT_EQ(cv::Size(read_info(file).width, read_info(file).height), size);
    EXPECT_EQ(picture.info.orientation, orientation);
    for (int y = 0; y < 2; ++y) {
      for (int x = 0; x < 3; ++x) {
        const int code = samples[static_cast<std::size_t>(9 * y + 3 * x)];
        EXPECT_EQ(picture.image(upright(orientation, x, y))[0], srgb8(code)) << x << ", " << y;
      }
    }
    WriteOptions options;
    options.metadata = picture.metadata;
    options.overwrite = true;
    write_image(folder / "again.tif", picture.image, options);
    EXPECT_EQ(read_info(folder / "again.tif").orientation, 1);
    EXPECT_EQ(distance(read_picture(folder / "again.tif").image, picture.image), 0);
  }
}

TEST(ImageHeader, JpegOrientationIsObeyed) {
  const TemporaryFolder folder;
  OIIO::ImageSpec spec(32, 16, 3, OIIO::TypeDesc::UINT8);
  spec["Orientation"] = 6;
  make(folder / "a.jpg", spec, std::vector<std::uint8_t>(32 * 16 * 3, 99));
  const ImageInfo info = read_info(folder / "a.jpg");
  EXPECT_EQ(info.width, 16);
  EXPECT_EQ(info.height, 32);
  EXPECT_EQ(info.orientation, 6);
}

TEST(ImageHeader, ChannelsByCount) {
  const TemporaryFolder folder;
  make(folder / "gray.png", OIIO::ImageSpec(2, 1, 1, OIIO::TypeDesc::UINT8), std::vector<std::uint8_t>{50, 200});
  const Picture gray = read_picture(folder / "gray.png");
  EXPECT_EQ(gray.image(0, 1), warp::Pixel(srgb8(200), srgb8(200), srgb8(200), 1));
  EXPECT_FALSE(gray.info.has_alpha);

  OIIO::ImageSpec spec(1, 1, 2, OIIO::TypeDesc::UINT16);
  spec.channelnames = {"Y", "A"};
  spec.alpha_channel = 1;
  spec["oiio:UnassociatedAlpha"] = 1;
  make(folder / "gray_alpha.png", spec, std::vector<std::uint16_t>{65535, 13107});
  const Picture gray_alpha = read_picture(folder / "gray_alpha.png");
  EXPECT_TRUE(gray_alpha.info.has_alpha);
  EXPECT_EQ(gray_alpha.image(0, 0), warp::Pixel(0.2F, 0.2F, 0.2F, 0.2F));
}

TEST(ImageHeader, ChannelsByName) {
  const TemporaryFolder folder;
  OIIO::ImageSpec spec(1, 1, 7, OIIO::TypeDesc::FLOAT);
  spec.channelnames = {"Z", "A", "normal.X", "B", "G", "R", "id"};
  make(folder / "many.exr", spec, std::vector<float>{9, 0.5F, 8, 3, 2, 1, 7});
  const Picture many = read_picture(folder / "many.exr");
  EXPECT_EQ(many.image(0, 0), warp::Pixel(1, 2, 3, 0.5F));
  EXPECT_EQ(many.info.channels, 7);

  OIIO::ImageSpec luminance(1, 1, 2, OIIO::TypeDesc::FLOAT);
  luminance.channelnames = {"Y", "Z"};
  luminance.alpha_channel = -1;
  make(folder / "y.exr", luminance, std::vector<float>{0.75F, 9});
  EXPECT_EQ(read_picture(folder / "y.exr").image(0, 0), warp::Pixel(0.75F, 0.75F, 0.75F, 1));
}

TEST(ImageHeader, ExrIsAsLargeAsItsDisplayWindow) {
  const TemporaryFolder folder;
  OIIO::ImageSpec spec(2, 2, 3, OIIO::TypeDesc::FLOAT);
  spec.x = 3, spec.y = -1;  // one row above the window, one column in it, one to the right
  spec.full_width = 4, spec.full_height = 3;
  make(folder / "a.exr", spec, std::vector<float>{1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4});
  const Picture picture = read_picture(folder / "a.exr");
  ASSERT_EQ(picture.image.size(), cv::Size(4, 3));
  EXPECT_EQ(read_info(folder / "a.exr").width, 4);
  EXPECT_EQ(picture.image(0, 3), warp::Pixel(3, 3, 3, 1));
  EXPECT_EQ(cv::countNonZero(picture.image.reshape(1)), 4);
}

TEST(ImageHeader, TiledFilesAreRead) {
  const TemporaryFolder folder;
  for (const std::string name : {"a.exr", "a.tif"}) {
    OIIO::ImageSpec spec(150, 90, 3, OIIO::TypeDesc::FLOAT);
    spec.tile_width = spec.tile_height = 32;
    std::vector<float> samples(150 * 90 * 3);
    std::iota(samples.begin(), samples.end(), 0.0F);
    const auto output = OIIO::ImageOutput::create(name);
    make(folder / name, spec, samples);
    const warp::Image image = read_picture(folder / name).image;
    for (int y = 0; y < 90; ++y) {
      for (int x = 0; x < 150; ++x) ASSERT_EQ(image(y, x)[1], static_cast<float>((y * 150 + x) * 3 + 1)) << name;
    }
  }
}

TEST(ImageHeader, NonFiniteExrPixelsBecomeTransparentAndAreCounted) {
  const TemporaryFolder folder;
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  make(folder / "a.exr", OIIO::ImageSpec(2, 2, 4, OIIO::TypeDesc::FLOAT),
       std::vector<float>{1, 1, 1, 1, kNan, 0, 0, 1, 0, 0, kInfinity, 1, 0.5F, 0.5F, 0.5F, 0.5F});
  const Picture picture = read_picture(folder / "a.exr");
  EXPECT_EQ(picture.nonfinite_pixels, 2);
  EXPECT_EQ(picture.image(0, 1), warp::Pixel(0, 0, 0, 0));
  EXPECT_EQ(picture.image(1, 0), warp::Pixel(0, 0, 0, 0));
  EXPECT_EQ(picture.image(0, 0), warp::Pixel(1, 1, 1, 1));
}

TEST(ImageHeader, AssociatedTiffIsNotPremultipliedAgain) {
  const TemporaryFolder folder;
  OIIO::ImageSpec spec(1, 1, 4, OIIO::TypeDesc::UINT8);
  make(folder / "a.tif", spec, std::vector<std::uint8_t>{102, 51, 0, 102});
  const warp::Pixel pixel = read_picture(folder / "a.tif").image(0, 0);
  EXPECT_NEAR(pixel[0], 0.4, 1e-6);  // white, covered by 0.4
  EXPECT_NEAR(pixel[1], warp::linear_from_srgb(0.5F) * 0.4F, 1e-6);
  EXPECT_EQ(pixel[3], 0.4F);
}

TEST(ImageHeader, ColorTagsAreObeyed) {
  const TemporaryFolder folder;
  const std::vector<std::uint8_t> samples = {128, 64, 255};
  OIIO::ImageSpec spec(1, 1, 3, OIIO::TypeDesc::UINT8);
  const auto red = [&](const std::string& name, const std::string& tag, float gamma) {
    OIIO::ImageSpec tagged = spec;
    if (!tag.empty()) tagged["oiio:ColorSpace"] = tag;
    if (gamma > 0) tagged["oiio:Gamma"] = gamma;
    make(folder / name, tagged, samples);
    return read_picture(folder / name).image(0, 0)[0];
  };
  EXPECT_EQ(red("none.png", "", 0), srgb8(128));
  EXPECT_EQ(red("srgb.png", "sRGB", 0), srgb8(128));
  EXPECT_EQ(red("linear.png", "Linear", 0), 128.0F / 255.0F);
  EXPECT_EQ(red("none.tif", "", 0), srgb8(128));
  EXPECT_NEAR(red("gamma.png", "GammaCorrected", 1.8F), std::pow(128.0F / 255.0F, 1.8F), 1e-4);
  EXPECT_EQ(read_info(folder / "gamma.png").color_space, "gamma 1.8");
  EXPECT_EQ(red("gamma22.png", "GammaCorrected", 2.2F), srgb8(128));
}

/// Phones upload them lying on their side.
TEST(ImageHeader, AWebpFileIsTurnedAsItsExifDataSay) {
  const TemporaryFolder folder;
  const test::Bytes red_over_blue = {255, 0, 0, 255, 0, 0, 255, 0, 0, 0, 0, 255, 0, 0, 255, 0, 0, 255};
  for (const bool as_in_jpeg : {false, true}) {
    test::Bytes exif = test::exif_saying(6, as_in_jpeg);
    if (as_in_jpeg) exif.insert(exif.begin(), {'E', 'x', 'i', 'f', 0, 0});
    test::write_webp(folder / "a.webp", {3, 2}, red_over_blue, {{"EXIF", exif}});
    const Picture picture = read_picture(folder / "a.webp");
    ASSERT_EQ(picture.image.size(), cv::Size(2, 3));
    EXPECT_EQ(picture.info.orientation, 6);
    for (int y = 0; y < 3; ++y) {
      EXPECT_EQ(picture.image(y, 0), warp::Pixel(0, 0, 1, 1)) << "what was below is on the left";
      EXPECT_EQ(picture.image(y, 1), warp::Pixel(1, 0, 0, 1));
    }
  }
  test::write_webp(folder / "b.webp", {3, 2}, red_over_blue, {{"EXIF", {'I', 'I', 42}}});
  EXPECT_EQ(read_info(folder / "b.webp").orientation, 1) << "data that cannot be read";
}

TEST(ImageHeader, KeepsMetadataExceptAttributesThatWouldBeWrong) {
  const TemporaryFolder folder;
  OIIO::ImageSpec spec(4, 2, 3, OIIO::TypeDesc::UINT8);
  spec["Copyright"] = "a photographer";
  spec["Artist"] = "somebody";
  spec["DateTime"] = "2001:02:03 04:05:06";
  spec["FNumber"] = 2.8F;
  spec["XResolution"] = 300.0F;
  spec["YResolution"] = 300.0F;
  spec["ResolutionUnit"] = "in";
  spec["Orientation"] = 6;
  const std::vector<std::uint8_t> samples(4 * 2 * 3, 100);
  make(folder / "a.tif", spec, samples);
  const Picture picture = read_picture(folder / "a.tif");
  for (const std::string name : {"b.tif", "b.jpg", "b.exr", "b.png", "b.webp", "b.tga"}) {
    SCOPED_TRACE(name);
    WriteOptions options;
    options.metadata = picture.metadata;
    write_image(folder / name, picture.image, options);
    const ImageInfo info = read_info(folder / name);
    EXPECT_EQ(info.orientation, 1);
    EXPECT_EQ(cv::Size(info.width, info.height), cv::Size(2, 4));
    const auto value = [&](const std::string& key) {
      const auto found = std::find_if(info.metadata.begin(), info.metadata.end(),
                                      [&](const auto& entry) { return entry.first == key; });
      return found == info.metadata.end() ? std::string() : found->second;
    };
    const bool is_exif_format = name == "b.tif" || name == "b.jpg" || name == "b.exr";
    if (is_exif_format) {
      EXPECT_EQ(value("Copyright"), "a photographer");
      EXPECT_EQ(value("DateTime"), "2001:02:03 04:05:06");
      EXPECT_EQ(value("FNumber").substr(0, 3), "2.8");
      EXPECT_EQ(value("XResolution"), "300");
    }
  }
}

TEST(ImageHeader, NoDateIsInvented) {
  const TemporaryFolder folder;
  for (const std::string name : {"b.tif", "b.jpg", "b.exr", "b.png"}) {
    write_image(folder / name, random_image(3, 3, false, 1));
    for (const auto& [key, text] : read_info(folder / name).metadata) {
      EXPECT_FALSE(contains(key, "Date") && !text.empty()) << name << " " << key << "=" << text;
    }
  }
}

}  // namespace
}  // namespace morphkit::media
