#include "morph/media/quick_size.h"

#include <filesystem>
#include <random>

#include <gtest/gtest.h>

#include "base/error.h"
#include "morph/media/image_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/media/exif_support.h"

namespace morphkit::media {
namespace {

using test::exif_saying;

using test::TemporaryFolder;

/// A PNG file of header, pixels and end alone.
test::Bytes without_texts(const test::Bytes& bytes) {
  test::Bytes plain(bytes.begin(), bytes.begin() + 8);
  for (std::size_t at = 8; at + 12 <= bytes.size();) {
    const std::size_t size = 12 + (std::size_t{bytes[at]} << 24 | std::size_t{bytes[at + 1]} << 16 |
                                   std::size_t{bytes[at + 2]} << 8 | bytes[at + 3]);
    const std::string type(bytes.begin() + static_cast<std::ptrdiff_t>(at) + 4,
                           bytes.begin() + static_cast<std::ptrdiff_t>(at) + 8);
    if (type == "IHDR" || type == "IDAT" || type == "IEND")
      plain.insert(plain.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                   bytes.begin() + static_cast<std::ptrdiff_t>(at + size));
    at += size;
  }
  return plain;
}

TEST(QuickSize, IsThatOfReadInfoForPlainPngFiles) {
  const TemporaryFolder folder;
  for (const Depth depth : {Depth::k8, Depth::k16}) {
    WriteOptions options;
    options.depth = depth;
    options.overwrite = true;
    write_image(folder / "a.png", warp::Image(5, 7, {0.5F, 0.5F, 0.5F, 1}), options);
    test::write_bytes(folder / "a.png", without_texts(test::read_bytes(folder / "a.png")));
    const auto size = quick_size(folder / "a.png");
    ASSERT_TRUE(size.has_value());
    const ImageInfo info = read_info(folder / "a.png");
    EXPECT_EQ(*size, cv::Size(info.width, info.height));
  }
}

TEST(QuickSize, LeavesOtherFormatsToTheLibrary) {
  const TemporaryFolder folder;
  for (const char* name : {"a.tif", "a.exr", "a.webp"}) {
    write_image(folder / name, warp::Image(5, 7, {0.5F, 0.5F, 0.5F, 1}));
    EXPECT_FALSE(quick_size(folder / name).has_value()) << name;
  }
}

/// A text may say which way is up, so it is the library's.
TEST(QuickSize, LeavesPngFilesWithTextsToTheLibrary) {
  const TemporaryFolder folder;
  write_image(folder / "a.png", warp::Image(5, 7, {0.5F, 0.5F, 0.5F, 1}));
  test::Bytes bytes = test::read_bytes(folder / "a.png");
  const test::Bytes text = {0, 0, 0, 0, 'e', 'X', 'I', 'f', 0, 0, 0, 0};
  const std::ptrdiff_t after_header = 8 + 25;
  bytes.insert(bytes.begin() + after_header, text.begin(), text.end());
  const std::uint32_t checksum = 0xCA79'9704;  // CRC-32 of "eXIf"
  for (int i = 0; i < 4; ++i)
    bytes[static_cast<std::size_t>(after_header + 8 + i)] = static_cast<std::uint8_t>(checksum >> (24 - 8 * i));
  test::write_bytes(folder / "a.png", bytes);
  EXPECT_FALSE(quick_size(folder / "a.png").has_value());
}

/// A JPEG file of 5 x 7 pixels that says nothing of which way is up: without its segments APP1.
test::Bytes plain_jpeg(const TemporaryFolder& folder) {
  write_image(folder / "plain.jpg", warp::Image(7, 5, {0.5F, 0.5F, 0.5F, 1}));
  const test::Bytes bytes = test::read_bytes(folder / "plain.jpg");
  test::Bytes plain(bytes.begin(), bytes.begin() + 2);
  for (std::size_t at = 2; at < bytes.size();) {
    const bool is_scan = bytes[at + 1] == 0xda;
    const std::size_t end = is_scan ? bytes.size() : at + 2 + (std::size_t{bytes[at + 2]} << 8 | bytes[at + 3]);
    if (bytes[at + 1] != 0xe1)
      plain.insert(plain.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                   bytes.begin() + static_cast<std::ptrdiff_t>(end));
    at = end;
  }
  return plain;
}

/// JPEG with Exif data in front.
test::Bytes with_exif(const test::Bytes& jpeg, const test::Bytes& exif) {
  const std::size_t length = 2 + 6 + exif.size();
  test::Bytes bytes = {
      0xff, 0xd8, 0xff, 0xe1, static_cast<std::uint8_t>(length >> 8), static_cast<std::uint8_t>(length), 'E', 'x',
      'i',  'f',  0,    0};
  bytes.insert(bytes.end(), exif.begin(), exif.end());
  bytes.insert(bytes.end(), jpeg.begin() + 2, jpeg.end());
  return bytes;
}

void expect_size_of_read_info(const std::filesystem::path& file) {
  const auto size = quick_size(file);
  ASSERT_TRUE(size.has_value()) << file;
  const ImageInfo info = read_info(file);
  EXPECT_EQ(*size, cv::Size(info.width, info.height)) << file;
}

TEST(QuickSize, IsThatOfReadInfoForPngFilesAsMorphkitWritesThem) {
  const TemporaryFolder folder;
  write_image(folder / "a.png", warp::Image(5, 7, {0.5F, 0.5F, 0.5F, 1}));
  expect_size_of_read_info(folder / "a.png");
}

TEST(QuickSize, IsThatOfReadInfoForJpegFilesWhateverWayIsUp) {
  const TemporaryFolder folder;
  write_image(folder / "a.jpg", warp::Image(5, 7, {0.5F, 0.5F, 0.5F, 1}));
  expect_size_of_read_info(folder / "a.jpg");
  const test::Bytes jpeg = plain_jpeg(folder);
  for (int orientation = 0; orientation <= 9; ++orientation) {
    test::write_bytes(folder / "a.jpg", with_exif(jpeg, exif_saying(orientation, orientation % 2 == 0)));
    expect_size_of_read_info(folder / "a.jpg");
  }
  const test::Bytes turned = with_exif(jpeg, exif_saying(6, true));
  test::write_bytes(folder / "a.jpg", with_exif(turned, exif_saying(1, true)));
  EXPECT_FALSE(quick_size(folder / "a.jpg").has_value()) << "two that may differ";
}

TEST(QuickSize, LeavesJpegFilesWithOtherWordsOnTheOrientationToTheLibrary) {
  const TemporaryFolder folder;
  const test::Bytes jpeg = plain_jpeg(folder);
  const auto quick = [&](std::uint8_t marker, const std::string& text) {
    test::Bytes bytes = {0xff, 0xd8, 0xff, marker, 0, static_cast<std::uint8_t>(2 + text.size())};
    bytes.insert(bytes.end(), text.begin(), text.end());
    bytes.insert(bytes.end(), jpeg.begin() + 2, jpeg.end());
    test::write_bytes(folder / "a.jpg", bytes);
    return quick_size(folder / "a.jpg").has_value();
  };
  EXPECT_TRUE(quick(0xfe, "a comment"));
  EXPECT_FALSE(quick(0xfe, "Orientation:6"));
  EXPECT_FALSE(quick(0xe1, "http://ns.adobe.com/xap/1.0/ tiff:Orientation=\"6\""));
  EXPECT_FALSE(quick(0xc3, "a lossless frame"));
}

/// Bytes of the headers changed at random: what is quickly told must be what the library tells, if it tells anything.
TEST(QuickSize, AgreesWithReadInfoOnDamagedJpegFiles) {
  const TemporaryFolder folder;
  const test::Bytes jpeg = with_exif(plain_jpeg(folder), exif_saying(6, true));
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  int told = 0;
  for (int trial = 0; trial < 400; ++trial) {
    test::Bytes bytes = jpeg;
    bytes[3 + random() % (bytes.size() - 3)] = static_cast<std::uint8_t>(random());
    if (trial % 4 == 0) bytes.resize(random() % bytes.size());
    test::write_bytes(folder / "a.jpg", bytes);
    try {
      const auto size = quick_size(folder / "a.jpg");
      if (!size) continue;
      const ImageInfo info = read_info(folder / "a.jpg");
      EXPECT_EQ(*size, cv::Size(info.width, info.height)) << trial;
      ++told;
    } catch (const Error&) {
    }
  }
  EXPECT_GT(told, 50);
}

TEST(QuickSize, RefusesWhatReadInfoRefuses) {
  const TemporaryFolder folder;
  EXPECT_THROW(quick_size(folder / "missing.png"), Error);
  write_image(folder / "a.png", warp::Image(5, 7, {0.5F, 0.5F, 0.5F, 1}));
  test::Bytes bytes = test::read_bytes(folder / "a.png");
  bytes.resize(bytes.size() - 20);
  test::write_bytes(folder / "a.png", bytes);
  EXPECT_THROW(quick_size(folder / "a.png"), Error);
}

}  // namespace
}  // namespace morphkit::media
