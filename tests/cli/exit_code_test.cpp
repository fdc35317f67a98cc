#include "cli/exit_code.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace morphkit::cli {
namespace {

TEST(ExitCode, IsAsTheManualSaysForEveryKind) {
  EXPECT_EQ(exit_code_of(ErrorKind::kFailed), 1);
  EXPECT_EQ(exit_code_of(ErrorKind::kBadInput), 3);
  EXPECT_EQ(exit_code_of(ErrorKind::kUnsupported), 3);
  EXPECT_EQ(exit_code_of(ErrorKind::kIo), 4);
  EXPECT_EQ(exit_code_of(ErrorKind::kInterrupted), 130);
}

TEST(ExitCode, WhatIsAskedForAndNotSupportedIsWrongUsage) {
  const auto refuse = [](ErrorKind kind) { as_asked([&]() -> int { throw Error(kind, "a.xyz", "no such kind"); }); };
  EXPECT_THROW(refuse(ErrorKind::kUnsupported), ArgumentError);
  try {
    refuse(ErrorKind::kIo);
  } catch (const ArgumentError&) {
    ADD_FAILURE() << "an error of the disk is no wrong usage";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kIo);
  }
  EXPECT_EQ(as_asked([] { return 7; }), 7);
}

}  // namespace
}  // namespace morphkit::cli
