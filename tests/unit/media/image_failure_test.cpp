// Tests morph/media/guard/png_check.cpp, morph/media/guard/promise_check.cpp and
// morph/media/image_format.cpp.
// Failures when people read and write images: missing files, other files, truncated and hostile ones, read-only
// folders, full disks.

#include <OpenImageIO/deepdata.h>
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <unistd.h>

#include "morph/media/image_format.h"
#include "tests/unit/media/image_support.h"

namespace morphkit::media {
namespace {

namespace fs = std::filesystem;
using test::Bytes;
using test::contains;
using test::error_of;
using test::random_image;
using test::TemporaryFolder;
using test::write_bytes;

void expect_refused(const fs::path& file, ErrorKind code, const std::string& part) {
  SCOPED_TRACE(file.filename());
  testing::internal::CaptureStderr();
  for (const bool pixels : {false, true}) {
    const Error error =
        error_of([&] { pixels ? static_cast<void>(read_picture(file)) : static_cast<void>(read_info(file)); });
    EXPECT_EQ(error.kind(), code);
    EXPECT_EQ(error.place(), file.string());
    EXPECT_TRUE(contains(error.message(), part)) << error.what();
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(ImageFailure, RefusesFilesThatAreNotImages) {
  const TemporaryFolder folder;
  expect_refused(folder / "missing.png", ErrorKind::kIo, "does not exist");
  fs::create_directory(folder / "folder.png");
  expect_refused(folder / "folder.png", ErrorKind::kIo, "is a folder");
  write_bytes(folder / "empty.png", {});
  expect_refused(folder / "empty.png", ErrorKind::kBadInput, "is empty");
  write_bytes(folder / "text.png", {'h', 'e', 'l', 'l', 'o'});
  expect_refused(folder / "text.png", ErrorKind::kUnsupported, "not an image that morphkit can read");
  expect_refused(folder / "text.png", ErrorKind::kUnsupported, "supported are PNG");
  write_bytes(folder / "x.tga", {'h', 'e', 'l', 'l', 'o'});
  expect_refused(folder / "x.tga", ErrorKind::kBadInput, "damaged");
  ASSERT_EQ(::mkfifo((folder / "pipe.png").c_str(), 0600), 0);
  expect_refused(folder / "pipe.png", ErrorKind::kIo, "not a regular file");
}

TEST(ImageFailure, UnreadableFile) {
  if (::geteuid() == 0) GTEST_SKIP() << "root reads everything";
  const TemporaryFolder folder;
  write_image(folder / "a.png", random_image(2, 2, false, 1));
  fs::permissions(folder / "a.png", fs::perms::none);
  expect_refused(folder / "a.png", ErrorKind::kIo, "cannot be read");
}

TEST(ImageFailure, TheContentsDecideAndNotTheExtension) {
  const TemporaryFolder folder;
  write_image(folder / "a.png", random_image(2, 2, false, 1));
  fs::rename(folder / "a.png", folder / "a.jpg");
  EXPECT_EQ(read_info(folder / "a.jpg").format, "png");
  EXPECT_EQ(read_picture(folder / "a.jpg").image.cols, 2);
}

TEST(ImageFailure, TruncatedFilesAreRefusedAtAnyLength) {
  const TemporaryFolder folder;
  const warp::Image image = random_image(40, 33, true, 3);
  for (const std::string extension : {".png", ".tif", ".jpg", ".webp", ".tga", ".exr"}) {
    const Bytes whole = encode_image(std::string("a").append(extension), image);
    // TGA ends in areas without pixels; a file cut only there is still a whole picture.
    const std::size_t tail = extension == ".tga" ? 600 : 3;
    for (const double part : {0.0, 0.1, 0.3, 0.5, 0.8, 0.95, 1.0}) {
      std::size_t size = static_cast<std::size_t>(part * static_cast<double>(whole.size() - tail));
      size = std::max<std::size_t>(size, 13);
      SCOPED_TRACE(testing::Message() << extension << " " << size << " of " << whole.size());
      const fs::path file = folder / (std::string("cut").append(extension));
      write_bytes(file, Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)));
      testing::internal::CaptureStderr();
      const Error error = error_of([&] { read_picture(file); });
      EXPECT_EQ(error.kind(), ErrorKind::kBadInput) << error.what();
      EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    }
  }
}

TEST(ImageFailure, DamagedPngIsReportedWithItsChunk) {
  const TemporaryFolder folder;
  Bytes bytes = encode_image("a.png", random_image(20, 20, false, 3));
  bytes[bytes.size() / 2] ^= 0x10;
  write_bytes(folder / "a.png", bytes);
  expect_refused(folder / "a.png", ErrorKind::kBadInput, "chunk IDAT");
}

/// CRC-32 of PNG, bit by bit (ISO/IEC 15948, annex D).
std::uint32_t checksum(const Bytes& bytes) {
  std::uint32_t crc = 0xffffffffU;
  for (const std::uint8_t byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1U) != 0 ? 0xedb88320U : 0U);
  }
  return ~crc;
}

