#include "morph/media/exif_orientation.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"
#include "tests/unit/media/exif_support.h"

namespace morphkit::media {
namespace {

using test::exif_saying;

TEST(ExifOrientation, IsReadInBothByteOrders) {
  for (const bool is_big : {false, true})
    for (int orientation = 1; orientation <= 8; ++orientation)
      EXPECT_EQ(exif_orientation(exif_saying(orientation, is_big)), orientation) << is_big;
}

TEST(ExifOrientation, IsUprightWhereThereIsNone) {
  EXPECT_EQ(exif_orientation(exif_saying(0, false)), 1);
  EXPECT_EQ(exif_orientation(exif_saying(9, false)), 1);
  test::Bytes other = exif_saying(6, false);
  other[10] = 0x0f;  // another tag
  EXPECT_EQ(exif_orientation(other), 1);
}

TEST(ExifOrientation, NothingIsSaidOfDamagedData) {
  const test::Bytes good = exif_saying(6, true);
  for (std::size_t size = 0; size < 22; ++size)
    EXPECT_FALSE(exif_orientation(std::span(good).first(size)).has_value()) << size;
  for (const std::size_t at : {0U, 1U, 3U, 4U, 8U, 13U, 17U}) {
    test::Bytes bad = good;
    bad[at] = 0x7f;
    EXPECT_FALSE(exif_orientation(bad).has_value()) << at;
  }
}

}  // namespace
}  // namespace morphkit::media
