// Tests morph/media/image_file.cpp and morph/media/webp_codec.cpp.
// Files written and read again: formats, depths, alpha, sizes, colour spaces, orientation, metadata.

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <limits>

#include "morph/media/image_format.h"
#include "tests/unit/media/image_support.h"
#include "warp/image/color.h"

namespace morphkit::media {
namespace {

namespace fs = std::filesystem;
using test::contains;
using test::distance;
using test::error_of;
using test::random_image;
using test::read_bytes;
using test::TemporaryFolder;

struct Case {
  std::string extension;
  Depth depth;
  bool alpha;
  double bound;  ///< of a linear, premultiplied sample after one trip; 0: bit for bit
};

/// Half a code in display light times the steepest slope of the sRGB curve's inverse (about 2.28 at white), plus half a
/// code of alpha, which multiplies colour.
constexpr double kBound8 = 0.5 / 255 * 2.28 + 0.5 / 255;
constexpr double kBound16 = 0.5 / 65535 * 2.28 + 0.5 / 65535;

const std::vector<Case>& lossless_cases() {
  static const std::vector<Case> cases = {
      {".png", Depth::k8, false, kBound8},       {".png", Depth::k8, true, kBound8},
      {".png", Depth::k16, false, kBound16},     {".png", Depth::k16, true, kBound16},
      {".tif", Depth::k8, false, kBound8},       {".tif", Depth::k8, true, kBound8},
      {".tiff", Depth::k16, false, kBound16},    {".tiff", Depth::k16, true, kBound16},
      {".tif", Depth::kFloat, false, 0},         {".tif", Depth::kFloat, true, 0},
      {".tga", Depth::k8, false, kBound8},       {".tga", Depth::k8, true, kBound8},
      {".webp", Depth::k8, false, kBound8},      {".webp", Depth::k8, true, kBound8},
      {".exr", Depth::kHalf, false, 0.5 / 2048}, {".exr", Depth::kHalf, true, 0.5 / 2048},
      {".exr", Depth::kFloat, false, 0},         {".exr", Depth::kFloat, true, 0},
  };
  return cases;
}

WriteOptions lossless(Depth depth) {
  WriteOptions options;
  options.depth = depth;
  options.quality = 100;
  options.overwrite = true;
  return options;
}

TEST(ImageRoundTrip, OneTripIsWithinHalfACodeAndTheNextIsExact) {
  const TemporaryFolder folder;
  const unsigned seed = std::random_device{}();
  for (const Case& test : lossless_cases()) {
    for (const cv::Size size : {cv::Size(1, 1), cv::Size(7, 3), cv::Size(2, 131), cv::Size(301, 70)}) {
      SCOPED_TRACE(testing::Message() << test.extension << " " << shown_depth(test.depth) << " alpha " << test.alpha
                                      << " " << size << " seed " << seed);
      const warp::Image image = random_image(size.width, size.height, test.alpha, seed);
      const fs::path file = folder / ("a" + test.extension);
      write_image(file, image, lossless(test.depth));
      const Picture once = read_picture(file);
      EXPECT_LE(distance(once.image, image), test.bound);
      EXPECT_EQ(once.info.has_alpha, test.alpha);
      EXPECT_EQ(once.nonfinite_pixels, 0);
      const fs::path again = folder / ("b" + test.extension);
      WriteOptions options = lossless(test.depth);
      options.alpha = once.info.has_alpha;
      write_image(again, once.image, options);
      const Picture twice = read_picture(again);
      if (test.alpha && test.depth != Depth::kHalf && test.depth != Depth::kFloat) {
        // A pixel with alpha 0 in the file loses its colour by the second trip; nothing else changes.
        EXPECT_EQ(distance(twice.image, once.image), 0);
      } else {
        EXPECT_EQ(read_bytes(file), read_bytes(again));
      }
    }
  }
}

TEST(ImageRoundTrip, InfoDescribesTheWrittenFile) {
  const TemporaryFolder folder;
  for (const Case& test : lossless_cases()) {
    SCOPED_TRACE(testing::Message() << test.extension << " " << shown_depth(test.depth) << " alpha " << test.alpha);
    const fs::path file = folder / ("a" + test.extension);
    write_image(file, random_image(13, 5, test.alpha, 1), lossless(test.depth));
    const ImageInfo info = read_info(file);
    EXPECT_EQ(info.width, 13);
    EXPECT_EQ(info.height, 5);
    EXPECT_EQ(info.channels, test.alpha ? 4 : 3);
    EXPECT_EQ(info.orientation, 1);
    EXPECT_EQ(info.bytes, static_cast<std::int64_t>(fs::file_size(file)));
    const std::string type = test.depth == Depth::k8      ? "uint8"
                             : test.depth == Depth::k16   ? "uint16"
                             : test.depth == Depth::kHalf ? "half"
                                                          : "float";
    EXPECT_EQ(info.channel_type, type);
    EXPECT_EQ(info.color_space, test.depth == Depth::kHalf || test.depth == Depth::kFloat ? "linear" : "sRGB");
  }
}

TEST(ImageRoundTrip, AutoDepthIsTheUsualOne) {
  const TemporaryFolder folder;
  const std::vector<std::pair<std::string, std::string>> cases = {{".png", "uint8"}, {".tif", "uint16"},
                                                                  {".jpg", "uint8"}, {".webp", "uint8"},
                                                                  {".tga", "uint8"}, {".EXR", "half"}};
  for (const auto& [extension, type] : cases) {
    const fs::path file = folder / ("a" + extension);
    write_image(file, random_image(4, 4, true, 1));
    EXPECT_EQ(read_info(file).channel_type, type) << extension;
  }
}

TEST(ImageRoundTrip, LossyFormatsStayClose) {
  const TemporaryFolder folder;
  warp::Image image(64, 64);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      image(y, x) = warp::Pixel(static_cast<float>(x) / 63.0F, static_cast<float>(y) / 63.0F, 0.5F, 1.0F);
    }
  }
  for (const std::string extension : {".jpg", ".webp"}) {
    const fs::path file = folder / ("a" + extension);
    write_image(file, image);
    // One code of display light where the curve is steepest, in the mean; the worst sample depends on where the codec's
    // blocks fall.
    const double mean = cv::norm(read_picture(file).image, image, cv::NORM_L1) / (64 * 64 * 4);
    EXPECT_LE(mean, 2.28 / 255) << extension;
    EXPECT_GT(mean, 0) << extension;
  }
}