/// A PNG with the given size in its header, a right checksum, and the pixels of a small picture.
Bytes png_of_size(std::uint32_t width, std::uint32_t height) {
  Bytes bytes = encode_image("a.png", random_image(2, 2, false, 1));
  for (int i = 0; i < 4; ++i) {
    bytes[16 + i] = static_cast<std::uint8_t>(width >> (24 - 8 * i));
    bytes[20 + i] = static_cast<std::uint8_t>(height >> (24 - 8 * i));
  }
  const std::uint32_t crc = checksum(Bytes(bytes.begin() + 12, bytes.begin() + 29));
  for (int i = 0; i < 4; ++i) bytes[29 + i] = static_cast<std::uint8_t>(crc >> (24 - 8 * i));
  return bytes;
}

TEST(ImageFailure, HostileSizesAreRefusedFromTheHeader) {
  const TemporaryFolder folder;
  write_bytes(folder / "huge.png", png_of_size(100000, 100000));
  expect_refused(folder / "huge.png", ErrorKind::kBadInput, "100000 x 100000");
  expect_refused(folder / "huge.png", ErrorKind::kBadInput, "65536");
  write_bytes(folder / "many.png", png_of_size(65000, 65000));
  expect_refused(folder / "many.png", ErrorKind::kBadInput, "1073741824");
  write_bytes(folder / "nothing.png", png_of_size(0, 5));
  expect_refused(folder / "nothing.png", ErrorKind::kBadInput, "has no pixels");
}

TEST(ImageFailure, ManyMissingLinesCostNothing) {
  const TemporaryFolder folder;
  write_bytes(folder / "empty.png", png_of_size(30000, 30000));
  EXPECT_EQ(error_of([&] { read_picture(folder / "empty.png"); }).kind(), ErrorKind::kBadInput);
}

/// The first 34 bytes of a PSD file of 5 x 4 pixels, with these lengths of colour mode data and resources.
Bytes psd_head(std::uint8_t colors, std::uint8_t resources) {
  return {'8', 'B', 'P', 'S', 0, 1, 0, 0, 0, 0,      0, 0, 0, 3, 0, 0,         0,
          4,   0,   0,   0,   5, 0, 8, 0, 3, colors, 0, 0, 0, 0, 0, resources, 0};
}

TEST(ImageFailure, RefusesHeadersWithSizesBeyondTheFile) {
  const TemporaryFolder folder;
  const auto refused = [&](const Bytes& bytes, const std::string& part) {
    write_bytes(folder / "a", bytes);
    expect_refused(folder / "a", ErrorKind::kBadInput, part);
  };
  refused({'G', 'I', 'F', '8', '9', 'a', 0x40, 0x9c, 0x30, 0x75, 0, 0, 0}, "40000 x 30000");
  refused({'G', 'I', 'F', '8', '9', 'a', 0x40, 0x9c}, "the GIF file is cut short: it ends at byte 8");
  Bytes bmp(60, 0);
  bmp[0] = 'B', bmp[1] = 'M', bmp[14] = 40, bmp[20] = 16, bmp[22] = bmp[23] = bmp[24] = bmp[25] = 0xff;
  refused(bmp, "1048576 x 1 ");
  Bytes dpx(2060, 0);
  dpx[0] = 'S', dpx[1] = 'D', dpx[2] = 'P', dpx[3] = 'X', dpx[32] = 0xf0, dpx[775] = dpx[779] = 2;
  refused(dpx, "the user data at byte 2048 needs 4026531840 bytes, 12 are left");
  dpx[773] = 2;
  refused(dpx, "131074 x 2");
  refused(psd_head(0x7f, 0), "the colour mode data at byte 30 needs 2130706432 bytes, 4 are left");
  refused(psd_head(0, 0x10), "the section of resources at byte 34 needs 4096 bytes, 0 are left");
}

