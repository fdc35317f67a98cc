// BMP and TGA files, byte by byte: which of their channels is alpha.

#include "morph/media/declared_alpha.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "tests/unit/media/image_support.h"
#include "warp/image/color.h"

namespace morphkit::media {
namespace {

namespace fs = std::filesystem;
using test::contains;
using test::TemporaryFolder;

using Bytes = std::vector<std::uint8_t>;

void add(Bytes& bytes, std::uint32_t number, int count) {
  for (int i = 0; i < count; ++i) bytes.push_back(static_cast<std::uint8_t>(number >> (8 * i)));
}

/// 2 x 1 pixels, uncompressed, with the header of Windows 3.
Bytes bmp(const Bytes& pixels) {
  Bytes bytes = {'B', 'M'};
  for (const std::uint32_t number : {62U, 0U, 54U, 40U, 2U, 1U}) add(bytes, number, 4);
  add(bytes, 1, 2);
  add(bytes, 32, 2);
  for (const std::uint32_t number : {0U, 8U, 0U, 0U, 0U, 0U}) add(bytes, number, 4);
  bytes.insert(bytes.end(), pixels.begin(), pixels.end());
  return bytes;
}

/// 2 x 1 pixels of type 2 (colours) or 3 (gray), from the top.
Bytes tga(std::uint8_t type, std::uint8_t bits, std::uint8_t alpha_bits, const Bytes& pixels) {
  Bytes bytes = {0, 0, type, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 1, 0, bits, static_cast<std::uint8_t>(0x20 | alpha_bits)};
  bytes.insert(bytes.end(), pixels.begin(), pixels.end());
  return bytes;
}

/// With an extension area that calls the alpha `attributes`.
Bytes extended(Bytes bytes, std::uint8_t attributes) {
  const auto place = static_cast<std::uint32_t>(bytes.size());
  add(bytes, 495, 2);
  bytes.resize(place + 494);
  bytes.push_back(attributes);
  add(bytes, place, 4);
  add(bytes, 0, 4);
  for (const char letter : std::string("TRUEVISION-XFILE.")) bytes.push_back(static_cast<std::uint8_t>(letter));
  bytes.push_back(0);
  return bytes;
}

Picture picture_of(const std::string& name, const Bytes& bytes) {
  const TemporaryFolder folder;
  std::ofstream(folder / name, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return read_picture(folder / name);
}

float srgb8(int code) {
  return warp::linear_from_srgb(static_cast<float>(code) / 255.0F);
}

warp::Pixel opaque(int red, int green, int blue) {
  return {srgb8(red), srgb8(green), srgb8(blue), 1};
}

warp::Pixel covered(int red, int green, int blue, int alpha) {
  const float part = static_cast<float>(alpha) / 255.0F;
  return {srgb8(red) * part, srgb8(green) * part, srgb8(blue) * part, part};
}

TEST(DeclaredAlpha, AFourthByteOfZerosInABmpIsNotAlpha) {
  const Picture picture = picture_of("a.bmp", bmp({10, 20, 30, 0, 40, 50, 60, 0}));
  EXPECT_EQ(picture.image(0, 0), opaque(30, 20, 10));
  EXPECT_EQ(picture.image(0, 1), opaque(60, 50, 40));
  EXPECT_FALSE(picture.info.has_alpha);
  EXPECT_EQ(warnings_of(picture), std::vector<std::string>());
}

TEST(DeclaredAlpha, AFourthByteThatVariesInABmpIsAlpha) {
  const Picture picture = picture_of("a.bmp", bmp({10, 20, 30, 0, 40, 50, 60, 102}));
  EXPECT_EQ(picture.image(0, 0), warp::Pixel(0, 0, 0, 0));
  EXPECT_EQ(picture.image(0, 1), covered(60, 50, 40, 102));
  EXPECT_TRUE(picture.info.has_alpha);
}

TEST(DeclaredAlpha, ATgaWithoutAlphaBitsIsOpaqueAndSaysSo) {
  for (const std::uint8_t fourth : Bytes{0, 5, 255}) {
    const Picture picture = picture_of("a.tga", tga(2, 32, 0, {10, 20, 30, fourth, 40, 50, 60, 7}));
    EXPECT_EQ(picture.image(0, 0), opaque(30, 20, 10));
    EXPECT_EQ(picture.image(0, 1), opaque(60, 50, 40));
    EXPECT_FALSE(picture.info.has_alpha);
    ASSERT_EQ(warnings_of(picture).size(), 1U);
    EXPECT_TRUE(contains(warnings_of(picture)[0], "declares no alpha")) << warnings_of(picture)[0];
  }
}

TEST(DeclaredAlpha, ATgaWithAlphaBitsAndNothingElseIsStraight) {
  const Picture picture = picture_of("a.tga", tga(2, 32, 8, {10, 20, 200, 102, 40, 50, 60, 255}));
  EXPECT_EQ(picture.image(0, 0), covered(200, 20, 10, 102));
  EXPECT_EQ(picture.image(0, 1), opaque(60, 50, 40));
  EXPECT_EQ(warnings_of(picture), std::vector<std::string>());
}

TEST(DeclaredAlpha, TheExtensionAreaOfATgaDecides) {
  const Bytes plain = tga(2, 32, 8, {10, 20, 51, 102, 40, 50, 60, 255});
  for (const std::uint8_t unused : Bytes{0, 1, 2})
    EXPECT_EQ(picture_of("a.tga", extended(plain, unused)).image(0, 0), opaque(51, 20, 10));
  EXPECT_EQ(picture_of("a.tga", extended(plain, 3)).image(0, 0), covered(51, 20, 10, 102));
  const warp::Pixel divided = picture_of("a.tga", extended(plain, 4)).image(0, 0);
  EXPECT_NEAR(divided[0], warp::linear_from_srgb(0.5F) * 0.4F, 1e-6);
  EXPECT_EQ(divided[3], 0.4F);
}

TEST(DeclaredAlpha, ColorAboveAlphaInAPremultipliedTgaIsHeldAndTold) {
  const Picture picture = picture_of("a.tga", extended(tga(2, 32, 8, {0, 51, 255, 1, 0, 0, 40, 40}), 4));
  const float part = 1.0F / 255.0F;
  EXPECT_EQ(picture.image(0, 0), warp::Pixel(part, part, 0, part));
  EXPECT_EQ(picture.above_alpha_pixels, 1);
  ASSERT_EQ(warnings_of(picture).size(), 1U);
  EXPECT_TRUE(contains(warnings_of(picture)[0], "1 pixels are brighter than their alpha")) << warnings_of(picture)[0];
}

TEST(DeclaredAlpha, GrayAndAlphaInATgaIsGray) {
  const Picture picture = picture_of("a.tga", tga(3, 16, 8, {100, 102, 200, 255}));
  EXPECT_EQ(picture.image(0, 0), covered(100, 100, 100, 102));
  EXPECT_EQ(picture.image(0, 1), opaque(200, 200, 200));
  EXPECT_TRUE(picture.info.has_alpha);
}

TEST(DeclaredAlpha, APictureThatIsTransparentEverywhereIsTold) {
  const Picture picture = picture_of("a.tga", tga(2, 32, 8, {10, 20, 30, 0, 40, 50, 60, 0}));
  ASSERT_EQ(warnings_of(picture).size(), 1U);
  EXPECT_EQ(warnings_of(picture)[0], "the picture is transparent everywhere");
}

}  // namespace
}  // namespace morphkit::media