TEST(ImageRoundTrip, JpegGetsTheImageOverBlack) {
  const TemporaryFolder folder;
  const warp::Pixel half_white(0.25F, 0.25F, 0.25F, 0.25F);
  write_image(folder / "a.jpg", warp::Image(16, 16, half_white));
  const Picture picture = read_picture(folder / "a.jpg");
  EXPECT_NEAR(picture.image(8, 8)[0], 0.25, 0.005);
  EXPECT_EQ(picture.image(8, 8)[3], 1.0F);
}

TEST(ImageRoundTrip, AlphaCanBeForcedAndForbidden) {
  const TemporaryFolder folder;
  WriteOptions options;
  options.alpha = true;
  write_image(folder / "opaque.png", random_image(3, 3, false, 1), options);
  EXPECT_EQ(read_info(folder / "opaque.png").channels, 4);
  options.alpha = false;
  write_image(folder / "transparent.png", random_image(3, 3, true, 1), options);
  EXPECT_EQ(read_info(folder / "transparent.png").channels, 3);
}

TEST(ImageRoundTrip, ExrKeepsValuesAboveOneAndBelowZero) {
  const TemporaryFolder folder;
  warp::Image image(1, 2);
  image(0, 0) = warp::Pixel(1000.0F, -2.0F, 0.5F, 0.25F);
  image(0, 1) = warp::Pixel(1e9F, -1e9F, 0.0F, 1.0F);
  write_image(folder / "a.exr", image);
  const warp::Image half = read_picture(folder / "a.exr").image;
  EXPECT_EQ(half(0, 0), image(0, 0));
  EXPECT_EQ(half(0, 1), warp::Pixel(65504.0F, -65504.0F, 0.0F, 1.0F));
}

TEST(ImageRoundTrip, ColorSpaceOverrides) {
  const TemporaryFolder folder;
  warp::Image image(1, 1, warp::Pixel(0.2F, 0.4F, 0.6F, 1.0F));
  write_image(folder / "a.png", image, lossless(Depth::k16));
  const warp::Image as_linear = read_picture(folder / "a.png", ColorSpace::kLinear).image;
  EXPECT_NEAR(as_linear(0, 0)[0], warp::srgb_from_linear(0.2F), 1e-4);
  EXPECT_EQ(read_picture(folder / "a.png", ColorSpace::kLinear).info.color_space, "linear");
  write_image(folder / "a.exr", image, lossless(Depth::kFloat));
  const warp::Image as_srgb = read_picture(folder / "a.exr", ColorSpace::kSrgb).image;
  EXPECT_EQ(as_srgb(0, 0)[0], warp::linear_from_srgb(0.2F));
}

TEST(ImageRoundTrip, ThreadsAndRepetitionsGiveTheSameBytes) {
  const warp::Image image = random_image(65, 40, true, 7);
  for (const Case& test : lossless_cases()) {
    const fs::path name = "a" + test.extension;
    EXPECT_EQ(encode_image(name, image, lossless(test.depth)), encode_image(name, image, lossless(test.depth)));
  }
}

