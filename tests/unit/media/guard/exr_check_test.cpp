// Wrong headers of EXR files: sizes are checked before OpenEXR allocates memory for them.

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

#include "morph/media/guard/exr_check.h"
#include "tests/unit/media/image_support.h"

namespace morphkit::media {
namespace {

using test::Bytes;
using test::contains;
using test::error_of;
using test::random_image;
using test::TemporaryFolder;
using test::write_bytes;

/// The header of an EXR file, built up by hand ("OpenEXR File Layout").
class Header {
 public:
  explicit Header(std::uint32_t version = 2) { number(0x01312f76).number(version); }

  Header& number(std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) bytes_.push_back(static_cast<std::uint8_t>(value >> shift));
    return *this;
  }

  Header& text(std::string_view value) {
    bytes_.insert(bytes_.end(), value.begin(), value.end());
    return *this;
  }

  Header& name(std::string_view value) { return text(value).byte(0); }

  Header& byte(std::uint8_t value) {
    bytes_.push_back(value);
    return *this;
  }

  Header& attribute(std::string_view its_name, std::string_view type, std::uint32_t size) {
    return name(its_name).name(type).number(size);
  }

  Header& window(std::string_view its_name, std::int32_t left, std::int32_t top, std::int32_t right,
                 std::int32_t bottom) {
    attribute(its_name, "box2i", 16);
    for (const std::int32_t edge : {left, top, right, bottom}) number(static_cast<std::uint32_t>(edge));
    return *this;
  }

  Header& channels(int count) {
    attribute("channels", "chlist", static_cast<std::uint32_t>(count) * (5 + 16) + 1);
    for (int i = 0; i < count; ++i) name(std::to_string(1000 + i)).number(2).number(0).number(1).number(1);
    return byte(0);
  }

  Header& end() { return byte(0); }

  const Bytes& bytes() const { return bytes_; }

