#pragma once
// The exit codes of the program (docs/commands.md), and which error becomes which code.

#include <string>
#include <utility>

#include "base/error.h"

namespace morphkit::cli {

inline constexpr int kExitDone = 0;
inline constexpr int kExitFailed = 1;
inline constexpr int kExitUsage = 2;
inline constexpr int kExitBadInput = 3;
inline constexpr int kExitIo = 4;
/// A command found a difference, or a fault in the input that it checks.
inline constexpr int kExitDifference = 5;
inline constexpr int kExitInterrupted = 130;

int exit_code_of(ErrorKind kind) noexcept;

/// An argument that parses but cannot be followed: wrong usage, exit code 2.
class ArgumentError : public Error {
 public:
  /// @param argument  the option or file that is wrong.
  ArgumentError(std::string argument, std::string message)
      : Error(ErrorKind::kBadInput, std::move(argument), std::move(message)) {}
};

/// Runs work that the arguments asked for. If a library does not support it (an unknown output format), that is wrong
/// usage. Not for reading: an unsupported input is bad input.
/// @throws ArgumentError in place of an Error kUnsupported.
template <typename Work>
decltype(auto) as_asked(const Work& work) {
  try {
    return work();
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::kUnsupported) throw;
    throw ArgumentError(error.place(), error.message());
  }
}

}  // namespace morphkit::cli