TEST(ImageRoundTrip, CompressionChangesOnlyTheSize) {
  const TemporaryFolder folder;
  // Smooth with a repeated pattern: filters, runs and long matches all help.
  warp::Image image(90, 160);
  for (int y = 0; y < image.rows; ++y)
    for (int x = 0; x < image.cols; ++x)
      image(y, x) = {static_cast<float>(x) / 160, static_cast<float>(y % 7) / 7, static_cast<float>(x * y % 31) / 31,
                     1};
  for (const char* name : {"a.png", "a.tif", "a.exr"}) {
    SCOPED_TRACE(name);
    std::vector<std::size_t> sizes;
    WriteOptions options;
    options.overwrite = true;
    write_image(folder / name, image, options);
    const warp::Image usual = read_picture(folder / name).image;
    const std::size_t usual_size = read_bytes(folder / name).size();
    for (const int level : {0, 1, 9}) {
      options.compression = level;
      write_image(folder / name, image, options);
      EXPECT_EQ(distance(read_picture(folder / name).image, usual), 0) << level;
      sizes.push_back(read_bytes(folder / name).size());
    }
    EXPECT_GT(sizes[0], usual_size);
    EXPECT_GT(sizes[0], sizes[1]);
    EXPECT_GT(sizes[1], sizes[2]);
  }
}

TEST(ImageRoundTrip, RefusesCompressionThatTheFormatDoesNotSupport) {
  WriteOptions options;
  options.compression = 5;
  for (const char* name : {"a.jpg", "a.webp", "a.tga"}) {
    const Error error = error_of([&] { encode_image(name, random_image(4, 4, false, 1), options); });
    EXPECT_EQ(error.kind(), ErrorKind::kUnsupported) << name;
    EXPECT_TRUE(contains(error.message(), "no levels of compression")) << error.message();
  }
  options.compression = 10;
  EXPECT_TRUE(contains(error_of([&] { encode_image("a.png", random_image(4, 4, false, 1), options); }).message(),
                       "0 (none) to 9"));
}

TEST(ImageRoundTrip, MapsAreStoredUnchanged) {
  const TemporaryFolder folder;
  warp::Map map(3, 5);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 5; ++x)
      map(y, x) = warp::MapPoint(static_cast<float>(x) * 100.25F, -0.1F * static_cast<float>(y));
  }
  map(1, 1)[0] = std::numeric_limits<float>::quiet_NaN();
  write_map(folder / "map.exr", map, false);
  const auto input = OIIO::ImageInput::open((folder / "map.exr").string());
  ASSERT_TRUE(input);
  EXPECT_EQ(input->spec().channelnames, (std::vector<std::string>{"R", "G"}));
  EXPECT_EQ(input->spec().format, OIIO::TypeDesc::FLOAT);
  warp::Map read(3, 5);
  ASSERT_TRUE(input->read_image(0, 0, 0, 2, OIIO::TypeDesc::FLOAT, read.data));
  EXPECT_EQ(std::memcmp(read.data, map.data, 15 * sizeof(warp::MapPoint)), 0);
  EXPECT_EQ(error_of([&] { write_map(folder / "map.png", map, false); }).kind(), ErrorKind::kUnsupported);
  EXPECT_EQ(error_of([&] { write_map(folder / "map.exr", map, false); }).kind(), ErrorKind::kIo);
}

TEST(ImageNames, ErrorsListTheChoices) {
  EXPECT_EQ(color_space_from("srgb"), ColorSpace::kSrgb);
  EXPECT_EQ(color_space_from("auto"), ColorSpace::kAuto);
  EXPECT_EQ(color_space_from("linear"), ColorSpace::kLinear);
  EXPECT_EQ(depth_from("auto"), Depth::kAuto);
  EXPECT_EQ(depth_from("8"), Depth::k8);
  EXPECT_EQ(depth_from("16"), Depth::k16);
  EXPECT_EQ(depth_from("half"), Depth::kHalf);
  EXPECT_EQ(depth_from("float"), Depth::kFloat);
  EXPECT_TRUE(contains(error_of([] { color_space_from("rgb"); }).what(), "auto, srgb or linear"));
  EXPECT_TRUE(contains(error_of([] { depth_from("12"); }).what(), "auto, 8, 16, half or float"));
  EXPECT_TRUE(is_image_extension("a.PNG"));
  EXPECT_FALSE(is_image_extension("a.mp4"));
  EXPECT_FALSE(is_image_extension("png"));
}

}  // namespace
}  // namespace morphkit::media
