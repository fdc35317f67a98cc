#pragma once
// Helpers for expected errors.

#include <string>

#include <gtest/gtest.h>

#include "base/error.h"

namespace morphkit::test {

/// The Error that `action` throws. The test fails if it throws none; other exceptions pass through.
template <typename Action>
Error error_of(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "no Error was thrown";
  return {ErrorKind::kFailed, "", ""};
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace morphkit::test
