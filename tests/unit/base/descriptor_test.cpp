#include "base/descriptor.h"

#include <fcntl.h>

#include <gtest/gtest.h>

namespace morphkit {
namespace {

int open_null() {
  return ::open("/dev/null", O_RDONLY | O_CLOEXEC);
}

bool is_open(int descriptor) {
  return ::fcntl(descriptor, F_GETFD) >= 0;
}

TEST(Descriptor, ClosesWhatItOwns) {
  const int number = open_null();
  {
    const Descriptor owner(number);
    EXPECT_TRUE(is_open(number));
  }
  EXPECT_FALSE(is_open(number));
}

TEST(Descriptor, ClosesOnceAndTellsOfFailure) {
  const int number = open_null();
  Descriptor owner(number);
  EXPECT_TRUE(owner.close());
  EXPECT_TRUE(owner.close()) << "nothing is left to close";
  Descriptor twice(number);
  EXPECT_FALSE(twice.close()) << "it is closed already";
}

TEST(Descriptor, GivesItAway) {
  const int number = open_null();
  Descriptor first(number);
  Descriptor second(std::move(first));
  EXPECT_EQ(second.get(), number);
  Descriptor third;
  third = std::move(second);
  EXPECT_EQ(third.release(), number);
  EXPECT_TRUE(is_open(number));
  ::close(number);
}

}  // namespace
}  // namespace morphkit