TEST(ImageFailure, DeepImagesAreRefused) {
  const TemporaryFolder folder;
  OIIO::ImageSpec spec(1, 1, 5, OIIO::TypeDesc::FLOAT);
  spec.channelnames = {"R", "G", "B", "A", "Z"};
  spec.deep = true;
  OIIO::DeepData deep(spec);
  deep.set_samples(0, 1);
  const auto output = OIIO::ImageOutput::create("deep.exr");
  ASSERT_TRUE(output->open((folder / "deep.exr").string(), spec));
  ASSERT_TRUE(output->write_deep_image(deep));
  ASSERT_TRUE(output->close());
  expect_refused(folder / "deep.exr", ErrorKind::kUnsupported, "deep");
}

TEST(ImageFailure, RefusesToWriteToImpossiblePlaces) {
  const TemporaryFolder folder;
  const warp::Image image = random_image(2, 2, false, 1);
  const auto refused = [&](const fs::path& file, ErrorKind code, const std::string& part) {
    const Error error = error_of([&] { write_image(file, image); });
    EXPECT_EQ(error.kind(), code);
    EXPECT_TRUE(contains(error.what(), part)) << error.what();
  };
  refused(folder / "no/such/a.png", ErrorKind::kIo, "no/such does not exist");
  fs::create_directory(folder / "a.png");
  refused(folder / "a.png", ErrorKind::kIo, "is a folder");
  write_bytes(folder / "file", {1});
  refused(folder / "file/a.png", ErrorKind::kIo, "file");
  write_image(folder / "there.png", image);
  refused(folder / "there.png", ErrorKind::kIo, "already exists");
  refused(folder / "a.xyz", ErrorKind::kUnsupported, ".webp");
  refused(folder / "noextension", ErrorKind::kUnsupported, ".png");
  refused("/proc/a.png", ErrorKind::kIo, "cannot be created");
  EXPECT_EQ(folder.names().size(), 3U);
}

TEST(ImageFailure, ReadOnlyFolder) {
  if (::geteuid() == 0) GTEST_SKIP() << "root writes everywhere";
  const TemporaryFolder folder;
  fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
  const Error error = error_of([&] { write_image(folder / "a.png", random_image(2, 2, false, 1)); });
  fs::permissions(folder.path(), fs::perms::owner_all);
  EXPECT_EQ(error.kind(), ErrorKind::kIo);
  EXPECT_TRUE(contains(error.what(), "Permission denied")) << error.what();
}

TEST(ImageFailure, RefusesDepthsThatTheFormatDoesNotSupport) {
  const warp::Image image = random_image(2, 2, false, 1);
  const auto message = [&](const std::string& name, Depth depth) {
    WriteOptions options;
    options.depth = depth;
    const Error error = error_of([&] { encode_image(name, image, options); });
    EXPECT_EQ(error.kind(), ErrorKind::kUnsupported);
    return std::string(error.what());
  };
  EXPECT_EQ(message("a.jpg", Depth::k16), "a.jpg: JPEG cannot hold 16 bit samples, only 8 bit");
  EXPECT_EQ(message("a.png", Depth::kHalf), "a.png: PNG cannot hold half samples, only 8 bit or 16 bit");
  EXPECT_EQ(message("a.exr", Depth::k8), "a.exr: EXR cannot hold 8 bit samples, only half or float");
}

TEST(ImageFailure, RefusesSizesAndQualitiesThatTheFormatDoesNotSupport) {
  EXPECT_TRUE(contains(error_of([] { encode_image("a.webp", warp::Image(1, 16384)); }).what(), "16383"));
  EXPECT_EQ(error_of([] { encode_image("a.png", warp::Image()); }).kind(), ErrorKind::kUnsupported);
  WriteOptions options;
  options.quality = 0;
  EXPECT_EQ(error_of([&] { encode_image("a.jpg", warp::Image(1, 1, warp::Pixel()), options); }).kind(),
            ErrorKind::kUnsupported);
}

TEST(ImageFailure, FullDisk) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can mount a small disk";
  const TemporaryFolder folder;
  if (::mount("tmpfs", folder.path().c_str(), "tmpfs", 0, "size=64k") != 0)
    GTEST_SKIP() << "mounting is not allowed here";
  for (const std::string extension : {".png", ".tif", ".exr", ".webp", ".tga", ".jpg"}) {
    SCOPED_TRACE(extension);
    const Error error =
        error_of([&] { write_image(folder / (std::string("a").append(extension)), random_image(400, 300, false, 1)); });
    EXPECT_EQ(error.kind(), ErrorKind::kIo);
    EXPECT_TRUE(contains(error.what(), "No space left on device")) << error.what();
    EXPECT_EQ(folder.names().size(), 0U);
  }
  ::umount(folder.path().c_str());
}

}  // namespace
}  // namespace morphkit::media