 private:
  Bytes bytes_;
};

void expect_refused(const Header& header, const std::string& part) {
  SCOPED_TRACE(part);
  const TemporaryFolder folder;
  write_bytes(folder / "a.exr", header.bytes());
  for (const bool alone : {true, false}) {
    const Error error = error_of([&] {
      if (alone) {
        check_exr(folder / "a.exr");
      } else {
        read_info(folder / "a.exr");
      }
    });
    EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
    EXPECT_EQ(error.place(), (folder / "a.exr").string());
    EXPECT_TRUE(contains(error.message(), part)) << error.what();
  }
}

TEST(ExrHeader, RefusesAttributesLargerThanTheFile) {
  expect_refused(Header().attribute("owner", "string", 1700000000).text("me").end(),
                 "attribute owner (string) at byte 8 needs 1700000000 bytes, 3 are left");
  expect_refused(Header().attribute("x", "mystery", 0x80000000).end(), "attribute x (mystery) at byte 8 needs -2147");
  expect_refused(Header().attribute("a", "int", 4).number(1).attribute("b\n", "int", 4).byte(0),
                 "attribute b? (int) at byte 22 needs 4 bytes, 1 are left");
}

TEST(ExrHeader, RefusesSizesThatOpenExrIgnores) {
  expect_refused(Header().attribute("dataWindow", "box2i", 20).text(std::string(20, '\0')).end(),
                 "has 20 bytes instead of 16");
  expect_refused(Header().attribute("a", "compression", 4).number(0).end(), "has 4 bytes instead of 1");
  expect_refused(Header().attribute("a", "floatvector", 6).text("abcdef").end(), "no multiple of 4");
}

TEST(ExrHeader, RefusesListsLongerThanTheirAttribute) {
  expect_refused(Header().attribute("a", "stringvector", 6).number(0x7fffffff).text("ab").end(),
                 "has a string of 2147483647 bytes where 2 are left");
  expect_refused(Header().attribute("a", "stringvector", 2).text("ab").end(), "ends within the length");
  expect_refused(Header().attribute("a", "preview", 8).number(1 << 30).number(1 << 30).end(),
                 "promises 1073741824 x 1073741824 pixels and has 0 bytes");
  expect_refused(Header().attribute("channels", "chlist", 4).name("R").name("G").end(), "a list without an end");
}

TEST(ExrHeader, RefusesWindowsTilesAndCountsBeyondTheLimits) {
  expect_refused(Header().window("dataWindow", 0, 0, 99999, 99999).end(), "100000 x 100000");
  expect_refused(Header().window("dataWindow", INT32_MIN, 0, INT32_MAX, 0).end(), "4294967296 x 1");
  expect_refused(Header().window("displayWindow", 5, 5, 4, 5).end(), "has no pixels (0 x 1");
  expect_refused(Header().channels(1025).end(), "1025 channels");
  expect_refused(Header()
                     .window("dataWindow", 0, 0, 9, 9)
                     .attribute("tiles", "tiledesc", 9)
                     .number(1 << 20)
                     .number(1 << 20)
                     .byte(0)
                     .end(),
                 "tiles of 1048576 x 1048576 pixels for a picture of 10 x 10");
  expect_refused(Header().attribute("chunkCount", "int", 4).number(1000000).end(), "1000000 chunks, 0 bytes are left");
  expect_refused(Header().attribute("chunkCount", "int", 4).number(0x80000000).end(), "promises -2147483648 chunks");
}

TEST(ExrHeader, RefusesUnknownPixelTypes) {
  expect_refused(Header().attribute("channels", "chlist", 19).name("R").number(3).number(0).number(1).number(1).byte(0),
                 "has a channel of the unknown pixel type 3");
}

TEST(ExrHeader, ChecksAllParts) {
  constexpr std::uint32_t kMultiPart = 0x1002;
  const auto two = [](std::string_view name, std::uint32_t size) {
    return Header(kMultiPart).attribute("a", "int", 4).number(1).end().attribute(name, "string", size).end().end();
  };
  expect_refused(two("second", 1 << 30), "attribute second (string) at byte 23 needs 1073741824 bytes");
}

TEST(ExrHeader, RefusesAHeaderCutShortAnywhere) {
  const Bytes whole = encode_image("a.exr", random_image(9, 7, true, 1));
  const TemporaryFolder folder;
  write_bytes(folder / "a.exr", whole);
  EXPECT_NO_THROW(check_exr(folder / "a.exr"));
  constexpr std::string_view kLast = "screenWindowWidth";  // attributes are sorted by name
  const auto last = std::search(whole.begin(), whole.end(), kLast.begin(), kLast.end());
  ASSERT_NE(last, whole.end());
  for (auto end = whole.begin() + 1; end != last; ++end) {
    write_bytes(folder / "cut.exr", Bytes(whole.begin(), end));
    EXPECT_EQ(error_of([&] { check_exr(folder / "cut.exr"); }).kind(), ErrorKind::kBadInput);
  }
}

TEST(ExrHeader, RefusesUnterminatedNamesAndOtherVersions) {
  expect_refused(Header().text(std::string(300, 'x')), "the name at byte 8 is longer than 255 bytes");
  expect_refused(Header(3).end(), "version 3");
}

TEST(ExrHeader, AcceptsLongNamesAndTilesLargerThanThePicture) {
  const TemporaryFolder folder;
  OIIO::ImageSpec spec(5, 4, 3, OIIO::TypeDesc::HALF);
  spec.tile_width = spec.tile_height = 256;
  spec[std::string(200, 'n')] = "value";
  const std::vector<float> samples(5 * 4 * 3, 0.5F);
  const auto output = OIIO::ImageOutput::create("a.exr");
  ASSERT_TRUE(output->open((folder / "a.exr").string(), spec)) << output->geterror();
  ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, samples.data())) << output->geterror();
  ASSERT_TRUE(output->close());
  EXPECT_EQ(read_picture(folder / "a.exr").image.size(), cv::Size(5, 4));
}

}  // namespace
}  // namespace morphkit::media
