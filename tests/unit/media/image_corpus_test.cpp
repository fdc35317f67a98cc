// The seed corpus of the image fuzzer, replayed: each file gives a picture or an Error.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/media/image_support.h"

namespace morphkit::media {
namespace {

namespace fs = std::filesystem;
using test::Bytes;
using test::read_bytes;
using test::TemporaryFolder;
using test::write_bytes;

TEST(ImageCorpus, EveryFileIsReadOrRefused) {
  const TemporaryFolder folder;
  int read = 0;
  int refused = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(MORPHKIT_FUZZ_CORPUS) / "fuzz_image")) {
    SCOPED_TRACE(entry.path());
    const Bytes bytes = read_bytes(entry.path());
    ASSERT_FALSE(bytes.empty());
    // As in fuzz_image.cpp: the first byte chooses the extension.
    const fs::path file = folder / (bytes[0] % 2 == 0 ? "input.png" : "input.tga");
    write_bytes(file, Bytes(bytes.begin() + 1, bytes.end()));
    const bool is_good = entry.path().filename().string().starts_with("good");
    try {
      const Picture picture = read_picture(file);
      for (const warp::Pixel& pixel : picture.image) {
        for (int c = 0; c < 4; ++c) ASSERT_TRUE(std::isfinite(pixel[c]));
      }
      EXPECT_TRUE(is_good);
      ++read;
    } catch (const Error& error) {
      EXPECT_FALSE(is_good) << error.what();
      EXPECT_TRUE(error.kind() == ErrorKind::kBadInput || error.kind() == ErrorKind::kUnsupported) << error.what();
      ++refused;
    }
  }
  EXPECT_GE(read, 8);
  EXPECT_GE(refused, 8);
}

}  // namespace
}  // namespace morphkit::media
